// What is asked of a report in a real browser; see report_test.mjs. Each check is a name and a list of problems.
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

import { compareCurves, compareLengths, compareNumbers, findMissing } from './compare.mjs';

const SKIPPED = 77;
const MOST_SHOWN = 12;
const BROWSER = process.env.HEED_CHROMIUM ?? '/usr/bin/chromium';
const FLAGS = [
  '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

export const VIEWS = [1280, 400].flatMap((width) => ['light', 'dark'].map((colorScheme) => ({ width, colorScheme })));

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(SKIPPED);
}

export async function launch() {
  if (!existsSync(BROWSER)) skip(`no browser at ${BROWSER}`);
  try {
    const { chromium } = await import('playwright-core');
    return await chromium.launch({ executablePath: BROWSER, args: FLAGS });
  } catch (error) {
    if (error.code === 'ERR_MODULE_NOT_FOUND') skip('playwright-core is missing: run `npm ci` in tests/web');
    throw error;
  }
}

// ---- run inside the page ---------------------------------------------------------------------------------------------

export function findOverflow() {
  const width = document.documentElement.clientWidth;
  const problems = [];
  if (document.documentElement.scrollWidth > width) problems.push(`page is ${document.documentElement.scrollWidth} wide`);
  const boxed = (element) => element.closest('.scroll') !== null;
  for (const element of document.body.querySelectorAll('*')) {
    if (boxed(element) && !element.classList.contains('scroll')) continue;
    const box = element.getBoundingClientRect();
    if (box.width > 0 && (box.right > width + 0.5 || box.left < -0.5))
      problems.push(`<${element.tagName.toLowerCase()} class="${element.getAttribute('class') ?? ''}"> reaches ${box.right.toFixed(1)}`);
  }
  for (const svg of document.querySelectorAll('svg.chart')) {
    const frame = svg.getBoundingClientRect();
    for (const text of svg.querySelectorAll('text')) {
      const box = text.getBoundingClientRect();
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        problems.push(`label "${text.textContent}" leaves its picture`);
    }
  }
  return problems;
}

function findCollisions() {
  const problems = [];
  for (const svg of document.querySelectorAll('svg.chart')) {
    const boxes = [...svg.querySelectorAll('text')].map((text) => [text.textContent, text.getBoundingClientRect()]);
    for (let i = 0; i < boxes.length; ++i)
      for (let j = i + 1; j < boxes.length; ++j) {
        const [a, b] = [boxes[i][1], boxes[j][1]];
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        // Line boxes of neighbouring rows touch; letters do not until a third of the line is shared.
        if (across > 0.5 && down > a.height / 3) problems.push(`labels "${boxes[i][0]}" and "${boxes[j][0]}" overlap`);
      }
  }
  return problems;
}

function findTooSmall() {
  const problems = [];
  for (const text of document.querySelectorAll('svg text')) {
    const scale = text.getScreenCTM().a;
    const size = parseFloat(getComputedStyle(text).fontSize) * scale;
    if (size < 10) problems.push(`"${text.textContent}" is ${size.toFixed(1)} px`);
  }
  return problems;
}

export function findContrast() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 1;
  const pen = canvas.getContext('2d', { willReadFrequently: true });
  const rgba = (colour) => {
    pen.clearRect(0, 0, 1, 1);
    pen.fillStyle = colour;
    pen.fillRect(0, 0, 1, 1);
    const [r, g, b, a] = pen.getImageData(0, 0, 1, 1).data;
    return [r, g, b, a / 255];
  };
  const over = (top, below) => [0, 1, 2].map((i) => top[i] * top[3] + below[i] * (1 - top[3])).concat(1);
  const luminance = ([r, g, b]) => {
    const [x, y, z] = [r, g, b].map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const ratio = (a, b) => {
    const [light, dark] = [luminance(a), luminance(b)].sort((x, y) => y - x);
    return (light + 0.05) / (dark + 0.05);
  };
  const background = (element) => {
    const layers = [];
    for (let at = element; at; at = at.parentElement) layers.push(rgba(getComputedStyle(at).backgroundColor));
    return layers.reduceRight((below, layer) => over(layer, below), [255, 255, 255, 1]);
  };
  // What is painted before an SVG text and lies under it is its background as well; alone, where it covers all of it.
  const painted = (text) => {
    const box = text.getBoundingClientRect();
    let under = [background(text.ownerSVGElement)];
    for (const shape of text.ownerSVGElement.querySelectorAll('rect, circle, polygon')) {
      const other = shape.getBoundingClientRect();
      const before = shape.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING;
      const across = Math.min(box.right, other.right) - Math.max(box.left, other.left);
      const down = Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top);
      if (!before || across <= 1 || down <= 3) continue;
      const fill = rgba(getComputedStyle(shape).fill);
      const covers = fill[3] === 1 && across >= box.width - 0.5 && down >= 0.7 * box.height;
      under = covers ? [fill] : under.concat([over(fill, under[0])]);
    }
    return under;
  };
  const problems = [];
  let looked = 0;
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (!node.textContent.trim() || element.closest('title, desc, style')) continue;
    const svg = element.ownerSVGElement;
    const colour = rgba(svg ? getComputedStyle(element).fill : getComputedStyle(element).color);
    for (const below of svg ? painted(element) : [background(element)]) {
      const found = ratio(over(colour, below), below);
      if (found < 4.5) problems.push(`"${node.textContent.trim().slice(0, 40)}" has ${found.toFixed(2)}`);
    }
    looked += 1;
  }
  if (looked < 50) problems.push(`only ${looked} texts found`);
  return problems;
}

function readNumbers() {
  return [...document.querySelectorAll('[data-path]')].map((element) => ({
    path: element.dataset.path,
    value: element.dataset.value,
    text: element.tagName === 'rect' ? null : (element.firstChild?.textContent ?? ''),
    tag: element.tagName.toLowerCase(),
    x: element.getAttribute('cx') ?? element.getAttribute('x1'),
    width: element.getAttribute('width'),
  }));
}

function readCurves() {
  return [...document.querySelectorAll('[data-points]')].map((element) => ({
    path: element.dataset.points,
    points: element.getAttribute('points').split(' ').map((pair) => pair.split(',').map(Number)),
  }));
}

// ---- the run -------------------------------------------------------------------------------------------------------------

async function look(browser, html, json, { width, colorScheme }, check) {
  const label = `${width} ${colorScheme}`;
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
  const page = await context.newPage();
  const requests = [];
  const complaints = [];
  page.on('request', (request) => requests.push(request.url()));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.goto(html, { waitUntil: 'load' });
  await page.evaluate(() => document.querySelectorAll('details').forEach((fold) => { fold.open = true; }));
  check(`${label}: nothing is requested`, requests.filter((url) => url !== html && !url.startsWith('data:')));
  check(`${label}: no complaints`, complaints);
  check(`${label}: no overflow`, await page.evaluate(findOverflow));
  check(`${label}: labels apart`, await page.evaluate(findCollisions));
  check(`${label}: labels readable`, await page.evaluate(findTooSmall));
  check(`${label}: contrast`, await page.evaluate(findContrast));
  const numbers = await page.evaluate(readNumbers);
  check(`${label}: numbers are the document's`, compareNumbers(numbers, json));
  check(`${label}: lengths are the numbers'`, compareLengths(numbers));
  check(`${label}: nothing is missing`, findMissing(numbers, json));
  check(`${label}: curves are the document's`, compareCurves(await page.evaluate(readCurves), json));
  await context.close();
}

/** Strict reading: a page that is not well formed shows an error instead. Scripts are off, since none is needed. */
async function readAsXml(browser, file, check) {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.route('http://report.invalid/**', (route) =>
    route.fulfill({ contentType: 'application/xhtml+xml; charset=utf-8', body: readFileSync(file) }));
  await page.goto('http://report.invalid/report.xhtml');
  check('well-formed', (await page.locator('parsererror').count()) === 0 ? [] : [await page.locator('parsererror').innerText()]);
  check('has a heading', (await page.locator('h1').count()) === 1 ? [] : ['no single h1']);
  await context.close();
}

/** A4 less its margins; folded lists unfold on paper, and dark readers print on white. */
async function lookAtPrint(browser, html, check) {
  const context = await browser.newContext({ viewport: { width: 680, height: 980 }, colorScheme: 'dark' });
  const page = await context.newPage();
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  await page.goto(html, { waitUntil: 'load' });
  await page.evaluate(() => document.querySelectorAll('details').forEach((fold) => { fold.open = false; }));
  check('print: no overflow', await page.evaluate(() => {
    const [found, room] = [document.documentElement.scrollWidth, document.documentElement.clientWidth];
    return found > room ? [`page is ${found} wide, paper ${room}`] : [];
  }));
  check('print: nothing is folded', await page.evaluate(() =>
    [...document.querySelectorAll('details > .list')].filter((list) => list.getBoundingClientRect().height === 0).map((list) => list.textContent)));
  check('print: contrast', await page.evaluate(findContrast));
  await context.close();
}

/** All checks of one page in the given views, as {name, problems}; `paper`: in print and as XML, too. */
export async function inspect(browser, file, json, { views = VIEWS, paper = true } = {}) {
  const results = [];
  const check = (name, problems) => results.push({ name, problems });
  const html = pathToFileURL(path.resolve(file)).href;
  for (const view of views) await look(browser, html, json, view, check);
  if (paper) {
    await lookAtPrint(browser, html, check);
    await readAsXml(browser, file, check);
  }
  return results;
}

/** Says what failed, and ends the program: 0 where nothing did. */
export function conclude(results) {
  const failed = results.filter(({ problems }) => problems.length > 0);
  for (const { name, problems } of failed) {
    console.log(`FAILED ${name}`);
    for (const problem of problems.slice(0, MOST_SHOWN)) console.log(`  ${problem}`);
    if (problems.length > MOST_SHOWN) console.log(`  and ${problems.length - MOST_SHOWN} more`);
  }
  console.log(`${results.length - failed.length} passed, ${failed.length} failed`);
  process.exit(failed.length === 0 ? 0 : 1);
}
