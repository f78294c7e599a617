// SPDX-License-Identifier: GPL-3.0-or-later
// docs/recorder in headless Chromium: what it saves is read as a trace.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { assertAccessible } from '../page/browser.mjs';
import { handhold, onHeadset } from './headset.mjs';

const page = new URL('../../docs/recorder/index.html', import.meta.url).href;

test('both hands of a session are saved and read', () => onHeadset(page, async (tab, folder) => {
  await assertAccessible(tab);
  await tab.click('#start');
  await tab.waitForFunction(() => recording.lines.length > 60, undefined, { timeout: 120000 });
  await tab.evaluate(() => device.activeSession.end());
  const download = tab.waitForEvent('download');
  await tab.click('#save');
  const file = join(folder, 'hands.jsonl');
  await (await download).saveAs(file);
  const info = handhold('trace', 'info', file);
  assert.equal(info.status, 0, info.stderr);
  assert.match(info.stdout, /left/);
  assert.match(info.stdout, /right/);
  assert.match(await tab.textContent('#state'), /2\.0 hands a frame/);
}));

test('a browser without a headset is told what to do', () => onHeadset(page, async (tab) => {
  await tab.evaluate(() => Object.defineProperty(navigator, 'xr', { value: undefined }));
  await tab.click('#start');
  assert.match(await tab.textContent('#state'), /no WebXR: open the page on the headset/);
  assert.ok(await tab.isDisabled('#save'));
}));
