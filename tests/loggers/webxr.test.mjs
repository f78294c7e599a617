// SPDX-License-Identifier: GPL-3.0-or-later
// docs/loggers/webxr.js in headless Chromium; its logs judged by the program.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { handhold, onHeadset } from './headset.mjs';

const logger = readFileSync(new URL('../../docs/loggers/webxr.js', import.meta.url), 'utf8');
const page = new URL('blank.html', import.meta.url).href;
const x = (line) => line.objects.cube.position[0];

/** In the page: a hand that pinches and moves to the side, and a cube between its fingers; `jump` from frame 60 on [m].
 * The clock is that of a headset at 90 Hz, however slow this machine is. */
async function record(jump) {
  const session = await navigator.xr.requestSession('immersive-vr', { optionalFeatures: ['hand-tracking'] });
  const gl = document.createElement('canvas').getContext('webgl2', { xrCompatible: true });
  session.updateRenderState({ baseLayer: new XRWebGLLayer(session, gl) });
  const space = await session.requestReferenceSpace('local');
  const shape = 'shape:box,x=0.02,y=0.02,z=0.02';
  const log = new HandholdLog({ cube: { shape, mass: 0.05, friction: 0.5 } });
  const hand = device.hands.right;
  hand.updatePinchValue(1);
  return new Promise((done) => {
    let n = 0;
    function frame(_, xrFrame) {
      hand.position.set(0.2 + 0.0005 * n, 1.2, -0.3);
      const source = [...xrFrame.session.inputSources].find((s) => s.handedness === 'right');
      const [a, b] = ['thumb-tip', 'index-finger-tip'].map((name) =>
        xrFrame.getJointPose(source.hand.get(name), space).transform.position);
      const position = { x: (a.x + b.x) / 2 + (n >= 60 ? jump : 0), y: (a.y + b.y) / 2, z: (a.z + b.z) / 2 };
      if (n > 1) log.frame(1000 + n / 0.09, xrFrame, space, { cube: { position, quaternion: { x: 0, y: 0, z: 0, w: 1 } } });
      if (++n === 120) done(log.text());
      else session.requestAnimationFrame(frame);
    }
    session.requestAnimationFrame(frame);
  });
}

/** Calls `body` with the log's frames and what judge-log says of them. */
const onLog = (jump, body) => onHeadset(page, async (tab, folder) => {
  await tab.addScriptTag({ content: logger.replace('export class', 'window.HandholdLog = class') });
  const text = await tab.evaluate(record, jump);
  const file = join(folder, 'session.jsonl');
  writeFileSync(file, text);
  const run = handhold('judge-log', file, '--no-replay', '--json');
  assert.ok(run.status === 0 || run.status === 1, run.stderr);
  body(text.trim().split('\n').slice(1).map((line) => JSON.parse(line)), JSON.parse(run.stdout));
});

test('a cube that a pinch carries is believed, and the hand is there', () => onLog(0, (lines, verdict) => {
  assert.equal(lines[0].hands.right.joints.length, 25);
  assert.ok(lines[0].hands.right.joints.every((joint) => joint.radius > 0));
  assert.deepEqual(verdict.findings.map((finding) => finding.text), []);
  assert.equal(verdict.grips.length, 1);
}));

test('a cube that jumps out of the pinch is found at that frame', () => onLog(0.3, (lines, verdict) => {
  const jump = verdict.findings.find((finding) => finding.fault === 'jump');
  assert.ok(Math.abs(jump.value - 0.3) < 0.002, `${jump.value}`);
  const at = lines.findIndex((line, i) => i > 0 && x(line) - x(lines[i - 1]) > 0.1);
  assert.ok(Math.abs(jump.end - lines[at].t / 1000) < 1e-6, `${jump.end} ${lines[at].t}`);
}));
