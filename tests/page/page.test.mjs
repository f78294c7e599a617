// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader does with the page, in headless Chromium from file://. HANDHOLD_PAGE_FAILING and HANDHOLD_PAGE_PASSING
// are folders of reports: the first of a suite whose engine steps too coarsely, so that gates fail.
import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { after, before, test } from 'node:test';
import { assertAccessible, cursor, drawn, instant, launch, open, PHONE, pixels, shown, WIDE } from './browser.mjs';

const FAILING = process.env.HANDHOLD_PAGE_FAILING;
const PASSING = process.env.HANDHOLD_PAGE_PASSING;
const D04 = '#case=D04&engine=realtime&t=0.277';
const ENGINE = '[aria-label=Engine] [aria-current]';
const chosenEngine = (tab) => tab.locator(ENGINE).textContent();
const results = (folder) => JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** A test with a tab of its own, which ends without an error of the page and without a request. */
function onPage(what, folder, options, body) {
  test(what, async () => {
    const tab = await open(browser, folder, options);
    try {
      await body(tab);
      assert.deepEqual(tab.faults, []);
    } finally {
      await tab.context().close();
    }
  });
}

/** A copy of the page with other data in it. */
async function withResults(change, body) {
  const folder = mkdtempSync(join(tmpdir(), 'handhold-page-'));
  try {
    const packed = deflateRawSync(JSON.stringify(change(results(PASSING)))).toString('base64');
    const html = readFileSync(join(PASSING, 'index.html'), 'utf8');
    writeFileSync(join(folder, 'index.html'), html.replace(/id="results">[^<]*</, () => `id="results">${packed}<`));
    await body(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

for (const folder of [FAILING, PASSING]) {
  const which = folder === FAILING ? 'failing' : 'passing';
  onPage(`counts the gates that the verdict counts: ${which}`, folder, {}, async (tab) => {
    const { gates, failed } = results(folder).verdict;
    assert.equal(Number(await tab.locator('#verdict-title').getAttribute('data-gates')), gates);
    await tab.waitForSelector('.gate-dots :is(circle, path.failed)');
    assert.equal(await tab.locator('.gate-dots :is(circle, path.failed)').count(), gates);
    assert.equal(await tab.locator('.failures tbody tr').count(), failed);
    assert.match(await tab.title(), failed ? /^✗ \d+ of/ : /^✓ All/);
  });
}

onPage('failed gates stand first, farthest off first', FAILING, {}, async (tab) => {
  assert.ok(results(FAILING).verdict.failed > 0, 'the planted fault must fail a gate');
  const order = await tab.evaluate(() => [...document.querySelectorAll('main > section')].map((s) => s.id));
  assert.deepEqual(order, ['verdict', 'failed', 'engines', 'case']);
  const ratios = await tab.locator('.failures .ratio').allTextContents();
  const sizes = ratios.map((r) => (r === 'not found' || r === 'wrong' ? Infinity : parseFloat(r)));
  assert.deepEqual(sizes, [...sizes].sort((a, b) => (a === b ? 0 : b - a)));
});

onPage('a failed gate opens its instant', FAILING, {}, async (tab) => {
  const link = tab.locator('.failures .go a').first();
  const t = parseFloat(new URLSearchParams((await link.getAttribute('href')).slice(1)).get('t'));
  await link.click();
  await shown(tab);
  assert.ok(Math.abs(await instant(tab) - t) < 1e-3);
});

onPage('nothing failed: no list of failures', PASSING, {}, async (tab) => {
  assert.equal(await tab.locator('#failed').count(), 0);
  assert.match(await tab.locator('.eyebrow').textContent(), /Passed/);
});

onPage('a link lands on its case, engine and instant', PASSING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  assert.match(await tab.locator('#case-title').textContent(), /D04/);
  assert.match(await chosenEngine(tab), /^realtime\b/);
  assert.ok(Math.abs(await instant(tab) - 0.277) < 1e-3);
  const top = await tab.evaluate(() => document.getElementById('case').getBoundingClientRect().top);
  assert.ok(Math.abs(top) < 120, `the case stands at ${top} px`);
});

onPage('the slider moves object and cursor', PASSING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  const from = { ...await pixels(tab), x: await cursor(tab) };
  assert.ok(from.share > 0.05, `only ${from.share} of the picture is drawn`);
  await tab.locator('.scrubber input').fill('0.45');
  await drawn(tab);
  assert.ok(Math.abs(await instant(tab) - 0.45) < 2e-3);
  assert.notEqual((await pixels(tab)).hash, from.hash);
  assert.ok(await cursor(tab) > from.x + 50);
  const thumb = await tab.locator('.scrubber input').evaluate((input) => Number(input.value) / Number(input.max));
  const line = await tab.locator('.time-line').evaluate((e) => Number(getComputedStyle(e).getPropertyValue('--share')));
  assert.ok(Math.abs(thumb - line) < 0.01, 'slider and cursor stand at one place');
});

onPage('hovering a curve moves the one cursor', PASSING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  await tab.locator('.plot').first().hover({ position: { x: 200, y: 60 } });
  assert.ok(Math.abs(await instant(tab) - 0.277) > 0.01);
  await drawn(tab);
  const line = await cursor(tab);
  const box = await tab.locator('.plot').first().boundingBox();
  assert.ok(Math.abs(line - box.x - 200) < 3);
});

onPage('the ghost shows only when asked for', FAILING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  const with_ = await pixels(tab);
  await tab.getByRole('button', { name: 'Ghost' }).click();
  await drawn(tab);
  assert.notEqual((await pixels(tab)).hash, with_.hash);
});

onPage('keys alone: play, step, engine, case', PASSING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  const start = await instant(tab);
  await tab.keyboard.press('ArrowRight');
  assert.ok(Math.abs(await instant(tab) - start - 1 / 90) < 2e-3);
  await tab.keyboard.press('Space');
  await tab.waitForFunction((t) => parseFloat(document.querySelector('.transport .now').textContent) > t + 0.05, start);
  await tab.keyboard.press('Space');
  const stopped = await instant(tab);
  await drawn(tab);
  assert.equal(await instant(tab), stopped);
  const engine = await chosenEngine(tab);
  await tab.keyboard.press('e');
  await tab.waitForFunction(([of, old]) => document.querySelector(of).textContent !== old, [ENGINE, engine]);
  const title = await tab.locator('#case-title').textContent();
  await tab.keyboard.press('j');
  await tab.waitForFunction((old) => document.querySelector('#case-title').textContent !== old, title);
  await shown(tab);
  await tab.keyboard.press('k');
  await tab.waitForFunction((old) => document.querySelector('#case-title').textContent === old, title);
});

onPage('keys alone: every control can be reached, and a cell opens its case', FAILING, {}, async (tab) => {
  const seen = new Set();
  for (let i = 0; i < 60; ++i) {
    await tab.keyboard.press('Tab');
    const at = await tab.evaluate(() => {
      const e = document.activeElement;
      return { text: e.textContent, row: e.closest('.failures') !== null, ring: getComputedStyle(e).outlineStyle };
    });
    seen.add(at.text);
    assert.notEqual(at.ring, 'none', `${at.text}: focus cannot be seen`);
    if (at.row && at.text.startsWith('see')) break;
  }
  assert.ok(seen.has('Engines') && seen.has('Dark'));
  await tab.keyboard.press('Enter');
  await shown(tab);
});

const LOOKS = [
  ['wide', WIDE, 'light'], ['wide, dark', WIDE, 'dark'], ['phone', PHONE, 'light'], ['phone, dark', PHONE, 'dark'],
];

for (const [name, size, scheme] of LOOKS) {
  onPage(`${name}: fits the window and is accessible`, FAILING, { size, scheme, hash: D04 }, async (tab) => {
    await shown(tab, 'D04-0');
    const extra = await tab.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(extra <= 0, `${extra} px wider than the window`);
    const paper = await tab.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert.equal(paper[0] < 60, scheme === 'dark');
    await assertAccessible(tab);
  });
}

onPage('the theme can be chosen', PASSING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  const light = await pixels(tab);
  await tab.getByRole('button', { name: 'Dark' }).click();
  await drawn(tab);
  assert.equal(await tab.evaluate(() => document.documentElement.dataset.theme), 'dark');
  assert.notEqual((await pixels(tab)).hash, light.hash);
});

onPage('prints', PASSING, { hash: D04 }, async (tab) => {
  await shown(tab, 'D04-0');
  await tab.emulateMedia({ media: 'print' });
  assert.equal(await tab.locator('.bar').isVisible(), false);
  assert.equal(await tab.locator('#verdict-title').isVisible(), true);
  assert.equal((await tab.pdf()).subarray(0, 5).toString(), '%PDF-');
});

onPage('without JavaScript a table of verdicts remains', FAILING, { script: false }, async (tab) => {
  assert.equal(await tab.locator('noscript table tr').count(), results(FAILING).cases.length + 1);
  assert.match(await tab.locator('noscript table').textContent(), /✗ fails/);
});

const newer = (r) => ({ ...r, version: 3 });

test('results of another version are refused in words', () => withResults(newer, async (folder) => {
  const tab = await browser.newPage();
  await tab.goto(`file://${folder}/index.html`);
  await tab.waitForSelector('#app[role=alert]');
  assert.match(await tab.locator('#app').textContent(), /reads results of version 2, and these are of version 3/);
  await tab.close();
}));

function bare(r) {
  for (const run of r.cases.flatMap((c) => c.runs)) Object.assign(run, { plays: [], curve: null });
  return r;
}

test('what is not there is said in words', () => withResults(bare, async (folder) => {
  const tab = await open(browser, folder, { hash: D04 });
  await shown(tab, 'D04-0');
  const text = await tab.locator('#case').textContent();
  assert.match(text, /carry no recording of this run/);
  assert.match(text, /No engine of this run recorded what its frames cost/);
  assert.deepEqual(tab.faults, []);
  await tab.context().close();
}));

onPage('costs less than a second of the processor before it shows its verdict', PASSING, {}, async (tab) => {
  const protocol = await tab.context().newCDPSession(tab);
  await protocol.send('Performance.enable', { timeDomain: 'threadTicks' });
  await tab.reload();
  await tab.waitForSelector('#verdict-title');
  const { metrics } = await protocol.send('Performance.getMetrics');
  const busy = metrics.find((m) => m.name === 'TaskDuration').value;
  const paint = await tab.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime);
  console.log(`# ${busy.toFixed(2)} s of the processor; first paint after ${(paint / 1000).toFixed(2)} s here and now`);
  assert.ok(busy < 1);
});

test('weighs at most 8 MB', () => assert.ok(statSync(join(PASSING, 'index.html')).size < 8e6));
