// SPDX-License-Identifier: GPL-3.0-or-later
// Jolt. Friction of a pair is the geometric mean of two coefficients, so both get the pair's. Its damping (0.05 of
// bodies by default), limits of speed and rounded edges (50 mm) are switched off: they are no part of any problem.
import { fromZ, turned } from './play.mjs';

export const about = { package: 'jolt-physics', twoCoefficients: false };
export const settings = { sleep: false, mNumVelocitySteps: 10, mNumPositionSteps: 2, mPenetrationSlop: 0.02,
  mSpeculativeContactDistance: 0.02, mUseBodyPairContactCache: true };

const list = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const zToY = fromZ([0, -1, 0]); // turns its capsules, which lie along y, to lie along z

function makeWorld(J, gravity, settings) {
  const [others, bodies, ghosts] = [0, 1, 2]; // object layers: bodies touch everything, others bodies, ghosts nothing
  const pairs = new J.ObjectLayerPairFilterTable(3);
  for (const layer of [others, bodies]) pairs.EnableCollision(layer, bodies);
  const phases = new J.BroadPhaseLayerInterfaceTable(3, 1);
  for (const layer of [others, bodies, ghosts]) phases.MapObjectToBroadPhaseLayer(layer, new J.BroadPhaseLayer(0));
  const world = new J.JoltInterface(Object.assign(new J.JoltSettings(), { mObjectLayerPairFilter: pairs,
    mBroadPhaseLayerInterface: phases,
    mObjectVsBroadPhaseLayerFilter: new J.ObjectVsBroadPhaseLayerFilterTable(phases, 1, pairs, 3) }));
  const system = world.GetPhysicsSystem();
  system.SetGravity(new J.Vec3(...gravity));
  const own = system.GetPhysicsSettings();
  for (const key of Object.keys(settings)) if (key !== 'sleep') own[key] = settings[key];
  own.mAllowSleeping = settings.sleep;
  system.SetPhysicsSettings(own);
  return world;
}

export async function start({ module }, { gravity, step, solids, settings }) {
  const J = await module.default();
  const vec = (a) => new J.Vec3(...a), place = (a) => new J.RVec3(...a), quat = ([w, x, y, z]) => new J.Quat(x, y, z, w);
  const world = makeWorld(J, gravity, settings), system = world.GetPhysicsSystem(), bodies = system.GetBodyInterface();
  const shapes = {
    box: ({ half_extents: h }) => new J.BoxShape(vec(h), 0), ball: ({ radius }) => new J.SphereShape(radius),
    capsule: ({ half_length, radius }) => new J.RotatedTranslatedShapeSettings(vec([0, 0, 0]), quat(zToY),
      new J.CapsuleShapeSettings(half_length, radius)).Create().Get(),
  };
  const motions = { fixed: J.EMotionType_Static, driven: J.EMotionType_Kinematic }; // others: dynamic
  const slides = J.EAllowedDOFs_TranslationX | J.EAllowedDOFs_TranslationY | J.EAllowedDOFs_TranslationZ;
  const all = solids.map((s) => {
    const layer = s.ghost ? 2 : s.role === 'body' ? 1 : 0, motion = motions[s.role] ?? J.EMotionType_Dynamic;
    const made = new J.BodyCreationSettings(shapes[s.shape.type](s.shape), place(s.p), quat(s.q), motion, layer);
    Object.assign(made, { mFriction: s.mu[0], mRestitution: 0, mLinearDamping: 0, mAngularDamping: 0,
      mMaxLinearVelocity: 1e4, mMaxAngularVelocity: 1e4, mAllowSleeping: settings.sleep });
    if (motion === J.EMotionType_Dynamic) {
      const mInertia = J.Mat44.prototype.sScaleVec3(vec(s.moments ?? [1, 1, 1]));
      made.mMassPropertiesOverride = Object.assign(new J.MassProperties(), { mMass: s.mass, mInertia });
      made.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
      if (s.locked) made.mAllowedDOFs = slides;
      if (s.role === 'finger') made.mGravityFactor = 0;
      if (s.role === 'body') [made.mLinearVelocity, made.mAngularVelocity] = [vec(s.v), vec(s.w)];
    }
    const body = bodies.CreateBody(made);
    return bodies.AddBody(body.GetID(), J.EActivation_Activate), body;
  });
  solids.forEach((s, i) => {
    if (s.role !== 'finger') return;
    const at = place(s.p), z = vec(turned(s.q, [0, 0, 1])), x = vec(turned(s.q, [1, 0, 0]));
    const slider = Object.assign(new J.SixDOFConstraintSettings(),
      { mPosition1: at, mPosition2: at, mAxisX1: z, mAxisX2: z, mAxisY1: x, mAxisY2: x });
    for (const axis of ['Y', 'Z']) slider.MakeFixedAxis(J[`SixDOFConstraintSettings_EAxis_Translation${axis}`]);
    system.AddConstraint(slider.Create(all[s.carrier], all[i]));
  });

  return {
    drive: (i, from, to) => bodies.MoveKinematic(all[i].GetID(), place(to.p), quat(to.q), step),
    push(i, force, torque) {
      bodies.AddForce(all[i].GetID(), vec(force), J.EActivation_Activate);
      bodies.AddTorque(all[i].GetID(), vec(torque), J.EActivation_Activate);
    },
    step: () => world.Step(step, 1),
    state(i) {
      const b = all[i], q = b.GetRotation();
      return { p: list(b.GetPosition()), q: [q.GetW(), q.GetX(), q.GetY(), q.GetZ()],
        v: list(b.GetLinearVelocity()), w: list(b.GetAngularVelocity()) };
    },
  };
}
