import './style.css';

import { App } from './app';
import { board, plantWords, speedWords } from './board';
import { camera } from './camera';
import { cards } from './cards';
import { chooser, sharing, transport } from './controls';
import { readPlay } from './data';
import { h, setText } from './dom';
import { placeOf, verdictOf, type Model } from './model';
import type { View } from './view';

/** Says in words what a step shows, for whoever does not see it. */
function announcer(): View {
  const element = h('div', { class: 'hidden', role: 'status', 'aria-live': 'polite', id: 'said' });
  const update = (model: Model): void => {
    const { play, state, now } = model;
    const seen = [...now].map((i) => play.symbols[i].label).join(', ') || 'nothing';
    const each = model.runs.map((run) => {
      const step = Math.min(state.at, run.steps.length - 1);
      const speed = speedWords(run.steps[step].kmh) || plantWords(model, run, step);
      return `${run.controller.title}: ${speed}, ${verdictOf(model, run).words}`;
    });
    setText(element, `Step ${state.at}, ${placeOf(model, state.at)}. Seen: ${seen}. ${each.join('. ')}.`);
  };
  return { element, update };
}

function start(): void {
  const play = readPlay();
  document.title = `${play.scenario} · heed play`;
  const app = new App(play);
  const views = { choose: chooser(app), board: board(app), time: transport(app), camera: camera(app), cards: cards(app), share: sharing(app), said: announcer() };
  const versions = play.versions.map(({ name, version }) => `${name} ${version}`).join(', ');
  document.getElementById('page')?.replaceChildren(
    h('header', {}, h('p', { class: 'eyebrow' }, 'heed play'), h('h1', {}, play.scenario), h('p', { class: 'lede' }, play.description)),
    h('main', {},
      views.choose.element,
      h('div', { class: 'stage' }, h('div', { class: 'drive' }, views.time.element, views.board.element), views.camera.element),
      views.cards.element, views.said.element),
    h('footer', {}, views.share.element,
      h('p', {}, `Controllers synthesized and verified by ${versions}. Their tables are inside this page; it asks nothing of any network.`)));
  app.show(Object.values(views));
}

start();
