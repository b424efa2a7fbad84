// Choosing what approaches, drawing a run, moving in time, sharing.
import type { App } from './app';
import { h, s, setText } from './dom';
import { placeOf, type Model } from './model';
import type { View } from './view';

function things(app: App): HTMLSelectElement {
  const { entities } = app.play;
  const groups = new Map<string, HTMLOptionElement[]>();
  entities.forEach((entity, i) => {
    const options = groups.get(entity.group) ?? [];
    options.push(h('option', { value: i }, entity.label));
    groups.set(entity.group, options);
  });
  const select = h('select', { id: 'thing', change: () => app.choose(Number(select.value)) });
  for (const [group, options] of groups) select.append(group === '' ? h('optgroup', { label: 'others' }, ...options) : h('optgroup', { label: group }, ...options));
  select.append(h('option', { value: entities.length }, 'nothing there'));
  return select;
}

function field(label: string, control: HTMLElement): HTMLElement {
  return h('div', { class: 'field' }, h('label', { for: control.id }, label), control);
}

export function chooser(app: App): View {
  const { play } = app;
  const thing = things(app);
  const profile = h('select', { id: 'profile', change: () => app.takeProfile(Number(profile.value)) },
    ...play.profiles.map((one, i) => h('option', { value: i }, one.title && one.title !== one.name ? `${one.name}: ${one.title}` : one.name)));
  const seed = h('input', { id: 'seed', type: 'number', min: 0, max: 4294967295, step: 1, inputmode: 'numeric', change: () => app.draw(Number(seed.value)) });
  const draw = h('button', { id: 'draw', type: 'button', class: 'primary', click: () => app.draw(app.state().seed + 1) }, 'Draw a run');
  const prescribes = h('p', { class: 'prescribes' });
  const element = h('section', { class: 'chooser', 'aria-label': 'What approaches, and how it is seen' },
    field(`The ${play.kind} that approaches`, thing),
    ...(play.profiles.length > 0 ? [field('Perception profile', profile), field('Seed', seed), draw] : []), prescribes);
  const update = ({ state, entity }: Model): void => {
    thing.value = String(state.thing);
    profile.value = String(state.profile);
    if (document.activeElement !== seed) seed.value = String(state.seed);
    setText(prescribes, entity ? `It prescribes: ${entity.prescribes.join(', ') || 'nothing'}.` : 'Nothing is there; whatever is seen is a misreading.');
  };
  return { element, update };
}

const ICONS = { start: 'M4 3h3v14H4ZM17 3v14L7 10Z', back: 'M15 3v14L5 10Z', next: 'M5 3v14l10-7Z', pause: 'M4 3h4v14H4ZM12 3h4v14h-4Z' };

function icon(name: keyof typeof ICONS): SVGElement {
  return s('svg', { viewBox: '0 0 20 20', class: 'icon', 'aria-hidden': 'true' }, s('path', { d: ICONS[name] }));
}

export function transport(app: App): View {
  const button = (id: string, label: string, mark: keyof typeof ICONS, click: () => void): HTMLButtonElement =>
    h('button', { type: 'button', id, 'aria-label': label, title: label, click }, icon(mark));
  const playing = { icon: h('span', {}), words: h('span', {}) };
  const play = h('button', { type: 'button', id: 'play', class: 'primary', click: () => app.toggle() }, playing.icon, playing.words);
  const slider = h('input', { type: 'range', id: 'step', min: 0, step: 1, 'aria-label': 'Step', input: () => app.change({ at: Number(slider.value) }) });
  const place = h('output', { for: 'step', class: 'place' });
  const back = button('back', 'One step back', 'back', () => app.step(-1));
  const on = button('next', 'One step on', 'next', () => app.step(1));
  const element = h('section', { class: 'transport', 'aria-label': 'Time' },
    play, button('reset', 'Back to the start', 'start', () => app.reset()), back, on, slider, place);
  const update = (model: Model): void => {
    slider.max = String(model.cells);
    slider.value = String(model.state.at);
    slider.setAttribute('aria-valuetext', placeOf(model, model.state.at));
    setText(place, `Step ${model.state.at} of ${model.cells}: ${placeOf(model, model.state.at)}`);
    playing.icon.replaceChildren(icon(app.playing() ? 'pause' : 'next'));
    setText(playing.words, app.playing() ? 'Pause' : 'Play');
    back.setAttribute('aria-disabled', String(model.state.at === 0));
    on.setAttribute('aria-disabled', String(model.state.at === model.cells));
  };
  return { element, update };
}

export function sharing(app: App): View {
  const address = h('input', { type: 'text', id: 'address', readonly: true, 'aria-label': 'Link to this run', focus: () => address.select() });
  const said = h('span', { role: 'status', class: 'soft' });
  const copy = async (): Promise<void> => {
    address.focus();
    try {
      await navigator.clipboard.writeText(address.value);
      setText(said, 'Copied.');
    } catch {  // no clipboard for this page: the link is selected
      setText(said, 'Selected: copy it with Ctrl+C.');
    }
  };
  const element = h('div', { class: 'sharing' }, h('button', { type: 'button', id: 'share', click: () => void copy() }, 'Copy link'), address, said);
  return { element, update: () => { address.value = app.link(); } };
}
