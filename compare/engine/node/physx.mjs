// SPDX-License-Identifier: GPL-3.0-or-later
// PhysX, the engine of Höll et al. 2018. Friction of a pair is the average of two coefficients, static and dynamic, so both
// get the pair's. A body that does not turn has moments 0, which are infinite to it: its lock flags only put a body back
// after the solver. Damping of spin (0.05) and the limits of speed are switched off.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fromZ } from './play.mjs';

export const about = { package: 'physx-js-webidl', twoCoefficients: true };
export const settings = { sleep: false, solver: 'ePGS', positionIterations: 4, velocityIterations: 1, contactOffset: 0.02 };

const list = (v) => [v.x, v.y, v.z];
const zToX = fromZ([1, 0, 0]); // turns its capsules and sliders, which lie along x, to lie along z

/** It is built for the web: it looks for a window, and must not see that this is node. */
async function instantiate(module, folder) {
  const { process } = globalThis, wasmBinary = readFileSync(join(folder, 'physx-js-webidl.wasm'));
  Object.assign(globalThis, { window: globalThis, document: { currentScript: null }, process: undefined });
  return module.default({ wasmBinary }).finally(() => Object.assign(globalThis, { process }));
}

export async function start({ module, folder }, { gravity, step, solids, settings }) {
  const P = await instantiate(module, folder), top = P.PxTopLevelFunctions.prototype;
  const vec = (a) => new P.PxVec3(...a);
  const pose = (p, [w, x, y, z]) => new P.PxTransform(vec(p), new P.PxQuat(x, y, z, w));
  const foundation = top.CreateFoundation(top.PHYSICS_VERSION, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
  const scale = new P.PxTolerancesScale(), physics = top.CreatePhysics(top.PHYSICS_VERSION, foundation, scale);
  top.InitExtensions(physics);
  const desc = new P.PxSceneDesc(scale);
  desc.gravity = vec(gravity);
  desc.cpuDispatcher = top.DefaultCpuDispatcherCreate(0);
  desc.filterShader = top.DefaultFilterShader();
  desc.solverType = P.PxSolverTypeEnum[settings.solver];
  const scene = physics.createScene(desc);
  const flags = new P.PxShapeFlags(P.PxShapeFlagEnum.eSIMULATION_SHAPE);

  const shapes = { box: ({ half_extents: h }) => new P.PxBoxGeometry(...h), ball: ({ radius }) => new P.PxSphereGeometry(radius),
    capsule: ({ half_length, radius }) => new P.PxCapsuleGeometry(radius, half_length) };
  const makeDynamic = (actor, s) => {
    actor.setMass(s.mass);
    actor.setMassSpaceInertiaTensor(vec(s.locked ? [0, 0, 0] : s.moments));
    actor.setLinearDamping(0), actor.setAngularDamping(0), actor.setMaxLinearVelocity(1e6), actor.setMaxAngularVelocity(1e6);
    actor.setSolverIterationCounts(settings.positionIterations, settings.velocityIterations);
    if (!settings.sleep) actor.setSleepThreshold(0), actor.setStabilizationThreshold(0);
    if (s.role === 'finger') return actor.setActorFlag(P.PxActorFlagEnum.eDISABLE_GRAVITY, true);
    actor.setLinearVelocity(vec(s.v)), actor.setAngularVelocity(vec(s.w));
  };
  const bodies = solids.map((s) => {
    const actor = physics[s.role === 'fixed' ? 'createRigidStatic' : 'createRigidDynamic'](pose(s.p, s.q));
    const shape = physics.createShape(shapes[s.shape.type](s.shape), physics.createMaterial(...s.mu, 0), true, flags);
    const [what, touches] = s.ghost ? [0, 0] : s.role === 'body' ? [1, 3] : [2, 1];
    shape.setSimulationFilterData(new P.PxFilterData(what, touches, 0, 0));
    shape.setContactOffset(settings.contactOffset);
    if (s.shape.type === 'capsule') shape.setLocalPose(pose([0, 0, 0], zToX));
    actor.attachShape(shape);
    if (s.role === 'driven') actor.setRigidBodyFlag(P.PxRigidBodyFlagEnum.eKINEMATIC, true);
    if (s.mass) makeDynamic(actor, s);
    scene.addActor(actor);
    return actor;
  });
  solids.forEach((s, i) => {
    if (s.role !== 'finger') return;
    const end = pose([0, 0, 0], zToX), slider = top.D6JointCreate(physics, bodies[s.carrier], end, bodies[i], end);
    for (const free of ['eX', 'eTWIST', 'eSWING1', 'eSWING2']) slider.setMotion(P.PxD6AxisEnum[free], P.PxD6MotionEnum.eFREE);
  });

  return {
    drive: (i, from, to) => bodies[i].setKinematicTarget(pose(to.p, to.q)),
    push: (i, force, torque) => (bodies[i].addForce(vec(force)), bodies[i].addTorque(vec(torque))),
    step: () => (scene.simulate(step), scene.fetchResults(true)),
    state(i) {
      const { p, q } = bodies[i].getGlobalPose();
      return { p: list(p), q: [q.w, q.x, q.y, q.z], v: list(bodies[i].getLinearVelocity()),
        w: list(bodies[i].getAngularVelocity()) };
    },
  };
}
