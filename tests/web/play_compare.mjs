// What a page shows against what the program says of the same observations. Each comparison gives a list of problems.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';

const DRAWS = 600;

async function readData(page) {
  return page.evaluate(() => JSON.parse(document.getElementById('play-data').textContent));
}

function hashOf(play, thing, profile, seen, at) {
  const parts = new URLSearchParams({ thing: play.entities[thing].name, at: String(at) });
  if (profile) parts.set('profile', profile);
  seen.forEach((row, symbol) => parts.append('see', `${play.symbols[symbol].name}.${row.map(Number).join('')}`));
  return `#${parts}`;
}

// ---- run inside the page -----------------------------------------------------------------------------------------------------

/** Opens each address in turn and gives what every card shows there. Told as a browser tells it, which takes ten times as long. */
function visit(addresses) {
  const shown = [];
  const fact = (card, name) => [...card.querySelectorAll('dt')].find((term) => term.textContent === name).nextSibling.textContent;
  for (const address of addresses) {
    history.replaceState(null, '', address);
    window.dispatchEvent(new HashChangeEvent('hashchange'));
    shown.push([...document.querySelectorAll('[data-controller]')].map((card) => ({
      name: card.dataset.controller,
      recognised: fact(card, 'Recognises'),
      prescribed: fact(card, 'Prescribed'),
      action: fact(card, 'Does'),
      state: fact(card, 'Plant').split(',')[0],
      outcome: card.querySelector('.verdict').dataset.outcome,
    })));
  }
  return shown;
}

/** Presses "Draw a run" again and again and gives the addresses. */
function drawRuns(count) {
  return Array.from({ length: count }, () => {
    document.getElementById('draw').click();
    return location.hash;
  });
}

// ---- heed exec ---------------------------------------------------------------------------------------------------------------

/** Every way in which the thing's symbols become visible, each in some cell or never, and stay so. */
function revealOrders(play, cells) {
  const symbols = play.entities[play.approached].shows;
  let runs = [[]];
  for (let i = 0; i < symbols.length; ++i) runs = runs.flatMap((run) => Array.from({ length: cells + 1 }, (_, onset) => [...run, onset]));
  return runs.map((onsets) => play.symbols.map((_, symbol) => {
    const at = symbols.indexOf(symbol);
    return Array.from({ length: cells }, (__, cell) => at >= 0 && cell >= onsets[at]);
  }));
}

function observation(play, seen, step) {
  const line = {};
  play.symbols.forEach((symbol, i) => {
    if (step === 0 || !seen[i][step - 1]) return;
    const { name, type } = play.inputs[symbol.input];
    line[name] = type === 'boolean' ? true : typeof type[0] === 'string' ? type[symbol.value] : symbol.value;
  });
  return JSON.stringify(line);
}

/** The program's answers, run by run and step by step. */
function answers(play, heed, file, runs, cells) {
  const steps = Array.from({ length: cells + 1 }, (_, step) => step);
  const lines = runs.flatMap((seen) => [...steps.map((step) => observation(play, seen, step)), '{"reset": true}']);
  const out = execFileSync(heed, ['exec', file], { input: lines.join('\n') + '\n', encoding: 'utf8', maxBuffer: 2 ** 30 });
  const all = out.trim().split('\n').map((line) => JSON.parse(line));
  return runs.map((_, run) => steps.map((step) => all[run * (cells + 2) + step]));
}

/** What people call the columns that the program names: the beginning of their comments in the controller's file. */
function labelsOf(machine, names) {
  const label = (name) => machine.outputs.find((output) => output.name === name).comment.split(':')[0];
  return names.map(label).join(', ') || 'nothing';
}

/** \p every  only each so many-th run: enough to find a flaw that many runs meet. */
export async function compareReactions(page, heed, folder, every = 1) {
  const play = await readData(page);
  const cells = play.profiles[0]?.cells ?? play.cells;
  const runs = revealOrders(play, cells).filter((_, i) => i % every === 0);
  // What comes after a step does not matter to it: runs that begin alike are looked at once.
  const looks = new Map();
  runs.forEach((seen, run) => {
    for (let step = 0; step <= cells; ++step) {
      const address = hashOf(play, play.approached, play.profiles[0]?.name, seen.map((row) => row.map((there, cell) => there && cell < step)), step);
      if (!looks.has(address)) looks.set(address, { run, step });
    }
  });
  const shown = await page.evaluate(visit, [...looks.keys()]);
  const problems = [];
  for (const [c, controller] of play.controllers.entries()) {
    const file = path.join(folder, `${controller.name}.controller.json`);
    const machine = JSON.parse(readFileSync(file, 'utf8'));
    const expected = answers(play, heed, file, runs, cells);
    [...looks].forEach(([address, { run, step }], i) => {
      const answer = expected[run][step];
      const right = {
        name: controller.name, recognised: labelsOf(machine, answer.recognised), prescribed: labelsOf(machine, answer.prescribed),
        action: String(answer.action).replaceAll('_', ' '), state: answer.state,
      };
      for (const key of Object.keys(right))
        if (shown[i][c][key] !== right[key]) problems.push(`${controller.name}, ${address}: ${key} ${shown[i][c][key]}, heed exec ${right[key]}`);
    });
  }
  if (runs.length < 24) problems.push(`only ${runs.length} runs`);
  return problems;
}

// ---- heed simulate -----------------------------------------------------------------------------------------------------------

function parseFraction(text) {
  const [over, under = '1'] = text.split('/');
  return [BigInt(over), BigInt(under)];
}

function reduce([over, under]) {
  let [a, b] = [over, under];
  while (b !== 0n) [a, b] = [b, a % b];
  return [over / a, under / a];
}

const times = ([a, b], [c, d]) => reduce([a * c, b * d]);
const plus = ([a, b], [c, d]) => reduce([a * d + b * c, b * d]);
const written = ([a, b]) => (b === 1n ? String(a) : `${a}/${b}`);

/** Every way through a chain: what is seen, and its probability. */
function waysThrough(play, profile, thing) {
  const approach = profile.approaches[profile.of[thing]];
  const chain = profile.chains[approach.chain];
  let ways = [{ state: 0, probability: [1n, 1n], seen: play.symbols.map(() => []) }];
  for (let cell = 0; cell < profile.cells; ++cell)
    ways = ways.flatMap((way) => chain[way.state].map(([probability, state, features]) => {
      const there = new Set(features.map((feature) => approach.symbols[feature]));
      return { state, probability: times(way.probability, parseFraction(probability)), seen: way.seen.map((row, i) => [...row, there.has(i)]) };
    }));
  const bySight = new Map();
  for (const { probability, seen } of ways) {
    const key = hashOf(play, thing, profile.name, seen, profile.cells);
    bySight.set(key, plus(bySight.get(key) ?? [0n, 1n], probability));
  }
  return bySight;
}

/** Outcomes of drawn runs against their probabilities: Pearson's statistic is below the 1e-6 quantile of any run of this length. */
function compareDraws(draws, bySight) {
  const counts = new Map();
  for (const hash of draws) {
    const parts = new URLSearchParams(hash.slice(1));
    const key = parts.getAll('see').join();
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  let [statistic, freedom, known] = [0, -1, 0];
  for (const [address, [over, under]] of bySight) {
    const key = new URLSearchParams(address.slice(1)).getAll('see').filter((one) => one.includes('1', one.lastIndexOf('.'))).join();
    const expected = (draws.length * Number(over)) / Number(under);
    const found = counts.get(key) ?? 0;
    known += found;
    statistic += (found - expected) ** 2 / expected;
    freedom += 1;
  }
  const problems = known === draws.length ? [] : [`${draws.length - known} draws are impossible`];
  // Wilson and Hilferty's cube root: 4.75 standard deviations.
  const bound = freedom * (1 - 2 / (9 * freedom) + 4.75 * Math.sqrt(2 / (9 * freedom))) ** 3;
  if (statistic > bound) problems.push(`draws do not follow the profile: ${statistic.toFixed(1)} > ${bound.toFixed(1)}`);
  return problems;
}

export async function compareProfiles(page, heed, scenario, folder) {
  const play = await readData(page);
  const files = play.controllers.map(({ name }) => path.join(folder, `${name}.controller.json`));
  const { results } = JSON.parse(execFileSync(heed, ['simulate', scenario, ...files, '--traces', '0', '--json'], { encoding: 'utf8', maxBuffer: 2 ** 30 }));
  const problems = [];
  for (const [p, profile] of play.profiles.entries()) {
    const bySight = waysThrough(play, profile, play.approached);
    const shown = await page.evaluate(visit, [...bySight.keys()]);
    for (const [c, controller] of play.controllers.entries()) {
      const sums = new Map();
      [...bySight.values()].forEach((probability, i) => {
        const { outcome } = shown[i][c];
        sums.set(outcome, plus(sums.get(outcome) ?? [0n, 1n], probability));
      });
      const exact = results.find((one) => one.controller === controller.name && one.profile === profile.name).outcomes;
      for (const bar of exact) {
        const found = written(sums.get(bar.label ?? bar.outcome) ?? [0n, 1n]);
        if (found !== bar.exact) problems.push(`${controller.name} under ${profile.name}: ${bar.label ?? bar.outcome} ${found}, heed simulate ${bar.exact}`);
      }
    }
    await page.selectOption('#profile', String(p));
    problems.push(...compareDraws(await page.evaluate(drawRuns, DRAWS), bySight).map((problem) => `${profile.name}: ${problem}`));
  }
  if (play.profiles.length === 0) problems.push('no profiles');
  return problems;
}
