// What is visible in which cell, by hand or drawn from a profile.
import type { Play, Profile } from './data';

/** `seen[symbol][cell]`. Each symbol is that one input has one value; within a cell the last one written counts. */
export type Seen = boolean[][];

export function nothingSeen(play: Play, cells: number): Seen {
  return play.symbols.map(() => new Array<boolean>(cells).fill(false));
}

/** Sets one cell; what the same input showed there otherwise goes. */
export function show(play: Play, seen: Seen, symbol: number, cell: number, there: boolean): void {
  const { input } = play.symbols[symbol];
  if (there) play.symbols.forEach((other, i) => { if (other.input === input) seen[i][cell] = false; });
  seen[symbol][cell] = there;
}

/** Per step the index of the observation, the blank one first; -1: no controller knows such a one. */
export function observationsOf(play: Play, seen: Seen, cells: number, index: Map<string, number>): number[] {
  const letters = [play.inputs.map(() => 0)];
  for (let cell = 0; cell < cells; ++cell) {
    const letter = play.inputs.map(() => 0);
    play.symbols.forEach((symbol, i) => { if (seen[i][cell]) letter[symbol.input] = symbol.value; });
    letters.push(letter);
  }
  return letters.map((letter) => index.get(letter.join()) ?? -1);
}

/** A well-mixed 32-bit word of two: draw number \p counter of \p seed. \cite in docs/formats/play.md */
export function word(seed: number, counter: number): number {
  let x = (Math.imul(seed, 0x9e3779b9) ^ Math.imul(counter + 1, 0x85ebca6b)) >>> 0;
  for (let round = 0; round < 2; ++round) {
    x ^= x >>> 16;
    x = Math.imul(x, 0x7feb352d) >>> 0;
    x ^= x >>> 15;
    x = Math.imul(x, 0x846ca68b) >>> 0;
    x ^= x >>> 16;
  }
  return x >>> 0;
}

export function fraction(text: string): number {
  const [over, under = '1'] = text.split('/');
  return Number(over) / Number(under);
}

/** One way through the profile's chain for a thing (its index; the last one is nothing there). */
export function sample(play: Play, profile: Profile, thing: number, seed: number): Seen {
  const approach = profile.approaches[profile.of[thing]];
  const chain = profile.chains[approach.chain];
  const seen = nothingSeen(play, profile.cells);
  let state = 0;
  for (let cell = 0; cell < profile.cells; ++cell) {
    let rest = word(seed, cell) / 2 ** 32;
    const draw = chain[state].find(([p]) => (rest -= fraction(p)) < 0) ?? chain[state][chain[state].length - 1];
    for (const feature of draw[2]) show(play, seen, approach.symbols[feature], cell, true);
    state = draw[1];
  }
  return seen;
}
