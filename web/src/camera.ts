// What has been made out so far, and what of the catalogue it could still be.
import type { App } from './app';
import { h, setText } from './dom';
import type { Model } from './model';
import { drawSign, lookOf, type Look } from './sign';
import type { View } from './view';

/** The thing as it has been seen so far; null: nothing of how it looks. */
function lookSoFar(model: Model): { look: Look | null; there: boolean; whole: boolean } {
  const { play, now } = model;
  const seen = [...now].map((i) => play.symbols[i]);
  const whole = seen.find(({ kind }) => kind === 'whole');
  if (whole?.entity !== undefined) return { look: lookOf(play, play.entities[whole.entity].features), there: true, whole: true };
  const features = seen.filter(({ kind, feature }) => kind === 'feature' && feature !== undefined).map(({ feature }) => feature as number);
  if (features.length === 0) return { look: null, there: now.size > 0, whole: false };
  return { look: lookOf(play, features), there: true, whole: false };
}

function candidatesNow(model: Model): Set<number> | null {
  const { candidates } = model.play;
  const observation = model.observations[Math.min(model.state.at, model.observations.length - 1)];
  return candidates && observation >= 0 ? new Set(candidates.sets[candidates.of[observation]]) : null;
}

function candidateWords(model: Model, left: Set<number>): string {
  const { play } = model;
  const all = play.entities.length;
  if (left.size === 0) return 'Nothing in the catalogue fits what is seen.';
  if (left.size === all) return `Could be any of ${all}.`;
  const names = [...left].slice(0, 4).map((i) => play.entities[i].label).join(', ');
  return `Could be ${left.size} of ${all}: ${names}${left.size > 4 ? ' …' : '.'}`;
}

export function camera(app: App): View {
  const { play } = app;
  const picture = h('div', { class: 'seen-picture' });
  const words = h('p', { class: 'seen-words' });
  const count = h('p', { class: 'count' });
  const thumbs = play.entities.map((entity, i) => h('button', {
    type: 'button', class: 'thumb', tabindex: -1, 'aria-hidden': 'true', title: entity.label, click: () => app.choose(i),
  }, drawSign(lookOf(play, entity.features), { whole: true })));
  const gallery = h('div', { class: 'gallery' }, ...thumbs);
  const element = h('section', { class: 'camera', 'aria-labelledby': 'camera-title' },
    h('h2', { id: 'camera-title' }, 'What the camera knows'), h('div', { class: 'seen-now' }, picture, words), count, gallery);

  const update = (model: Model): void => {
    const { look, there, whole } = lookSoFar(model);
    picture.replaceChildren(drawSign(look, { there, whole }));
    const names = [...model.now].map((i) => play.symbols[i].label);
    setText(words, names.length > 0 ? `Seen now: ${names.join(', ')}.` : 'Nothing is seen yet.');
    const left = candidatesNow(model);
    count.hidden = gallery.hidden = !left || play.entities.length === 0;
    if (left) setText(count, candidateWords(model, left));
    thumbs.forEach((thumb, i) => {
      thumb.classList.toggle('out', left !== null && !left.has(i));
      thumb.classList.toggle('true', i === model.state.thing);
    });
  };
  return { element, update };
}
