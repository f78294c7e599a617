// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo. Friction of a pair is the larger of two coefficients; sliding friction alone is given (condim 3). What moves is a
// heavy body on slides and hinges whose velocity is set before every step: a mocap body has no velocity for its contacts.
import { add, conjugate, multiply, scaled, turned } from './play.mjs';

export const about = { package: '@mujoco/mujoco', twoCoefficients: false };
export const settings = { cone: 'elliptic', impratio: 10, solref: '0.02 1', iterations: 100, integrator: 'Euler' };

const heavy = 1000; // of a body that moves as it is told [kg], [kg m²]

const geom = ({ type, half_extents, radius, half_length }, mu, what) => {
  const size = { box: () => half_extents.join(' '), ball: () => radius, capsule: () => `${radius} ${half_length}` }[type]();
  return `<geom type='${type === 'ball' ? 'sphere' : type}' size='${size}' friction='${mu} 0 0' condim='3' contype='${what}'
    conaffinity='1'/>`;
};
const inertial = (mass, moments) => `<inertial pos='0 0 0' mass='${mass}' diaginertia='${moments.join(' ')}'/>`;
const slides = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((a) => `<joint type='slide' axis='${a.join(' ')}'/>`).join('');
const pose = (s) => `pos='${s.p.join(' ')}' quat='${s.q.join(' ')}'`;

/** Slides of a carrier are along the axes of W: it is not turned, what it carries is. */
function bodyText(s, i) {
  const shape = geom(s.shape, s.mu[0], s.role === 'body' ? 1 : 0);
  if (s.role === 'fixed') return `<body name='b${i}' ${pose(s)}>${shape}</body>`;
  if (s.role === 'body') {
    const joints = s.locked ? slides : "<joint type='free'/>";
    const turn = s.locked ? [`<body name='b${i}' pos='${s.p.join(' ')}'>`, shape.replace('<geom', `<geom quat='${s.q.join(' ')}'`)]
      : [`<body name='b${i}' ${pose(s)}>`, shape];
    return `${turn[0]}${joints}${inertial(s.mass, s.moments)}${turn[1]}</body>`;
  }
  const carrier = `<body name='b${i}' pos='${s.p.join(' ')}' gravcomp='1'>${slides}<joint type='ball'/>${inertial(heavy, [heavy, heavy, heavy])}`;
  const turnedShape = shape.replace('<geom', `<geom quat='${s.q.join(' ')}'`);
  if (s.role === 'driven') return `${carrier}${turnedShape}</body>`;
  return `${carrier}<body name='f${i}' gravcomp='1'><joint type='slide' axis='${s.axis.join(' ')}'/>${inertial(s.mass, [1, 1, 1])}
    ${turnedShape}</body></body>`;
}

export async function start({ module }, { gravity, step, solids, settings: o }) {
  const M = await module.default();
  const model = M.MjModel.from_xml_string(`<mujoco><compiler inertiafromgeom='false' autolimits='true'/>
    <option timestep='${step}' gravity='${gravity.join(' ')}' cone='${o.cone}' impratio='${o.impratio}' tolerance='0'
      iterations='${o.iterations}' integrator='${o.integrator}'/>
    <default><geom solref='${o.solref}'/></default>
    <worldbody>${solids.map(bodyText).join('')}</worldbody></mujoco>`);
  const data = new M.MjData(model);
  const id = (name) => M.mj_name2id(model, M.mjtObj.mjOBJ_BODY.value ?? 1, name);
  const ids = solids.map((s, i) => id(`b${i}`));
  const firstJoint = (i) => model.body_jntadr[ids[i]];
  const q0 = (i) => model.jnt_qposadr[firstJoint(i)], v0 = (i) => model.jnt_dofadr[firstJoint(i)];
  solids.forEach((s, i) => {
    if (s.role === 'body') data.qvel.set(s.locked ? s.v : [...s.v, ...turned(conjugate(s.q), s.w)], v0(i)); // its spin: own axes
  });
  M.mj_forward(model, data);

  return {
    drive(i, from, to) {
      const s = solids[i], turn = multiply(to.q, conjugate(from.q)), sine = Math.hypot(...turn.slice(1));
      const angle = sine > 0 ? 2 * Math.atan2(sine, turn[0]) / sine / step : 0;
      const now = multiply(from.q, conjugate(s.q));
      data.qpos.set([...add(from.p, s.p, -1), ...now], q0(i));
      data.qvel.set([...scaled(add(to.p, from.p, -1), 1 / step), ...turned(conjugate(now), scaled(turn.slice(1), angle))], v0(i));
    },
    push(i, force, torque) {
      data.xfrc_applied.set([...force, ...torque], 6 * (solids[i].role === 'finger' ? id(`f${i}`) : ids[i]));
    },
    step: () => M.mj_step(model, data),
    state(i) {
      const s = solids[i], q = data.qpos.slice(q0(i), q0(i) + 7), v = data.qvel.slice(v0(i), v0(i) + 6);
      if (s.locked) return { p: add(s.p, [...q.slice(0, 3)]), q: s.q, v: [...v.slice(0, 3)], w: [0, 0, 0] };
      return { p: [...q.slice(0, 3)], q: [...q.slice(3, 7)], v: [...v.slice(0, 3)], w: turned([...q.slice(3, 7)], [...v.slice(3, 6)]) };
    },
  };
}
