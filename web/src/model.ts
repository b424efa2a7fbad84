// From the state that a person changes to all that is shown: a pure function, computed anew with every change.
import type { Entity, Play } from './data';
import { cellsOf, type State } from './link';
import { deceleration, drive, outcomeOf, type Drive } from './machine';
import { observationsOf } from './perception';

export interface Model {
  play: Play;
  state: State;
  cells: number;
  /** null: nothing there. */
  entity: Entity | null;
  runs: Drive[];
  observations: number[];
  /** Symbols that are seen in the present step. */
  now: Set<number>;
  /** Symbols that were seen so far. */
  soFar: Set<number>;
}

export function derive(play: Play, state: State, index: Map<string, number>): Model {
  const cells = cellsOf(play, state.profile);
  const observations = observationsOf(play, state.seen, cells, index);
  const runs = play.controllers.map((controller) => drive(play, controller, observations));
  const entity = play.entities[state.thing] ?? null;
  const symbols = play.symbols.map((_, i) => i);
  const now = new Set(symbols.filter((i) => state.at > 0 && state.seen[i][state.at - 1]));
  const soFar = new Set(symbols.filter((i) => state.seen[i].slice(0, state.at).some(Boolean)));
  return { play, state, cells, entity, runs, observations, now, soFar };
}

export type Tone = 'good' | 'bad' | 'warn' | 'plain';

export interface Verdict {
  tone: Tone;
  mark: string;
  words: string;
  /** Label of the scenario's outcome; empty: none yet. */
  outcome: string;
}

function hardness(braking: number): string {
  return braking <= 3 ? 'gentle' : braking <= 6 ? 'firm' : 'emergency';
}

function withBraking(model: Model, run: Drive, label: string): string {
  const left = run.steps[run.decided]?.left;
  const braking = deceleration(model.play, left);
  return Number.isFinite(braking) ? `${label}: ${braking.toFixed(1)} m/s\u00b2, ${hardness(braking)}` : label;
}

/** Whether \p label, which is no miss, was the right thing to do here. */
function judgeReaction(model: Model, run: Drive, label: string): Omit<Verdict, 'outcome'> {
  const react = model.entity?.react;
  if (run.decided < 0) return { tone: 'plain', mark: '\u00b7', words: label };
  if (react === 'must') return { tone: 'good', mark: '\u2713', words: withBraking(model, run, label) };
  if (react === 'may') return { tone: 'plain', mark: '\u00b7', words: `${label}: not needed, but excused` };
  return { tone: 'warn', mark: '!', words: `${withBraking(model, run, label)}; needless` };
}

function judgeMiss(model: Model, run: Drive, label: string): Omit<Verdict, 'outcome'> {
  if (model.entity?.react === 'must') return { tone: 'bad', mark: '\u2717', words: `${label}: missed` };
  return { tone: 'good', mark: '\u2713', words: run.decided < 0 ? 'does not react, and need not' : label };
}

/** What the run has come to by the present step: the scenario's outcome, and whether it was the right one for this thing. */
export function verdictOf(model: Model, run: Drive): Verdict {
  const { play, state, cells } = model;
  if (play.outcomes.length === 0) return { tone: 'plain', mark: '\u00b7', words: 'the scenario judges nothing', outcome: '' };
  const decided = run.decided >= 0 && run.decided <= state.at;
  if (!decided && state.at < cells) return { tone: 'plain', mark: '\u2026', words: 'not decided yet', outcome: '' };
  const outcome = outcomeOf(play, run);
  if (outcome < 0) return { tone: 'warn', mark: '!', words: 'no answer to this observation: the run ends', outcome: '' };
  const label = play.outcomes[outcome];
  return { ...(outcome === play.miss ? judgeMiss(model, run, label) : judgeReaction(model, run, label)), outcome: label };
}

/** "30 m", or the cell's number where the scenario has no lengths; step 0 is before the first cell. */
export function placeOf(model: Model, step: number): string {
  const left = model.cells - step;
  if (!model.play.speed) return step === 0 ? 'before the first cell' : `cell ${step} of ${model.cells}`;
  return left === 0 ? 'at the place' : `${left * model.play.speed.cell_metres} m to go`;
}
