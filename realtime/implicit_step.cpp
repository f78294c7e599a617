#include "realtime/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "realtime/small_solve.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& r) {
  Matrix3d m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

/// Σ Gᵀ G slope over the linear samples, G = [1, −a×].
Matrix6 stick_slope(const PatchStep& p) {
  const double s = p.stiffness.slope;
  const Matrix3d a = s * cross_matrix(p.sums.arm);
  Matrix6 S;
  S.topLeftCorner<3, 3>() = s * p.sums.count * Matrix3d::Identity();
  S.topRightCorner<3, 3>() = -a;
  S.bottomLeftCorner<3, 3>() = a;
  S.bottomRightCorner<3, 3>() = s * (p.sums.arm_arm.trace() * Matrix3d::Identity() - p.sums.arm_arm);
  return S;
}

/// Adds Gᵀ D G.
void add_slope(const Vector3d& arm, const Matrix3d& D, Matrix6& S) {
  const Matrix3d r = cross_matrix(arm);
  const Matrix3d Dr = D * r;
  S.topLeftCorner<3, 3>() += D;
  S.topRightCorner<3, 3>() -= Dr;
  S.bottomLeftCorner<3, 3>() += r * D;
  S.bottomRightCorner<3, 3>() -= r * Dr;
}

/// Evaluates one element at a change `dv` of relative velocity; its slope is zero when apart. `touching`: what has just
/// come in is taken to press, or else, before anything has moved, nothing would carry anything.
void evaluate(Slider& slider, const Vector3d& dv, const Friction& friction, bool touching) {
  slider.trial = trial(slider.element, dv);
  slider.presses = slider.trial.N > 0 || (touching && slider.entering);
  ElementForce force;
  if (slider.presses && slider.trial.N <= 0)
    force = sticking_force(slider.element, slider.trial);
  else if (slider.presses)
    force = slider.sliding ? sliding_force(slider.element, slider.trial, friction.mu_dynamic)
                           : sticking_force(slider.element, slider.trial);
  slider.f = force.f;
  slider.tangent = force.tangent;
  slider.slope = force.slope;
}

/// What touches while it moves sideways faster than its cone opens slides from the start: made to stick first, it would
/// stop the body, and nothing found from there would be near the solution.
bool touches_sliding(const Slider& slider, Mode mode, const Friction& friction) {
  if (mode != Mode::apart) return false;
  const Trial t = trial(slider.element, Vector3d::Zero());
  return t.t_norm > friction.mu_static * std::max(t.N, 0.0);
}

/// Sticking sliders outside the static cone start to slide; true if there was one.
bool break_away(Island& island) {
  bool any = false;
  for (const PatchStep& p : island.patches)
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      Slider& s = island.sliders[std::size_t(i)];
      if (s.sliding || s.trial.N <= 0 || s.trial.t_norm <= p.friction.mu_static * s.trial.N) continue;
      s.sliding = any = true;
    }
  return any;
}

/// Linear samples that do not hold at the solution become free ones; true if there was one.
bool let_go(const PatchSlot& patch, const Friction& friction, const Contacts& contacts, StickMoments& moments,
            std::vector<Role>& role) {
  bool any = false;
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    if (role[slot] != Role::linear) continue;
    const Vector3d f = contacts.f_O[slot], n = contacts.n_O[slot];
    const double N = -f.dot(n);
    if (N > 0 && (f + N * n).norm() <= friction.mu_static * N) continue;
    role[slot] = Role::free;
    moments.stale = true;
    any = true;
  }
  return any;
}

/// The slope of a slider without what its friction gains with its pressure: symmetric and never negative, so that a
/// Newton step with it always goes downhill.
Matrix3d lessened_slope(const Slider& slider, const Friction& friction) {
  const double cap = friction.mu_dynamic * slider.trial.N;
  if (!slider.sliding || slider.trial.t_norm <= cap) return slider.slope;
  const Vector3d &n = slider.element.n, t = slider.trial.t / slider.trial.t_norm;
  const double slope = slider.element.h * slider.element.stiffness + slider.element.damping;
  const Matrix3d across = Matrix3d::Identity() - n * n.transpose() - t * t.transpose();
  return slope * (n * n.transpose() + cap / slider.trial.t_norm * across);
}

/// Samples on watch that the solution brings inside become free ones; true if there was one.
bool step_in(const SlotStep& step, const Scheme& scheme, const Vector3d& dv, const Vector3d& dw, const BodyStep& target,
             const Contacts& contacts, std::vector<Role>& role) {
  bool any = false;
  const PatchSlot& patch = contacts.patches[std::size_t(step.patch)];
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    if (role[slot] != Role::watch) continue;
    const SampleStep s = sample_step(step.motion, target, scheme.lead(), contacts, slot);
    const Vector3d end = s.reach - scheme.reach() * (dv + dw.cross(s.arm));
    if (end.dot(s.n) >= 0) continue;
    role[slot] = Role::free;
    any = true;
  }
  return any;
}

}  // namespace

void PatchStep::relative(const std::vector<BodyStep>& bodies, Vector3d& dv, Vector3d& dw) const {
  const Vector6& d = bodies[std::size_t(target)].change;
  dv = d.head<3>();
  dw = d.tail<3>();
  if (source < 0) return;
  const Vector6& e = bodies[std::size_t(source)].change;
  dv -= e.head<3>() + e.tail<3>().cross(offset);
  dw -= e.tail<3>();
}

void IslandSolver::reserve(int bodies) {
  row_.assign(std::size_t(bodies), -1);
  residual_.reserve(std::size_t(bodies));
  correction_.reserve(std::size_t(bodies));
  best_.reserve(std::size_t(bodies));
  if (bodies > 1) blocks_.reserve(bodies);
}

void IslandSolver::begin(const Island& island) {
  const int rows = int(island.bodies.size());
  residual_.resize(island.bodies.size());
  correction_.resize(island.bodies.size());
  best_.resize(island.bodies.size());
  for (int i = 0; i < rows; ++i) row_[std::size_t(island.bodies[std::size_t(i)])] = i;
  analysed_ = rows < 2;
}

/// Once an island, and only if there is anything to solve for.
void IslandSolver::analyse(const Island& island) {
  if (analysed_) return;
  analysed_ = true;
  blocks_.begin(int(island.bodies.size()));
  for (const PatchStep& p : island.patches)
    if (row(p.target) >= 0 && row(p.source) >= 0) blocks_.couple(row(p.target), row(p.source));
  blocks_.analyse();
}

/// Makes sliders of all samples that are neither idle nor linear, in the order of slots, and sums the linear ones.
void IslandSolver::collect(Island& island, const Scheme& scheme, const std::vector<BodyStep>& bodies,
                           const Contacts& contacts, std::vector<StickMoments>& moments,
                           const std::vector<Role>& role) const {
  island.sliders.clear();
  for (PatchStep& p : island.patches) {
    const BodyStep& target = bodies[std::size_t(p.target)];
    const SlotStep* const slots = island.slots.data() + p.first_patch;
    p.first_slider = int(island.sliders.size());
    for (int at = 0; at < p.patch_count; ++at) {
      const PatchSlot& patch = contacts.patches[std::size_t(slots[at].patch)];
      StickMoments& moment = moments[std::size_t(slots[at].patch)];
      update(patch, contacts, role, moment);
      if (moment.count == patch.count) continue;
      for (int i = 0; i < patch.count; ++i) {
        const std::size_t slot = patch.slot(i);
        if (role[slot] != Role::free && role[slot] != Role::sliding) continue;
        const SampleStep sample = sample_step(slots[at].motion, target, scheme.lead(), contacts, slot);
        Slider s;
        s.slot = slot;
        s.element = {p.stiffness.k, p.stiffness.c, scheme.reach(), sample.n, sample.reach, sample.v};
        s.arm = sample.arm;
        s.entering = contacts.mode[slot] == Mode::apart;
        s.sliding = role[slot] == Role::sliding || touches_sliding(s, contacts.mode[slot], p.friction);
        island.sliders.push_back(s);
      }
    }
    p.slider_count = int(island.sliders.size()) - p.first_slider;
    p.sums = sum_sticking(slots, slots + p.patch_count, p.stiffness, target, moments);
  }
}

/// Puts a patch's slope against its relative velocity where its bodies' velocities are: T = [1, −offset×; 0, 1] takes
/// the source's to the target's centre.
void IslandSolver::add_stiffness(const PatchStep& p, double reach, const Matrix6& S) {
  const int t = row(p.target), s = row(p.source);
  if (residual_.size() == 1) {
    if (t >= 0) dense_ += reach * S;
    if (s < 0) return;
  }
  Matrix6 T = Matrix6::Identity();
  T.topRightCorner<3, 3>() = -cross_matrix(p.offset);
  if (residual_.size() == 1) {
    dense_ += reach * T.transpose() * S * T;
    return;
  }
  if (t >= 0) blocks_.block(t, t) += reach * S;
  if (s < 0) return;
  const Matrix6 ST = reach * S * T;
  const Matrix6 TS = T.transpose() * S;
  blocks_.block(s, s).noalias() += T.transpose() * ST;
  if (t < 0) return;
  blocks_.block(t, s) -= ST;
  blocks_.block(s, t) -= reach * TS;
}

/// Residual at the present changes of velocity; true if it is next to nothing against the sizes of its terms.
bool IslandSolver::is_balanced(Island& island, double reach, const std::vector<BodyStep>& bodies, double tolerance,
                               bool touching) {
  constexpr double rounding = 4e-16;
  double size = 0, noise = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyStep& body = bodies[std::size_t(island.bodies[i])];
    residual_[i] = body.rest;
    if (!body.change.isZero(0)) residual_[i] -= body.mass * body.change;
    size += reach * body.external.norm() + body.momentum.norm();
  }
  for (PatchStep& p : island.patches) {
    if (p.sums.count == 0 && p.slider_count == 0) continue;
    Vector3d dv, dw;
    p.relative(bodies, dv, dw);
    const double s = p.stiffness.slope;
    const Matrix3d& aa = p.sums.arm_arm;
    Vector3d force = p.sums.force - s * (p.sums.count * dv + dw.cross(p.sums.arm));
    Vector3d torque = p.sums.torque - s * (p.sums.arm.cross(dv) + aa.trace() * dw - aa * dw);
    size += reach * std::max(force.norm(), p.sums.size);
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      Slider& slider = island.sliders[std::size_t(i)];
      evaluate(slider, dv + dw.cross(slider.arm), p.friction, touching);
      force += slider.f;
      torque += slider.arm.cross(slider.f);
      size += reach * slider.f.norm();
    }
    // What rounding of positions makes of forces.
    const double extent = bodies[std::size_t(p.target)].center.norm() + p.offset.norm();
    const double stiff = reach * p.stiffness.k * extent;
    noise += (p.sums.count + p.slider_count) * stiff * stiff;
    if (const int t = row(p.target); t >= 0) {
      residual_[std::size_t(t)].head<3>() += reach * force;
      residual_[std::size_t(t)].tail<3>() += reach * torque;
    }
    if (const int t = row(p.source); t >= 0) {
      residual_[std::size_t(t)].head<3>() -= reach * force;
      residual_[std::size_t(t)].tail<3>() -= reach * (torque + p.offset.cross(force));
    }
  }
  squared_ = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    if (!bodies[std::size_t(island.bodies[i])].turns) residual_[i].tail<3>().setZero();
    squared_ += residual_[i].squaredNorm();
  }
  // Angular rows are in N m s: an arm of a metre would make them comparable, objects are smaller, so this is the safe
  // side.
  return std::sqrt(squared_) <= tolerance * size + rounding * std::sqrt(noise);
}

/// The system of a Newton step; true if it is symmetric.
bool IslandSolver::add_slopes(const Island& island, double reach, const std::vector<BodyStep>& bodies, bool exact) {
  analyse(island);
  const bool one = island.bodies.size() == 1;
  if (one)
    dense_ = bodies[std::size_t(island.bodies[0])].mass;
  else
    blocks_.clear();
  for (std::size_t i = 0; !one && i < island.bodies.size(); ++i)
    blocks_.block(int(i), int(i)) = bodies[std::size_t(island.bodies[i])].mass;
  bool symmetric = true;
  for (const PatchStep& p : island.patches) {
    if (p.sums.count == 0 && p.slider_count == 0) continue;
    Matrix6 S = Matrix6::Zero();
    if (p.sums.count > 0) S = stick_slope(p);
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      const Slider& slider = island.sliders[std::size_t(i)];
      if (!slider.presses) continue;
      symmetric = symmetric && !(exact && slider.sliding);
      add_slope(slider.arm, exact ? slider.slope : lessened_slope(slider, p.friction), S);
    }
    add_stiffness(p, reach, S);
  }
  return symmetric;
}

/// One Newton step.
void IslandSolver::correct(const Island& island, std::vector<BodyStep>& bodies, bool symmetric) {
  if (island.bodies.size() > 1)
    blocks_.solve(residual_);
  else if (symmetric)
    residual_[0] = solve_symmetric(dense_, residual_[0]);
  else
    residual_[0] = dense_.partialPivLu().solve(Vector6(residual_[0]));
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    BodyStep& body = bodies[std::size_t(island.bodies[i])];
    if (!body.turns) residual_[i].tail<3>().setZero();
    body.change += residual_[i];
  }
  std::swap(correction_, residual_);
}

/// Takes back `share` of the last Newton step.
void IslandSolver::step_back(const Island& island, std::vector<BodyStep>& bodies, double share) const {
  for (std::size_t i = 0; i < correction_.size(); ++i)
    bodies[std::size_t(island.bodies[i])].change -= share * correction_[i];
}

void IslandSolver::remember(const Island& island, const std::vector<BodyStep>& bodies) {
  if (!(squared_ < best_squared_)) return;
  best_squared_ = squared_;
  for (std::size_t i = 0; i < best_.size(); ++i) best_[i] = bodies[std::size_t(island.bodies[i])].change;
}

SolverReport IslandSolver::solve(Island& island, const Scheme& scheme, std::vector<BodyStep>& bodies,
                                 Contacts& contacts, std::vector<StickMoments>& moments, std::vector<Role>& role,
                                 const SolverOptions& options) {
  const double reach = scheme.reach();
  begin(island);
  collect(island, scheme, bodies, contacts, moments, role);
  const auto lap = [&](Phase phase) {
    if (clock_) clock_->lap(phase);
  };
  lap(Phase::sums);
  const auto evaluate_linear = [&] {
    lap(Phase::solve);
    bool again = false;
    for (PatchStep& p : island.patches) {
      if (p.sums.count == 0 && !p.watches) continue;
      Vector3d dv, dw;
      p.relative(bodies, dv, dw);
      const BodyStep& target = bodies[std::size_t(p.target)];
      p.stuck = result_of(p.sums, p.stiffness, dv, dw);
      SlotStep* const slots = island.slots.data() + p.first_patch;
      evaluate_sticking(slots, slots + p.patch_count, p.stiffness, p.friction.mu_static, dv, dw, target, role, moments,
                        contacts);
      for (const SlotStep* step = slots; step != slots + p.patch_count; ++step) {
        const PatchSlot& patch = contacts.patches[std::size_t(step->patch)];
        if (p.watches && step_in(*step, scheme, dv, dw, target, contacts, role)) again = true;
        if (!step->holds && let_go(patch, p.friction, contacts, moments[std::size_t(step->patch)], role)) again = true;
      }
    }
    lap(Phase::check);
    return again;
  };
  constexpr int most_halvings = 8, eager = 8, patience = 24, most_rounds = 100;
  SolverReport report{0, false};
  bool corrected = false;
  double last = 0;
  best_squared_ = std::numeric_limits<double>::infinity();
  int halvings = 0;
  int rounds = 0;  // of roles
  for (int tries = 0; tries <= options.max_iterations && rounds < most_rounds; ++tries, ++report.iterations) {
    // A linear system is solved by one step, to rounding.
    bool solved = island.sliders.empty() && corrected;
    if (!solved) {
      const bool first = tries == 0 && rounds == 0;
      const bool balanced = is_balanced(island, reach, bodies, options.tolerance, first);
      solved = balanced && (!first || island.sliders.empty());
    }
    if (!solved) {
      // Friction that changes its side looks flat from both: a full step goes from one to the other for ever.
      remember(island, bodies);
      const bool worse = tries >= eager && corrected && !(squared_ <= last) && halvings < most_halvings;
      if (worse) {
        step_back(island, bodies, std::ldexp(0.5, -halvings++));
        continue;
      }
      last = squared_;
      halvings = 0;
      const bool exact = tries < patience;
      correct(island, bodies, add_slopes(island, reach, bodies, exact));
      corrected = true;
      continue;
    }
    if (break_away(island)) {
      for (const Slider& s : island.sliders) role[s.slot] = s.sliding ? Role::sliding : Role::free;
      corrected = false;
      best_squared_ = std::numeric_limits<double>::infinity();
      tries = 0;
      ++rounds;
      continue;
    }
    report.converged = !evaluate_linear();
    if (report.converged) break;
    collect(island, scheme, bodies, contacts, moments, role);
    lap(Phase::sums);
    corrected = false;
    best_squared_ = std::numeric_limits<double>::infinity();
    tries = 0;
    ++rounds;
  }
  if (!report.converged) {  // the best that was found, and what the samples do there
    for (std::size_t i = 0; i < island.bodies.size() && std::isfinite(best_squared_); ++i)
      bodies[std::size_t(island.bodies[i])].change = best_[i];
    (void)is_balanced(island, reach, bodies, options.tolerance, false);
    evaluate_linear();
  }
  for (const int body : island.bodies) row_[std::size_t(body)] = -1;
  return report;
}

}  // namespace handhold::realtime
