// A whole visit without a mouse.

/** What has the focus, and whether one sees that. */
function focused() {
  const element = document.activeElement;
  const style = getComputedStyle(element);
  const labelled = element.getAttribute('aria-label') || element.labels?.[0]?.textContent || element.textContent;
  return {
    id: element.id,
    visible: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
    label: labelled.trim(),
    inside: element !== document.body,
  };
}

/** Tab from the top of the page until the focus leaves it again. */
async function tabThrough(page) {
  const stops = [];
  await page.evaluate(() => document.activeElement?.blur());
  for (let i = 0; i < 200; ++i) {
    await page.keyboard.press('Tab');
    const stop = await page.evaluate(focused);
    if (!stop.inside) break;
    stops.push(stop);
  }
  return stops;
}

async function tabTo(page, id) {
  for (let i = 0; i < 200; ++i) {
    if (await page.evaluate((wanted) => document.activeElement.id === wanted, id)) return;
    await page.keyboard.press('Tab');
  }
}

export async function useKeyboard(page) {
  const problems = [];
  const expect = (truth, words) => { if (!truth) problems.push(words); };
  const value = (id) => page.evaluate((one) => document.getElementById(one).value, id);
  const said = () => page.evaluate(() => document.querySelector('[aria-live]')?.textContent ?? '');

  const stops = await tabThrough(page);
  for (const { id, visible, label } of stops) {
    expect(visible, `one does not see that ${id} has the focus`);
    expect(label !== '', `${id} has no label`);
  }
  const reached = new Set(stops.map(({ id }) => id));
  const controls = await page.evaluate(() => [...document.querySelectorAll('button, select, input')].filter((element) =>
    !element.closest('[role=grid], [aria-hidden=true]') && element.getClientRects().length > 0).map((element) => element.id));
  for (const id of controls) expect(reached.has(id), `Tab does not reach ${id}`);
  expect(stops.filter(({ id }) => id.startsWith('see-')).length === 1, 'the grid is no single stop');

  await tabTo(page, 'step');
  const quiet = await said();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  expect((await value('step')) === '2', 'arrows do not move the step');
  expect((await said()) !== quiet && (await said()).startsWith('Step 2'), 'the step is not announced');

  await tabTo(page, 'clear');
  await page.keyboard.press('Enter');
  const first = await page.evaluate(() => document.querySelector('[role=grid] button').id);
  await page.evaluate(() => document.activeElement.blur());
  await tabTo(page, first);
  for (const key of ['ArrowRight', 'ArrowDown', 'Enter']) await page.keyboard.press(key);
  const pressed = await page.evaluate(() => [...document.querySelectorAll('[role=grid] [role=row]')].map((row) => [...row.querySelectorAll('button')].map((button) => button.getAttribute('aria-pressed')).join(' ')));
  expect(pressed[1]?.startsWith('false true true') && !pressed[0].includes('true'), `Enter in the grid gives ${pressed.join(' / ')}`);
  expect((await said()).includes('Seen: ') && !(await said()).includes('Seen: nothing'), 'what is seen is not announced');
  await page.keyboard.press('Enter');
  expect(await page.evaluate(() => document.querySelectorAll('[aria-pressed=true]').length === 0), 'a second Enter does not hide it');

  await page.evaluate(() => document.activeElement.blur());
  await tabTo(page, 'play');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => Number(document.getElementById('step').value) >= 3, undefined, { timeout: 5000 }).catch(() => problems.push('Enter does not play'));
  await page.keyboard.press('Space');
  const stopped = await value('step');
  await page.waitForTimeout(1200);
  expect((await value('step')) === stopped, 'Space does not pause');

  await page.evaluate(() => document.activeElement.blur());
  await tabTo(page, 'thing');
  const before = await value('thing');
  await page.keyboard.press('ArrowDown');
  expect((await value('thing')) !== before && (await value('step')) === '0', 'arrows do not choose another thing');
  return problems;
}
