#pragma once

// Audits every sub-step of a World from the outside: from the states and forces it shows before and after, with the
// laws written down anew here. What holds in any scene, chaotic or not:
//
//   finite        no NaN, no infinity, unit quaternions
//   momentum      m (v1 − v0) = h (m g + F + Σ f), L1 − L0 = h (T + Σ a × f), for every body on its own
//   no adhesion   N >= 0, and no force at all while apart; free flight is the balance of momentum without forces
//   cone          |f_t| <= μ N (1 + 1e-12), μ_s while it sticks and μ_d while it slides
//   element       f = k r + c v where it sticks; −N n + μ_d N t*/|t*| where it slides
//   anchors       bitwise unmoved while they stick; dissipation never falls, but where one step takes an anchor round
//                 an edge, so that it ends behind where it began (counted)
//   energy        the book is off by the scheme's own, known terms and by nothing else (see EnergyTerms)

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "realtime/hand_path.hpp"
#include "realtime/surface.hpp"
#include "realtime/world.hpp"

namespace handhold::realtime::testing {

/// How kinetic + potential + elastic + dissipated − hand_work changes in one implicit Euler step: exactly by these.
///
/// With u the velocities held during the step, v and ė those of a sample against its body and of its lag, r = p − C ('
/// : as linearised), J the inertia at the pose about which the step is linearised (BodyStep):
///
///   numerical   −½ m |Δu|² − ½ ΔL J⁻¹ ΔL − Σ ½ k (|h v_n|² + |h ė|²): never positive
///   turning     ½ L1 (I1⁻¹ − J⁻¹) L1 − ½ L0 (I0⁻¹ − J⁻¹) L0 + Σ ½ k ((|r1|² − |r1'|²) − (|r0|² − |r0'|²)):
///               forces and inertia are those of one orientation, the book knows the true ones. Of second order in the
///               angle h w of a step, either sign; none of it in a scene where nothing turns
///   touching    Σ ½ k |r0'|²: a sample that comes in has no energy before, though its spring is measured from where
///               it will have touched
///   appearing   the same of samples that are inside as the step begins: of a hand that was not there a step ago
///   blocked     Σ of sliding anchors that stop at an edge, or follow a curved surface, instead of the straight way
struct EnergyTerms {
  double numerical{}, turning{}, touching{}, appearing{}, blocked{};  // [J]

  [[nodiscard]] double sum() const { return numerical + turning + touching + appearing + blocked; }
};

/// What an audit saw; ratios are to what is allowed, so 1 is a fault.
struct AuditTally {
  long steps{}, forces{}, slides{};
  long unknown{};   ///< slid as they touched, from an anchor that nobody shows: neither cone nor energy is checked
  long backward{};  ///< slides round an edge, or out of a lag of centimetres, that ended behind where they began
  long unconverged{}, audited{};  ///< steps; audited: with their energy
  double momentum{}, cone{}, element{}, energy{};
  double gain{};    ///< most of kinetic + potential − hand_work − start, ever: a body's beyond what hands gave [J]
  double growth{};  ///< most of book − start, ever [J]
  double throughput{};  ///< Σ |energy that passed| = kinetic energy at the start + Σ |h f·v_p| [J]
  EnergyTerms terms{};  ///< sums
  std::string fault{};  ///< the first; empty: none
};

class StepAudit {
 public:
  using Vector3d = Eigen::Vector3d;
  using Matrix3d = Eigen::Matrix3d;

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
  /// A body in the step: pose about which all is linearised, velocities before and while it moves, momenta about its
  /// centre.
  struct Moved {
    bool moves{false}, turns{false};
    Scheme scheme{};
    double mass{}, grown{1};
    Vector3d center_O{Vector3d::Zero()}, center{Vector3d::Zero()};
    Matrix3d R{Matrix3d::Identity()}, inverse_J{Matrix3d::Zero()};
    Matrix3d turn{Matrix3d::Identity()};  // of forces, from there to where they are taken
    Vector3d u0{Vector3d::Zero()}, w0{Vector3d::Zero()}, u{Vector3d::Zero()}, w{Vector3d::Zero()};
    Vector3d v1{Vector3d::Zero()};  // at the end
    Vector3d L0{Vector3d::Zero()}, L1{Vector3d::Zero()};
    Vector3d force{Vector3d::Zero()}, torque{Vector3d::Zero()};  // sums of contacts
    Vector3d load{Vector3d::Zero()}, load_torque{Vector3d::Zero()};

    [[nodiscard]] Vector3d at_theta(const Vector3d& start, const Vector3d& end) const {
      return scheme.theta == 1 ? end : Vector3d(0.5 * (start + end));
    }
    [[nodiscard]] Vector3d at(const Vector3d& p_O) const { return center + R * (p_O - center_O); }
    [[nodiscard]] Vector3d velocity(const Vector3d& p) const { return u + w.cross(p - center); }
    [[nodiscard]] Vector3d velocity_before(const Vector3d& p) const { return u0 + w0.cross(p - center); }
    [[nodiscard]] Vector3d change(const Vector3d& p) const { return u - u0 + (w - w0).cross(p - center); }
  };

  void fail(const std::string& what) {
    if (!tally_.fault.empty()) return;
    std::ostringstream text;
    text.precision(17);
    text << "step " << tally_.steps << ", t = " << t_ << ": " << what;
    tally_.fault = text.str();
  }
  template <class... Parts>
  void require(bool holds, const Parts&... parts) {
    if (holds) return;
    std::ostringstream text;
    text.precision(9);
    (text << ... << parts);
    fail(text.str());
  }
  /// Notes how near to its bound a quantity is.
  template <class... Parts>
  void bound(double value, double allowed, double& worst, const Parts&... what) {
    const double ratio = allowed > 0 ? value / allowed : (value > 0 ? 1e300 : 0);
    worst = std::max(worst, ratio);
    require(ratio <= 1, what..., ": ", value, " of ", allowed, " allowed");
  }
  struct Name {
    SampleId id{};
    friend std::ostream& operator<<(std::ostream& out, const Name& name) {
      return out << "sample " << int(name.id.hand) << "/" << int(name.id.phalanx) << "/" << int(name.id.body) << "/"
                 << int(name.id.sample);
    }
  };

  void audit(const World& world) {
    if (!check_finite(world)) return;
    if (!solved_) return;  // counted: its forces are only as good as the iteration got
    for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i] = moved(world, i);
    terms_ = {};
    known_ = true;
    size_ = noise_ = power_ = rounding_energy_ = slack_ = 0;
    after_ = &world.bodies();
    const Contacts& now = world.contacts();
    for (const PatchSlot& patch : now.patches) {
      if (!patch.active) continue;
      // A sample that is found to be just apart leaves the rounding of its position, as a force, in the solve.
      const double k = patch.of_body() ? scene_.body_contact.stiffness : scene_.contact.stiffness;
      noise_ += h_ * 1e-15 * k * patch.count * moved_[std::size_t(patch.body)].center.norm();
      for (int i = 0; i < patch.count; ++i) {
        const std::size_t slot = patch.slot(i);
        if (now.mode[slot] == Mode::apart)
          require(world.force(slot).isZero(0), Name{now.id[slot]}, " is apart and has a force");
        else
          check_sample(world, patch, slot);
      }
    }
    for (std::size_t i = 0; i < moved_.size(); ++i) size_ += h_ * weight(moved_[i]).norm() + size_of(moved_[i]);
    for (std::size_t i = 0; i < moved_.size(); ++i) check_momentum(i);
    check_energy(world);
  }

  bool check_finite(const World& world) {
    bool finite = std::isfinite(book(world));
    for (const RigidBody& b : world.bodies()) {
      finite = finite && b.v.allFinite() && b.w.allFinite() && b.X_WO.p.allFinite() && b.X_WO.R.coeffs().allFinite();
      require(std::abs(b.X_WO.R.norm() - 1) < 4e-15, "a quaternion of norm ", b.X_WO.R.norm());  // rounding
    }
    require(finite, "a number that is not finite");
    return finite;
  }

  [[nodiscard]] Moved moved(const World& world, std::size_t i) const {
    const RigidBody &before = bodies_[i], &after = world.bodies()[i];
    Moved m;
    m.moves = before.moves();
    m.turns = before.turns();
    m.mass = before.mass;
    m.center_O = before.center_O;
    m.scheme = {.h = h_, .theta = m.moves ? world.scheme(i).theta : 1};
    const Load load = scene_.bodies[i].load ? scene_.bodies[i].load(t_ + m.scheme.reach()) : Load{};
    const BodyStep step = predict(before, m.scheme, scene_.gravity, load, before.held(t_ + h_));
    m.R = step.R;
    m.turn = step.turn;
    m.center = step.center;
    if (!m.moves) return m;
    if (before.held(t_ + h_)) m.grown = 1 + h_ / support_time;
    m.u0 = before.v;
    m.w0 = before.w;
    m.u = m.scheme.theta == 1 ? after.v : Vector3d(0.5 * (before.v + after.v));
    m.v1 = after.v;
    m.load = load.force_W;
    m.load_torque = load.torque_W;
    if (!m.turns) return m;
    m.inverse_J = m.R * before.inverse_inertia_O * m.R.transpose();
    m.L0 = before.inertia() * before.w;
    m.L1 = after.inertia() * after.w;
    m.w = m.inverse_J * m.at_theta(m.L0, m.L1);
    return m;
  }

  [[nodiscard]] Vector3d weight(const Moved& m) const {
    if (!m.moves) return Vector3d::Zero();
    return m.grown > 1 ? m.load : Vector3d(m.load + m.mass * scene_.gravity);
  }
  [[nodiscard]] static double size_of(const Moved& m) {
    return m.mass * (m.u0.norm() + m.grown * m.u.norm()) + m.L0.norm() + m.grown * m.L1.norm();
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

  /// The anchor of a hand's sample that touched in this step, before it slid on in the same step.
  [[nodiscard]] bool touch_of_finger(const PatchSlot& patch, const Vector3d& p_P, const Vector3d& p,
                                     const Vector3d& v_p, Anchor& anchor) const {
    if (patch.of_body()) return false;
    const HandPath& path = paths_[std::size_t(patch.hand)];
    const Vector3d p0 = path.is_back() ? path.last_seen(patch.phalanx) * p_P : hand_point(patch, p_P);
    const Moved& body = moved_[std::size_t(patch.body)];
    const Vector3d fall = body.moves ? Vector3d(h_ * h_ / body.mass * weight(body)) : Vector3d(Vector3d::Zero());
    const Vector3d way = (h_ - body.scheme.place()) * (v_p - body.velocity_before(p)) - fall;
    const Vector3d to = body.R.transpose() * (p - body.center + way) + body.center_O;
    const Vector3d from = bodies_[std::size_t(patch.body)].X_WO.inverse() * p0;
    return find_touch(*scene_.bodies[std::size_t(patch.body)].field, from, to, TouchNormal::smooth, anchor);
  }

  void check_sample(const World& world, const PatchSlot& patch, std::size_t slot) {
    const Contacts& now = world.contacts();
    Moved& target = moved_[std::size_t(patch.body)];
    Moved* const source = patch.of_body() ? &moved_[std::size_t(patch.phalanx)] : nullptr;
    const ContactParameters& contact = source ? scene_.body_contact : scene_.contact;
    Friction friction = scene_.bodies[std::size_t(patch.body)].friction;
    if (source) friction = combined(friction, scene_.bodies[std::size_t(patch.phalanx)].friction);
    const Vector3d f = world.force(slot), p_P = now.p_P[slot];
    // Bodies in contact are of one island, and moved by one scheme; a fixed one has none of its own.
    const Scheme scheme = source && !target.moves ? source->scheme : target.scheme;
    const double place_ = scheme.place(), reach = scheme.reach();
    const Vector3d p0 = source ? bodies_[std::size_t(patch.phalanx)].X_WO * p_P : hand_point(patch, p_P);
    const Vector3d p1 = after_point(patch, p_P), share = (p1 - p0) / h_;
    const Vector3d p = source ? source->at(p_P) : Vector3d(p0 + place_ * share);  // where the step is linearised
    const Vector3d v_p = source ? source->velocity(p) : share;
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

    const bool touched = slot >= contacts_.size() || contacts_.mode[slot] == Mode::apart;
    const bool slides = now.mode[slot] == Mode::slip;
    tally_.slides += slides;
    Anchor anchor{now.C_O[slot], now.n_O[slot]};  // before the step
    if (slides && touched && !touch_of_finger(patch, p_P, p, share, anchor)) {
      ++tally_.unknown;
      known_ = false;
      return;
    }
    if (!touched) anchor = {contacts_.C_O[slot], contacts_.n_O[slot]};
    if (!slides) require(anchor.C_O == now.C_O[slot], Name{now.id[slot]}, " sticks, but its anchor moved");

    const double mu = slides ? friction.mu_dynamic : friction.mu_static;
    const Matrix3d R = target.turn * target.R;
    const Vector3d n = R * anchor.n_O;
    bound(beyond(f, n, mu), 1e-12 * f.norm(), tally_.cone, Name{now.id[slot]}, " leaves its cone");
    const Vector3d tangent = f - f.dot(n) * n;

    // What friction moves, it moves forward, but for the anchor's leap onto the voxels' surface: half a voxel at edges.
    const Vector3d moved = R * (now.C_O[slot] - anchor.C_O);
    const double leap = 0.5 * scene_.bodies[std::size_t(patch.body)].field->grid().spacing;
    tally_.backward += tangent.dot(moved) < -leap * tangent.norm();
    slack_ += std::max(0.0, -tangent.dot(moved));
    // The element at the solution, as linearised.
    const Vector3d v_before = (source ? source->velocity_before(p) : share) - target.velocity_before(p);
    const Vector3d turned = target.turn * v_before - v_before;
    const Vector3d v = v_before + turned - target.change(p) + (source ? source->change(p) : Vector3d(Vector3d::Zero()));
    const Vector3d r0 = target.turn * (p - target.at(anchor.C_O) - place_ * v_before), r = r0 + reach * v;
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
    bound((f - law).norm(), 1e-12 * f.norm() + 10 * (rounding + speed_rounding), tally_.element, Name{now.id[slot]},
          " breaks its law");

    const auto stored = [k](const Vector3d& at) { return 0.5 * k * at.squaredNorm(); };
    const Vector3d end = true_end(now, patch, slot);
    if (scheme.theta == 1) terms_.numerical -= 0.5 * k * h_ * h_ * (closing * closing + stretch.squaredNorm());
    const double slid = stored(r1 - moved) - stored(r1 - straight) + tangent.dot(moved - straight);
    terms_.blocked += slid;
    terms_.turning += stored(end) - stored(r1 - moved);
    (source ? terms_.turning : turned_work_) += h_ * f.dot(turned);
    if (touched)
      (r0.dot(n) < 0 ? terms_.appearing : terms_.touching) += stored(r0);
    else
      terms_.turning -= stored(p0 - bodies_[std::size_t(patch.body)].X_WO * anchor.C_O) - stored(r0);
    rounding_energy_ += rounding * (end.norm() + h_ * v.norm());
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
    const Moved& m = moved_[i];
    if (!m.moves) return;
    const double allowed = 2e-13 * size_ + noise_ + 1e-18;  // [N s]: what oil leaves of a motion is nobody's concern
    // P1 − P0 = h (F + f) − P_θ h / τ.
    const Vector3d linear = m.mass * (m.v1 - m.u0 + (m.grown - 1) * m.u) - h_ * (weight(m) + m.force);
    bound(linear.norm(), allowed, tally_.momentum, "linear momentum of body ", i);
    if (!m.turns) return;
    const Vector3d angular = m.L1 - m.L0 + (m.grown - 1) * m.at_theta(m.L0, m.L1) - h_ * (m.load_torque + m.torque);
    bound(angular.norm(), allowed, tally_.momentum, "angular momentum of body ", i);
  }

  void check_energy(const World& world) {
    const Energy now = world.energy();
    const double falls = energy_.dissipated - now.dissipated;  // may be all of the slack, but for rounding
    require(!known_ || falls <= (1 + 1e-9) * slack_ + 1e-14 * now.dissipated, "dissipation falls by ", falls);
    tally_.throughput += power_;
    tally_.growth = std::max(tally_.growth, book(world) - start_);
    appeared_ += terms_.appearing;
    tally_.gain =
        std::max(tally_.gain, now.kinetic + now.potential - (now.hand_work - turned_work_) - start_ - appeared_);
    double fastest = 0;
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      const Moved& m = moved_[i];
      if (!m.moves) continue;
      fastest = std::max({fastest, m.u.norm() + m.u0.norm(), m.w.norm() + m.w0.norm()});
      const bool loses = m.scheme.theta == 1;
      if (loses) terms_.numerical -= 0.5 * m.mass * (m.u - m.u0).squaredNorm();
      if (!m.turns) continue;
      if (loses) terms_.numerical -= 0.5 * (m.L1 - m.L0).dot(m.inverse_J * (m.L1 - m.L0));
      terms_.turning +=
          0.5 * m.L1.dot(world.bodies()[i].w - m.inverse_J * m.L1) - 0.5 * m.L0.dot(m.w0 - m.inverse_J * m.L0);
    }
    if (!known_) return;
    ++tally_.audited;
    tally_.terms.numerical += terms_.numerical;
    tally_.terms.turning += terms_.turning;
    tally_.terms.touching += terms_.touching;
    tally_.terms.appearing += terms_.appearing;
    tally_.terms.blocked += terms_.blocked;
    const double change = (now.kinetic - energy_.kinetic) + (now.potential - energy_.potential) +
                          (now.elastic - energy_.elastic) + (now.dissipated - energy_.dissipated) -
                          (now.hand_work - energy_.hand_work);
    const double unexplained = change - terms_.sum();
    // The solver's tolerance times the velocities it is wrong by, and rounding of the book's own numbers.
    double sizes = now.kinetic + now.elastic + now.dissipated + std::abs(now.hand_work);
    for (const RigidBody& b : world.bodies())  // the potential is a small difference of large heights
      if (b.moves()) sizes += b.mass * scene_.gravity.norm() * b.center().norm();
    const double allowed = 1e-14 * sizes + (2e-13 * size_ + noise_) * fastest + rounding_energy_;
    bound(std::abs(unexplained), allowed, tally_.energy, "energy");
  }

  const Scene& scene_;
  AuditTally tally_{};
  std::vector<HandPath> paths_;
  double h_{}, t_{}, start_{}, appeared_{};
  double turned_work_{};  // what the book's work of hands is more than Σ h f·v_p: it sees v_p turned, too [J]
  bool solved_{true}, known_{true};
  std::vector<HandFrame> hands_{};
  const std::vector<HandFrame>* next_{};
  std::vector<RigidBody> bodies_{};
  const std::vector<RigidBody>* after_{};
  Contacts contacts_{};
  Energy energy_{};
  std::vector<Moved> moved_{};
  EnergyTerms terms_{};
  double size_{}, noise_{}, power_{}, rounding_energy_{}, slack_{};
};

}  // namespace handhold::realtime::testing
