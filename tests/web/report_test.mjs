// Looks at a report in a real browser: report_test.mjs REPORT.html REPORT.json
// At 1280 and 400 pixels, light and dark: the page does not overflow, every text has a contrast of 4.5 or more against what lies
// behind it, nothing is requested, nothing is complained about, and every number of a picture is the document's.
import { readFileSync } from 'node:fs';

import { inspect, launch } from './inspect.mjs';

const MOST_SHOWN = 12;

const [file, document] = process.argv.slice(2);
if (!file || !document) {
  console.error('usage: report_test.mjs REPORT.html REPORT.json');
  process.exit(2);
}
const browser = await launch();
const results = await inspect(browser, file, JSON.parse(readFileSync(document, 'utf8')));
await browser.close();

const failed = results.filter(({ problems }) => problems.length > 0);
for (const { name, problems } of failed) {
  console.log(`FAILED ${name}`);
  for (const problem of problems.slice(0, MOST_SHOWN)) console.log(`  ${problem}`);
  if (problems.length > MOST_SHOWN) console.log(`  and ${problems.length - MOST_SHOWN} more`);
}
console.log(`${results.length - failed.length} passed, ${failed.length} failed`);
process.exit(failed.length === 0 ? 0 : 1);
