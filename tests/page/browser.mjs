// SPDX-License-Identifier: GPL-3.0-or-later
// Headless Chromium on a page from file://, with what every test asks of it: no error, no request.
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import assert from 'node:assert/strict';

/** The folder where the page was built: its node_modules hold playwright-core and axe-core. */
const require = createRequire(join(process.env.HANDHOLD_PAGE_TOOLS, 'package.json'));
const { chromium } = require('playwright-core');

export const WIDE = { width: 1360, height: 900 };
export const PHONE = { width: 390, height: 844 };

// WebGL without a graphics card; and nothing that looks for a network.
const FLAGS = [
  '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
  '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

export function launch() {
  return chromium.launch({ executablePath: process.env.HANDHOLD_CHROMIUM ?? '/usr/bin/chromium', args: FLAGS });
}

/** A tab on `folder`/index.html; `faults` collects what must not happen. */
export async function open(browser, folder, { size = WIDE, scheme = 'light', hash = '', script = true } = {}) {
  const phone = size.width < 500;
  const context = await browser.newContext({
    viewport: size, colorScheme: scheme, deviceScaleFactor: phone ? 2 : 1, hasTouch: phone, javaScriptEnabled: script,
  });
  context.setDefaultTimeout(60000);
  const tab = await context.newPage();
  const url = pathToFileURL(join(folder, 'index.html')).href;
  tab.faults = [];
  tab.on('console', (m) => { if (['error', 'warning'].includes(m.type())) tab.faults.push(m.text()); });
  tab.on('pageerror', (error) => tab.faults.push(String(error)));
  tab.on('request', (request) => {
    const asked = request.url();
    if (asked.split('#')[0] !== url && !/^(data|blob):/.test(asked)) tab.faults.push(`asked for ${asked}`);
  });
  await tab.goto(url + hash);
  if (script) await tab.waitForSelector('#verdict-title');
  return tab;
}

/** Waits until the case is decoded and drawn. */
export async function shown(tab, id) {
  await tab.waitForSelector(id ? `#case[data-ready="${id}"]` : '#case[data-ready]');
  await drawn(tab);
}

/** Two display frames: what was asked for has been drawn. */
export function drawn(tab) {
  return tab.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** The seconds that the page shows. */
export const instant = async (tab) => parseFloat(await tab.locator('.transport .now').textContent());

/** A hash of the 3D view's pixels, and how many are not empty. */
export function pixels(tab) {
  return tab.evaluate(() => {
    const gl = document.querySelector('.scene canvas').getContext('webgl2');
    const { drawingBufferWidth: w, drawingBufferHeight: h } = gl;
    const bytes = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let hash = 0;
    let lit = 0;
    for (let i = 0; i < bytes.length; i += 4) {
      hash = (hash * 31 + bytes[i] + 7 * bytes[i + 1] + 13 * bytes[i + 2]) >>> 0;
      if (bytes[i + 3] > 0) ++lit;
    }
    return { hash, share: lit / (w * h) };
  });
}

export const cursor = (tab) => tab.evaluate(() => document.querySelector('.time-line').getBoundingClientRect().left);

export async function assertAccessible(tab) {
  await tab.addScriptTag({ path: require.resolve('axe-core/axe.min.js') });
  const violations = await tab.evaluate(async () => (await axe.run(document)).violations.map((v) =>
    `${v.id}: ${v.nodes.length} x ${v.nodes[0].target} ${v.nodes[0].failureSummary}`));
  assert.deepEqual(violations, []);
}
