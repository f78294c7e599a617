// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a problem.json (docs/engines.md, ../problem.schema.json) with an engine from npm and writes OUT/frames.csv.
//
//   node play.mjs ENGINE PROBLEM OUT [KEY=VALUE]...      ENGINE: rapier, jolt, havok, physx, mujoco
//
// KEY=VALUE changes one of the engine's settings, which are at the head of its adapter. ./dev engines puts this folder and
// the packages into build/engines. Exit code: 0 played; 4 not asked, with {"not_asked": "why"} as the last line.
//
// The engine gets solids, each with a pose of its own: the bodies, plates in place of planes, balls and capsules in place
// of curved surfaces. A plate that presses is a body of the pressed body's mass on a slider along its z axis, without
// weight, pushed by N(t); the slider's carrier moves as the problem says. Forces are those of the step's beginning.
// An adapter exports `about`, `settings` and start(package, scene), which returns drive(i, pose now, pose after the step),
// push(i, force, torque), step() and state(i) of the solids by number.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const plate = [1, 1, 0.05]; // half extents of a plane's plate: farther than anything slides, thicker than it sinks [m]

export class NotAsked extends Error {}

// --- vectors, and quaternions as [w, x, y, z] ---------------------------------------------------------------------------
export const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
export const scaled = (a, s) => a.map((x) => x * s);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const cross = (a, b) => [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));
export const multiply = (a, b) => {
  const [v, w] = [a.slice(1), b.slice(1)];
  return [a[0] * b[0] - dot(v, w), ...add(add(scaled(w, a[0]), v, b[0]), cross(v, w))];
};
export const conjugate = (q) => [q[0], -q[1], -q[2], -q[3]];
export const turned = (q, a) => multiply(multiply(q, [0, ...a]), conjugate(q)).slice(1);
const still = { p: [0, 0, 0], q: [1, 0, 0, 0] };
const after = (X, Y) => ({ p: add(X.p, turned(X.q, Y.p)), q: multiply(X.q, Y.q) });
const inverse = (X) => ({ p: scaled(turned(conjugate(X.q), X.p), -1), q: conjugate(X.q) });

/** The rotation that takes the z axis to a direction. */
export const fromZ = (direction) => {
  const n = unit(direction);
  return n[2] < -0.999999 ? [0, 1, 0, 0] : unit([1 + n[2], -n[1], n[0], 0]);
};

// --- from the problem to solids -----------------------------------------------------------------------------------------
const require_ = (holds, why) => {
  if (!holds) throw new NotAsked(why);
};

function bodySolid(b) {
  require_(b.shapes.length === 1, `${b.name} has ${b.shapes.length} shapes: this harness plays bodies of one primitive`);
  const { type, p = still.p, q = still.q, ...size } = b.shapes[0];
  const inShape = { p, q };
  const locked = b.mobility === 'translation';
  require_(locked || Math.hypot(...p) === 0, `${b.name} turns about a point that is not its shape's centre`);
  require_(locked || b.inertia.every((row, i) => row.every((x, j) => i === j || x === 0)), `${b.name} has inertia products`);
  const moments = [0, 1, 2].map((i) => b.inertia[i][i]);
  return { role: 'body', name: b.name, shape: { type, ...size }, inShape, ...after(b, inShape), v: b.v, w: b.w, locked,
    mass: b.mass, moments, force: b.force, torque: b.torque };
}

/** Where a foot touches a curved surface, the body is a ball about the foot and the surface is smaller by its radius. */
function supportSolid(s, body) {
  const { type, radius, hollow } = s.surface;
  require_(!hollow, `${s.name} is touched from inside: engines have no hollow primitives`);
  const foot = s.contact.radius === 0 && type !== 'plane' ? body.shape.radius : 0;
  const shape = { plane: { type: 'box', half_extents: plate }, sphere: { type: 'ball', radius: radius - foot },
    cylinder: { type: 'capsule', radius: radius - foot, half_length: 1 } }[type];
  const q = fromZ(s.surface.normal ?? s.surface.axis ?? [0, 0, 1]);
  const p = type === 'plane' ? add(s.surface.p, turned(q, [0, 0, -plate[2]])) : s.surface.p;
  const role = s.normal_force ? 'finger' : s.motion ? 'driven' : 'fixed';
  return { role, name: s.name, shape, start: { p, q }, p, q, mass: s.normal_force && body.mass, axis: turned(q, [0, 0, 1]),
    press: s.normal_force, motion: s.motion, locked: true };
}

/** What a finger slides on: it moves as the finger's motion says, and touches nothing. */
function carrierOf(finger, number) {
  const { start, motion } = finger;
  Object.assign(finger, { carrier: number, motion: undefined });
  return { role: 'driven', ghost: true, shape: { type: 'ball', radius: 0.001 }, start, ...start, motion };
}

/** The pose of a solid that moves as sample k says: the motion is about the origin of W. */
const moved = (solid, k) => {
  if (!solid.motion) return solid.start;
  return after({ p: solid.motion.p[k], q: solid.motion.q?.[k] ?? still.q }, solid.start);
};

function sceneOf(problem, about, settings) {
  const bodies = problem.bodies.map(bodySolid);
  const named = Object.fromEntries(bodies.map((b) => [b.name, b]));
  const solids = [...bodies, ...problem.supports.map((s) => supportSolid(s, named[s.body]))];
  const [mu_s, mu_d] = [problem.supports[0]?.mu_static ?? 0, problem.supports[0]?.mu_dynamic ?? 0];
  require_(problem.supports.every((s) => s.mu_static === mu_s && s.mu_dynamic === mu_d), 'supports of different friction');
  require_(about.twoCoefficients || mu_s === mu_d, 'the engine has one coefficient of friction, the problem has two');
  for (const finger of solids.filter((s) => s.role === 'finger')) solids.push(carrierOf(finger, solids.length));
  for (const s of solids) Object.assign(s, moved({ start: { p: s.p, q: s.q }, ...s }, 0), { mu: [mu_s, mu_d] });
  return { gravity: problem.gravity, step: problem.step, solids, settings };
}

// --- a step -------------------------------------------------------------------------------------------------------------
function springForce(spring, body, k) {
  const at = turned(body.q, spring.p);
  const end = add(spring.anchor, spring.motion?.p[k] ?? still.p);
  const force = scaled(add(end, add(body.p, at), -1), spring.stiffness);
  return { force, torque: cross(at, force) };
}

function load(engine, problem, scene, states, k) {
  scene.solids.forEach((solid, i) => {
    if (solid.role === 'finger') engine.push(i, scaled(solid.axis, solid.press[k]), still.p);
    if (solid.role !== 'body') return;
    let [force, torque] = [solid.force?.[k] ?? still.p, solid.torque?.[k] ?? still.p];
    for (const spring of problem.springs.filter((s) => s.body === solid.name)) {
      const pull = springForce(spring, states[i], k);
      [force, torque] = [add(force, pull.force), add(torque, pull.torque)];
    }
    if (force.some(Boolean) || torque.some(Boolean)) engine.push(i, force, solid.locked ? still.p : torque);
  });
}

function statesOf(engine, scene) {
  return scene.solids.filter((s) => s.role === 'body').map((solid, i) => {
    const state = engine.state(i);
    return { ...state, ...after(state, inverse(solid.inShape)) };
  });
}

function play(engine, problem, scene) {
  let states = problem.bodies;
  const frames = [[0, states]];
  for (let k = 0; k < problem.steps; ++k) {
    load(engine, problem, scene, states, k);
    scene.solids.forEach((solid, i) => {
      if (solid.motion) engine.drive(i, moved(solid, k), moved(solid, k + 1));
    });
    engine.step();
    states = statesOf(engine, scene);
    if ((k + 1) % problem.frame_every === 0) frames.push([(k + 1) * problem.step, states]);
  }
  return frames;
}

// --- files --------------------------------------------------------------------------------------------------------------
function write(out, problem, engineName, version, settings, frames) {
  const header = [`# engine: ${engineName} ${version}`, `# scene: ${problem.name}`, '# outcome: complete',
    ...problem.bodies.map((b) => `# body: ${b.name}`), `# provenance.settings: ${JSON.stringify(settings)}`];
  const columns = ['x_m', 'y_m', 'z_m', 'qw', 'qx', 'qy', 'qz', 'vx_m_per_s', 'vy_m_per_s', 'vz_m_per_s', 'wx_rad_per_s',
    'wy_rad_per_s', 'wz_rad_per_s'];
  const names = ['t_s', ...problem.bodies.flatMap((b) => columns.map((c) => `"${b.name}.${c}"`))];
  const rows = frames.map(([t, states]) => [t, ...states.flatMap((s) => [...s.p, ...s.q, ...s.v, ...s.w])].join(','));
  mkdirSync(out, { recursive: true });
  writeFileSync(join(out, 'frames.csv'), [...header, names.join(','), ...rows].join('\n') + '\n');
}

/** The module of a package, the folder it lies in, and its version. */
async function installed(name) {
  const found = createRequire(import.meta.url).resolve(name);
  const folder = dirname(found);
  let root = folder;
  while (!existsSync(join(root, 'package.json'))) root = dirname(root);
  const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  return { module: await import(pathToFileURL(found)), folder, version };
}

function withChanges(settings, changes) {
  for (const change of changes) {
    const [key, value] = change.split('=');
    if (!(key in settings)) throw new Error(`${change}: no such setting (${Object.keys(settings).join(', ')})`);
    settings[key] = JSON.parse(value);
  }
  return settings;
}

async function main([engineName, problemFile, out, ...changes]) {
  if (!out) throw new Error('usage: node play.mjs ENGINE PROBLEM OUT [KEY=VALUE]...');
  const problem = JSON.parse(readFileSync(problemFile, 'utf8'));
  if (problem.format !== 'handhold-problem 1') throw new NotAsked(`a problem of format "${problem.format}"`);
  const adapter = await import(new URL(`${engineName}.mjs`, import.meta.url));
  const settings = withChanges({ ...adapter.settings }, changes);
  const scene = sceneOf(problem, adapter.about, settings);
  const found = await installed(adapter.about.package);
  const engine = await adapter.start(found, scene);
  write(out, problem, engineName, found.version, settings, play(engine, problem, scene));
}

main(process.argv.slice(2)).then(
  () => process.exit(0),
  (error) => {
    if (error instanceof NotAsked) console.log(JSON.stringify({ not_asked: error.message }));
    else console.error(error.stack ?? String(error));
    process.exit(error instanceof NotAsked ? 4 : 1);
  });
