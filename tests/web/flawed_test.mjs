// Breaks a good report in one place at a time: flawed_test.mjs REPORT.html REPORT.json FOLDER
// The check that is named must find it; a test that cannot fail proves nothing.
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

import { inspect, launch } from './inspect.mjs';

const FLAWS = [
  ['a wide box', 'no overflow', (page) => page.replace('<main>', '<main><div style="width:2000px">wide</div>')],
  ['a label beyond its picture', 'no overflow', (page) => page.replace('text-anchor="end">infeasible', 'text-anchor="end">quite infeasible')],
  ['faint text', 'contrast', (page) => page.replace('</style>', '.lede { color: #999 }</style>')],
  ['faint text in a picture', 'contrast', (page) => page.replace('</style>', 'svg .tick { fill: #aaa }</style>')],
  ['text upon a bar', 'contrast', (page) => page.replace('</style>', 'svg .bar { width: 300px; fill: #444 }</style>')],
  ['small labels', 'labels readable', (page) => page.replace('</style>', 'svg .tick { font-size: 7px }</style>')],
  ['labels one upon the other', 'labels apart', (page) => page.replace('</style>', 'svg .name { transform: translateY(18px) }</style>')],
  ['a picture from elsewhere', 'nothing is requested', (page) => page.replace('<main>', '<main><img alt="" src="logo.png"/>')],
  ['a script that fails', 'no complaints', (page) => page.replace('<main>', '<main><script>missing();</script>')],
  ['another number', "numbers are the document's", (page) => page.replace('data-value="0.625"', 'data-value="0.626"')],
  ['another text', "numbers are the document's", (page) => page.replaceAll('>62.5 %<', '>61.5 %<')],
  ['a false zero', "numbers are the document's", (page) => page.replaceAll('>0.1 %<', '>0 %<')],
  ['a longer bar', "lengths are the numbers'", (page) => page.replace('width="151.2500"', 'width="161.2500"')],
  ['a shifted point', "lengths are the numbers'", (page) => page.replace(/(class="dot" cx=")(\d+)([^>]*frequency)/, (_, start, x, end) => start + (Number(x) + 3) + end)],
  ['a missing point', 'nothing is missing', (page) => page.replace(/<circle class="dot"[^>]*frequency"[^>]*>/, '')],
  ['another curve', "curves are the document's", (page) => page.replace(/(class="curve[^>]*? points="[\d.]+,[\d.]+ [\d.]+,)(\d+)/, (_, start, y) => start + (Number(y) + 9))],
  ['a table wider than paper', 'print: no overflow', (page) => page.replace('</style>', '@media print { .errors { width: 900px } }</style>')],
  ['an element left open', 'well-formed', (page) => page.replace('</h2>', '')],
];

const [file, document, folder] = process.argv.slice(2);
if (!file || !document || !folder) {
  console.error('usage: flawed_test.mjs REPORT.html REPORT.json FOLDER');
  process.exit(2);
}
const browser = await launch();
const page = readFileSync(file, 'utf8');
const json = JSON.parse(readFileSync(document, 'utf8'));
let failed = 0;
for (const [flaw, name, spoil] of FLAWS) {
  const spoilt = spoil(page);
  const target = path.join(folder, 'flawed.html');
  writeFileSync(target, spoilt);
  const results = await inspect(browser, target, json, {
    views: [{ width: 400, colorScheme: 'light' }],
    paper: ['well-formed', 'print: no overflow'].includes(name),
  });
  const found = results.some((result) => result.name.endsWith(name) && result.problems.length > 0);
  if (found && spoilt !== page) continue;
  failed += 1;
  console.log(`FAILED ${flaw}: ${spoilt === page ? 'could not be made' : `"${name}" did not notice`}`);
}
await browser.close();
console.log(`${FLAWS.length - failed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
