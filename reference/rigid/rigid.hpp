// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/model/rigid_problem.hpp"

namespace handhold::reference::rigid {

struct Options {
  double accuracy{1e-10};       ///< local error of the integrator a step [m, rad, m/s, J, absolute], 1e-13 to 1e-3
  double max_step{1e-3};        ///< longest step; a pair of events inside one step would be missed [s], > 0
  double frame_rate{100};       ///< of the trajectory [Hz], > 0
  long step_limit{20'000'000};  ///< accepted steps, after which the run counts as stalled, > 0
};

/// Throws InputError for an option out of range.
void validate(const Options& options);

/// What the method errs by beside the accuracy of its integrator.
inline constexpr double event_noise = 1e-10;  ///< velocities and gaps up to it count as none at an event [m/s, m]
inline constexpr double event_delay = 1e-12;  ///< at the beginning of a step, an event is found this much later [s]
inline constexpr double recovery = 100;       ///< α: errors of the contact equations decay as e^(−αt) [1/s]

struct SupportState {
  Mode mode{Mode::apart};                               ///< a ball that sticks rolls
  double gap{};                                         ///< [m]; of no meaning for a force-controlled support
  double normal_force{};                                ///< N [N]
  Eigen::Vector3d friction_W{Eigen::Vector3d::Zero()};  ///< on the body [N]
  Eigen::Vector3d slip_W{Eigen::Vector3d::Zero()};      ///< velocity of the body against the surface, tangential [m/s]
};

struct Frame {
  double t{};  ///< [s]
  BodyState body{};
  std::vector<SupportState> supports{};
  Energy energy{};  ///< elastic: of springs; hand_work: of moving surfaces, pressing fingers, anchors and the load
};

/// A change of one support's mode, located on re-integrated states to within `window`. From slip to slip: the sliding
/// stopped and went on in another direction at once.
struct Event {
  double t{};       ///< [s]
  double window{};  ///< [s]; 0 at t = 0
  int support{};
  Mode from{}, to{};
  BodyState before{}, after{};  ///< they differ by an impact, and by the noise that a stop removes
};

struct Trajectory {
  Outcome outcome{Outcome::complete};
  std::string note{};
  std::vector<Frame> frames{};  ///< the first at t = 0 (after what happens there at once), the last at the end
  std::vector<Event> events{};  ///< ascending in time
  long steps{};                 ///< accepted
};

/// Simulates a body under rigid Coulomb friction with exact stiction: constraints of Simbody, switched by events.
///
/// Stick: gap = 0 and no sliding velocity; slip under a normal force that the constraint finds: a constraint on the gap
/// whose force is along n − μ_d d, d the direction of sliding, so that friction and normal force are found together.
/// Between events a Runge-Kutta-Merson integrator with error control; the constraint equations carry their own errors
/// back to zero (e'' = −2αe' − α²e, much faster than motions, slower than steps). An event is the zero of a regular
/// witness: μ_s N − |f|, N, the gap, or u · held (see Contact), located by bracketing on states that are integrated
/// anew from the beginning of the step.
///
/// Throws InputError for input that cannot be simulated, before Simbody sees it. What goes wrong later is data:
/// Outcome::stalled with a note (no consistent modes; an impact whose friction would turn; a function that gives NaN).
/// `progress` is called at every frame and now and then between; returning false stops the run (Outcome::interrupted).
/// Deterministic, reentrant.
[[nodiscard]] Trajectory simulate(const RigidProblem& problem, const Options& options = {},
                                  const std::function<bool(double t)>& progress = {});

}  // namespace handhold::reference::rigid
