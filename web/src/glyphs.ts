// What stands on a sign, as strokes in a square of 100 units: enough to be told apart at the size of a thumbnail.

export interface Stroke {
  d: string;
  /** Filled instead of drawn with a line. */
  fill?: boolean;
  /** Instead of the sign's ink. */
  colour?: string;
  width?: number;
}

const RED = '#c1121f';
const line = (d: string, more: Partial<Stroke> = {}): Stroke => ({ d, ...more });
const shape = (d: string, more: Partial<Stroke> = {}): Stroke => ({ d, fill: true, ...more });
const dot = (x: number, y: number, r: number): string => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;

const person = (x: number, lean = 0): Stroke[] => [
  shape(dot(x + lean, 24, 7)),
  line(`M${x + lean} 34L${x} 56L${x - 9} 80M${x} 56L${x + 10} 80M${x - 12} 50L${x + lean} 38L${x + 13} 50`),
];
const car = (x: number, colour?: string): Stroke[] => [
  shape(`M${x - 15} 70V50L${x - 9} 36H${x + 9}L${x + 15} 50V70H${x + 9}V64H${x - 9}V70Z`, { colour }),
];

/** Tried in this order against the words of the symbol. */
const GLYPHS: [RegExp, Stroke[]][] = [
  [/arrow ahead/, [line('M50 82V24M30 44L50 22L70 44')]],
  [/arrow.* back/, [line('M66 80V44a15 15 0 0 0-30 0V68M24 56L36 70L48 56')]],
  [/arrow.* down.* right/, [line('M28 28L70 70M72 40V72H40')]],
  [/arrow.* left/, [line('M78 74V50H26M44 30L24 50L44 70')]],
  [/arrow.* right/, [line('M22 74V50H74M56 30L76 50L56 70')]],
  [/arrows in a circle/, [line('M28 40A25 25 0 0 1 70 36M72 22V40H54M75 54A25 25 0 0 1 50 76M64 84L48 76L58 62M36 70A25 25 0 0 1 25 52M14 62L26 48L38 60', { width: 7 })]],
  [/opposed arrows.*ours smaller/, [line('M34 22V72M20 58L34 74L48 58', { colour: RED, width: 10 }), line('M70 76V40M60 50L70 38L80 50', { width: 7 })]],
  [/opposed arrows/, [line('M34 32V68M24 58L34 70L44 58', { colour: RED, width: 7 }), line('M66 80V26M50 42L66 24L82 42', { width: 10 })]],
  [/bend/, [line('M36 84V62L62 46V24M48 38L62 22L76 38')]],
  [/bicycle/, [line(`${dot(28, 62, 15)}${dot(72, 62, 15)}M28 62L42 38H64L72 62M42 38L54 62L64 38M54 62H28M36 34H46M60 30H70`, { width: 5 })]],
  [/bus/, [shape('M16 26H84V70H76a8 8 0 0 1-16 0H40a8 8 0 0 1-16 0H16ZM24 34V50H38V34ZM44 34V50H58V34ZM64 34V50H78V34Z')]],
  [/narrow/, [line('M30 84V66L42 50V20M70 84V66L58 50V20')]],
  [/children/, [...person(36, 5), ...person(66, 5)]],
  [/pedestrian|person/, person(50, 4)],
  [/work/, [...person(38, 10), shape('M54 84L70 62L88 84Z')]],
  [/descend/, [shape('M16 40L84 78H16Z'), line('M46 36L74 52', { width: 6 })]],
  [/motorway/, [line('M36 84L45 20M64 84L55 20M20 42H80')]],
  [/diagonal bars/, [line('M24 82L82 24M14 72L72 14M34 90L90 34', { width: 5 })]],
  [/rock/, [shape(`M14 84L30 36L52 62L60 84Z${dot(64, 34, 8)}${dot(78, 52, 6)}${dot(70, 68, 7)}`)]],
  [/fuel/, [shape('M24 82V22H58V82ZM31 30V46H51V30Z'), line('M60 42L74 54V72a5 5 0 0 0 10 0V40L72 28', { width: 5 })]],
  [/telephone/, [line('M24 34c2 34 20 48 50 46M24 34l10-8M74 80l8-10', { width: 14 })]],
  [/oblique cross/, [line('M20 20L80 80M80 20L20 80', { colour: RED, width: 11 })]],
  [/oblique bar/, [line('M20 20L80 80', { colour: RED, width: 11 })]],
  [/cross$/, [line('M50 22V78M22 50H78', { colour: RED, width: 17 })]],
  [/crossroads/, [line('M28 28L72 72M72 28L28 72', { width: 12 })]],
  [/gate/, [line('M18 40H82M18 62H82M28 28V80M50 28V80M72 28V80', { width: 7 })]],
  [/light/, [shape(dot(50, 24, 11), { colour: RED }), shape(dot(50, 51, 11), { colour: '#e0a100' }), shape(dot(50, 78, 11), { colour: '#0b7a3b' })]],
  [/horizontal.*bar/, [shape('M12 40H88V60H12Z')]],
  [/road closed/, [line('M50 86V38', { width: 14 }), line('M26 30H74', { colour: RED, width: 14 })]],
  [/skid/, [...car(50).map((one) => ({ ...one, d: one.d.replace('M35 70', 'M35 62').replaceAll('70', '60') })), line('M36 66c-12 8 12 12 0 22M60 66c-12 8 12 12 0 22', { width: 5 })]],
  [/car beside/, [...car(30, RED), ...car(70)]],
  [/hump/, [shape('M10 72C22 72 24 46 34 46S44 64 50 64S58 46 68 46S78 72 90 72Z')]],
  [/engine|train/, [shape(`M16 70V34H40V48H62V34H72V48H84V70Z${dot(28, 74, 9)}${dot(52, 74, 9)}${dot(74, 74, 9)}`)]],
  [/deer|animal/, [line('M26 84L34 58L62 52L72 84M34 58L40 82M62 52L56 82M62 52L72 32H82M72 32L64 16M72 32L80 14', { width: 6 })]],
];

const BLANK = /blank|nothing|none/;

/** Strokes for a symbol's words; nothing where there is no picture of it, empty where it is blank. */
export function glyphFor(words: string): Stroke[] | null {
  if (BLANK.test(words)) return [];
  const found = GLYPHS.find(([pattern]) => pattern.test(words));
  if (!found) return null;
  const crossed = /crossed-out/.test(words) ? [line('M16 84L84 16', { colour: RED, width: 8 })] : [];
  return [...found[1], ...crossed];
}
