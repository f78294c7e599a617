// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <array>

#include <Simbody.h>

#include "reference/simbody_force.hpp"

namespace handhold::reference::simbody {

/// Finds the first change of mode within a step.
///
/// Simbody's own event handling asks every witness at every stage of the integrator and copies whole states while it
/// narrows a root down: half of the time of a run. Here witnesses are asked at the ends of a step only; between them
/// the state is its cubic Hermite interpolant (error h⁴/384), which serves to find a time, and the run then integrates
/// afresh up to there.
class Locator {
 public:
  Locator(const SimTK::System& system, const ContactForce& force) : system_(system), force_(force) {}

  /// The largest witness of every kind.
  using Values = std::array<double, 5>;
  [[nodiscard]] static Values values(const Evaluation& watched);

  /// A step begins at `state` (realized to Acceleration here).
  void begin(const SimTK::State& state);

  /// It ended at `state`: whether a witness has risen above zero.
  [[nodiscard]] bool rises(const SimTK::State& end);

  struct Window {
    double low{}, high{};  ///< the first rise lies between [s]
  };
  /// Narrows the rise that `rises` found down to `width` [s].
  [[nodiscard]] Window narrow(double width);

  /// Whether the rise lies within the last `width` of the step [s].
  [[nodiscard]] bool at_end(double width);

  /// Puts the state back to where the step began.
  void rewind(SimTK::State& state) const;

 private:
  struct Point {
    double t{};
    SimTK::Vector y{}, rate{};
    Values values{};
  };

  void read(const SimTK::State& state, Point& point) const;
  [[nodiscard]] double value_at(double t);

  const SimTK::System& system_;
  const ContactForce& force_;
  Point begin_{}, end_{};
  SimTK::State scratch_{};
  std::array<bool, 5> rising_{};
};

}  // namespace handhold::reference::simbody
