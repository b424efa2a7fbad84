// The controllers' tables, stepped. A run is one observation in which nothing is in view, then one per cell; everything here is a
// function of the observations, so that going back is as easy as going on.
import type { Controller, Play } from './data';

/** What a controller did at one step; `letter` is -1 where it has no answer, and the run ends there. */
export interface Step {
  letter: number;
  outcome: number;
  fallback: boolean;
  kmh: number;
  /** Cells to the thing; NaN where the plant does not tell. */
  left: number;
}

export interface Drive {
  controller: Controller;
  steps: Step[];
  /** The first event's outcome and step; -1: none. */
  outcome: number;
  decided: number;
}

/** Observations of the data by their values. */
export function indexObservations(play: Play): Map<string, number> {
  return new Map(play.observations.map((letter, i) => [letter.join(), i]));
}

/** How fast a car that does not brake takes up its speed again. */
const ACCELERATION = 2;

/** With \p left cells to go it brakes so that it would stand at the thing: v^2 falls evenly with the way. */
function speedAfter(play: Play, kmh: number, left: number, brakes: boolean): number {
  if (!play.speed) return NaN;
  if (brakes && left > 0) return kmh * Math.sqrt((left - 1) / left);
  const metres = Math.sqrt((kmh / 3.6) ** 2 + 2 * ACCELERATION * play.speed.cell_metres);
  return Math.min(play.speed.kmh, metres * 3.6);
}

function leftAt(play: Play, controller: Controller, letter: number, step: number, steps: number): number {
  const column = controller.outputs.findIndex((output) => output.role === 'plant');
  if (column < 0 || !play.plant.way) return steps - 1 - step;
  return play.plant.values[play.plant.way][controller.reactions[letter][column]];
}

/** Steps \p controller through all observations; -1 stands for an observation that no table knows. */
export function drive(play: Play, controller: Controller, observations: number[]): Drive {
  const result: Drive = { controller, steps: [], outcome: -1, decided: -1 };
  let state = 0;
  let kmh = play.speed?.kmh ?? NaN;
  for (const [t, observation] of observations.entries()) {
    const row = controller.states[state].find((one) => one[0] === observation);
    if (!row) {
      result.steps.push({ letter: -1, outcome: -1, fallback: false, kmh, left: NaN });
      break;
    }
    const outcome = row[3] ?? -1;
    const left = leftAt(play, controller, row[1], t, observations.length);
    result.steps.push({ letter: row[1], outcome, fallback: row[4] === 1, kmh, left });
    if (outcome >= 0 && result.decided < 0) [result.outcome, result.decided] = [outcome, t];
    kmh = speedAfter(play, kmh, left, outcome >= 0 && outcome !== play.miss);
    state = row[2];
  }
  // Before the first cell a plant on a loop still stands at the end of the stretch behind it.
  const [first, second] = result.steps;
  if (second && first.left < second.left) first.left = second.left + 1;
  return result;
}

/** The outcome of the whole run: that of the first event, else the one for the rest. */
export function outcomeOf(play: Play, run: Drive): number {
  if (run.steps.some((step) => step.letter < 0) && run.decided < 0) return -1;
  return run.decided < 0 ? play.rest : run.outcome;
}

export function columnValue(run: Drive, step: number, column: number): number {
  const letter = run.steps[step]?.letter ?? -1;
  return letter < 0 ? 0 : run.controller.reactions[letter][column];
}

/** m/s^2 of a stop within \p cells cells from the speed of the scenario. */
export function deceleration(play: Play, cells: number): number {
  if (!play.speed || cells <= 0) return NaN;
  return (play.speed.kmh / 3.6) ** 2 / (2 * cells * play.speed.cell_metres);
}
