// A thing of the catalogue drawn from its features: shape, colours, symbol and text where they say so, else a plain plate with
// their words.
import type { Play } from './data';
import { s } from './dom';
import { glyphFor, type Stroke } from './glyphs';

/** What is known of how a thing looks; empty: unknown. */
export interface Look {
  shape: string;
  main: string;
  ground: string;
  border: string;
  symbol: string;
  text: string;
  /** Features that are none of these. */
  words: string[];
}

const COLOURS: Record<string, string> = {
  red: '#c1121f', blue: '#0b559f', green: '#0a6b3d', yellow: '#f2b705', white: '#ffffff', black: '#16181a', orange: '#e07a00', brown: '#6f4320', grey: '#8a8d91', gray: '#8a8d91',
};
const DARK = new Set(['red', 'blue', 'green', 'black', 'brown']);
const UNKNOWN = '#a4a7ab';

export function lookOf(play: Play, features: number[]): Look {
  const look: Look = { shape: '', main: '', ground: '', border: '', symbol: '', text: '', words: [] };
  for (const index of features) {
    const { aspect, value, label } = play.features[index];
    if (/shape/.test(aspect)) look.shape = value;
    else if (/ground/.test(aspect)) look.ground = value;
    else if (/border/.test(aspect)) look.border = value;
    else if (/colou?r/.test(aspect)) look.main = value;
    else if (/symbol/.test(aspect)) look.symbol = value;
    else if (/text/.test(aspect)) look.text = value;
    else look.words.push(label);
  }
  return look;
}

function looksLikeSign(look: Look): boolean {
  return look.shape !== '' || look.main !== '' || look.ground !== '';
}

interface Outline {
  /** The plate, shrunk towards its middle by `scale`. */
  plate: (scale: number, attributes: Record<string, string | number>) => SVGElement;
  /** Middle and size of what stands on it. */
  middle: number;
  room: number;
}

function polygon(corners: [number, number][], middle: [number, number]): Outline['plate'] {
  return (scale, attributes) => {
    const points = corners.map(([x, y]) => `${(middle[0] + (x - middle[0]) * scale).toFixed(1)},${(middle[1] + (y - middle[1]) * scale).toFixed(1)}`);
    return s('polygon', { points: points.join(' '), 'stroke-linejoin': 'round', ...attributes });
  };
}

function ring(count: number, turn: number): [number, number][] {
  return Array.from({ length: count }, (_, i) => {
    const angle = ((i + turn) * 2 * Math.PI) / count;
    return [50 + 48 * Math.cos(angle), 50 + 48 * Math.sin(angle)];
  });
}

function outlineOf(shape: string): Outline {
  if (/octagon/.test(shape)) return { plate: polygon(ring(8, 0.5), [50, 50]), middle: 50, room: 0.8 };
  if (/invert|down/.test(shape)) return { plate: polygon([[3, 10], [97, 10], [50, 92]], [50, 37.3]), middle: 36, room: 0.42 };
  if (/triang/.test(shape)) return { plate: polygon([[50, 7], [97, 89], [3, 89]], [50, 61.7]), middle: 63, room: 0.46 };
  if (/diamond|rhomb/.test(shape)) return { plate: polygon(ring(4, 0), [50, 50]), middle: 50, room: 0.55 };
  if (/rect|square/.test(shape)) return { plate: polygon([[8, 8], [92, 8], [92, 92], [8, 92]], [50, 50]), middle: 50, room: 0.84 };
  const disc: Outline['plate'] = (scale, attributes) => s('circle', { cx: 50, cy: 50, r: (47 * scale).toFixed(1), ...attributes });
  return { plate: disc, middle: 50, room: 0.66 };
}

function drawStrokes(strokes: Stroke[], ink: string, outline: Outline): SVGElement {
  const group = s('g', { transform: `translate(${50 - 50 * outline.room} ${outline.middle - 50 * outline.room}) scale(${outline.room})` });
  for (const stroke of strokes) {
    const colour = stroke.colour ?? ink;
    group.append(stroke.fill
      ? s('path', { d: stroke.d, fill: colour, 'fill-rule': 'evenodd' })
      : s('path', { d: stroke.d, fill: 'none', stroke: colour, 'stroke-width': stroke.width ?? 9, 'stroke-linejoin': 'round' }));
  }
  return group;
}

/** Long words of a sign in lines, short ones as they stand. */
function linesOf(text: string): string[] {
  if (text.length <= 7) return [text];
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const last = lines[lines.length - 1];
    if (last !== undefined && `${last} ${word}`.length <= 8) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

function drawText(words: string, ink: string, outline: Outline): SVGElement {
  const lines = linesOf(words.replace(/^(word|number|letter|text) /, ''));
  const longest = Math.max(2, ...lines.map((line) => line.length));
  const size = Math.min(46, (128 * outline.room) / longest, (92 * outline.room) / lines.length);
  return s('g', {}, ...lines.map((line, i) => s('text', {
    x: 50, y: (outline.middle + size * (0.36 + 1.05 * (i - (lines.length - 1) / 2))).toFixed(1),
    'text-anchor': 'middle', 'font-size': size.toFixed(1), 'font-weight': 700, style: `fill:${ink}`,
  }, line)));
}

function fallbackPlate(look: Look): SVGElement[] {
  const words = look.words.slice(0, 4).map((word) => word.slice(0, 14));
  const size = Math.min(16, 130 / Math.max(...words.map((word) => word.length)));
  return [
    s('rect', { x: 6, y: 6, width: 88, height: 88, rx: 10, class: 'plain' }),
    ...words.map((word, i) => s('text', { x: 50, y: 54 + 17 * (i - (words.length - 1) / 2), 'text-anchor': 'middle', 'font-size': size.toFixed(1), class: 'plain-text' }, word)),
  ];
}

function drawPlate(look: Look, whole: boolean): SVGElement[] {
  const outline = outlineOf(look.shape);
  const known = look.shape !== '';
  const ground = COLOURS[look.ground] ?? COLOURS[look.main] ?? UNKNOWN;
  const rim = COLOURS[look.border] ?? ground;
  const edge = { stroke: 'var(--outline)', 'stroke-width': 2, ...(known || whole ? {} : { 'stroke-dasharray': '7 6' }) };
  const parts = [outline.plate(known ? 1 : 0.92, { fill: rim, ...edge })];
  if (rim !== ground) parts.push(outline.plate(/triang/.test(look.shape) ? 0.68 : look.border === 'red' ? 0.78 : 0.9, { fill: ground }));
  const ink = DARK.has(look.ground || look.main) ? '#ffffff' : '#16181a';
  const glyph = look.symbol ? glyphFor(look.symbol) : [];
  if (glyph && glyph.length > 0) parts.push(drawStrokes(glyph, ink, outline));
  if (look.text) parts.push(drawText(look.text, ink, outline));
  return parts;
}

/** Nothing is known but that something is there. */
function drawUnknown(there: boolean): SVGElement[] {
  return [
    s('circle', { cx: 50, cy: 50, r: 43, class: there ? 'unsure' : 'nothing', 'stroke-dasharray': '7 6' }),
    s('text', { x: 50, y: 64, 'text-anchor': 'middle', 'font-size': 42, 'font-weight': 600, class: there ? 'unsure-text' : 'nothing-text' }, there ? '?' : '·'),
  ];
}

export interface SignOptions {
  label?: string;
  /** Of something that may be there and of which nothing is known: false when not even that it is there. */
  there?: boolean;
  whole?: boolean;
}

/** \p label empty: decoration that a screen reader passes over. */
export function drawSign(look: Look | null, options: SignOptions = {}): SVGElement {
  const picture = s('svg', { viewBox: '0 0 100 100', class: 'sign', ...(options.label ? { role: 'img', 'aria-label': options.label } : { 'aria-hidden': 'true' }) });
  if (!look) picture.append(...drawUnknown(options.there ?? false));
  else if (looksLikeSign(look)) picture.append(...drawPlate(look, options.whole ?? false));
  else if (look.words.length > 0) picture.append(...fallbackPlate(look));
  else picture.append(...drawUnknown(true));
  return picture;
}
