// SPDX-License-Identifier: GPL-3.0-or-later
// Rapier. Friction of a pair is the average of two coefficients, so both get the pair's.
import { fromZ } from './play.mjs';

export const about = { package: '@dimforge/rapier3d-compat', twoCoefficients: false };
export const settings = { sleep: false, numSolverIterations: 4, numInternalPgsIterations: 1, lengthUnit: 1 };

const vec = ([x, y, z]) => ({ x, y, z });
const quat = ([w, x, y, z]) => ({ w, x, y, z });
const list = ({ x, y, z }) => [x, y, z];
const ofBodies = 0x0001ffff, ofOthers = 0x00020001; // collision groups: bodies touch everything, others touch bodies
const zToY = fromZ([0, -1, 0]); // turns its capsules, which lie along y, to lie along z

export async function start({ module }, { gravity, step, solids, settings }) {
  const R = module.default ?? module;
  await R.init();
  const world = new R.World(vec(gravity));
  world.timestep = step;
  for (const key of ['numSolverIterations', 'numInternalPgsIterations', 'lengthUnit'])
    world.integrationParameters[key] = settings[key];

  const shapes = {
    box: ({ half_extents: h }) => R.ColliderDesc.cuboid(...h),
    ball: ({ radius }) => R.ColliderDesc.ball(radius),
    capsule: ({ half_length, radius }) => R.ColliderDesc.capsule(half_length, radius),
  };
  const bodies = solids.map((s) => {
    const desc = s.role === 'fixed' ? R.RigidBodyDesc.fixed()
      : s.role === 'driven' ? R.RigidBodyDesc.kinematicPositionBased() : R.RigidBodyDesc.dynamic();
    desc.setTranslation(...s.p).setRotation(quat(s.q)).setCanSleep(settings.sleep);
    const dynamic = s.role === 'body' || s.role === 'finger';
    if (dynamic) desc.setAdditionalMassProperties(s.mass, vec([0, 0, 0]), vec(s.moments ?? [1, 1, 1]), quat([1, 0, 0, 0]));
    if (s.role === 'body') desc.setLinvel(...s.v).setAngvel(vec(s.w));
    if (s.role === 'finger') desc.setGravityScale(0);
    if (dynamic && s.locked) desc.lockRotations();
    const body = world.createRigidBody(desc);
    const collider = shapes[s.shape.type](s.shape).setDensity(0).setFriction(s.mu[0]).setRestitution(0);
    if (s.shape.type === 'capsule') collider.setRotation(quat(zToY));
    world.createCollider(collider.setCollisionGroups(s.ghost ? 0 : s.role === 'body' ? ofBodies : ofOthers), body);
    return body;
  });
  const origin = vec([0, 0, 0]), slider = R.JointData.prismatic(origin, origin, vec([0, 0, 1]));
  solids.forEach((s, i) => {
    if (s.role === 'finger') world.createImpulseJoint(slider, bodies[s.carrier], bodies[i], true);
  });

  return {
    drive(i, from, to) {
      bodies[i].setNextKinematicTranslation(vec(to.p));
      bodies[i].setNextKinematicRotation(quat(to.q));
    },
    push(i, force, torque) {
      bodies[i].resetForces(true);
      bodies[i].resetTorques(true);
      bodies[i].addForce(vec(force), true);
      bodies[i].addTorque(vec(torque), true);
    },
    step: () => world.step(),
    state(i) {
      const b = bodies[i], q = b.rotation();
      return { p: list(b.translation()), q: [q.w, q.x, q.y, q.z], v: list(b.linvel()), w: list(b.angvel()) };
    },
  };
}
