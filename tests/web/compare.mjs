// The numbers of a page against those of the JSON document. Each comparison gives a list of problems.

function lookup(json, pointer) {
  return pointer.split('/').slice(1).reduce((value, key) => value?.[key.replaceAll('~1', '/').replaceAll('~0', '~')], json);
}

/** The figure that a reader sees, against the number it stands for; true where the text shows no share. */
function shows(text, value) {
  const words = text.replaceAll('\u00a0', ' ').trim();
  const match = /^([<>]?)([\d.]+)(?: %)?$/.exec(words);
  if (!match) return true;
  if (match[1] === '<') return value > 0 && value < 0.0005;
  if (match[1] === '>') return value < 1 && value > 0.9994999;
  const exact = (value === 0) === (match[2] === '0') && (value === 1) === (match[2] === '100');
  return exact && Math.abs(Number(match[2]) / 100 - value) <= 0.000501;
}

export function compareNumbers(numbers, json) {
  const problems = [];
  for (const number of numbers) {
    const expected = lookup(json, number.path);
    if (typeof expected !== 'number') problems.push(`${number.path}: no such number in the document`);
    else if (Number(number.value) !== expected) problems.push(`${number.path}: page ${number.value}, document ${expected}`);
    else if (/exact\/value$|encounters/.test(number.path) && number.text !== null && !shows(number.text, expected))
      problems.push(`${number.path}: shown as ${number.text}, is ${expected}`);
  }
  return problems;
}

export function compareLengths(numbers) {
  const bars = numbers.filter((number) => number.tag === 'rect' && Number(number.value) > 0);
  const scales = bars.map((bar) => Number(bar.width) / Number(bar.value));
  const problems = bars.filter((_, i) => Math.abs(scales[i] / scales[0] - 1) > 0.01).map((bar) => `${bar.path}: length is off`);
  const left = (mark) => Number(mark.x) - scales[0] * Number(mark.value);
  const marks = numbers.filter((number) => /\/(frequency|low|high)$/.test(number.path));
  for (const mark of marks) if (Math.abs(left(mark) - left(marks[0])) > 0.05) problems.push(`${mark.path}: stands in the wrong place`);
  return problems;
}

/** Every bar, sampled point and interval of the document is on the page. */
export function findMissing(numbers, json) {
  const there = new Set(numbers.map((number) => number.path));
  const wanted = [];
  json.charts.forEach((chart, c) => chart.bars.forEach((bar, b) => {
    wanted.push(`/charts/${c}/bars/${b}/exact/value`);
    if (chart.traces > 0 && (bar.sampled > 0 || bar.exact.value > 0))
      for (const key of ['frequency', 'low', 'high']) wanted.push(`/charts/${c}/bars/${b}/${key}`);
  }));
  json.catalogue.forEach((entry, e) => entry.encounters.forEach((encounter, i) => {
    const kind = encounter.miss ? 'miss' : encounter.needless ? 'needless' : 'stop';
    wanted.push(`/catalogue/${e}/encounters/${i}/${kind}/value`);
  }));
  json.speed.curves.forEach((_, c) => wanted.push(`/speed/curves/${c}/deceleration`));
  return wanted.filter((pointer) => !there.has(pointer)).map((pointer) => `${pointer} is not on the page`);
}

export function compareCurves(curves, json) {
  const problems = [];
  if (curves.length !== json.speed.curves.length) problems.push(`${curves.length} curves`);
  const all = curves.flatMap((curve) => {
    const points = lookup(json, curve.path);
    if (points.length !== curve.points.length) problems.push(`${curve.path}: ${curve.points.length} points`);
    return points.map((point, i) => [point, curve.points[i] ?? [NaN, NaN]]);
  });
  if (all.length === 0) return problems;
  // One affine map takes metres and km/h to the picture: fixed by two points, it must fit them all.
  const farthest = all.reduce((a, b) => (b[0].metres_to_sign > a[0].metres_to_sign ? b : a));
  const nearest = all.reduce((a, b) => (b[0].metres_to_sign < a[0].metres_to_sign ? b : a));
  const share = (value, key) => (value - nearest[0][key]) / (farthest[0][key] - nearest[0][key]);
  for (const [point, [x, y]] of all) {
    const right = nearest[1][0] + share(point.metres_to_sign, 'metres_to_sign') * (farthest[1][0] - nearest[1][0]);
    const down = nearest[1][1] + share(point.kmh, 'kmh') * (farthest[1][1] - nearest[1][1]);
    if (!(Math.abs(right - x) < 0.05 && Math.abs(down - y) < 0.05)) problems.push(`point ${point.metres_to_sign} m, ${point.kmh} km/h is off`);
  }
  return problems;
}
