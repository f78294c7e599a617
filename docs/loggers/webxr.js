// SPDX-License-Identifier: Apache-2.0
// Logs hands and objects of a WebXR page for `handhold judge-log` (docs/judge-log.md). Import it, or copy it.
//
//   const log = new HandholdLog({ cube: { shape: 'shape:box,x=0.05,y=0.05,z=0.05', mass: 0.1, friction: 0.46 } });
//   function onFrame(time, xrFrame) {
//     ... move things ...
//     log.frame(time, xrFrame, referenceSpace, { cube: cubeMesh });  // three.js, or { position, quaternion } of your own
//     xrFrame.session.requestAnimationFrame(onFrame);
//   }
//   log.save('session.jsonl');  // offers the file for download

export class HandholdLog {
  #lines;

  /** `objects`: what judge-log must know of each, by name; `drawnHands`: the joints are those drawn, not those tracked. */
  constructor(objects, { drawnHands = false } = {}) {
    this.#lines = [JSON.stringify({ format: 'webxr', time: 'ms', drawn_hands: drawnHands, objects })];
  }

  /** `time` in ms, as the frame's callback gives it; `poses` by name: anything with `position` and `quaternion`. */
  frame(time, xrFrame, referenceSpace, poses) {
    const hands = {};
    for (const source of xrFrame.session.inputSources) {
      if (source.hand) hands[source.handedness] = { joints: joints(source.hand, xrFrame, referenceSpace) };
    }
    const objects = {};
    for (const [name, { position, quaternion }] of Object.entries(poses)) {
      objects[name] = { position: numbers(position), orientation: [...numbers(quaternion), quaternion.w] };
    }
    this.#lines.push(JSON.stringify({ t: time, hands, objects }));
  }

  text() {
    return this.#lines.join('\n') + '\n';
  }

  save(name) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([this.text()], { type: 'application/jsonl' }));
    link.download = name;
    link.click();
    URL.revokeObjectURL(link.href);
  }
}

const numbers = ({ x, y, z }) => [x, y, z];

/** The 25 joints in the specification's order; null where one is not tracked. */
function joints(hand, xrFrame, referenceSpace) {
  return Array.from(hand.values(), (space) => {
    const pose = xrFrame.getJointPose(space, referenceSpace);
    if (!pose) return null;
    const { position, orientation } = pose.transform;
    return { position: numbers(position), orientation: [...numbers(orientation), orientation.w], radius: pose.radius };
  });
}
