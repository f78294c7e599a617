#include <cmath>

#include "realtime/world.hpp"

// One step of one island: what its samples are given, the solve, and what comes of it.

namespace handhold::realtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double touching = 1e-6;  // [m]

Matrix3d cross_times(const Vector3d& w, const Matrix3d& R) {
  Matrix3d product;
  for (int i = 0; i < 3; ++i) product.col(i) = w.cross(R.col(i));
  return product;
}

}  // namespace

void World::step_island(double h) {
  Scheme scheme{.h = h, .theta = options_.order == 2 ? 0.5 : 1.0};
  const auto solve = [&] {
    prepare(scheme);
    return solver_.solve(island_, scheme.reach(), steps_, contacts_, samples_, role_, options_.solver);
  };
  SolverReport report = solve();
  if (scheme.theta < 1 && (!report.converged || changes_mode())) {
    scheme.theta = 1;
    report = solve();
  }
  if (!report.converged) ++unconverged_;
  finish(scheme);
}

void World::prepare(const Scheme& scheme) {
  // At θ = 1, `detect` has just predicted all bodies; a solve leaves its change of velocity behind.
  for (const int body : island_.bodies) {
    BodyStep& s = steps_[std::size_t(body)];
    if (options_.order == 1)
      s.change.setZero();
    else
      s = predicted(body, scheme);
  }
  for (PatchStep& p : island_.patches) prepare_patch(p, scheme);
}

void World::prepare_patch(PatchStep& p, const Scheme& scheme) {
  const PatchSlot& slot = patch(p.patch);
  p.target = slot.body;
  p.source = slot.of_body() ? slot.phalanx : -1;
  const ContactParameters& contact = slot.of_body() ? scene_.body_contact : scene_.contact;
  p.stiffness = {contact.stiffness, contact.damping, contact.stiffness * scheme.reach() + contact.damping};
  const Friction& friction = source(p.target).friction;
  p.friction = p.source < 0 ? friction : combined(friction, source(p.source).friction);
  if (p.source >= 0) p.offset = steps_[std::size_t(p.target)].center - steps_[std::size_t(p.source)].center;
  for (int i = 0; i < slot.count; ++i) {
    const std::size_t s = slot.slot(i);
    samples_.used[s] = p.source < 0 || contacts_.mode[s] != Mode::apart || (watched_[std::size_t(p.patch)] && near_[s]);
  }
  const PatchMotion m = motion(p, scheme);
  project(m, contacts_, slot, samples_);
  bool anchored = false;
  for (int i = 0; i < slot.count; ++i) {
    const std::size_t s = slot.slot(i);
    role_[s] = role_of(p, s, scheme);
    samples_.linear[s] = role_[s] == Role::linear ? 1 : 0;
    p.watches = p.watches || role_[s] == Role::watch;
    anchored = anchored || role_[s] == Role::free || role_[s] == Role::watch;
  }
  if (anchored) project(m, contacts_, slot, samples_);
}

PatchMotion World::motion(const PatchStep& p, const Scheme& scheme) const {
  const BodyStep& target = steps_[std::size_t(p.target)];
  const Vector3d v0 = target.u0.head<3>(), w0 = target.u0.tail<3>();
  PatchMotion m;
  if (p.source >= 0) {
    const BodyStep& from = steps_[std::size_t(p.source)];
    const Vector3d v1 = from.u0.head<3>(), w1 = from.u0.tail<3>();
    m.R_a = from.R;
    m.t_a = from.origin() - target.center;
    m.R_v = cross_times(w1 - w0, m.R_a);
    m.t_v = v1 - w1.cross(from.arm_O) - v0 - w0.cross(m.t_a);
  } else {
    const PatchSlot& slot = contacts_.patches[std::size_t(p.patch)];
    const Pose& X0 = now_[std::size_t(slot.hand)].X_WP[std::size_t(slot.phalanx)];
    const Pose& X1 = next_[std::size_t(slot.hand)].X_WP[std::size_t(slot.phalanx)];
    const Matrix3d R0 = X0.R.toRotationMatrix(), R1 = X1.R.toRotationMatrix();
    const double at = scheme.place() / scheme.h;
    m.R_a = (1 - at) * R0 + at * R1;
    m.t_a = (1 - at) * X0.p + at * X1.p - target.center;
    m.R_v = (R1 - R0) / scheme.h - cross_times(w0, m.R_a);
    m.t_v = (X1.p - X0.p) / scheme.h - v0 - w0.cross(m.t_a);
  }
  const double lead = scheme.reach() - scheme.place();
  m.R_r = m.R_a + lead * m.R_v;
  m.t_r = m.t_a + target.arm_O + lead * m.t_v;
  m.R = target.R;
  if (!target.turned) return m;
  for (Matrix3d* R : {&m.R_v, &m.R_r, &m.R}) *R = Matrix3d(target.turn * *R);
  for (Vector3d* t : {&m.t_v, &m.t_r}) *t = Vector3d(target.turn * *t);
  return m;
}

Role World::role_of(const PatchStep& p, std::size_t slot, const Scheme& scheme) {
  if (contacts_.mode[slot] == Mode::stick) return Role::linear;
  if (contacts_.mode[slot] == Mode::slip) return Role::sliding;
  if (!samples_.used[slot]) return Role::idle;
  Anchor anchor;
  const Role role = p.source < 0 ? role_of_finger(p, slot, scheme, anchor) : role_of_corner(p, slot, scheme, anchor);
  if (role == Role::idle) return role;
  contacts_.C_O.set(slot, anchor.C_O);
  contacts_.n_O.set(slot, anchor.n_O);
  return role;
}

/// Where a sample would be at the end of the step, in O, if nothing held its bodies back.
Vector3d World::free_end(const PatchStep& p, std::size_t slot, const Scheme& scheme) const {
  const BodyStep& target = steps_[std::size_t(p.target)];
  const RigidBody& body = bodies_[std::size_t(p.target)];
  Vector3d fall = -free_change(body, target, scheme);
  if (p.source >= 0) fall += free_change(bodies_[std::size_t(p.source)], steps_[std::size_t(p.source)], scheme);
  const Vector3d end = samples_.arm[slot] + (scheme.h - scheme.place()) * (target.turn.transpose() * samples_.v[slot]) +
                       scheme.h / scheme.theta * fall;
  return target.R.transpose() * end + body.center_O;
}

/// A hand's sample that is apart takes part if it would be inside at the end of the step: k d + c d' > 0 alone would
/// let a damper push before the surface is reached.
Role World::role_of_finger(const PatchStep& p, std::size_t slot, const Scheme& scheme, Anchor& anchor) const {
  const PatchSlot& patch = contacts_.patches[std::size_t(p.patch)];
  const VoxelField& field = *source(p.target).field;
  const Vector3d to = free_end(p, slot, scheme);
  const Vector3d from = steps_[std::size_t(p.target)].X_WO.inverse() * (start_pose(patch) * contacts_.p_P[slot]);
  const double interpolation = 0.5 * field.grid().spacing;
  if (field.distance(to).distance >= (to - from).norm() + interpolation) return Role::idle;  // no surface on the way
  if (!find_touch(field, from, to, TouchNormal::smooth, anchor)) return Role::idle;
  return (to - anchor.C_O).dot(anchor.n_O) < 0 ? Role::free : Role::idle;
}

/// A corner of a body on an edge of another has no nearest face there. The face it comes through is looked for from
/// inside its own body, where it comes from. What the other contacts of both bodies leave of their motion shows only in
/// the solution, so one that is near stays on watch.
Role World::role_of_corner(const PatchStep& p, std::size_t slot, const Scheme& scheme, Anchor& anchor) const {
  const VoxelField& field = *source(p.target).field;
  const Pose X_OS = steps_[std::size_t(p.target)].X_WO.inverse() * steps_[std::size_t(p.source)].X_WO;
  const Vector3d& outward = outward_[std::size_t(p.source)][contacts_.id[slot].sample];
  const double thickness = source(p.source).field->bounds().sizes().minCoeff();
  const Vector3d inside = X_OS * (contacts_.p_P[slot] - 0.5 * thickness * outward);
  const Vector3d to = free_end(p, slot, scheme);
  const Vector3d beyond = to + field.grid().spacing * (X_OS.R * outward);
  // A corner right on a corner would be missed as often as not: a micrometre towards the middle of the target it hits.
  const Vector3d aside = touching * (field.bounds().center() - to).normalized();
  if (!find_touch(field, inside + aside, beyond + aside, TouchNormal::face, anchor)) return Role::idle;
  // The way from inside is no motion: the anchor lies where the sample's own way crosses that face, or below its start.
  const Vector3d start = X_OS * contacts_.p_P[slot];
  const double height = (start - anchor.C_O).dot(anchor.n_O), depth = -(to - anchor.C_O).dot(anchor.n_O);
  const double crossed = height > 0 && depth > 0 ? height / (height + depth) : 0;
  const Vector3d at = start + crossed * (to - start);
  anchor.C_O = at - (at - anchor.C_O).dot(anchor.n_O) * anchor.n_O;
  return depth > -1e-3 * touching ? Role::free : Role::watch;
}

/// Whether any sample touches, lets go, breaks away or sticks again in the solution, or slides back at its end: the
/// mean of a step in which sliding stops still slides.
bool World::changes_mode() const {
  for (const PatchStep& p : island_.patches) {
    Vector3d dv, dw;
    p.relative(steps_, dv, dw);
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      const Slider& s = island_.sliders[std::size_t(i)];
      const Mode mode = contacts_.mode[s.slot];
      const bool presses = s.trial.N > 0;
      const bool slides = s.sliding && s.trial.t_norm > p.friction.mu_dynamic * s.trial.N;
      const Mode next = !presses ? Mode::apart : slides ? Mode::slip : Mode::stick;
      if (next != mode) return true;
      const Vector3d v_end = s.element.v_p - 2 * (dv + dw.cross(s.arm));
      if (slides && s.tangent.dot(v_end) < 0) return true;
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
    changed_[std::size_t(body)] = rigid.v - s.u0.head<3>();
    turned_[std::size_t(body)] = scheme.h * u.tail<3>().norm();
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
  contacts_.f_W.set(s.slot, s.f);
  const bool slides = s.sliding && s.trial.t_norm > p.friction.mu_dynamic * s.trial.N;
  Vector3d dv, dw;
  p.relative(steps_, dv, dw);
  const Vector3d v = s.element.v_p - dv - dw.cross(s.arm);
  const Vector3d reach = s.trial.lag - s.trial.depth * s.element.n;  // p − C at θ h
  const double closing = -v.dot(s.element.n);
  Vector3d stretch = s.trial.v_t;  // rate of the lag
  if (slides) {
    const Vector3d before = s.trial.lag - scheme.reach() * s.trial.v_t;
    stretch = (lag_after_sliding(s.element, s.tangent, before) - before) / scheme.reach();
    slip(p, s, reach + (scheme.h - scheme.reach()) * v, scheme.h * (s.trial.v_t - stretch));
  }
  dissipated_ += scheme.h * s.element.damping * (closing * closing + stretch.squaredNorm());
  if (p.source < 0) {
    const Vector6 u = steps_[std::size_t(p.target)].velocity();
    hand_work_ += scheme.h * s.f.dot(v + u.head<3>() + u.tail<3>().cross(s.arm));
    if (s.entering) book_appearance(s, reach - scheme.reach() * v);
  }
  set_mode(s.slot, slides ? Mode::slip : Mode::stick, scheme.h);
}

/// The work of friction is that on what the slider slips, wherever the surface lets its anchor go.
void World::slip(const PatchStep& p, const Slider& s, const Vector3d& reach, const Vector3d& step) {
  const BodyStep& target = steps_[std::size_t(p.target)];
  const Matrix3d R_OW = (target.turn * target.R).transpose();
  Anchor anchor{contacts_.C_O[s.slot], contacts_.n_O[s.slot]};
  if (!slide(*source(p.target).field, anchor.C_O + R_OW * reach, R_OW * step, anchor)) slid_off_.push_back(s.slot);
  contacts_.C_O.set(s.slot, anchor.C_O);
  contacts_.n_O.set(s.slot, anchor.n_O);
  dissipated_ += s.tangent.dot(step);
}

}  // namespace handhold::realtime
