// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo. Friction of a pair is the larger of two coefficients; sliding friction alone is given (condim 3). What moves is a
// heavy body on slides and hinges whose velocity is set before every step: a mocap body has no velocity for its contacts.
import { add, conjugate, multiply, scaled, turned } from './play.mjs';

export const about = { package: '@mujoco/mujoco', twoCoefficients: false };
export const settings = { cone: 'elliptic', impratio: 10, solref: '0.02 1', iterations: 100, integrator: 'Euler' };

const heavy = 1000; // of a body that moves as it is told [kg], [kg m²]

const text = (a) => a.join(' ');
const sizes = { box: (s) => text(s.half_extents), ball: (s) => s.radius, capsule: (s) => `${s.radius} ${s.half_length}` };
const slides = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((a) => `<joint type='slide' axis='${text(a)}'/>`).join('');
const inertial = (mass, moments) => `<inertial pos='0 0 0' mass='${mass}' diaginertia='${text(moments)}'/>`;
const geom = (s, q) => `<geom type='${s.shape.type === 'ball' ? 'sphere' : s.shape.type}' size='${sizes[s.shape.type](s.shape)}'
  quat='${text(q)}' friction='${s.mu[0]} 0 0' condim='3' contype='${s.role === 'body' ? 1 : 0}' conaffinity='1'/>`;

/** Slides are along the axes of W: what slides or is driven is a body that is not turned, with a geom that is. */
function bodyText(s, i, solids) {
  const open = `<body name='b${i}' pos='${text(s.p)}'`, unturned = [1, 0, 0, 0];
  if (s.role === 'fixed') return `${open}>${geom(s, s.q)}</body>`;
  if (s.role === 'body' && !s.locked)
    return `${open} quat='${text(s.q)}'><freejoint/>${inertial(s.mass, s.moments)}${geom(s, unturned)}</body>`;
  if (s.role === 'body') return `${open}>${slides}${inertial(s.mass, s.moments)}${geom(s, s.q)}</body>`;
  if (s.role === 'finger') return ''; // in its carrier
  const fingers = solids.map((f, k) => f.carrier !== i ? '' : `<body name='b${k}' gravcomp='1'>
    <joint type='slide' axis='${text(f.axis)}'/>${inertial(f.mass, [1, 1, 1])}${geom(f, f.q)}</body>`).join('');
  return `${open} gravcomp='1'>${slides}<joint type='ball'/>${inertial(heavy, [heavy, heavy, heavy])}
    ${s.ghost ? '' : geom(s, s.q)}${fingers}</body>`;
}

export async function start({ module }, { gravity, step, solids, settings: o }) {
  const M = await module.default();
  const model = M.MjModel.from_xml_string(`<mujoco><compiler inertiafromgeom='false' autolimits='true'/>
    <option timestep='${step}' gravity='${gravity.join(' ')}' cone='${o.cone}' impratio='${o.impratio}' tolerance='0'
      iterations='${o.iterations}' integrator='${o.integrator}'/>
    <default><geom solref='${o.solref}'/></default>
    <worldbody>${solids.map((s, i) => bodyText(s, i, solids)).join('')}</worldbody></mujoco>`);
  const data = new M.MjData(model);
  const ids = solids.map((s, i) => M.mj_name2id(model, M.mjtObj.mjOBJ_BODY.value, `b${i}`));
  const firstJoint = (i) => model.body_jntadr[ids[i]];
  const q0 = (i) => model.jnt_qposadr[firstJoint(i)], v0 = (i) => model.jnt_dofadr[firstJoint(i)];
  solids.forEach((s, i) => {
    const spin = s.role === 'body' && !s.locked ? turned(conjugate(s.q), s.w) : []; // in its own axes
    if (s.role === 'body') data.qvel.set([...s.v, ...spin], v0(i));
  });
  M.mj_forward(model, data);

  return {
    drive(i, from, to) {
      const s = solids[i], turn = multiply(to.q, conjugate(from.q)), sine = Math.hypot(...turn.slice(1));
      const angle = sine > 0 ? 2 * Math.atan2(sine, turn[0]) / sine / step : 0;
      const now = multiply(from.q, conjugate(s.q));
      data.qpos.set([...add(from.p, s.p, -1), ...now], q0(i));
      const w = turned(conjugate(now), scaled(turn.slice(1), angle));
      data.qvel.set([...scaled(add(to.p, from.p, -1), 1 / step), ...w], v0(i));
    },
    push(i, force, torque) {
        data.xfrc_applied.set([...force, ...torque], 6 * ids[i]);
    },
    step: () => M.mj_step(model, data),
    state(i) {
      const s = solids[i];
      const q = [...data.qpos.slice(q0(i), q0(i) + 7)], v = [...data.qvel.slice(v0(i), v0(i) + 6)];
      if (s.locked) return { p: add(s.p, q.slice(0, 3)), q: s.q, v: v.slice(0, 3), w: [0, 0, 0] };
      return { p: q.slice(0, 3), q: q.slice(3), v: v.slice(0, 3), w: turned(q.slice(3), v.slice(3)) };
    },
  };
}
