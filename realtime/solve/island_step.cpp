// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "cases/model/defect.hpp"
#include "realtime/world.hpp"

// One step of one island: what its samples are given, the solve, and what comes of it.

namespace handhold::realtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double slightly = 3e-5;  // of a body's thickness: a micrometre of 3 cm

/// Rotation by a unit quaternion, less the identity: exactly zero for a hand that does not turn.
Matrix3d turn_by(const Eigen::Quaterniond& q) {
  const Vector3d two = 2 * q.vec(), w = q.w() * two;
  const double xx = q.x() * two.x(), yy = q.y() * two.y(), zz = q.z() * two.z();
  const double xy = q.x() * two.y(), xz = q.x() * two.z(), yz = q.y() * two.z();
  Matrix3d turn;
  turn << -yy - zz, xy - w.z(), xz + w.y(), xy + w.z(), -xx - zz, yz - w.x(), xz - w.y(), yz + w.x(), -xx - yy;
  return turn;
}

/// Whether a slider that is still outside in the middle of a step, where the midpoint rule looks, is inside at its end.
bool ends_inside(const Slider& s, const Vector3d& dv, const Vector3d& dw, const Scheme& scheme) {
  const Vector3d v = s.v - dv - dw.cross(s.arm);
  const Vector3d reach = s.trial.lag - s.trial.depth * s.element.n;  // p − C at θ h
  return (reach + (scheme.h - scheme.reach()) * v).dot(s.element.n) < 0;
}

/// Whether the lag of a slider ends on its other side: the midpoint rule takes one that is too long by as much too
/// short, and then back again. So it is after a blow, say, when the pressure that had allowed it is gone.
bool turns_over(const Slider& s, const Scheme& scheme) {
  const Vector3d before = s.trial.lag - scheme.reach() * s.trial.v_t;
  const Vector3d change = (lag_after_sliding(s.element, s.tangent, before) - before) / scheme.theta;
  return s.tangent.dot(before) > 0 && s.tangent.dot(before + change) < 0;
}

/// Whether a point of the plane of a face belongs to the face, which may end at an edge before it, or in a hollow one.
bool lies_on(const VoxelField& field, const Vector3d& C_O, double slack) {
  const double voxel = field.grid().spacing;
  if (field.distance(C_O).distance > voxel) return false;  // cheap, and wrong by half a voxel at most
  const std::optional<SurfacePoint> surface = field.closest(C_O, voxel);
  return surface && std::abs(surface->distance) <= 1.5 * slack;  // more than the callers step aside
}

}  // namespace

void World::step_island(double h) {
  // A step after a jump is Euler's, too: the midpoint rule would let what the jump left ring, and where one contact has
  // changed its mode the next one is likely to.
  const bool smooth = options_.order == 2 && std::none_of(island_.bodies.begin(), island_.bodies.end(),
                                                          [&](int body) { return jumped_[std::size_t(body)] != 0; });
  Scheme scheme{.h = h, .theta = smooth ? 0.5 : 1.0};
  const auto solve = [&] {
    prepare(scheme);
    lap(Phase::patches);
    return solver_.solve(island_, scheme, steps_, contacts_, moments_, role_, options_.solver);
  };
  SolverReport report = solve();
  const bool jumps = options_.order == 2 && (!report.converged || turns_unforeseen(scheme) || changes_mode(scheme));
  for (const int body : island_.bodies) jumped_[std::size_t(body)] = jumps;
  if (smooth && jumps) {
    scheme.theta = 1;
    report = solve();
  }
  if (!report.converged) ++unconverged_;
  finish(scheme);
  lap(Phase::finish);
}

void World::prepare(const Scheme& scheme) {
  // At θ = 1, `detect` has just predicted all bodies; a solve leaves its change of velocity behind.
  for (const int body : island_.bodies) {
    BodyStep& s = steps_[std::size_t(body)];
    if (options_.order == 1)
      s.change.setZero();
    else
      predict_body(body, scheme);
  }
  for (PatchStep& p : island_.patches) prepare_patches(p, scheme);
}

void World::prepare_patches(PatchStep& p, const Scheme& scheme) {
  const ContactParameters& contact = p.source < 0 ? scene_.contact : scene_.body_contact;
  const double k = contact.stiffness, c = contact.damping;
  p.stiffness = {k, c, k * scheme.reach() + c, k * scheme.lead() + c};
  const Friction& friction = source(p.target).friction;
  p.friction =
      p.source < 0 ? friction : DEFECT(pair_friction_of_one, combined(friction, source(p.source).friction), friction);
  const BodyStep& target = steps_[std::size_t(p.target)];
  if (p.source >= 0) p.offset = target.center - steps_[std::size_t(p.source)].center;
  p.watches = false;
  for (int i = p.first_patch; i < p.first_patch + p.patch_count; ++i) {
    SlotStep& step = island_.slots[std::size_t(i)];
    step.motion = p.source < 0 ? motion_of_hand(patch(step.patch), target, scheme)
                               : motion_of_body(steps_[std::size_t(p.source)], target, scheme);
    if (give_roles(p, step, scheme)) p.watches = true;
  }
}

/// Points of a phalanx go straight from where they are before the step to where they are after it, x0 to x1; for the
/// midpoint rule by 2 tan(α / 2) axis × (x0 + x1) / 2 about it (Cayley), with α and axis of its turn. Euler's rule sees
/// them from the body, as that would move: else a hand that carries a body round would press it harder at every step,
/// by the sagitta of its way, and take work from nowhere.
PatchMotion World::motion_of_hand(const PatchSlot& patch, const BodyStep& target, const Scheme& scheme) const {
  const Pose& X0 = now_[std::size_t(patch.hand)].X_WP[std::size_t(patch.phalanx)];
  const Pose& X1 = next_[std::size_t(patch.hand)].X_WP[std::size_t(patch.phalanx)];
  const Eigen::Quaterniond turn = X1.R * X0.R.conjugate();
  const double rate = 1 / scheme.h;
  const Vector3d v0 = target.u0.head<3>(), w0 = target.u0.tail<3>(), v = rate * (X1.p - X0.p) - v0;
  PatchMotion m;
  m.R = X0.R.toRotationMatrix();
  if (scheme.place() > 0) {
    constexpr double half_turn = 1e-3;  // beyond it the mean of two orientations is none
    m.R = Matrix3d(0.5 * (m.R + X1.R.toRotationMatrix()));
    m.t = 0.5 * (X0.p + X1.p) - target.center;
    m.W = cross_matrix(2 * rate / std::copysign(std::max(std::abs(turn.w()), half_turn), turn.w()) * turn.vec() - w0);
    m.u = v - w0.cross(m.t);
    return m;
  }
  const Matrix3d back = turn_by(target.turn.conjugate());
  m.t = X0.p - target.center;
  m.W = rate * turn_by(target.turn.conjugate() * turn);
  m.u = v + back * (v + rate * m.t);
  return m;
}

PatchMotion World::motion_of_body(const BodyStep& from, const BodyStep& target, const Scheme& scheme) const {
  const Vector3d v0 = target.u0.head<3>(), w0 = target.u0.tail<3>();
  const Vector3d v1 = from.u0.head<3>(), w1 = from.u0.tail<3>();
  PatchMotion m;
  m.R = from.R;
  m.t = from.origin() - target.center;
  if (scheme.place() > 0) {
    m.W = cross_matrix(w1 - w0);
    m.u = v1 - w1.cross(from.arm_O) - v0 - w0.cross(m.t);
    return m;
  }
  const double rate = 1 / scheme.h;
  const Matrix3d back = turn_by(target.turn.conjugate());
  m.W = rate * turn_by(target.turn.conjugate() * from.turn);
  m.u = v1 - v0 + back * (v1 - v0 + rate * (from.center - target.center)) - m.W * from.arm_O;
  return m;
}

/// True if a sample is on watch. Roles of samples that all stick, as they did, are what they were.
bool World::give_roles(const PatchStep& p, const SlotStep& step, const Scheme& scheme) {
  const PatchSlot& slots = patch(step.patch);
  const StickMoments& moments = moments_[std::size_t(step.patch)];
  if (!moments.stale && moments.count == slots.count) return false;
  bool watches = false;
  for (int i = 0; i < slots.count; ++i) {
    const std::size_t slot = slots.slot(i);
    role_[slot] = role_of(p, step, slot, scheme);
    watches = watches || role_[slot] == Role::watch;
  }
  return watches;
}

Role World::role_of(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme) {
  if (contacts_.mode[slot] == Mode::stick) return Role::linear;
  if (contacts_.mode[slot] == Mode::slip) return Role::sliding;
  const bool finger = p.source < 0;
  if (finger && !next_[std::size_t(patch(step.patch).hand)].present) return Role::idle;
  if (!finger && !(watched_[std::size_t(step.patch)] && near_[slot])) return Role::idle;
  Anchor anchor;
  const Role role =
      finger ? role_of_finger(p, step, slot, scheme, anchor) : role_of_corner(p, step, slot, scheme, anchor);
  if (role == Role::idle) return role;
  contacts_.C_O.set(slot, anchor.C_O);
  contacts_.n_O.set(slot, anchor.n_O);
  return role;
}

/// Where a sample would be at the end of the step, in O, if nothing held its bodies back.
Vector3d World::free_end(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme) const {
  const BodyStep& target = steps_[std::size_t(p.target)];
  const RigidBody& body = bodies_[std::size_t(p.target)];
  Vector3d fall = -free_change(body, target, scheme);
  if (p.source >= 0)
    fall += DEFECT(own_fall_unforeseen, 1.0, 0.0) *
            free_change(bodies_[std::size_t(p.source)], steps_[std::size_t(p.source)], scheme);
  const Vector3d x = step.motion.R * contacts_.p_P[slot];
  const Vector3d v = step.motion.W * x + step.motion.u;
  const Vector3d end = x + step.motion.t + (scheme.h - scheme.place()) * v + scheme.h / scheme.theta * fall;
  return target.R.transpose() * end + body.center_O;
}

/// A hand's sample that is apart takes part if it would be inside at the end of the step: k d + c d' > 0 alone would
/// let a damper push before the surface is reached.
Role World::role_of_finger(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme,
                           Anchor& anchor) const {
  const PatchSlot& patch = contacts_.patches[std::size_t(step.patch)];
  const VoxelField& field = *source(p.target).field;
  const Vector3d to = free_end(p, step, slot, scheme);
  const Vector3d from = steps_[std::size_t(p.target)].X_WO.inverse() * (start_pose(patch) * contacts_.p_P[slot]);
  const double interpolation = 0.5 * field.grid().spacing;
  if (field.distance(to).distance >= (to - from).norm() + interpolation) return Role::idle;  // no surface on the way
  if (!find_touch(field, from, to, TouchNormal::smooth, anchor)) return Role::idle;
  return (to - anchor.C_O).dot(anchor.n_O) < 0 ? Role::free : Role::idle;
}

/// A corner of a body on an edge of another has no nearest face there. The face it comes through is looked for from
/// inside its own body, where it comes from. What the other contacts of both bodies leave of their motion shows only in
/// the solution, so one that is near stays on watch, if it is above the face.
Role World::role_of_corner(const PatchStep& p, const SlotStep& step, std::size_t slot, const Scheme& scheme,
                           Anchor& anchor) const {
  const VoxelField& field = *source(p.target).field;
  const Pose X_OS = steps_[std::size_t(p.target)].X_WO.inverse() * steps_[std::size_t(p.source)].X_WO;
  const Vector3d& outward = outward_[std::size_t(p.source)][contacts_.id[slot].sample];
  const double thickness = source(p.source).field->bounds().sizes().minCoeff();
  const Vector3d inside = X_OS * (contacts_.p_P[slot] - 0.5 * thickness * outward);
  const Vector3d to = free_end(p, step, slot, scheme);
  const Vector3d beyond = to + field.grid().spacing * (X_OS.R * outward);
  // A corner right on a corner would be missed as often as not: slightly towards the middle of the target it hits.
  const double slack = slightly * thickness;
  const Vector3d aside = slack * (field.bounds().center() - to).normalized();
  if (!find_touch(field, inside + aside, beyond + aside, TouchNormal::face, anchor)) return Role::idle;
  // The way from inside is no motion: the anchor lies where the sample's own way crosses that face, or below its start.
  const Vector3d start = X_OS * contacts_.p_P[slot];
  const double height = (start - anchor.C_O).dot(anchor.n_O), depth = -(to - anchor.C_O).dot(anchor.n_O);
  const double crossed = height > 0 && depth > 0 ? height / (height + depth) : 0;
  const Vector3d at = start + crossed * (to - start);
  anchor.C_O = at - (at - anchor.C_O).dot(anchor.n_O) * anchor.n_O;
  if (lies_on(field, anchor.C_O + aside, slack)) return depth > -1e-3 * slack ? Role::free : Role::watch;
  // That face ends before: an edge cuts into the body between the sample and where it was looked from.
  return find_touch(field, start, to, TouchNormal::face, anchor) ? Role::free : Role::idle;
}

/// The midpoint rule takes arms and normals in the middle of the step as it was predicted: what turns back and forth
/// too fast for that would be driven by it.
bool World::turns_unforeseen(const Scheme& scheme) const {
  constexpr double slight = 0.01;  // in the middle [rad]: of every force, 1 % points elsewhere
  return std::any_of(island_.bodies.begin(), island_.bodies.end(), [&](int body) {
    return scheme.place() * steps_[std::size_t(body)].change.tail<3>().norm() > slight;
  });
}

/// Whether any sample touches (be it in the second half of the step), lets go, breaks away or sticks again in the
/// solution, or slides back at its end (the mean of a step in which sliding stops still slides), or has its lag turned
/// over.
bool World::changes_mode(const Scheme& scheme) const {
  for (const PatchStep& p : island_.patches) {
    Vector3d dv, dw;
    p.relative(steps_, dv, dw);
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      const Slider& s = island_.sliders[std::size_t(i)];
      const Mode mode = contacts_.mode[s.slot];
      const bool presses = s.trial.N > 0;
      const bool slides = s.sliding && s.trial.t_norm > p.friction.mu_dynamic * s.trial.N;
      if (mode == Mode::apart && !presses && ends_inside(s, dv, dw, scheme)) return true;
      const Mode next = !presses ? Mode::apart : slides ? Mode::slip : Mode::stick;
      if (next != mode) return true;
      const Vector3d v_end = s.v - (dv + dw.cross(s.arm)) / scheme.theta;
      if (slides && s.tangent.dot(v_end) < 0) return true;
      if (slides && turns_over(s, scheme)) return true;
    }
  }
  return false;
}

void World::finish(const Scheme& scheme) {
  for (const int body : island_.bodies) {
    RigidBody& rigid = bodies_[std::size_t(body)];
    const BodyStep& s = steps_[std::size_t(body)];
    move(rigid, s, scheme);
    const Vector6 u = s.velocity();
    moved_[std::size_t(body)] = scheme.h * u.head<3>();
    pushed_[std::size_t(body)] = rigid.v - s.u0.head<3>() - free_change(rigid, s, {.h = scheme.h});
    turned_[std::size_t(body)] = scheme.h * u.tail<3>().norm();
    scheme_[std::size_t(body)] = scheme;
    book_body(body, scheme);
  }
  for (const PatchStep& p : island_.patches) {
    if (p.sums.count > 0) book_sticking(p, scheme);
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i)
      finish_slider(p, island_.sliders[std::size_t(i)], scheme);
  }
}

void World::finish_slider(const PatchStep& p, const Slider& s, const Scheme& scheme) {
  if (!(s.trial.N > 0)) return let_go(s.slot, scheme.h);
  const BodyStep& target = steps_[std::size_t(p.target)];
  contacts_.f_O.set(s.slot, target.R.transpose() * s.f);
  const bool slides = s.sliding && s.trial.t_norm > p.friction.mu_dynamic * s.trial.N;
  Vector3d dv, dw;
  p.relative(steps_, dv, dw);
  const Vector3d change = dv + dw.cross(s.arm), v = s.v - change;
  const Vector3d reach = s.trial.lag - s.trial.depth * s.element.n;  // p − C at θ h
  const double closing = (change - s.element.v_p).dot(s.element.n);
  Vector3d stretch = s.trial.v_t;  // rate of the lag
  if (slides) {
    const Vector3d before = s.trial.lag - scheme.reach() * s.trial.v_t;
    stretch = (lag_after_sliding(s.element, s.tangent, before) - before) / scheme.reach();
    slip(p, s, reach + (scheme.h - scheme.reach()) * v, scheme.h * (s.trial.v_t - stretch));
  }
  dissipated_ +=
      scheme.h * DEFECT(damper_warms_nothing, s.element.damping, 0.0) * (closing * closing + stretch.squaredNorm());
  if (p.source < 0) {
    book_hand(p.target, s.f.dot(v), s.f, s.arm.cross(s.f), scheme);
    if (s.entering) book_appearance(s, reach - scheme.reach() * v);
  }
  set_mode(s.slot, slides ? Mode::slip : Mode::stick, scheme.h);
}

/// The work of friction is that on what the slider slips, wherever the surface lets its anchor go.
void World::slip(const PatchStep& p, const Slider& s, const Vector3d& reach, const Vector3d& step) {
  const BodyStep& target = steps_[std::size_t(p.target)];
  const Matrix3d R_OW = target.R.transpose();
  Anchor anchor{contacts_.C_O[s.slot], contacts_.n_O[s.slot]};
  contacts_.from_O.set(s.slot, anchor.C_O);
  contacts_.from_n_O.set(s.slot, anchor.n_O);
  if (!slide(*source(p.target).field, anchor.C_O + R_OW * reach, R_OW * step, anchor)) slid_off_.push_back(s.slot);
  contacts_.C_O.set(s.slot, DEFECT(anchor_kept_through_slide, anchor.C_O, contacts_.C_O[s.slot]));
  contacts_.n_O.set(s.slot, DEFECT(stale_normal, anchor.n_O, contacts_.n_O[s.slot]));
  dissipated_ += DEFECT(slip_warms_nothing, s.tangent.dot(step), 0.0);
}

}  // namespace handhold::realtime
