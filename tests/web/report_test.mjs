// Looks at a report in a real browser: report_test.mjs REPORT.html REPORT.json
// At 1280 and 400 pixels, light and dark: the page does not overflow, every text has a contrast of 4.5 or more against what lies
// behind it, nothing is requested, nothing is complained about, and every number of a picture is the document's.
import { readFileSync } from 'node:fs';

import { conclude, inspect, launch } from './inspect.mjs';

const [file, document] = process.argv.slice(2);
if (!file || !document) {
  console.error('usage: report_test.mjs REPORT.html REPORT.json');
  process.exit(2);
}
const browser = await launch();
const results = await inspect(browser, file, JSON.parse(readFileSync(document, 'utf8')));
await browser.close();
conclude(results);
