// Plays with a page in a real browser: play_test.mjs PAGE.html [HEED SCENARIO FOLDER [--flaws]]
// FOLDER holds the scenario's controllers as `heed run` wrote them. What the page shows is held against what `heed exec` answers
// to the same observations and against the exact figures of `heed simulate`; the page is also looked at, and used by keyboard alone.
// With the page alone it is only looked at. With --flaws the page is broken in one place at a time, and the check that is named must find it.
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

import { conclude, findContrast, findOverflow, launch, VIEWS } from './inspect.mjs';
import { compareProfiles, compareReactions } from './play_compare.mjs';
import { useKeyboard } from './play_keyboard.mjs';

const MOST_BYTES = 1_000_000;
const MOST_MILLISECONDS = 1000;

/** Opens \p address with everything that the page asks for or complains about written down. */
async function open(browser, address, { width = 1280, colorScheme = 'light' } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme, reducedMotion: 'reduce' });
  const page = await context.newPage();
  const heard = { requests: [], complaints: [] };
  const document = address.replace(/#.*/, '');
  page.on('request', (request) => { if (request.url().replace(/#.*/, '') !== document && !request.url().startsWith('data:')) heard.requests.push(request.url()); });
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) heard.complaints.push(message.text()); });
  page.on('pageerror', (error) => heard.complaints.push(String(error)));
  await page.goto(address, { waitUntil: 'load' });
  return { page, context, heard };
}

async function look(browser, address, views, check) {
  for (const view of views) {
    const label = `${view.width} ${view.colorScheme}`;
    const { page, context, heard } = await open(browser, address, view);
    for (const at of [0, 1]) {
      if (at === 1) {
        await page.click('#everything');
        if (await page.locator('#draw').count() > 0) await page.click('#draw');
        await page.focus('#step');
        await page.keyboard.press('End');
      }
      check(`${label}: no overflow`, await page.evaluate(findOverflow));
      check(`${label}: contrast`, await page.evaluate(findContrast));
    }
    check(`${label}: nothing is requested`, heard.requests);
    check(`${label}: no complaints`, heard.complaints);
    await context.close();
  }
}

/** A page that a link opened shows what the one showed that gave the link. */
async function share(browser, address, check) {
  const { page, context } = await open(browser, address);
  await page.selectOption('#thing', { index: 1 });
  await page.click('#everything');
  await page.click('[id^="see-"][id$="-1"]');
  await page.click('#single');
  await page.click('[id^="see-"][id$="-3"] >> nth=1');
  for (let i = 0; i < 3; ++i) await page.click('#next');
  const link = await page.inputValue('#address');
  const shown = () => document.querySelector('main').innerText.replace(/\s+/g, ' ');
  const first = await page.evaluate(shown);
  const problems = (await page.evaluate(() => location.href)) === link ? [] : ['the address is another one'];
  const other = await open(browser, link);
  await other.page.click('#everything');
  if ((await other.page.evaluate(shown)) !== first) problems.push('the link opens another run');
  if ((await other.page.evaluate(() => document.getElementById('step').value)) !== '3') problems.push('the link opens another step');
  await other.page.evaluate(() => { location.hash = '#thing=nonsense&profile=none&at=-7&see=foo.111&see=&seed=x'; });
  await other.page.waitForTimeout(50);
  check('a link restores the run', problems.concat(other.heard.complaints));
  await other.context.close();
  await context.close();
}

async function load(browser, file, address, check) {
  check('small', statSync(file).size <= MOST_BYTES ? [] : [`${statSync(file).size} bytes`]);
  const { page, context } = await open(browser, address);
  const took = await page.evaluate(() => performance.getEntriesByType('navigation')[0].loadEventEnd);
  const cards = await page.locator('[data-controller]').count();
  check('loads quickly', took > 0 && took <= MOST_MILLISECONDS && cards > 0 ? [] : [`${took.toFixed(0)} ms, ${cards} controllers`]);
  await context.close();
}

async function inspectPlay(browser, file, { heed, scenario, folder, every, views = VIEWS }, only = () => true) {
  const results = [];
  const check = (name, problems) => results.push({ name, problems });
  const address = pathToFileURL(path.resolve(file)).href;
  if (only('load')) await load(browser, file, address, check);
  if (only('look')) await look(browser, address, views, check);
  if (!heed) return results;
  if (only('share')) await share(browser, address, check);
  const { page, context } = await open(browser, address);
  if (only('reactions')) check("reactions are heed exec's", await compareReactions(page, heed, folder, every));
  if (only('profiles')) check("outcomes are heed simulate's", await compareProfiles(page, heed, scenario, folder));
  await context.close();
  if (only('keyboard')) {
    const { page: keyed, context: other } = await open(browser, address);
    check('the keyboard suffices', await useKeyboard(keyed));
    await other.close();
  }
  return results;
}

// ---- flaws -----------------------------------------------------------------------------------------------------------------

const data = (change) => (page) => page.replace(/(<script type="application\/json" id="play-data">)(.*?)(<\/script>)/s, (_, start, json, end) => {
  const play = JSON.parse(json);
  change(play);
  return start + JSON.stringify(play).replaceAll('<', '\\u003c') + end;
});
const styled = (rule) => (page) => page.replace('</style>', `${rule}</style>`);
/** The row of the first controller that answers when everything comes into view in the third cell. */
function rowOf(play) {
  const [{ states }] = play.controllers;
  let state = 0;
  for (let step = 0; step < 3; ++step) [, , state] = states[state].find(([observation]) => observation === 0);
  return states[state].at(-1);
}

const FLAWS = [
  ['another reaction', 'reactions', "reactions are heed exec's", data((play) => { rowOf(play)[1] = 0; })],
  ['another next state', 'reactions', "reactions are heed exec's", data((play) => { rowOf(play)[2] = 0; })],
  ['another label', 'reactions', "reactions are heed exec's", data((play) => { play.controllers[0].recognises[0].label += 's'; })],
  ['another outcome', 'profiles', "outcomes are heed simulate's", data((play) => { play.controllers.at(-1).states.flat().forEach((row) => { if (row[3] === 2) row[3] = 3; }); })],
  ['another probability', 'profiles', "outcomes are heed simulate's", data((play) => { const [a, b] = play.profiles[1].chains[play.profiles[1].approaches[play.profiles[1].of[play.approached]].chain][0]; [a[0], b[0]] = ['1/2', '1/6']; })],
  ['a generator that draws little', 'profiles', "outcomes are heed simulate's", (page) => page.replaceAll('2146121005', '0').replaceAll('2221713035', '0')],
  ['a wide box', 'look', 'no overflow', styled('.lede { width: 2000px; max-width: none }')],
  ['faint text', 'look', 'contrast', styled('.policy { color: #999 !important }')],
  ['a picture from elsewhere', 'look', 'nothing is requested', (page) => page.replace('<noscript>', '<img alt="" src="logo.png"><noscript>')],
  ['a script that fails', 'look', 'no complaints', (page) => page.replace('<noscript>', '<script>missing();</script><noscript>')],
  ['an invisible focus', 'keyboard', 'the keyboard suffices', styled(':focus-visible { outline: none !important }')],
  ['a button that Tab passes over', 'keyboard', 'the keyboard suffices', (page) => page.replace('</body>', '<script type="module">document.getElementById("next").tabIndex = -1</script></body>')],
  ['a silent page', 'keyboard', 'the keyboard suffices', (page) => page.replace('</body>', '<script type="module">document.getElementById("said").remove()</script></body>')],
];

async function tryFlaws(browser, file, setting) {
  const good = readFileSync(file, 'utf8');
  const results = [];
  for (const [flaw, part, name, spoil] of FLAWS) {
    const spoilt = spoil(good);
    const target = path.join(setting.folder, 'flawed_play.html');
    writeFileSync(target, spoilt);
    const found = (await inspectPlay(browser, target, setting, (one) => one === part)).some((result) => result.name.endsWith(name) && result.problems.length > 0);
    results.push({ name: flaw, problems: spoilt === good ? ['could not be made'] : found ? [] : [`"${name}" did not notice`] });
  }
  return results;
}

const [file, heed, scenario, folder, flaws] = process.argv.slice(2);
if (!file || (heed && !folder)) {
  console.error('usage: play_test.mjs PAGE.html [HEED SCENARIO FOLDER [--flaws]]');
  process.exit(2);
}
const browser = await launch();
const setting = { heed, scenario, folder };
const results = flaws === '--flaws' ? await tryFlaws(browser, file, { ...setting, every: 7, views: VIEWS.slice(-2, -1) }) : await inspectPlay(browser, file, setting);
await browser.close();
conclude(results);
