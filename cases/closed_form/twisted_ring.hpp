// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// G08. A ring of samples on a plane face of an object that stays; the hand turns about a centre at distance c from the
/// ring's centre, on the line to its first sample. L2, exact at finite angles: sample i at distance D_i from the centre
/// of rotation sticks until its chord 2 D_i sin(θ/2) reaches μ_s N_i / k, with torque k D_i² sin θ, and then follows a
/// curve of pursuit (pursuit.hpp).
struct TwistedRing {
  double radius{0.004};    ///< a [m]
  double offset{0.003};    ///< c [m]
  double stiffness{100};   ///< k of each sample [N/m]
  double normal_force{2};  ///< N of the ring [N]
  int samples{8};
  Friction friction{0.5, 0.5};
};

/// Distances D_i of the samples from the centre of rotation [m]; serves the torque.
[[nodiscard]] std::vector<double> distances(const TwistedRing& ring);

/// 2 asin(μ_s N_i / (2 k D)) for the sample at distance `D` [rad]; NaN if it never slips. Serves the torque.
[[nodiscard]] double slip_angle(const TwistedRing& ring, double distance);

/// Angle at which the first sample slips, and the last one [rad]. G08 asks for the first; the last bounds its curve.
[[nodiscard]] double first_slip_angle(const TwistedRing& ring);
[[nodiscard]] double last_slip_angle(const TwistedRing& ring);

/// How many samples slip at angle θ.
[[nodiscard]] int slipping(const TwistedRing& ring, double angle);

/// Torque on the object about the centre of rotation after a turn by θ >= 0 [N m].
[[nodiscard]] double torque(const TwistedRing& ring, double angle);

/// What the exact torque is tested against, 1.3 % above it at 0.35 rad and so no truth of a case. The same for small
/// angles: Σ min(k θ D_i, μ_d N_i) D_i (μ_s = μ_d) [N m].
[[nodiscard]] double linear_torque(const TwistedRing& ring, double angle);

}  // namespace handhold::closed_form
