// SPDX-License-Identifier: GPL-3.0-or-later
// A tab with the emulated headset of npm's iwer, whose hands are tracked.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch } from '../page/browser.mjs';

const require = createRequire(join(process.env.HANDHOLD_PAGE_TOOLS, 'package.json'));

/** Calls `body` with a tab on `url`, where `device` is the headset, and a folder that goes afterwards. */
export async function onHeadset(url, body) {
  const browser = await launch();
  const folder = mkdtempSync(join(tmpdir(), 'handhold-headset-'));
  try {
    const tab = await browser.newPage();
    const errors = [];
    tab.on('pageerror', (error) => errors.push(String(error)));
    await tab.addInitScript({ path: require.resolve('iwer/build/iwer.js') });
    await tab.addInitScript(() => {
      window.device = new IWER.XRDevice(IWER.metaQuest3);
      window.device.installRuntime({ polyfillLayers: false, forceInstall: true });
      window.device.primaryInputMode = 'hand';
    });
    await tab.goto(url);
    await body(tab, folder);
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
}

export const handhold = (...words) => spawnSync(process.env.HANDHOLD_EXECUTABLE, words, { encoding: 'utf8' });
