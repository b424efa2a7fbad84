// A run as the part of an address after '#': what approaches, under which profile and seed, what was seen when, and the step.
import type { Play } from './data';
import { nothingSeen, show, type Seen } from './perception';

export interface State {
  /** Index of an entity; the number of entities stands for nothing there. */
  thing: number;
  profile: number;
  seed: number;
  seen: Seen;
  at: number;
}

export function cellsOf(play: Play, profile: number): number {
  return play.profiles[profile]?.cells ?? play.cells;
}

export function initialState(play: Play): State {
  const thing = play.approached >= 0 ? play.approached : play.entities.length;
  return { thing, profile: 0, seed: play.seed, seen: nothingSeen(play, cellsOf(play, 0)), at: 0 };
}

/** Names, not numbers: a link outlives changes of the ontology that it does not speak of. */
export function toHash(play: Play, state: State): string {
  const parts = new URLSearchParams();
  parts.set('thing', play.entities[state.thing]?.name ?? '');
  if (play.profiles[state.profile]) parts.set('profile', play.profiles[state.profile].name);
  parts.set('seed', String(state.seed));
  parts.set('at', String(state.at));
  state.seen.forEach((row, symbol) => {
    if (row.some(Boolean)) parts.append('see', `${play.symbols[symbol].name}.${row.map(Number).join('')}`);
  });
  return `#${parts.toString()}`;
}

function boundedNumber(text: string | null, otherwise: number, most: number): number {
  const value = Number(text ?? NaN);
  return Number.isInteger(value) && value >= 0 && value <= most ? value : otherwise;
}

/** Whatever a link says that this page does not know is passed over. */
export function fromHash(play: Play, hash: string): State {
  const state = initialState(play);
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  if (parts.has('thing')) {
    const thing = play.entities.findIndex((entity) => entity.name === parts.get('thing'));
    if (thing >= 0 || parts.get('thing') === '') state.thing = thing >= 0 ? thing : play.entities.length;
  }
  const profile = play.profiles.findIndex((one) => one.name === parts.get('profile'));
  if (profile >= 0) state.profile = profile;
  const cells = cellsOf(play, state.profile);
  state.seen = nothingSeen(play, cells);
  for (const one of parts.getAll('see')) {
    const dot = one.lastIndexOf('.');
    const symbol = play.symbols.findIndex(({ name }) => name === one.slice(0, dot));
    if (symbol < 0) continue;
    for (let cell = 0; cell < cells; ++cell) if (one[dot + 1 + cell] === '1') show(play, state.seen, symbol, cell, true);
  }
  state.seed = boundedNumber(parts.get('seed'), state.seed, 2 ** 32 - 1);
  state.at = boundedNumber(parts.get('at'), 0, cells);
  return state;
}
