// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::reference {

/// Which surface the samples touch.
enum class SurfaceModel {
  automatic,  ///< of every body: the mesh if it has creases, the voxels if it is smooth
  voxels,     ///< the zero set of the C2 spline through the shared voxel field
  mesh,       ///< the exact triangles
};

struct Options {
  double accuracy{1e-10};       ///< local error of the integrator a step [m, rad, m/s, J, absolute], 1e-13 to 1e-3
  double max_step{1e-3};        ///< longest step; a pair of events inside one step would be missed [s], > 0
  double frame_rate{90};        ///< of the recording [Hz], > 0
  long step_limit{20'000'000};  ///< accepted steps, after which the run counts as stalled, > 0
  SurfaceModel surface{SurfaceModel::automatic};
  std::vector<double> frame_times{};  ///< instead of a rate: ascending in (0, duration], the last at its end [s]
};

/// Options of a name: "reference" (the defaults) or "gold" (accuracy 1e-12, steps of at most 5e-4 s: to certify the
/// others). Throws InputError for another.
[[nodiscard]] Options preset(std::string_view name);

/// Throws InputError for an option out of range.
void validate(const Options& options);

/// Simulates a scene with the contact element of docs/contact-law.md in continuous time: high-order adaptive
/// integration (Simbody, Runge-Kutta-Merson), every change of mode located to within a tenth of the accuracy (in s).
/// Any number of hands and bodies; see docs/reference.md for what is practical.
///
/// `progress` is called at every frame and now and then between; returning false stops the run (Outcome::interrupted).
/// Throws InputError for a scene that cannot be simulated, std::logic_error when an invariant of the contact law breaks
/// (our bug). Everything else that goes wrong is data: Outcome::stalled with a note. Deterministic, reentrant.
[[nodiscard]] Recording simulate(const Scene& scene, const Options& options,
                                 const std::function<bool(double t)>& progress = {});

}  // namespace handhold::reference
