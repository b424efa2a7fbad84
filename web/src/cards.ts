// One card per controller: what it knows, what it does, and why.
import type { App } from './app';
import { colourClass, plantWords, speedWords } from './board';
import { printed, type Controller } from './data';
import { h, percent, setText } from './dom';
import { columnValue, type Drive } from './machine';
import { verdictOf, type Model } from './model';
import { adviceAt, prescribedAt, reasonsAt, recognisedAt, type Reason } from './reasons';
import type { View } from './view';

/** Most names in a list; a whole catalogue would fill the screen. */
const MOST_NAMES = 8;

interface Card {
  element: HTMLElement;
  update: (model: Model, run: Drive) => void;
}

function listed(names: string[]): string {
  const more = names.length - MOST_NAMES;
  return names.length === 0 ? 'nothing' : names.slice(0, MOST_NAMES).join(', ') + (more > 0 ? ` and ${more} more` : '');
}

function shortFile(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}

function drawReason(reason: Reason): HTMLElement {
  return h('li', {}, reason.sentence,
    reason.formula !== '' && h('code', {}, reason.formula),
    ...reason.axioms.map((axiom) => h('span', { class: 'axiom' }, h('span', { class: 'soft' }, `${axiom.id} `), axiom.text,
      axiom.file !== '' && h('span', { class: 'soft' }, ` (${shortFile(axiom.file)}:${axiom.line})`))));
}

function actionOf(controller: Controller, run: Drive, step: number): string {
  const column = controller.outputs.findIndex(({ role }) => role === 'action');
  return column < 0 ? '' : printed(controller.outputs[column].type, columnValue(run, step, column)).replaceAll('_', ' ');
}

function fact(name: string): [HTMLElement, HTMLElement] {
  const value = h('dd');
  return [h('div', {}, h('dt', {}, name), value), value];
}

function makeCard(app: App, model: Model, index: number): Card {
  const controller = app.play.controllers[index];
  const verdict = h('p', { class: 'verdict' });
  const [knowsBox, knows] = fact('Recognises');
  const [prescribedBox, prescribed] = fact('Prescribed');
  const [doesBox, does] = fact('Does');
  const [plantBox, plant] = fact('Plant');
  const [speedBox, speed] = fact('Speed');
  const gauge = h('div', { class: 'gauge', 'aria-hidden': 'true' }, h('div', {}));
  const advice = h('p', { class: 'soft' });
  const why = h('ol', { class: 'why' });
  const without = h('p', { class: 'soft' }, 'Nothing that it recognises prescribes what the plant is bound to.');
  speedBox.hidden = !app.play.speed;
  const element = h('article', { class: `card ${colourClass(model, index)}`, 'aria-label': controller.title, 'data-controller': controller.name },
    h('h3', {}, controller.title), h('p', { class: 'policy' }, controller.policy ? `Recognises when ${controller.policy}.` : ''),
    verdict, h('dl', { class: 'facts' }, knowsBox, prescribedBox, doesBox, plantBox, speedBox), gauge, h('h4', {}, 'Why'), why, without, advice);

  let shown = '';
  const update = (now: Model, run: Drive): void => {
    const step = Math.min(now.state.at, run.steps.length - 1);
    const answered = run.steps[step].letter >= 0;
    const { tone, mark, words, outcome } = verdictOf(now, run);
    setText(verdict, `${mark} ${words}`);
    verdict.className = `verdict ${tone}`;
    verdict.dataset.outcome = outcome;
    setText(knows, listed(recognisedAt(run, step)));
    setText(prescribed, listed(prescribedAt(run, step).map(({ label }) => label)));
    setText(does, answered ? actionOf(controller, run, step) + (run.steps[step].fallback ? ' (fallback)' : '') : 'no answer');
    setText(plant, plantWords(now, run, step));
    setText(speed, speedWords(run.steps[step].kmh));
    (gauge.firstChild as HTMLElement).style.width = percent(now.play.speed ? run.steps[step].kmh / now.play.speed.kmh : 0);
    gauge.hidden = !now.play.speed;
    const reasons = reasonsAt(now.play, run, step, now.now);
    without.hidden = reasons.length > 0;
    const told = adviceAt(run, step);
    setText(advice, told.length > 0 ? `Advice only, bound to nothing of the plant: ${listed(told)}.` : '');
    advice.hidden = told.length === 0;
    const key = JSON.stringify(reasons);
    if (key !== shown) why.replaceChildren(...reasons.map(drawReason));
    shown = key;
  };
  return { element, update };
}

export function cards(app: App): View {
  const element = h('section', { class: 'controllers', 'aria-labelledby': 'controllers-title' });
  let made: Card[] = [];
  const update = (model: Model): void => {
    if (made.length === 0) {
      made = model.play.controllers.map((_, i) => makeCard(app, model, i));
      element.append(h('h2', { id: 'controllers-title' }, 'What each controller makes of it'), h('div', { class: 'cards' }, ...made.map((card) => card.element)));
    }
    made.forEach((card, i) => card.update(model, model.runs[i]));
  };
  return { element, update };
}
