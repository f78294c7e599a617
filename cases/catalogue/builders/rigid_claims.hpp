// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/catalogue/case.hpp"

// Claims and runs of rigid problems, with their limits.

namespace handhold::catalogue::rigid {

/// How far a method that controls its error may be off in the states (places, velocities, turns, energies) of a run,
/// absolute: see Limit.
struct StateError {
  double per_accuracy{}, per_noise{}, per_rounding{};
  std::string why{};
};

/// Between its events the motion is a polynomial of at most the fourth degree in t, which a Runge-Kutta method of the
/// fourth order gives exactly: what remains is rounding, of states up to `size`, in every step.
[[nodiscard]] StateError polynomial(double duration, double size = 1);

/// Else ten times the accuracy, which is of a step and absolute, and the noise that is cleared away at events.
/// `magnified`: where the motion lets errors grow.
[[nodiscard]] StateError controlled(double magnified = 1, const std::string& why = "");

/// A claim that lacks source and limits, and how an error of the state shows in it.
struct RigidClaim {
  Claim claim{};
  double sensitivity{1};  ///< [the claim's unit per unit of the state's error]; 0: yes or no, nothing to tolerate
  int recoveries{0};      ///< as in Limit
  std::string why{};      ///< of the sensitivity
  Limit stepped{};        ///< without a reason: not derived
};

/// The n-th event of that kind, of one support or of any (-1). `rate`: how fast what decides crosses zero, by the error
/// of the state that moves it, e.g. the deceleration at a stop [m/s²].
[[nodiscard]] RigidClaim event_time(const std::string& quantity, EventKind kind, int n, double truth, double rate,
                                    int support = -1);
/// One is there at t = 0, to the bit.
[[nodiscard]] RigidClaim from_the_start(const std::string& quantity, EventKind kind);
/// How many there are.
[[nodiscard]] RigidClaim event_count(EventKind kind, int truth, int support = -1);

/// A way along the axis since t = 0, against support 0; at an instant, or at the n-th event of a kind. `scale`: of what
/// a share is a share, where the truth may vanish.
[[nodiscard]] RigidClaim way(const std::string& quantity, const Eigen::Vector3d& axis, double t, double truth,
                             double scale = 0);
[[nodiscard]] RigidClaim way_at(const std::string& quantity, const Eigen::Vector3d& axis, EventKind kind, int n,
                                double truth, double rate = 0, double speed = 0);
[[nodiscard]] RigidClaim speed(const std::string& quantity, const Eigen::Vector3d& axis, double t, double truth,
                               double scale = 0);
[[nodiscard]] RigidClaim speed_at(const std::string& quantity, const Eigen::Vector3d& axis, EventKind kind, int n,
                                  double truth, double scale = 0);
/// On a frame. `per_state`: of a ball that rolls, 1/r.
[[nodiscard]] RigidClaim spin(const std::string& quantity, const Eigen::Vector3d& axis, double t, double truth,
                              double per_state, double scale = 0);
/// Through which error of the state a contact force errs: a method that holds e = 0 by e' = −αe gives friction that
/// holds m α e, e the speed of sliding; one by e'' = −2αe' − α²e a normal force m α² e, e the gap.
enum class Through { sliding_speed = 1, gap = 2 };
/// Of one support on the body of that mass, on a frame.
[[nodiscard]] RigidClaim force(const std::string& quantity, int support, const Eigen::Vector3d& axis, double t,
                               double truth, Through through, double mass, double scale = 0);
/// On a frame. `per_state`: the friction that does the work [J/m].
[[nodiscard]] RigidClaim dissipated(double t, double truth, double per_state = 1);
[[nodiscard]] RigidClaim mode(int support, double t, Mode truth);
/// The energy ledger stays balanced; `scale`: of the energies that are turned over [J].
[[nodiscard]] RigidClaim energy_balance(double scale);

/// A run with these claims. Claims without a stepped limit keep stepped methods from being asked.
[[nodiscard]] Run run(const std::string& name, const std::function<RigidProblem()>& problem, const std::string& source,
                      const StateError& error, const std::vector<RigidClaim>& claims);

}  // namespace handhold::catalogue::rigid
