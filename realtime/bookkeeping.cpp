// SPDX-License-Identifier: Apache-2.0
#include "cases/model/defect.hpp"
#include "realtime/world.hpp"

// Events, energy, and what a world tells about its samples.

namespace handhold::realtime {

void World::set_mode(std::size_t slot, Mode mode, double h) {
  const Mode from = contacts_.mode[slot];
  if (mode == Mode::apart) contacts_.f_O.set(slot, Eigen::Vector3d::Zero());
  if (from == mode) return;
  contacts_.mode[slot] = mode;
  // What touches has no part in the clearance of its pair: now that it is free again it is to be looked at.
  if (mode == Mode::apart && contacts_.id[slot].belongs_to_body())
    pairs_.set_clearance(contacts_.id[slot].body, contacts_.id[slot].phalanx, step_, 0);
  moments_[std::size_t(patch_of_slot_[slot])].stale = true;
  events_.push_back({t_ + h, h, change_of(from, mode), contacts_.id[slot], bodies_[contacts_.id[slot].body].state()});
}

/// A spring that lets go keeps nothing.
void World::let_go(std::size_t slot, double h) {
  if (contacts_.mode[slot] != Mode::apart) {
    const PatchSlot& patch = contacts_.patches[std::size_t(patch_of_slot_[slot])];
    dissipated_ += DEFECT(lost_spring_keeps_its_energy, 1.0, 0.0) *
                   stored(slot, steps_[std::size_t(patch.body)].X_WO.inverse() * point_at_start(patch, slot));
  }
  set_mode(slot, Mode::apart, h);
}

Eigen::Vector3d World::point_at_start(const PatchSlot& patch, std::size_t slot) const {
  if (patch.of_body()) return steps_[std::size_t(patch.phalanx)].X_WO * contacts_.p_P[slot];
  return now_[std::size_t(patch.hand)].X_WP[std::size_t(patch.phalanx)] * contacts_.p_P[slot];
}

/// Energy in the springs of a sample in contact that is at `p_O`.
double World::stored(std::size_t slot, const Eigen::Vector3d& p_O) const {
  const bool of_body = contacts_.id[slot].belongs_to_body();
  const double k = of_body ? scene_.body_contact.stiffness : scene_.contact.stiffness;
  return 0.5 * k * (p_O - contacts_.C_O[slot]).squaredNorm();
}

/// The oil of a support takes, its carrying of the weight gives, and so does a load.
void World::book_body(int body, const Scheme& scheme) {
  const BodyStep& s = steps_[std::size_t(body)];
  const Vector6 u = s.velocity();
  hand_work_ += scheme.h * DEFECT(load_gives_nothing, s.load.dot(u), 0.0);
  if (!s.held) return;
  const RigidBody& rigid = bodies_[std::size_t(body)];
  const double grown = 1 + scheme.reach() * s.drag;
  double twice_kinetic = rigid.mass * u.head<3>().squaredNorm();
  if (s.turns) twice_kinetic += u.tail<3>().dot(s.mass.bottomRightCorner<3, 3>() * u.tail<3>()) / grown;
  dissipated_ += scheme.h * DEFECT(oil_warms_nothing, s.drag, 0.0) * twice_kinetic;
  hand_work_ -= scheme.h * rigid.mass * scene_.gravity.dot(u.head<3>());
}

/// What is inside as it touches was pushed in where nobody saw it, by a hand that is back from a gap, say: whoever did
/// that loaded the spring. `start` is p − C as the step begins.
void World::book_appearance(const Slider& s, const Eigen::Vector3d& start) {
  if (start.dot(s.element.n) < 0) hand_work_ += 0.5 * s.element.stiffness * start.squaredNorm();
}

void World::book_sticking(const PatchStep& p, const Scheme& scheme) {
  dissipated_ += scheme.h * p.stiffness.c * p.stuck.squared_v;
  if (p.source < 0) book_hand(p.target, p.stuck.power, p.stuck.force, p.stuck.torque, scheme);
}

/// What a hand gives whose force turns with the body by half a step's turn, its mean: to third order in that turn no
/// work if the hand rests, and none if it is carried round. `power` is that on the motion which the body sees.
void World::book_hand(int body, double power, const Eigen::Vector3d& force, const Eigen::Vector3d& torque,
                      const Scheme& scheme) {
  const Vector6 u = steps_[std::size_t(body)].velocity();
  const Eigen::Vector3d w = u.tail<3>();
  const Eigen::Vector3d turned = scheme.place() > 0 ? force : Eigen::Vector3d(rotation_by(0.5 * scheme.h * w) * force);
  hand_work_ += scheme.h * (power + turned.dot(u.head<3>()) + torque.dot(w));
}

Eigen::Vector3d World::force(std::size_t slot) const {
  const PatchSlot& patch = contacts_.patches[std::size_t(patch_of_slot_[slot])];
  const BodyStep& step = steps_[std::size_t(patch.body)];
  return step.R * contacts_.f_O[slot];
}

ContactState World::contact(std::size_t slot) const {
  ContactState state;
  const int index = patch_of_slot_[slot];
  const PatchSlot& patch = contacts_.patches[std::size_t(index)];
  if (int(slot) >= patch.first + patch.count) return state;  // idle: fills up a patch of odd size
  const Pose& X_WO = bodies_[std::size_t(patch.body)].X_WO;
  const Pose& X_WS = patch.of_body() ? bodies_[std::size_t(patch.phalanx)].X_WO
                                     : next_[std::size_t(patch.hand)].X_WP[std::size_t(patch.phalanx)];
  state.id = contacts_.id[slot];
  state.mode = contacts_.mode[slot];
  state.p_W = X_WS * contacts_.p_P[slot];
  state.f_W = X_WO.R * contacts_.f_O[slot];
  Anchor anchor{contacts_.C_O[slot], contacts_.n_O[slot]};
  const Eigen::Vector3d p_O = X_WO.inverse() * state.p_W;
  if (state.mode == Mode::apart && !foot(*source(patch.body).field, p_O, anchor)) anchor = {p_O, anchor.n_O};
  state.depth = -(p_O - anchor.C_O).dot(anchor.n_O);
  state.C_W = X_WO * anchor.C_O;
  state.n_W = X_WO.R * anchor.n_O;
  return state;
}

Energy World::energy() const {
  Energy e;
  e.potential = -start_height_;
  for (const int i : by_rank_) {
    const RigidBody& body = bodies_[std::size_t(i)];
    if (!body.moves()) continue;
    e.kinetic += 0.5 * body.mass * body.v.squaredNorm() + 0.5 * body.w.dot(body.inertia() * body.w);
    e.potential -= body.mass * scene_.gravity.dot(body.center());
  }
  for (const Active& active : active_) {
    const PatchSlot& patch = contacts_.patches[std::size_t(active.patch)];
    for (int i = 0; i < patch.count; ++i) {
      const std::size_t slot = patch.slot(i);
      if (contacts_.mode[slot] == Mode::apart) continue;
      const Pose& X_WS = patch.of_body() ? bodies_[std::size_t(patch.phalanx)].X_WO
                                         : next_[std::size_t(patch.hand)].X_WP[std::size_t(patch.phalanx)];
      e.elastic += stored(slot, bodies_[std::size_t(patch.body)].X_WO.inverse() * (X_WS * contacts_.p_P[slot]));
    }
  }
  e.dissipated = dissipated_;
  e.hand_work = hand_work_;
  return e;
}

}  // namespace handhold::realtime
