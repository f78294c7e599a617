// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Audits every sub-step of a World from the outside: from the states and forces it shows before and after, with the
// laws written down anew here. What holds in any scene, chaotic or not:
//
//   finite        no NaN, no infinity, unit quaternions
//   momentum      m (v1 − v0) = h (m g + F + Σ f), L1 − L0 = h (T + Σ a × f), for every body on its own
//   no adhesion   N >= 0, and no force at all while apart; free flight is the balance of momentum without forces
//   cone          |f_t| <= μ N (1 + 1e-12), μ_s while it sticks and μ_d while it slides
//   element       f = k r + c v where it sticks; −N n + μ_d N t*/|t*| where it slides; what comes in is damped
//                 by the depth that it reaches, and not pushed before it touches
//   anchors       bitwise unmoved while they stick; dissipation never falls
//   energy        the book is off by the scheme's own, known terms and by nothing else (see EnergyTerms), and so bodies
//                 never have more than hands gave and those terms added

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "cases/model/scene.hpp"
#include "realtime/detection/surface.hpp"
#include "realtime/world.hpp"
#include "tests/realtime/audited_sample.hpp"

namespace handhold::realtime::testing {

/// Of one World.
class StepAudit {
 public:
  explicit StepAudit(const Scene& scene) : scene_(scene), moved_(scene.bodies.size()) {}

  void begin(const World& world, const std::vector<HandFrame>& hands) {
    hands_ = hands;
    start_ = book(world);
    tally_.throughput = world.energy().kinetic;
  }

  /// Advances a world of one sub-step a frame by h, and audits that, of either order.
  void advance(World& world, double h, const std::vector<HandFrame>& hands) {
    h_ = h;
    t_ = world.time();
    faults_.at(t_);
    bodies_ = world.bodies();
    contacts_ = world.contacts();
    energy_ = world.energy();
    const long unconverged = world.unconverged();
    world.advance(h, hands);
    ++tally_.steps;
    tally_.unconverged += world.unconverged() - unconverged;
    solved_ = world.unconverged() == unconverged;
    next_ = &hands;
    audit(world);
    hands_ = hands;
  }

  [[nodiscard]] const AuditTally& tally() const { return tally_; }
  [[nodiscard]] static double book(const World& world) { return energy_sum(world.energy()); }

 private:
  void audit(const World& world) {
    if (!check_finite(world)) return;
    if (!solved_) return;  // counted: its forces are only as good as the iteration got
    for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i] = moved(world, i);
    terms_ = {};
    size_ = noise_ = power_ = turned_ = rounding_energy_ = 0;
    after_ = &world.bodies();
    events_ = &world.events();
    const Contacts& now = world.contacts();
    lost_.resize(now.size(), 0);
    for (const PatchSlot& patch : now.patches) {
      if (!patch.active) {
        for (int i = 0; i < patch.count; ++i) lost_[patch.slot(i)] = 0;
        continue;
      }
      // A sample that is found to be just apart leaves the rounding of its position, as a force, in the solve.
      const double k = patch.of_body() ? scene_.body_contact.stiffness : scene_.contact.stiffness;
      noise_ += h_ * 1e-15 * k * patch.count * moved_[std::size_t(patch.body)].center.norm();
      for (int i = 0; i < patch.count; ++i) {
        const std::size_t slot = patch.slot(i);
        note_loss(patch, slot);
        if (now.mode[slot] == Mode::apart)
          faults_.require(world.force(slot).isZero(0), Name{now.id[slot]}, " is apart and has a force");
        else
          check_sample(world, patch, slot);
      }
    }
    for (std::size_t i = 0; i < moved_.size(); ++i) size_ += h_ * moved_[i].load.norm() + moved_[i].size();
    for (std::size_t i = 0; i < moved_.size(); ++i) check_momentum(i);
    check_energy(world);
  }

  bool check_finite(const World& world) {
    bool finite = std::isfinite(book(world));
    for (const RigidBody& b : world.bodies()) {
      finite = finite && b.v.allFinite() && b.w.allFinite() && b.X_WO.p.allFinite() && b.X_WO.R.coeffs().allFinite();
      faults_.require(std::abs(b.X_WO.R.norm() - 1) < 4e-15, "a quaternion of norm ", b.X_WO.R.norm());  // rounding
    }
    faults_.require(finite, "a number that is not finite");
    return finite;
  }

  [[nodiscard]] AuditedBody moved(const World& world, std::size_t i) const {
    const RigidBody& before = bodies_[i];
    const Scheme scheme{.h = h_, .theta = before.moves() ? world.scheme(i).theta : 1};
    const Load load = scene_.bodies[i].load ? scene_.bodies[i].load(t_ + scheme.reach()) : Load{};
    return audited_body(before, world.bodies()[i], scheme, scene_.gravity, load, before.held(t_ + h_));
  }

  /// Hand's sample at the start of the step.
  [[nodiscard]] Vector3d hand_point(const PatchSlot& patch, const Vector3d& p_P) const {
    const auto hand = std::size_t(patch.hand);
    const HandFrame& frame = hands_[hand].present ? hands_[hand] : (*next_)[hand];
    return frame.X_WP[std::size_t(patch.phalanx)] * p_P;
  }

  /// Sample point as the step begins.
  [[nodiscard]] Vector3d before_point(const PatchSlot& patch, const Vector3d& p_P) const {
    if (patch.of_body()) return bodies_[std::size_t(patch.phalanx)].X_WO * p_P;
    return hand_point(patch, p_P);
  }

  /// Sample point at the end of the step.
  [[nodiscard]] Vector3d after_point(const PatchSlot& patch, const Vector3d& p_P) const {
    const auto phalanx = std::size_t(patch.phalanx);
    if (patch.of_body()) return (*after_)[phalanx].X_WO * p_P;
    return (*next_)[std::size_t(patch.hand)].X_WP[phalanx] * p_P;
  }

  /// A sample as the step was given it; the anchor of one that slides is that from before.
  [[nodiscard]] AuditedSample sample(const World& world, const PatchSlot& patch, std::size_t slot) const {
    const Contacts& now = world.contacts();
    const Body& body = scene_.bodies[std::size_t(patch.body)];
    AuditedSample s;
    s.target = &moved_[std::size_t(patch.body)];
    if (patch.of_body()) s.source = &moved_[std::size_t(patch.phalanx)];
    const ContactParameters& contact = s.source ? scene_.body_contact : scene_.contact;
    const Friction friction =
        s.source ? combined(body.friction, scene_.bodies[std::size_t(patch.phalanx)].friction) : body.friction;
    // Bodies in contact are of one island, and moved by one scheme; a fixed one has none of its own.
    s.scheme = s.source && !s.target->moves ? s.source->scheme : s.target->scheme;
    s.k = contact.stiffness;
    s.c = contact.damping;
    s.slides = now.mode[slot] == Mode::slip;
    s.touched = touched(now, slot);
    s.mu = s.slides ? friction.mu_dynamic : friction.mu_static;
    s.p0 = before_point(patch, now.p_P[slot]);
    s.p1 = after_point(patch, now.p_P[slot]);
    s.p = s.source ? s.source->at(now.p_P[slot]) : Vector3d(s.p0 + s.scheme.place() * s.share());
    s.C = s.target->at((s.slides ? now.from_O : now.C_O)[slot]);
    s.n = s.target->R * (s.slides ? now.from_n_O : now.n_O)[slot];
    s.f = world.force(slot);
    return s;
  }

  void check_sample(const World& world, const PatchSlot& patch, std::size_t slot) {
    const AuditedSample s = sample(world, patch, slot);
    add_force(patch, s);
    check_anchor(world.contacts(), patch, slot);
    const Name name{world.contacts().id[slot]};
    const AuditedElement element(s);
    faults_.require(!element.entered || element.r1.dot(s.n) < 0, name, " is pushed before it touches");
    faults_.bound(s.outside_cone(), 1e-12 * s.f.norm(), tally_.cone, name, " leaves its cone");
    faults_.bound((s.f - element.f).norm(), 1e-12 * s.f.norm() + 10 * (s.rounding() + s.speed_rounding()),
                  tally_.element, name, " breaks its law");
    add_terms(world.contacts(), patch, slot, s, element);
  }

  /// To the sums of the momentum balance, and what rounding makes of them.
  void add_force(const PatchSlot& patch, const AuditedSample& s) {
    AuditedBody& target = moved_[std::size_t(patch.body)];
    target.force += s.f;
    target.torque += (s.p - target.center).cross(s.f);
    if (s.source) {
      AuditedBody& source = moved_[std::size_t(patch.phalanx)];
      source.force -= s.f;
      source.torque -= (s.p - source.center).cross(s.f);
    }
    size_ += h_ * s.f.norm();
    noise_ += h_ * s.rounding();
    if (!s.source) power_ += h_ * std::abs(s.f.dot(s.velocity()));
    ++tally_.forces;
    tally_.slides += s.slides;
  }

  /// An anchor is where it was, or where the sample touched, and slides the way that friction pulls.
  void check_anchor(const Contacts& now, const PatchSlot& patch, std::size_t slot) {
    const bool slides = now.mode[slot] == Mode::slip;
    const Anchor anchor{(slides ? now.from_O : now.C_O)[slot], (slides ? now.from_n_O : now.n_O)[slot]};
    if (touched(now, slot)) {
      check_touch(patch, now.id[slot], anchor);
      if (!patch.of_body() && !now.kept[slot]) check_way_in(patch, now.p_P[slot], now.id[slot], anchor);
    } else {
      // In a hollow edge a normal turns with the pull.
      const bool same = anchor.n_O == contacts_.n_O[slot] || contacts_.hollow[slot];
      faults_.require(anchor.C_O == contacts_.C_O[slot] && same, Name{now.id[slot]},
                      slides ? " slides from another anchor than it had" : " sticks, but its anchor moved");
    }
    if (!slides || now.n_O[slot].dot(anchor.n_O) < 0) return;  // round a rim: forward, and so behind where it began
    const Vector3d f = now.f_O[slot], tangent = f - f.dot(anchor.n_O) * anchor.n_O;
    const double voxel = scene_.bodies[std::size_t(patch.body)].field->grid().spacing;
    tally_.backward += falls_back(tangent, now.C_O[slot] - anchor.C_O, voxel);
  }

  /// See EnergyTerms.
  void add_terms(const Contacts& now, const PatchSlot& patch, std::size_t slot, const AuditedSample& s,
                 const AuditedElement& e) {
    const auto stored = [&](const Vector3d& at) { return 0.5 * s.k * at.squaredNorm(); };
    const Vector3d end = true_end(now, patch, slot), touched_at = s.slides ? now.from_O[slot] : now.C_O[slot];
    const Vector3d moved = s.target->R * (now.C_O[slot] - touched_at);
    rounding_energy_ += s.rounding() * (end.norm() + h_ * (s.velocity().norm() + s.target->velocity(s.p).norm()));
    if (s.scheme.theta == 1)
      terms_.numerical -= 0.5 * s.k * h_ * h_ * (e.closing * e.closing + e.stretch.squaredNorm());
    // What the book has of a way of the anchor: the spring it leaves, and what damper and friction take on it.
    const auto booked = [&](const Vector3d& way) {
      const Vector3d rate = e.rate - way / h_;
      const Vector3d force = s.k * (e.r0 + s.scheme.reach() * e.v - s.scheme.theta * way) + s.c * rate;
      return stored(e.r1 - way) + h_ * s.c * rate.squaredNorm() + std::max(0.0, force.dot(way));
    };
    if (s.slides) {
      terms_.curving += booked(moved) - booked(e.slid);
      const double relaxed = e.entered ? 0 : (e.r0 - (e.r1 - moved)).dot(moved);
      terms_.relaxing += (s.scheme.theta - 0.5) * s.k * std::max(0.0, relaxed);
    }
    terms_.turning += stored(end) - stored(e.r1 - moved);
    if (s.source)
      terms_.turning += h_ * s.f.dot(s.seen_before() - s.straight_before());
    else
      book_hand(s, e);
    if (!s.touched)
      terms_.turning -= stored(start_of(patch, slot)) - stored(e.r0);
    else if (e.entered)
      terms_.touching += s.f.dot(e.r0);
    else
      book_appearance(slot, s.source != nullptr, stored(e.r0));
  }

  /// A finger touches where its way through the step, as nothing but gravity and loads would have it, comes in. One
  /// that was not there before comes from elsewhere.
  void check_way_in(const PatchSlot& patch, const Vector3d& p_P, const SampleId& id, const Anchor& anchor) {
    if (!hands_[std::size_t(patch.hand)].present) return;
    AuditedSample s;
    s.target = &moved_[std::size_t(patch.body)];
    s.scheme = s.target->scheme;
    s.p0 = hand_point(patch, p_P);
    s.p1 = after_point(patch, p_P);
    s.p = s.p0 + s.scheme.place() * s.share();
    const AuditedBody& body = *s.target;
    const Vector3d fall = body.moves ? Vector3d(h_ * h_ / body.mass * body.load) : Vector3d(Vector3d::Zero());
    const Vector3d end = s.p + (h_ - s.scheme.place()) * s.seen_before() - fall;
    const Vector3d to = body.R.transpose() * (end - body.center) + body.center_O;
    const Vector3d from = bodies_[std::size_t(patch.body)].X_WO.inverse() * s.p0;
    Anchor expected;
    const VoxelField& field = *scene_.bodies[std::size_t(patch.body)].field;
    faults_.require(find_touch(field, from, to, TouchNormal::smooth, expected), Name{id}, " touches out of reach");
    faults_.bound((expected.C_O - anchor.C_O).norm(), 1e-9, tally_.way_in, Name{id}, " touches off its way");
    faults_.bound((expected.n_O - anchor.n_O).norm(), 1e-6, tally_.way_in, Name{id}, " touches another face");
  }

  /// The book's work of a hand differs from the balance of momentum by how the mean force is not that of the start, and
  /// from the work on the way of its point by what is of third order.
  void book_hand(const AuditedSample& s, const AuditedElement& e) {
    const double turning = h_ * (s.mean_force() - s.f).dot(s.target->u);
    terms_.turning -= turning;
    turned_ += h_ * s.f.dot(e.v + s.target->velocity(s.p)) + turning - s.work_of_hand();
  }

  /// In this step, though it may have been in contact before: what slid off an edge is let go as a step begins.
  [[nodiscard]] bool touched(const Contacts& now, std::size_t slot) const {
    if (slot >= contacts_.size() || contacts_.mode[slot] == Mode::apart) return true;
    return std::any_of(events_->begin(), events_->end(),
                       [&](const Event& e) { return e.kind == EventKind::touch && e.id == now.id[slot]; });
  }

  /// A sample touches where the surface is: a corner to 3e-5 of its body's thickness that it is looked for aside, and
  /// half as much again; a finger to half a voxel, where its smooth normal was taken.
  void check_touch(const PatchSlot& patch, const SampleId& id, const Anchor& anchor) {
    const VoxelField& field = *scene_.bodies[std::size_t(patch.body)].field;
    const double voxel = field.grid().spacing;
    const std::optional<SurfacePoint> surface = field.closest(anchor.C_O, voxel);
    const double off = surface ? std::abs(surface->distance) : 2 * voxel;
    double allowed = 0.5 * voxel;
    if (patch.of_body())
      allowed = 7.5e-5 * scene_.bodies[std::size_t(patch.phalanx)].field->bounds().sizes().minCoeff();
    faults_.bound(off, allowed, tally_.touch, Name{id}, " touches beside the surface");
  }

  /// Friction moves an anchor forward, but for the error of its projection onto the voxels' surface.
  [[nodiscard]] static bool falls_back(const Vector3d& tangent, const Vector3d& moved, double voxel) {
    constexpr double projection_error = 0.1;  // voxels
    return tangent.dot(moved) < -projection_error * voxel * tangent.norm();
  }

  /// The book has it as work of a hand, which for the most part it is: of one that was not there a step ago. But what
  /// let go inside, and touches again, only takes back what it lost then.
  void book_appearance(std::size_t slot, bool of_body, double stored) {
    double& lost = lost_[slot];
    const double regained = std::min(lost, stored);
    lost -= regained;
    if (of_body)
      terms_.appearing += stored;
    else
      regained_ += regained;
    power_ += stored - regained;
  }

  /// What a spring had that lets go in this step.
  void note_loss(const PatchSlot& patch, std::size_t slot) {
    if (slot >= contacts_.size() || contacts_.mode[slot] == Mode::apart) return;
    const double k = patch.of_body() ? scene_.body_contact.stiffness : scene_.contact.stiffness;
    lost_[slot] = 0.5 * k * start_of(patch, slot).squaredNorm();
  }

  /// p − C as the step begins.
  [[nodiscard]] Vector3d start_of(const PatchSlot& patch, std::size_t slot) const {
    return before_point(patch, contacts_.p_P[slot]) - bodies_[std::size_t(patch.body)].X_WO * contacts_.C_O[slot];
  }

  /// p − C as it really is after the step.
  [[nodiscard]] Vector3d true_end(const Contacts& now, const PatchSlot& patch, std::size_t slot) const {
    return after_point(patch, now.p_P[slot]) - (*after_)[std::size_t(patch.body)].X_WO * now.C_O[slot];
  }

  /// To the solver's tolerance, 1e-13 of the sizes of all terms (of an island: here of the scene), and rounding.
  void check_momentum(std::size_t i) {
    const AuditedBody& m = moved_[i];
    if (!m.moves) return;
    const double allowed = 2e-13 * size_ + noise_ + 1e-18;  // [N s]: what oil leaves of a motion is nobody's concern
    faults_.bound(m.linear_residual().norm(), allowed, tally_.momentum, "linear momentum of body ", i);
    if (!m.turns) return;
    faults_.bound(m.angular_residual().norm(), allowed, tally_.momentum, "angular momentum of body ", i);
  }

  void check_energy(const World& world) {
    const Energy now = world.energy();
    tally_.throughput += power_;
    tally_.growth = std::max(tally_.growth, book(world) - start_);
    double fastest = 0;
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      const AuditedBody& m = moved_[i];
      if (!m.moves) continue;
      fastest = std::max({fastest, m.u.norm() + m.u0.norm(), m.w.norm() + m.w0.norm()});
      const bool loses = m.scheme.theta == 1;
      if (loses) terms_.numerical -= 0.5 * m.mass * (m.u - m.u0).squaredNorm();
      if (!m.turns) continue;
      if (loses) terms_.numerical -= 0.5 * (m.L1 - m.L0).dot(m.inverse_J * (m.L1 - m.L0));
      terms_.turning +=
          0.5 * m.L1.dot(world.bodies()[i].w - m.inverse_J * m.L1) - 0.5 * m.L0.dot(m.w0 - m.inverse_J * m.L0);
    }
    // The solver's tolerance times the velocities it is wrong by, and rounding of the book's own numbers.
    double sizes = now.kinetic + now.elastic + now.dissipated + std::abs(now.hand_work);
    for (const RigidBody& b : world.bodies())  // the potential is a small difference of large heights
      if (b.moves()) sizes += b.mass * scene_.gravity.norm() * b.center().norm();
    const double allowed = 1e-14 * sizes + (2e-13 * size_ + noise_) * fastest + rounding_energy_;
    faults_.require(now.dissipated >= energy_.dissipated - allowed, "dissipation falls by ",
                    energy_.dissipated - now.dissipated);
    ++tally_.audited;
    tally_.terms += terms_;
    const double change = (now.kinetic - energy_.kinetic) + (now.potential - energy_.potential) +
                          (now.elastic - energy_.elastic) + (now.dissipated - energy_.dissipated) -
                          (now.hand_work - energy_.hand_work);
    faults_.bound(std::abs(change - terms_.sum()), allowed, tally_.energy, "energy");
    check_gain(now, allowed);
  }

  /// What bodies and springs have beyond the start and what hands gave: by the identity of EnergyTerms no more than
  /// what the terms added in the steps in which they added at all.
  void check_gain(const Energy& now, double rounding) {
    tally_.excess += std::max(0.0, terms_.sum() + turned_);
    turned_work_ += turned_;
    all_rounding_ += rounding;
    const double work = now.hand_work - turned_work_ - regained_;
    const double gain = now.kinetic + now.potential - work - start_;
    tally_.gain = std::max(tally_.gain, gain);
    if (tally_.audited < tally_.steps) return;
    faults_.require(gain <= tally_.excess + all_rounding_, "gain of ", gain, " of ", tally_.excess, " J explained");
  }

  const Scene& scene_;
  AuditTally tally_{};
  Faults faults_{tally_};
  double h_{}, t_{}, start_{};
  double regained_{}, turned_work_{}, all_rounding_{};  // sums over steps
  double turned_{};  // of a step, what the book's work of hands is more than that on the ways of their points [J]
  std::vector<double> lost_{};  // by slot, see book_appearance
  bool solved_{true};
  std::vector<HandFrame> hands_{};
  const std::vector<HandFrame>* next_{};
  std::vector<RigidBody> bodies_{};
  const std::vector<RigidBody>* after_{};
  const std::vector<Event>* events_{};
  Contacts contacts_{};
  Energy energy_{};
  std::vector<AuditedBody> moved_{};
  EnergyTerms terms_{};
  double size_{}, noise_{}, power_{}, rounding_energy_{};
};

}  // namespace handhold::realtime::testing
