// The road and, below it in the same columns, what is seen in which cell.
import type { App } from './app';
import { h, percent, s, setText } from './dom';
import { columnValue, type Drive } from './machine';
import { placeOf, verdictOf, type Model } from './model';
import { nothingSeen, show } from './perception';
import { drawSign, lookOf } from './sign';
import type { View } from './view';

/** `k0` is the controller that the scenario is about, the others follow in their order: as in the report. */
export function colourClass(model: Model, index: number): string {
  const subject = model.play.controllers.findIndex(({ name }) => name === model.play.subject);
  if (index === subject) return 'k0';
  return `k${1 + ((index > subject ? index - 1 : index) % 4)}`;
}

export function speedWords(kmh: number): string {
  return Number.isFinite(kmh) ? `${Math.round(kmh)} km/h` : '';
}

/** What the plant is called at the step: its state and the labels that hold there. */
export function plantWords(model: Model, run: Drive, step: number): string {
  const column = run.controller.outputs.findIndex(({ role }) => role === 'plant');
  if (column < 0) return '';
  const state = columnValue(run, step, column);
  const labels = Object.entries(model.play.plant.labels).filter(([, states]) => states.includes(state)).map(([label]) => label);
  return [model.play.plant.states[state], ...labels].join(', ');
}

function drawCar(): SVGElement {
  return s('svg', { viewBox: '0 0 64 34', class: 'car', 'aria-hidden': 'true' },
    s('path', { class: 'body', d: 'M3 25V17q0-3 4-4l7-1L22 4q1-1 3-1h16q3 0 5 2l7 8 6 2q3 1 3 4v6q0 2-2 2H5q-2 0-2-2Z' }),
    s('path', { class: 'glass', d: 'M18 13L25 6h7v7ZM35 6h6l6 7H35Z' }),
    s('circle', { class: 'tyre', cx: 16, cy: 27, r: 6 }), s('circle', { class: 'tyre', cx: 48, cy: 27, r: 6 }),
    s('rect', { class: 'brake', x: 0, y: 16, width: 6, height: 6, rx: 2 }));
}

interface Lane {
  name: HTMLElement;
  status: HTMLElement;
  road: HTMLElement;
  car: HTMLElement;
  speed: HTMLElement;
  braking: HTMLElement;
}

function makeLane(model: Model, index: number): Lane {
  const status = h('span', { class: 'status' });
  const name = h('div', { class: `lane-name ${colourClass(model, index)}` }, h('strong', {}, model.play.controllers[index].title), status);
  const braking = h('div', { class: 'braking' });
  const speed = h('span', { class: 'speed' });
  const car = h('div', { class: 'vehicle' }, speed, drawCar());
  const road = h('div', { class: `road ${colourClass(model, index)}`, 'aria-hidden': 'true' }, braking, car);
  return { name, status, road, car, speed, braking };
}

/** Where a car stands, as a share of the road: in the middle of its cell. */
function shareOf(left: number, cells: number): number {
  return Math.max(0.02, (cells - left - 0.5) / cells);
}

function updateLane(model: Model, lane: Lane, run: Drive): void {
  const { at } = model.state;
  const known = Math.min(at, run.steps.length - 1);
  const step = run.steps[known];
  const left = Number.isFinite(step.left) ? step.left : model.cells - at;
  const brakes = step.outcome >= 0 && step.outcome !== model.play.miss;
  lane.car.style.left = `max(2rem, ${percent(shareOf(left, model.cells))})`;  // before the first cell it still shows its speed
  lane.car.classList.toggle('brakes', brakes);
  setText(lane.speed, speedWords(step.kmh));
  const decided = run.decided >= 0 && run.decided <= at && run.outcome !== model.play.miss;
  const from = decided ? shareOf(run.steps[run.decided].left, model.cells) : 0;
  lane.braking.hidden = !decided;
  lane.braking.style.left = percent(from);
  lane.braking.style.width = percent(Math.max(0, shareOf(left, model.cells) - from));
  const verdict = verdictOf(model, run);
  setText(lane.status, `${verdict.mark} ${verdict.words}`);
  lane.status.className = `status ${verdict.tone}`;
}

class Board {
  readonly element = h('section', { class: 'board', 'aria-label': 'The road and what is seen on it' });
  private lanes: Lane[] = [];
  private heads: HTMLElement[] = [];
  private buttons: HTMLButtonElement[][] = [];
  private rows: number[] = [];
  private shape = '';
  private focus: [number, number] = [0, 0];
  private single = false;
  private everything = false;

  constructor(private readonly app: App) {}

  update(model: Model): void {
    const rows = this.rowsOf(model);
    const shape = [model.cells, model.state.thing, rows.join(), this.everything].join('|');
    if (shape !== this.shape) {
      this.shape = shape;
      this.rows = rows;
      this.build(model);
    }
    this.heads.forEach((head, cell) => head.classList.toggle('here', cell === model.state.at - 1));
    this.lanes.forEach((lane, i) => updateLane(model, lane, model.runs[i]));
    this.updateButtons(model);
  }

  /** What the thing shows, whatever was set by hand, or everything. */
  private rowsOf(model: Model): number[] {
    const shows = new Set(model.entity?.shows ?? []);
    const all = this.everything || shows.size === 0;
    return model.play.symbols.map((_, i) => i).filter((i) => all || shows.has(i) || model.state.seen[i].some(Boolean));
  }

  private build(model: Model): void {
    const focused = this.element.contains(document.activeElement) ? document.activeElement?.id : undefined;
    this.element.style.setProperty('--cells', String(model.cells));
    const box = h('div', { class: 'scroll', tabindex: model.cells > 6 ? 0 : -1, role: 'group', 'aria-label': 'Road' });
    box.append(this.buildRoad(model), this.buildGrid(model));
    this.element.replaceChildren(box, this.buildOptions());
    if (focused) document.getElementById(focused)?.focus();
  }

  private buildRoad(model: Model): HTMLElement {
    const { play, cells, entity } = model;
    this.heads = Array.from({ length: cells }, (_, cell) => {
      const left = cells - 1 - cell;
      return h('div', { class: 'head' }, play.speed ? `${left * play.speed.cell_metres} m` : String(cell + 1));
    });
    this.lanes = play.controllers.map((_, i) => makeLane(model, i));
    const sign = entity ? drawSign(lookOf(play, entity.features), { whole: true, label: entity.label }) : h('span', { class: 'none' }, 'nothing there');
    const post = h('div', { class: 'post', style: `grid-row: 1 / span ${play.controllers.length + 1}` }, h('div', { class: 'pole' }), sign);
    return h('div', { class: 'grid lanes' }, h('div', { class: 'corner' }, play.speed ? 'way to go' : 'cell'), ...this.heads, post,
      ...this.lanes.flatMap(({ name, road }) => [name, road]));
  }

  private buildGrid(model: Model): HTMLElement {
    const { play, cells } = model;
    const shows = new Set(model.entity?.shows ?? []);
    this.buttons = this.rows.map((symbol, row) => Array.from({ length: cells }, (_, cell) => h('button', {
      type: 'button', class: 'cell', id: `see-${symbol}-${cell}`, tabindex: -1,
      click: () => this.toggle(symbol, cell), focus: () => { this.focus = [row, cell]; },
      keydown: (event: KeyboardEvent) => this.move(event, row, cell),
    })));
    const rows = this.rows.map((symbol, row) => h('div', { role: 'row', class: 'row' },
      h('div', { role: 'rowheader', class: 'see-name' }, play.symbols[symbol].label, !shows.has(symbol) && h('span', { class: 'false' }, ' (misread)')),
      ...this.buttons[row].map((button) => h('div', { role: 'gridcell' }, button))));
    const head = h('p', { class: 'see-title', id: 'see-title' }, 'What the camera sees, cell by cell');
    return h('div', {}, head, h('div', { role: 'grid', class: 'grid sees', 'aria-labelledby': 'see-title', 'aria-describedby': 'see-help' }, ...rows));
  }

  private buildOptions(): HTMLElement {
    const box = (label: string, id: string, on: boolean, change: (on: boolean) => void): HTMLElement =>
      h('label', { class: 'check', for: id }, h('input', { type: 'checkbox', id, checked: on, change: (event: Event) => change((event.target as HTMLInputElement).checked) }), label);
    return h('div', { class: 'options' },
      h('p', { id: 'see-help', class: 'soft' }, 'You are the camera: press a cell to show or hide a feature from there on, or draw a run above. Arrow keys move, Enter presses.'),
      h('div', { class: 'checks' },
        box('Single cells (flicker)', 'single', this.single, (on) => { this.single = on; }),
        box('Misreadings, too', 'everything', this.everything, (on) => { this.everything = on; this.app.refresh(); }),
        h('button', { type: 'button', id: 'clear', click: () => this.app.change({ seen: nothingSeen(this.app.play, this.app.cells()) }) }, 'Hide everything')));
  }

  private updateButtons(model: Model): void {
    const { play, state } = model;
    this.focus = [Math.min(this.focus[0], this.rows.length - 1), Math.min(this.focus[1], model.cells - 1)];
    this.buttons.forEach((row, r) => row.forEach((button, cell) => {
      const symbol = this.rows[r];
      const on = state.seen[symbol][cell];
      button.setAttribute('aria-pressed', String(on));
      button.setAttribute('aria-label', `${play.symbols[symbol].label}, ${placeOf(model, cell + 1)}: ${on ? 'seen' : 'not seen'}`);
      button.classList.toggle('here', cell === state.at - 1);
      button.tabIndex = r === this.focus[0] && cell === this.focus[1] ? 0 : -1;
    }));
  }

  private toggle(symbol: number, cell: number): void {
    const { play } = this.app;
    const seen = this.app.state().seen.map((row) => [...row]);
    const on = !seen[symbol][cell];
    const last = this.single ? cell + 1 : seen[symbol].length;
    for (let at = cell; at < last; ++at) show(play, seen, symbol, at, on);
    this.app.change({ seen });
  }

  private move(event: KeyboardEvent, row: number, cell: number): void {
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [row, cell - 1], ArrowRight: [row, cell + 1], ArrowUp: [row - 1, cell], ArrowDown: [row + 1, cell],
      Home: [row, 0], End: [row, this.buttons[row].length - 1],
    };
    const [r, c] = moves[event.key] ?? [-1, -1];
    const next = this.buttons[r]?.[c];
    if (!next) return;
    event.preventDefault();
    this.buttons[row][cell].tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
  }
}

export function board(app: App): View {
  return new Board(app);
}
