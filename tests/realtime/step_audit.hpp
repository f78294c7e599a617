#pragma once

// Audits every sub-step of a World from the outside: from the states and forces it shows before and after, with the
// laws written down anew here. What holds in any scene, chaotic or not:
//
//   finite        no NaN, no infinity, unit quaternions
//   momentum      m (v1 − v0) = h (m g + F + Σ f), L1 − L0 = h (T + Σ a × f), for every body on its own
//   no adhesion   N >= 0, and no force at all while apart; free flight is the balance of momentum without forces
//   cone          |f_t| <= μ N (1 + 1e-12), μ_s while it sticks and μ_d while it slides
//   element       f = k r + c v where it sticks; −N n + μ_d N t*/|t*| where it slides
//   anchors       bitwise unmoved while they stick; dissipation never falls
//   energy        the book is off by the scheme's own, known terms and by nothing else (see EnergyTerms), and so bodies
//                 never have more than hands gave and those terms added

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "realtime/hand_path.hpp"
#include "realtime/surface.hpp"
#include "realtime/world.hpp"
#include "tests/realtime/audited_body.hpp"

namespace handhold::realtime::testing {

/// Of one World.
class StepAudit {
 public:
  StepAudit(const Scene& scene, const Options& options)
      : scene_(scene), paths_(scene.hands.size(), HandPath(options.longest_bridge)), moved_(scene.bodies.size()) {}

  void begin(const World& world, const std::vector<HandFrame>& hands) {
    for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].observe(0, hands[i]);
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
    for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].observe(h, hands[i]);
    audit(world);
    hands_ = hands;
  }

  [[nodiscard]] const AuditTally& tally() const { return tally_; }
  [[nodiscard]] static double book(const World& world) {
    const Energy e = world.energy();
    return e.kinetic + e.potential + e.elastic + e.dissipated - e.hand_work;
  }

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

  /// Touched in this step, though it may have been in contact before: what slid off an edge is let go as a step begins.
  [[nodiscard]] bool has_touched(const SampleId& id) const {
    return std::any_of(events_->begin(), events_->end(),
                       [&](const Event& e) { return e.kind == EventKind::touch && e.id == id; });
  }

  /// Hand's sample at the start of the step.
  [[nodiscard]] Vector3d hand_point(const PatchSlot& patch, const Vector3d& p_P) const {
    const auto hand = std::size_t(patch.hand);
    const HandFrame& frame = hands_[hand].present ? hands_[hand] : (*next_)[hand];
    return frame.X_WP[std::size_t(patch.phalanx)] * p_P;
  }

  /// Sample point at the end of the step.
  [[nodiscard]] Vector3d after_point(const PatchSlot& patch, const Vector3d& p_P) const {
    const auto phalanx = std::size_t(patch.phalanx);
    if (patch.of_body()) return (*after_)[phalanx].X_WO * p_P;
    return (*next_)[std::size_t(patch.hand)].X_WP[phalanx] * p_P;
  }

  void check_sample(const World& world, const PatchSlot& patch, std::size_t slot) {
    const Contacts& now = world.contacts();
    AuditedBody& target = moved_[std::size_t(patch.body)];
    AuditedBody* const source = patch.of_body() ? &moved_[std::size_t(patch.phalanx)] : nullptr;
    const ContactParameters& contact = source ? scene_.body_contact : scene_.contact;
    Friction friction = scene_.bodies[std::size_t(patch.body)].friction;
    if (source) friction = combined(friction, scene_.bodies[std::size_t(patch.phalanx)].friction);
    const Vector3d f = world.force(slot), p_P = now.p_P[slot];
    // Bodies in contact are of one island, and moved by one scheme; a fixed one has none of its own.
    const Scheme scheme = source && !target.moves ? source->scheme : target.scheme;
    const double place = scheme.place(), reach = scheme.reach();
    const Vector3d p0 = source ? bodies_[std::size_t(patch.phalanx)].X_WO * p_P : hand_point(patch, p_P);
    const Vector3d p1 = after_point(patch, p_P), share = (p1 - p0) / h_;
    const Vector3d p = source ? source->at(p_P) : Vector3d(p0 + place * share);  // where the step is linearised
    const Vector3d v_p = source ? source->velocity(p) : share;
    const Vector3d v_before = seen_before(target, source, p, p1, share);
    const double k = contact.stiffness, c = contact.damping, slope = k * reach + c;

    // Sums of the momentum balance, and what rounding makes of them: of positions a metre from the origin, times k.
    target.force += f;
    target.torque += (p - target.center).cross(f);
    if (source) source->force -= f;
    if (source) source->torque -= (p - source->center).cross(f);
    const double rounding = 4e-15 * (k * (p1.norm() + target.center.norm()) +
                                     slope * (v_p.norm() + target.velocity(p).norm()) + c / h_ * p1.norm());
    // Velocities are the ends of sums of momenta, so that they are right to a share of the step's largest.
    const double speed_rounding = 1e-15 * slope * (target.u.norm() + target.w.norm() * (p - target.center).norm());
    size_ += h_ * f.norm();
    noise_ += h_ * rounding;
    if (!source) power_ += h_ * std::abs(f.dot(v_p));
    ++tally_.forces;

    const bool touched = slot >= contacts_.size() || contacts_.mode[slot] == Mode::apart || has_touched(now.id[slot]);
    const bool slides = now.mode[slot] == Mode::slip;
    tally_.slides += slides;
    const Anchor anchor{(slides ? now.from_O : now.C_O)[slot], (slides ? now.from_n_O : now.n_O)[slot]};  // before it
    if (touched)
      check_touch(patch, now.id[slot], anchor);
    else
      faults_.require(anchor.C_O == contacts_.C_O[slot] && anchor.n_O == contacts_.n_O[slot], Name{now.id[slot]},
                      slides ? " slides from another anchor than it had" : " sticks, but its anchor moved");

    const double mu = slides ? friction.mu_dynamic : friction.mu_static;
    const Matrix3d& R = target.R;
    const Vector3d n = R * anchor.n_O;
    faults_.bound(beyond(f, n, mu), 1e-12 * f.norm(), tally_.cone, Name{now.id[slot]}, " leaves its cone");
    const Vector3d tangent = f - f.dot(n) * n;

    const Vector3d moved = R * (now.C_O[slot] - anchor.C_O);
    const double voxel = scene_.bodies[std::size_t(patch.body)].field->grid().spacing;
    const bool round_a_rim = (R * now.n_O[slot]).dot(n) < 0;  // forward all the way, and so behind where it began
    tally_.backward += !round_a_rim && falls_back(tangent, moved, voxel);
    rounding_energy_ += rounding * (true_end(now, patch, slot).norm() + h_ * (v_p.norm() + target.velocity(p).norm()));

    // The element at the solution, as linearised.
    const Vector3d v = v_before - target.change(p) + (source ? source->change(p) : Vector3d(Vector3d::Zero()));
    const Vector3d r0 = p - target.at(anchor.C_O) - place * v_before, r = r0 + reach * v;
    const Vector3d r1 = r0 + h_ * v;
    const double closing = -v.dot(n), d = -r.dot(n);
    const Vector3d lag = r + d * n, v_t = v + closing * n, pull = k * lag + c * v_t;
    Vector3d law = -(k * d + c * closing) * n + pull, stretch = v_t, straight = Vector3d::Zero();
    if (slides) {
      const Vector3d before = lag - reach * v_t, cap = friction.mu_dynamic * (k * d + c * closing) * pull.normalized();
      law += cap - pull;
      stretch = ((cap + c / reach * before) / (k + c / reach) - before) / reach;
      straight = h_ * (v_t - stretch);
    }
    faults_.bound((f - law).norm(), 1e-12 * f.norm() + 10 * (rounding + speed_rounding), tally_.element,
                  Name{now.id[slot]}, " breaks its law");

    const auto stored = [k](const Vector3d& at) { return 0.5 * k * at.squaredNorm(); };
    if (scheme.theta == 1) terms_.numerical -= 0.5 * k * h_ * h_ * (closing * closing + stretch.squaredNorm());
    terms_.curving += stored(r1 - moved) - stored(r1 - straight);
    double turning = stored(true_end(now, patch, slot)) - stored(r1 - moved);
    if (source)
      turning += h_ * f.dot(v_before - source->velocity_before(p) + target.velocity_before(p));
    else
      turned_ += h_ * f.dot(v + target.velocity(p)) - work_of_hand(target, f, h_ * share);
    if (!touched)
      turning -= stored(start_of(patch, slot)) - stored(r0);
    else if (r0.dot(n) >= 0)
      terms_.touching += stored(r0);
    else
      book_appearance(slot, source != nullptr, stored(r0));
    terms_.turning += turning;
  }

  /// A sample touches where the surface is: a corner to the micrometre that it is looked for aside, a finger to half a
  /// voxel, where its smooth normal was taken.
  void check_touch(const PatchSlot& patch, const SampleId& id, const Anchor& anchor) {
    const VoxelField& field = *scene_.bodies[std::size_t(patch.body)].field;
    const double voxel = field.grid().spacing;
    const std::optional<SurfacePoint> surface = field.closest(anchor.C_O, voxel);
    const double off = surface ? std::abs(surface->distance) : 2 * voxel;
    faults_.bound(off, patch.of_body() ? 2e-6 : 0.5 * voxel, tally_.touch, Name{id},
                  " touches beside the surface");
  }

  /// Relative velocity if no velocity changed; in an Euler step that of p as the target sees it, which goes on as it
  /// does.
  [[nodiscard]] Vector3d seen_before(const AuditedBody& target, const AuditedBody* source, const Vector3d& p,
                                     const Vector3d& p1, const Vector3d& share) const {
    if (target.scheme.place() > 0 || (source && source->scheme.place() > 0))
      return (source ? source->velocity_before(p) : share) - target.velocity_before(p);
    const Vector3d end = source ? source->goes_on(p, h_) : p1, moved = target.center + h_ * target.u0;
    return (target.turn_before(h_).conjugate() * (end - moved) - (p - target.center)) / h_;
  }

  /// What a hand gave with a force that turns with its body, while its point moved by `way`.
  [[nodiscard]] double work_of_hand(const AuditedBody& target, const Vector3d& f, const Vector3d& way) const {
    const Vector3d with = h_ * target.u;  // the centre, which is moved by what the forces sum up to: by no turned one
    const Eigen::Quaterniond half = rotation_by((target.scheme.place() > 0 ? 0 : 0.5 * h_) * target.w);
    return f.dot(with) + (half * f).dot(way - with);
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
    regained_ += regained;
    if (of_body) terms_.appearing += stored;
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
    const Vector3d& p_P = contacts_.p_P[slot];
    const Vector3d p = patch.of_body() ? bodies_[std::size_t(patch.phalanx)].X_WO * p_P : hand_point(patch, p_P);
    return p - bodies_[std::size_t(patch.body)].X_WO * contacts_.C_O[slot];
  }

  /// p − C as it really is after the step.
  [[nodiscard]] Vector3d true_end(const Contacts& now, const PatchSlot& patch, std::size_t slot) const {
    return after_point(patch, now.p_P[slot]) - (*after_)[std::size_t(patch.body)].X_WO * now.C_O[slot];
  }

  /// How far a force is outside its cone; one that pulls is, too [N].
  [[nodiscard]] static double beyond(const Vector3d& f, const Vector3d& n, double mu) {
    const double N = -f.dot(n);
    return std::max((f + N * n).norm() - mu * N, -N);
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
  std::vector<HandPath> paths_;
  double h_{}, t_{}, start_{};
  double regained_{}, turned_work_{}, all_rounding_{};  // sums over steps
  double turned_{};  // of a step, what the book's work of hands is more than Σ h f·v_p: it sees v_p turned, too [J]
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
