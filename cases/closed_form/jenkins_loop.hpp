// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// G03, G12. A Jenkins element (spring K in series with a slider that yields at μ N) on an object that stays, its free
/// end moved by the hand. L2, and independent of the rate: no mass takes part.
struct JenkinsLoop {
  double stiffness{800};    ///< K [N/m]
  double normal_force{2};   ///< [N]
  double mu{0.5};           ///< μ_s = μ_d
  double amplitude{0.004};  ///< A of the cyclic displacement, from 0 [m]
};

/// Lag at which it yields: μ N / K [m]; serves the distances and losses below.
[[nodiscard]] double yield_lag(const JenkinsLoop& loop);

/// Dissipated in a full cycle: 4 μ N (A − μ N / K), 0 if it never yields [J].
[[nodiscard]] double loss_per_cycle(const JenkinsLoop& loop);

/// Force at the extremes: min(K A, μ N) [N].
[[nodiscard]] double greatest_force(const JenkinsLoop& loop);

/// Force on the way back from the extreme A, at displacement x >= −A: μ N − K (A − x), at least −μ N; K x if it never
/// yields [N].
[[nodiscard]] double returning_force(const JenkinsLoop& loop, double x);

/// Displacement between a reversal and the slip that follows it: 2 μ N / K [m].
[[nodiscard]] double reversal_distance(const JenkinsLoop& loop);

}  // namespace handhold::closed_form
