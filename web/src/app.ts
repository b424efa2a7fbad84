// The one place where the state lives; views read a model of it and ask for changes.
import type { Play } from './data';
import { cellsOf, fromHash, toHash, type State } from './link';
import { indexObservations } from './machine';
import { derive, type Model } from './model';
import { nothingSeen, sample, type Seen } from './perception';
import type { View } from './view';

const TICK = 900;
const SEEDS = 2 ** 32;

export class App {
  private current: State;
  private views: View[] = [];
  private timer: ReturnType<typeof setInterval> | undefined;
  private readonly index: Map<string, number>;

  constructor(readonly play: Play) {
    this.index = indexObservations(play);
    this.current = fromHash(play, location.hash);
    if (location.hash === '') this.current.seen = this.firstLook(this.current.thing, this.current.seed);
    window.addEventListener('hashchange', () => {
      if (location.hash === toHash(this.play, this.current)) return;
      this.pause();
      this.current = fromHash(this.play, location.hash);
      this.refresh();
    });
  }

  state(): Readonly<State> {
    return this.current;
  }

  cells(): number {
    return cellsOf(this.play, this.current.profile);
  }

  model(): Model {
    return derive(this.play, this.current, this.index);
  }

  show(views: View[]): void {
    this.views = views;
    this.refresh();
  }

  refresh(): void {
    const model = this.model();
    for (const view of this.views) view.update(model);
  }

  change(part: Partial<State>): void {
    this.current = { ...this.current, ...part };
    // replaceState: going back in the browser leaves the page instead of undoing every step.
    history.replaceState(null, '', toHash(this.play, this.current));
    this.refresh();
  }

  link(): string {
    return location.href.replace(/#.*/, '') + toHash(this.play, this.current);
  }

  /** What was seen of the one thing makes no sense of the other: it is drawn anew, where there is a profile. */
  choose(thing: number): void {
    this.pause();
    this.change({ thing, seen: this.firstLook(thing, this.current.seed), at: 0 });
  }

  private firstLook(thing: number, seed: number): Seen {
    const profile = this.play.profiles[this.current.profile];
    return profile ? sample(this.play, profile, thing, seed) : nothingSeen(this.play, this.cells());
  }

  takeProfile(profile: number): void {
    this.pause();
    const cells = cellsOf(this.play, profile);
    this.current = { ...this.current, profile, seen: nothingSeen(this.play, cells), at: 0 };
    this.draw(this.current.seed);
  }

  draw(seed: number): void {
    const profile = this.play.profiles[this.current.profile];
    if (!profile || !Number.isFinite(seed)) return;
    const whole = ((Math.trunc(seed) % SEEDS) + SEEDS) % SEEDS;
    this.pause();
    this.change({ seed: whole, seen: sample(this.play, profile, this.current.thing, whole), at: 0 });
  }

  step(by: number): void {
    this.pause();
    this.change({ at: Math.min(this.cells(), Math.max(0, this.current.at + by)) });
  }

  reset(): void {
    this.pause();
    this.change({ at: 0 });
  }

  playing(): boolean {
    return this.timer !== undefined;
  }

  toggle(): void {
    if (this.playing()) {
      this.pause();
      this.refresh();
      return;
    }
    if (this.current.at === this.cells()) this.change({ at: 0 });
    this.timer = setInterval(() => this.tick(), TICK);
    this.refresh();
  }

  private tick(): void {
    const at = this.current.at + 1;
    if (at >= this.cells()) this.pause();
    this.change({ at: Math.min(at, this.cells()) });
  }

  private pause(): void {
    clearInterval(this.timer);
    this.timer = undefined;
  }
}
