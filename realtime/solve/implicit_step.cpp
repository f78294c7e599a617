// SPDX-License-Identifier: Apache-2.0
#include "realtime/solve/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "cases/model/defect.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

/// What touches while it moves sideways faster than its cone opens slides from the start: made to stick first, it would
/// stop the body, and nothing found from there would be near the solution.
bool touches_sliding(const Slider& slider, Mode mode, const Friction& friction) {
  const Trial& t = slider.at_rest;
  return mode == Mode::apart &&
         t.t_norm > DEFECT(first_touch_at_mu_d, friction.mu_static, friction.mu_dynamic) * std::max(t.N, 0.0);
}

/// Rate of what a damper feels. Along the normal, one that comes in from outside begins at the surface: its impulse
/// over the step is that of the way inside, c d. So there is no force before the surface is reached.
Vector3d rate(const Slider& slider, const SampleStep& sample, const Scheme& scheme) {
  const Vector3d start = sample.reach - scheme.reach() * sample.v;
  if (DEFECT(damper_pushes_before_touch, !slider.entering, true) || start.dot(sample.n) <= 0) return sample.v;
  return sample.v + (sample.reach / scheme.reach() - sample.v).dot(sample.n) * sample.n;
}

/// Sticking sliders outside the static cone start to slide; true if there was one.
bool break_away(Island& island) {
  bool any = false;
  for (const PatchStep& p : island.patches)
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      Slider& s = island.sliders[std::size_t(i)];
      if (s.sliding || s.trial.N <= 0 ||
          s.trial.t_norm <= DEFECT(breaks_away_at_mu_d, p.friction.mu_static, p.friction.mu_dynamic) * s.trial.N)
        continue;
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

void store(const Island& island, const std::vector<BodyStep>& bodies, std::vector<Vector6>& changes) {
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i] = bodies[std::size_t(island.bodies[i])].change;
}

void restore(const Island& island, const std::vector<Vector6>& changes, std::vector<BodyStep>& bodies) {
  for (std::size_t i = 0; i < changes.size(); ++i) bodies[std::size_t(island.bodies[i])].change = changes[i];
}

/// What the frozen limits of friction are away from what the pressures now allow.
struct Way {
  double length{};  ///< Σ |way| [N]
  double onward{};  ///< Σ way · the way of last time [N²]
};

Way find_way(Island& island) {
  Way all;
  for (const PatchStep& p : island.patches)
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      Slider& s = island.sliders[std::size_t(i)];
      const double way = s.limit(p.friction) * std::max(s.trial.N, 0.0) - s.cap;
      all.length += std::abs(way);
      all.onward += way * s.way;
      s.way = way;
    }
  return all;
}

void refreeze(Island& island, double share) {
  for (Slider& s : island.sliders) s.cap += share * s.way;
}

}  // namespace

void IslandSolver::reserve(int bodies) {
  system_.reserve(bodies);
  best_.reserve(std::size_t(bodies));
  frozen_.reserve(std::size_t(bodies));
}

/// Makes sliders of all samples that are neither idle nor linear, in the order of slots, and sums the linear ones.
void IslandSolver::collect(Island& island, const std::vector<BodyStep>& bodies, const Samples& samples) {
  const auto& [scheme, contacts, moments, role] = samples;
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
        s.entering = contacts.mode[slot] == Mode::apart;
        s.v = sample.v;
        s.arm = sample.arm;
        s.element = {p.stiffness.k, p.stiffness.c, scheme.reach(), sample.n, sample.reach, rate(s, sample, scheme)};
        s.at_rest = trial(s.element, Vector3d::Zero());
        s.sliding = role[slot] == Role::sliding || touches_sliding(s, contacts.mode[slot], p.friction);
        island.sliders.push_back(s);
      }
    }
    p.slider_count = int(island.sliders.size()) - p.first_slider;
    p.sums = sum_sticking(slots, slots + p.patch_count, p.stiffness, target, moments);
  }
  system_.regroup(island);
  lap(Phase::sums);
}

/// Samples whose roles do not suit the present δ get others; true if there was one.
bool IslandSolver::change_roles(Island& island, const std::vector<BodyStep>& bodies, const Samples& samples) {
  const auto& [scheme, contacts, moments, role] = samples;
  lap(Phase::solve);
  bool any = false;
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
      if (p.watches && step_in(*step, scheme, dv, dw, target, contacts, role)) any = true;
      if (!step->holds && let_go(patch, p.friction, contacts, moments[std::size_t(step->patch)], role)) any = true;
    }
  }
  lap(Phase::check);
  return any;
}

/// Newton with the cones as they are. It jumps between pieces of the law, so the residual may rise at first; later
/// steps that have it rise are cut. Gives up when it has not fallen to a half for some steps.
///
/// A solution that takes such steps is not waited for to look at the roles of `samples`, if there are any: those that
/// do not suit change after the first cut, and whenever the residual has fallen to a tenth.
bool IslandSolver::newton(Island& island, std::vector<BodyStep>& bodies, const Samples* samples, int patience,
                          bool first) {
  constexpr int whole_steps = 1;
  constexpr double half = 1.0 / 4, tenth = 1.0 / 100;  // of a residual, squared
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool touching = first && !island.bodies.empty() && !island.sliders.empty();
  bool balanced = system_.balance(island, bodies, tolerance_, touching ? Cones::touching : Cones::live);
  double least = infinity, look = 0;
  for (int step = touching ? -1 : 0, waits = 0; waits <= patience; ++step) {
    const double squared = system_.squared_residual();
    if (step >= 0) {
      if (balanced) return true;
      remember_best(island, bodies);
      waits = squared < least ? 0 : waits + 1;
      if (waits == 0) least = half * squared;
    }
    if (samples && squared < look) {
      look = tenth * squared;
      if (change_roles(island, bodies, *samples)) {
        collect(island, bodies, *samples);
        balanced = system_.balance(island, bodies, tolerance_, Cones::live);
        best_squared_ = least = infinity;
        continue;
      }
    }
    system_.correct(island, bodies);
    ++iterations_;
    if (island.sliders.empty()) return system_.is_finite();  // linear: solved by one step, to rounding
    balanced = system_.balance(island, bodies, tolerance_, Cones::live);
    if (!eager_ || step < whole_steps || balanced || system_.squared_residual() < squared) continue;
    if (look == 0) look = infinity;
    balanced = cut_step(squared, island, bodies);
  }
  return false;
}

/// Shortens the last step until |r|² is less than `before` it, or that is no longer worth while; true if balanced.
bool IslandSolver::cut_step(double before, Island& island, std::vector<BodyStep>& bodies) {
  constexpr int most_cuts = 2;
  constexpr double shorter = 0.3;
  bool balanced = false;
  double at = 1;
  for (int cut = 0; cut < most_cuts && !balanced && !(system_.squared_residual() < before); ++cut) {
    system_.step_back(island, bodies, (1 - shorter) * at);
    at *= shorter;
    balanced = system_.balance(island, bodies, tolerance_, Cones::live);
  }
  return balanced;
}

/// With frozen cones, far enough for the limits to be worth finding anew: down a convex potential, whose slope along a
/// Newton step falls steadily from what it is at its start. Too long a step has it below −1/2 of that; regula falsi
/// finds a shorter one.
void IslandSolver::descend(Island& island, std::vector<BodyStep>& bodies) {
  constexpr int most_steps = 60, most_cuts = 30;
  bool balanced = system_.balance(island, bodies, tolerance_, Cones::frozen);
  const double enough = 0.01 * system_.squared_residual();
  for (int i = 0; i < most_steps && !balanced && !(system_.squared_residual() < enough); ++i) {
    system_.correct(island, bodies);
    ++iterations_;
    const double start = system_.fall();
    double low = 0, high = 1, fall_low = start, fall_high = 0, at = 1;
    balanced = system_.balance(island, bodies, tolerance_, Cones::frozen);
    for (int cut = 0; cut < most_cuts; ++cut) {
      const double fall = system_.fall();
      if (fall >= -0.5 * start && (at == 1 || fall <= 0.5 * start)) break;
      (fall < 0 ? high : low) = at;
      (fall < 0 ? fall_high : fall_low) = fall;
      const double share = std::clamp(fall_low / (fall_low - fall_high), 0.1, 0.9);
      const double next = low + share * (high - low);
      system_.step_back(island, bodies, at - next);
      at = next;
      balanced = system_.balance(island, bodies, tolerance_, Cones::frozen);
    }
  }
}

void IslandSolver::remember_best(const Island& island, const std::vector<BodyStep>& bodies) {
  if (!(system_.squared_residual() < best_squared_)) return;
  best_squared_ = system_.squared_residual();
  store(island, bodies, best_);
}

/// δ for the present roles.
bool IslandSolver::find_balance(Island& island, std::vector<BodyStep>& bodies, const Samples& samples, bool first) {
  constexpr int between = 6;
  const int most_freezes = eager_ ? 40 : 400;
  best_squared_ = std::numeric_limits<double>::infinity();
  if (newton(island, bodies, eager_ ? &samples : nullptr, 6, first)) return true;

  if (!std::isfinite(best_squared_)) return false;  // a body that is not finite
  restore(island, best_, bodies);
  (void)system_.balance(island, bodies, tolerance_, Cones::live);
  for (Slider& s : island.sliders) s.cap = s.way = 0;
  double share = 1, goal = 0.1 * find_way(island).length;
  for (int freeze = 1; freeze <= most_freezes; ++freeze) {
    refreeze(island, share);
    descend(island, bodies);
    const Way way = find_way(island);
    // Limits that swing to and fro are led gently, those that run away are let go to where all sticks or nothing
    // touches.
    share = way.onward < 0 ? std::max(0.5 * share, 0.01) : std::min(1.3 * share, 1.0);
    if (way.length > goal && freeze % between != 0) continue;
    goal = 0.1 * way.length;
    store(island, bodies, frozen_);
    if (newton(island, bodies, nullptr, eager_ ? 4 : 2, false)) return true;
    restore(island, frozen_, bodies);
  }
  return false;
}

void IslandSolver::keep_roles(const Island& island, const Samples& samples) {
  first_role_.clear();
  for (const SlotStep& step : island.slots) {
    const PatchSlot& patch = samples.contacts.patches[std::size_t(step.patch)];
    for (int i = 0; i < patch.count; ++i) first_role_.push_back(samples.role[patch.slot(i)]);
  }
}

void IslandSolver::begin_again(Island& island, std::vector<BodyStep>& bodies, const Samples& samples) {
  std::size_t at = 0;
  for (const SlotStep& step : island.slots) {
    const PatchSlot& patch = samples.contacts.patches[std::size_t(step.patch)];
    for (int i = 0; i < patch.count; ++i) samples.role[patch.slot(i)] = first_role_[at++];
    samples.moments[std::size_t(step.patch)].stale = true;
  }
  for (const int body : island.bodies) bodies[std::size_t(body)].change.setZero();
}

/// True with a solution that suits all roles.
bool IslandSolver::attempt(Island& island, std::vector<BodyStep>& bodies, const Samples& samples) {
  constexpr int most_rounds = 100;
  collect(island, bodies, samples);
  for (int round = 0; round < most_rounds; ++round) {
    if (!find_balance(island, bodies, samples, round == 0)) return false;
    if (break_away(island)) {
      for (const Slider& s : island.sliders) samples.role[s.slot] = s.sliding ? Role::sliding : Role::free;
      continue;
    }
    if (!change_roles(island, bodies, samples)) return true;
    collect(island, bodies, samples);
  }
  return false;
}

SolverReport IslandSolver::solve(Island& island, const Scheme& scheme, std::vector<BodyStep>& bodies,
                                 Contacts& contacts, std::vector<StickMoments>& moments, std::vector<Role>& role,
                                 const SolverOptions& options) {
  tolerance_ = options.tolerance;
  iterations_ = 0;
  best_.resize(island.bodies.size());
  frozen_.resize(island.bodies.size());
  system_.begin(island, scheme.reach());
  const Samples samples{scheme, contacts, moments, role};
  keep_roles(island, samples);
  eager_ = true;
  bool converged = attempt(island, bodies, samples);
  if (!converged) {
    eager_ = false;
    begin_again(island, bodies, samples);
    converged = attempt(island, bodies, samples);
  }
  if (!converged) {  // the best that was found, and what the samples do there
    if (std::isfinite(best_squared_)) restore(island, best_, bodies);
    (void)system_.balance(island, bodies, tolerance_, Cones::live);
    (void)change_roles(island, bodies, samples);
  }
  system_.end(island, bodies);
  return {iterations_, converged};
}

}  // namespace handhold::realtime
