// What the program writes into the page: docs/formats/play.md.

export type Domain = 'boolean' | string[] | [number, number];

export interface Variable {
  name: string;
  type: Domain;
  comment?: string;
}

export type Role = 'action' | 'output' | 'plant' | 'memory' | 'recognised' | 'prescribed';

export interface Column extends Variable {
  role: Role;
}

/** One thing that perception can report: that an input has a value. */
export interface Symbol {
  name: string;
  label: string;
  kind: 'feature' | 'group' | 'whole' | 'missing' | 'view';
  input: number;
  value: number;
  feature?: number;
  entity?: number;
}

export interface Feature {
  label: string;
  /** The role that binds it, such as "shape"; empty for a class. */
  aspect: string;
  value: string;
}

export interface Entity {
  name: string;
  label: string;
  group: string;
  features: number[];
  prescribes: string[];
  react: 'must' | 'may' | '';
  /** Symbols that can rightly be seen of it. */
  shows: number[];
}

export interface Plant {
  states: string[];
  labels: Record<string, number[]>;
  values: Record<string, number[]>;
  /** The value that tells how many cells are left; empty: none does. */
  way: string;
}

/** Probability as a fraction, next state, indices of the profile's features that are reported. */
export type Draw = [string, number, number[]];

export interface Profile {
  name: string;
  title: string;
  cells: number;
  lines: string[];
  chains: Draw[][][];
  /** What is drawn for a thing: a chain, and the symbol that each of the profile's features shows. */
  approaches: { chain: number; symbols: number[] }[];
  /** Per entity, then for nothing there. */
  of: number[];
}

export interface Axiom {
  text: string;
  file: string;
  line: number;
}

export interface Evidence {
  atoms: string[];
  axioms: string[];
  sigma: string;
}

export interface Recognised {
  column: number;
  label: string;
  evidence: Evidence[];
}

export interface Prescribed {
  column: number;
  label: string;
  /** The plant formula it is bound to; empty: advice only. */
  effect: string;
  because: { column: number; axioms: string[]; sigma: string }[];
}

export interface Sigma {
  id: string;
  kind: string;
  text: string;
  sentence: string;
  axioms: string[];
}

/** Observation, reaction, next state, then (where not -1) the outcome of an event here, then 1 for a fallback. */
export type Row = [number, number, number, number?, number?];

export interface Controller {
  name: string;
  title: string;
  policy: string;
  beside: boolean;
  assumptions: string[];
  notes: string[];
  outputs: Column[];
  /** One value per column, once read. */
  reactions: number[][];
  states: Row[][];
  recognises: Recognised[];
  prescribes: Prescribed[];
  sigma: Sigma[];
}

export interface Play {
  heed: string;
  version: number;
  scenario: string;
  description: string;
  thing: string;
  kind: string;
  /** Index of the entity that approaches first; -1: nothing. */
  approached: number;
  seed: number;
  cells: number;
  subject: string;
  inputs: Variable[];
  symbols: Symbol[];
  features: Feature[];
  entities: Entity[];
  plant: Plant;
  speed: { cell_metres: number; kmh: number } | null;
  event: string;
  outcomes: string[];
  rest: number;
  miss: number;
  profiles: Profile[];
  observations: number[][];
  candidates: { sets: number[][]; of: number[] } | null;
  axioms: Record<string, Axiom>;
  controllers: Controller[];
  versions: { name: string; version: string }[];
}

/** Pairs of column and value; what is not mentioned is 0. */
function spread(pairs: number[], columns: number): number[] {
  const letter = new Array<number>(columns).fill(0);
  for (let i = 0; i < pairs.length; i += 2) letter[pairs[i]] = pairs[i + 1];
  return letter;
}

export function readPlay(): Play {
  const play = JSON.parse(document.getElementById('play-data')?.textContent ?? '{}') as Play;
  if (play.heed !== 'play' || play.version !== 1) throw new Error('the page carries no data that it knows');
  for (const controller of play.controllers)
    controller.reactions = controller.reactions.map((pairs) => spread(pairs, controller.outputs.length));
  return play;
}

/** A value as the controller files write it. */
export function printed(domain: Domain, value: number): string {
  if (domain === 'boolean') return value === 0 ? 'false' : 'true';
  return typeof domain[0] === 'string' ? String(domain[value]) : String(value);
}
