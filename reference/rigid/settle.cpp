// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/settle.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cases/model/defect.hpp"

namespace handhold::reference::rigid {
namespace {

constexpr int direction_rounds = 100;  // of the fixed point of an incipient slip's direction
constexpr double direction_tolerance = 1e-12;

using Choice = std::vector<std::size_t>;  // for every support, which of its possible modes

struct Situation {
  std::vector<Mode> possible{};
  bool at_rest{false};
};

Situation possibilities(const RigidSupport& support, double t, const ContactPoint& point,
                        const Tolerances& tolerances) {
  const bool at_rest = point.slip.norm() <= tolerances.speed;
  if (support.normal_force) {
    if (!(support.normal_force(t) > 0)) return {{Mode::apart}, at_rest};
    if (!at_rest) return {{Mode::slip}, false};
    return {{Mode::stick, Mode::slip}, true};
  }
  if (point.gap > tolerances.gap || point.gap_rate > tolerances.speed) return {{Mode::apart}, at_rest};
  if (!at_rest) return {{Mode::slip, Mode::apart}, false};
  return {{Mode::stick, Mode::apart, Mode::slip}, true};  // what is not needed leaves, rather than rub idly
}

bool uneven(const Choice& choice, const std::vector<Situation>& supports) {
  std::size_t least = 99, most = 0;
  for (std::size_t i = 0; i < choice.size(); ++i) {
    if (supports[i].possible.size() < 2) continue;
    least = std::min(least, choice[i]);
    most = std::max(most, choice[i]);
  }
  return least < most;
}

std::vector<Choice> all_choices(const std::vector<Situation>& supports) {
  std::vector<Choice> all{{}};
  for (const Situation& support : supports) {
    std::vector<Choice> longer;
    for (const Choice& choice : all)
      for (std::size_t k = 0; k < support.possible.size(); ++k) {
        longer.push_back(choice);
        longer.back().push_back(k);
      }
    all = longer;
  }
  const auto rank = [&](const Choice& c) {
    return std::pair{uneven(c, supports), std::accumulate(c.begin(), c.end(), std::size_t{0})};
  };
  std::stable_sort(all.begin(), all.end(), [&](const Choice& a, const Choice& b) { return rank(a) < rank(b); });
  return all;
}

/// Turns the direction of every slip that begins until the sliding it starts is along it: d = u'/|u'|. False if that
/// does not settle.
bool align(Modes& modes, const std::vector<Situation>& supports, const Trial& trial, double slow,
           std::vector<Reaction>& reactions) {
  for (int round = 0; round < direction_rounds; ++round) {
    double change = 0;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      if (modes[i].mode != Mode::slip || !supports[i].at_rest) continue;
      const Eigen::Vector3d& n = reactions[i].point.normal;
      const Eigen::Vector3d& u = reactions[i].rates.acceleration;
      const Eigen::Vector3d level = u - n * n.dot(u);
      if (level.norm() <= slow) continue;
      const Eigen::Vector3d direction = level.normalized();
      if (direction.dot(modes[i].held) <= 0) return false;
      change = std::max(change, (direction - modes[i].held).norm());
      modes[i].held = direction;
    }
    if (change <= direction_tolerance) return true;
    reactions = trial(modes);
  }
  return false;
}

/// Whether a slip from rest goes forward. One that does not accelerate may begin where sticking was too much to ask;
/// else it would be a contact wedged by its own friction, or one that carries nothing.
bool begins(const RigidProblem& problem, const Reaction& r, const Contact& contact, bool overloaded,
            const Tolerances& tolerances) {
  const double forward = r.rates.acceleration.dot(contact.held);
  if (forward > tolerances.acceleration) return true;
  return overloaded && forward >= -tolerances.acceleration && r.normal_force > problem.mass * tolerances.acceleration;
}

bool consistent(const RigidProblem& problem, const Modes& modes, const std::vector<Situation>& supports,
                const std::vector<Reaction>& held_up, const std::vector<Reaction>& reactions,
                const Tolerances& tolerances) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const Reaction& r = reactions[i];
    const bool choice = supports[i].possible.size() > 1;
    // Fingers that are alike are overloaded alike, up to round-off.
    const bool overloaded = cone_margin(problem.supports[i], held_up[i]) < problem.mass * tolerances.acceleration;
    if (!std::isfinite(r.normal_force) || !r.friction.allFinite()) return false;
    if (modes[i].mode == Mode::apart) {
      if (choice && r.rates.gap_acceleration < -tolerances.acceleration) return false;
      continue;
    }
    if (!problem.supports[i].normal_force && r.normal_force < 0) return false;
    if (modes[i].mode == Mode::stick && cone_margin(problem.supports[i], r) < 0) return false;
    if (modes[i].mode == Mode::slip && supports[i].at_rest && !begins(problem, r, modes[i], overloaded, tolerances))
      return false;
  }
  return true;
}

}  // namespace

std::optional<Modes> settle(const RigidProblem& problem, double t, const std::vector<ContactPoint>& points,
                            const Trial& trial, const Tolerances& tolerances) {
  std::vector<Situation> supports;
  for (std::size_t i = 0; i < points.size(); ++i)
    supports.push_back(possibilities(problem.supports[i], t, points[i], tolerances));
  std::vector<Reaction> held_up;  // the first trial, with all the sticking there can be: friction that would be needed
  for (const Choice& choice : all_choices(supports)) {
    Modes modes(points.size());
    bool directed = true;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      modes[i].mode = supports[i].possible[choice[i]];
      if (modes[i].mode != Mode::slip) continue;
      if (!supports[i].at_rest) modes[i].held = points[i].slip.normalized();
      if (supports[i].at_rest) modes[i].held = -held_up[i].friction.normalized();
      directed = directed && !modes[i].held.isZero(0);
    }
    if (!directed) continue;
    std::vector<Reaction> reactions = trial(modes);
    if (held_up.empty()) held_up = reactions;
    if (!DEFECT(incipient_slip_unaligned, align(modes, supports, trial, tolerances.acceleration, reactions), true))
      continue;
    if (consistent(problem, modes, supports, held_up, reactions, tolerances)) return modes;
  }
  return std::nullopt;
}

}  // namespace handhold::reference::rigid
