// Why a controller does what it does: from what is seen over evidence to what is recognised, what that prescribes, and what the
// plant then does; each with the axioms behind it.
import type { Axiom, Play, Prescribed, Sigma } from './data';
import { columnValue, type Drive } from './machine';

export interface Reason {
  sentence: string;
  formula: string;
  axioms: (Axiom & { id: string })[];
}

/** Names that are true at the step: symbols that are seen, and Boolean columns such as levels of a tree. */
export function trueNames(play: Play, run: Drive, step: number, seen: Set<number>): Set<string> {
  const names = new Set([...seen].map((symbol) => play.symbols[symbol].name));
  run.controller.outputs.forEach((output, column) => {
    if (output.role === 'memory' && output.type === 'boolean' && columnValue(run, step, column) !== 0) names.add(output.name);
  });
  return names;
}

export function recognisedAt(run: Drive, step: number): string[] {
  return run.controller.recognises.filter(({ column }) => columnValue(run, step, column) !== 0).map(({ label }) => label);
}

export function prescribedAt(run: Drive, step: number): Prescribed[] {
  return run.controller.prescribes.filter(({ column }) => columnValue(run, step, column) !== 0);
}

function joined(words: string[]): string {
  return words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words[words.length - 1]}`;
}

/** At most \p most names, and how many there are besides. */
export function shortened(words: string[], most: number): string {
  return words.length <= most + 1 ? joined(words) : `${words.slice(0, most).join(', ')} and ${words.length - most} more`;
}

class Explainer {
  constructor(private readonly play: Play, private readonly run: Drive, private readonly names: Set<string>) {}

  /** The smallest evidence that is there now. */
  recognition(column: number): Reason | null {
    const what = this.run.controller.recognises.find((one) => one.column === column);
    const found = what?.evidence.find(({ atoms }) => atoms.every((atom) => this.names.has(atom)));
    if (!what || !found) return null;
    const words = joined(found.atoms.map((atom) => this.wordsFor(atom)));
    return { sentence: `${words.charAt(0).toUpperCase()}${words.slice(1)}: that counts as ‘${what.label}’.`, ...this.grounds(found.axioms, found.sigma) };
  }

  /** The first cause in full, the others by name: where a whole catalogue is recognised, twenty alike say no more. */
  prescription(what: Prescribed, step: number): Reason[] {
    const causes = what.because.filter(({ column }) => columnValue(this.run, step, column) !== 0);
    const reasons: Reason[] = [];
    if (causes.length > 0) {
      const [{ column, axioms, sigma }, ...others] = causes;
      const recognition = this.recognition(column);
      if (recognition) reasons.push(recognition);
      reasons.push({ sentence: `\u2018${this.labelOf(column)}\u2019 prescribes to ${what.label}.`, ...this.grounds(axioms, sigma) });
      const rest = others.map((other) => `\u2018${this.labelOf(other.column)}\u2019`);
      if (rest.length > 0) reasons.push({ sentence: `So ${rest.length > 1 ? 'do' : 'does'} ${shortened(rest, 4)}, recognised as well.`, formula: '', axioms: [] });
    } else {
      reasons.push({ sentence: this.run.controller.outputs[what.column].comment ?? what.label, formula: '', axioms: [] });
    }
    if (what.effect) reasons.push({ sentence: `To ${what.label} is bound to \u201c${what.effect}\u201d.`, formula: '', axioms: [] });
    return reasons;
  }

  private labelOf(column: number): string {
    return this.run.controller.recognises.find((one) => one.column === column)?.label ?? '';
  }

  private wordsFor(atom: string): string {
    const symbol = this.play.symbols.find(({ name }) => name === atom);
    if (!symbol) return this.run.controller.outputs.find(({ name }) => name === atom)?.comment || `‘${atom}’`;
    return symbol.kind === 'whole' ? `${symbol.label} is read` : `‘${symbol.label}’ is seen`;
  }

  private grounds(ids: string[], sigma: string): { formula: string; axioms: Reason['axioms'] } {
    const formula: Sigma | undefined = this.run.controller.sigma.find(({ id }) => id === sigma);
    const axioms = ids.filter((id) => this.play.axioms[id]).map((id) => ({ id, ...this.play.axioms[id] }));
    return { formula: formula ? `${formula.id}  ${formula.text}` : '', axioms };
  }
}

/** Why the bound behaviours that are prescribed now are prescribed; empty while there are none. */
export function reasonsAt(play: Play, run: Drive, step: number, seen: Set<number>): Reason[] {
  if ((run.steps[step]?.letter ?? -1) < 0) return [];
  const explainer = new Explainer(play, run, trueNames(play, run, step, seen));
  const bound = prescribedAt(run, step).filter(({ effect }) => effect !== '');
  return bound.flatMap((what) => explainer.prescription(what, step));
}

/** Behaviours that are prescribed and bound to nothing of the plant. */
export function adviceAt(run: Drive, step: number): string[] {
  return prescribedAt(run, step).filter(({ effect }) => effect === '').map(({ label }) => label);
}
