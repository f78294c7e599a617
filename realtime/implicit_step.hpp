#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "cases/scene/friction.hpp"
#include "realtime/element.hpp"
#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

/// One sample in the solve of one body: what it is given, and what comes out.
struct StepSample {
  ElementStep element{};
  Eigen::Vector3d arm{Eigen::Vector3d::Zero()};      ///< C − centre of mass at the start of the step, in W [m]
  bool sliding{false};                               ///< in: slid before; out: slides
  Trial trial{};                                     ///< out: at the solution
  Eigen::Vector3d f{Eigen::Vector3d::Zero()};        ///< out: force on the object [N]
  Eigen::Vector3d tangent{Eigen::Vector3d::Zero()};  ///< out: its tangential part [N]
};

struct SolverOptions {
  int max_iterations{30};
  double tolerance{1e-13};  ///< of the momentum balance, relative to the sum of its terms' sizes
};

struct SolverReport {
  int iterations{};
  bool converged{true};
};

/// Solves M (u − u0) = h (F + Σ Gᵀ f(u)) for the velocity u at the end of the step: all elements of a body are coupled
/// through its six velocities only, so one dense 6 × 6 system a Newton step is all there is.
///
/// Semi-smooth Newton on touching (N >= 0) and sliding (|f_t| <= μ_d N); sticking samples whose t* leaves the static
/// cone at a solution start to slide, never back within a step, so the loop ends. A body that does not move (`moves`
/// false) gets u = 0.
SolverReport solve_velocity(const RigidBody& body, const Vector6& external, double drag, double h,
                            const Friction& friction, std::vector<StepSample>& samples, std::size_t count,
                            const SolverOptions& options, Vector6& u);

}  // namespace handhold::realtime
