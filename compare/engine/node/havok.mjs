// SPDX-License-Identifier: GPL-3.0-or-later
// Havok. Friction is set on each shape, static and dynamic; both shapes get the pair's. Its contacts keep boxes some 10 mm
// apart from their edges, which leaves a hand-sized box without support: lengths, gravity and forces are given to it
// `scale` times as large. Damping of spin (0.1) and the limits of speed (200 m/s, 100 rad/s) are switched off.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { scaled } from './play.mjs';

export const about = { package: '@babylonjs/havok', twoCoefficients: true };
export const settings = { sleep: false, scale: 50, idealStep: true };

const quat = ([w, x, y, z]) => [x, y, z, w];

export async function start({ module, folder }, { gravity, step, solids, settings }) {
  const H = await module.default({ wasmBinary: readFileSync(join(folder, 'HavokPhysics.wasm')) });
  const ok = (result) => {
    if ((Array.isArray(result) ? result[0] : result) !== H.Result.RESULT_OK) throw new Error('Havok refuses a call');
    return result[1];
  };
  const size = settings.scale, place = (p) => scaled(p, size), zero = [0, 0, 0], noTurn = [0, 0, 0, 1];
  const world = ok(H.HP_World_Create());
  ok(H.HP_World_SetGravity(world, place(gravity)));
  ok(H.HP_World_SetSpeedLimit(world, 1e6, 1e6));
  if (settings.idealStep) ok(H.HP_World_SetIdealStepTime(world, step)); // meant for steps shorter than 1/60 s

  const shapes = {
    box: ({ half_extents: h }) => H.HP_Shape_CreateBox(zero, noTurn, place(scaled(h, 2))),
    ball: ({ radius }) => H.HP_Shape_CreateSphere(zero, radius * size),
    capsule: ({ half_length: l, radius }) => H.HP_Shape_CreateCapsule([0, 0, -l * size], [0, 0, l * size], radius * size),
  };
  const motions = { fixed: 'STATIC', driven: 'KINEMATIC', finger: 'DYNAMIC', body: 'DYNAMIC' };
  const control = settings.sleep ? 'SIMULATION_CONTROLLED' : 'ALWAYS_ACTIVE';
  const bodies = solids.map((s) => {
    const body = ok(H.HP_Body_Create()), shape = ok(shapes[s.shape.type](s.shape));
    ok(H.HP_Shape_SetMaterial(shape, [...s.mu, 0, H.MaterialCombine.MAXIMUM, H.MaterialCombine.MAXIMUM]));
    ok(H.HP_Shape_SetFilterInfo(shape, s.ghost ? [0, 0] : s.role === 'body' ? [1, 3] : [2, 1]));
    ok(H.HP_Body_SetShape(body, shape));
    ok(H.HP_Body_SetMotionType(body, H.MotionType[motions[s.role]]));
    // Moments are for a mass of 1; 0 is infinite: a body that does not turn.
    const moments = s.locked ? zero : scaled(s.moments ?? zero, size * size / s.mass);
    if (s.mass) ok(H.HP_Body_SetMassProperties(body, [zero, s.mass, moments, noTurn]));
    ok(H.HP_Body_SetLinearDamping(body, 0));
    ok(H.HP_Body_SetAngularDamping(body, 0));
    ok(H.HP_Body_SetQTransform(body, [place(s.p), quat(s.q)]));
    if (s.role === 'body') ok(H.HP_Body_SetLinearVelocity(body, place(s.v))), ok(H.HP_Body_SetAngularVelocity(body, s.w));
    if (s.role === 'finger') ok(H.HP_Body_SetGravityFactor(body, 0));
    ok(H.HP_Body_SetActivationControl(body, H.ActivationControl[control]));
    ok(H.HP_World_AddBody(world, body, false));
    return body;
  });
  solids.forEach((s, i) => {
    if (s.role !== 'finger') return;
    const slider = ok(H.HP_Constraint_Create());
    ok(H.HP_Constraint_SetParentBody(slider, bodies[s.carrier]));
    ok(H.HP_Constraint_SetChildBody(slider, bodies[i]));
    for (const side of ['Parent', 'Child']) ok(H[`HP_Constraint_SetAnchorIn${side}`](slider, zero, [0, 0, 1], [1, 0, 0]));
    for (const axis of ['LINEAR_Y', 'LINEAR_Z'])
      ok(H.HP_Constraint_SetAxisMode(slider, H.ConstraintAxis[axis], H.ConstraintAxisLimitMode.LOCKED));
    ok(H.HP_Constraint_SetEnabled(slider, true));
  });

  return {
    drive: (i, from, to) => ok(H.HP_Body_SetTargetQTransform(bodies[i], [place(to.p), quat(to.q)])),
    push(i, force, torque) {
      const at = ok(H.HP_Body_GetPosition(bodies[i]));
      ok(H.HP_Body_ApplyImpulse(bodies[i], at, scaled(force, step * size)));
      ok(H.HP_Body_ApplyAngularImpulse(bodies[i], scaled(torque, step * size * size)));
    },
    step: () => ok(H.HP_World_Step(world, step)),
    state(i) {
      const [p, [x, y, z, w]] = ok(H.HP_Body_GetQTransform(bodies[i]));
      return { p: scaled(p, 1 / size), q: [w, x, y, z], v: scaled(ok(H.HP_Body_GetLinearVelocity(bodies[i])), 1 / size),
        w: ok(H.HP_Body_GetAngularVelocity(bodies[i])) };
    },
  };
}
