// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <Eigen/Core>

#include "cases/catalogue/claim.hpp"

// What most cases ask, in a line each. Other measures and claims are written out.

namespace handhold::catalogue {

/// The instant of the n-th event of a kind, and that there is none.
[[nodiscard]] Measure time_of(EventKind kind, int n = 1);
[[nodiscard]] Measure none_of(EventKind kind);

/// On body 0 along or about an axis at time t [s]; forces are those of all samples.
[[nodiscard]] Measure displacement_at(double t, const Eigen::Vector3d& axis);
[[nodiscard]] Measure rotation_at(double t, const Eigen::Vector3d& axis);
[[nodiscard]] Measure speed_at(double t, const Eigen::Vector3d& axis);
[[nodiscard]] Measure force_at(double t, const Eigen::Vector3d& axis);
[[nodiscard]] Measure count_at(double t, Mode mode);

/// The same at the first event of a kind.
[[nodiscard]] Measure displacement_when(EventKind kind, const Eigen::Vector3d& axis);
[[nodiscard]] Measure rotation_when(EventKind kind, const Eigen::Vector3d& axis);

/// A claim in the unit of what it measures. `converges`: see Claim.
[[nodiscard]] Claim claim(const std::string& quantity, double truth, const std::string& source, const Measure& measure,
                          const Limit& controlled, const Limit& stepped, bool converges = false);

/// One to which every method must answer the same: nothing to tolerate.
[[nodiscard]] Claim yes_or_no(const std::string& quantity, bool truth, const std::string& source,
                              const Measure& measure);

/// The claim, its truth not exact but of that pedigree.
[[nodiscard]] Claim of_pedigree(Pedigree pedigree, Claim claim);

/// "m", "N", ...; nothing for counts, and yes or no.
[[nodiscard]] std::string unit_of(Measure::Kind kind);

}  // namespace handhold::catalogue
