// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "cases/model/hand_model.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// A stretch of time in which a hand exists.
struct Interval {
  double begin{};  ///< [s]
  double end{};    ///< [s]
};

/// One hand as a twice continuously differentiable function of time: the spline of a trace (hand/trace_spline.hpp) or a
/// motion that a formula gives (hand/prescribed_motion.hpp).
///
/// An engine evaluates it anywhere, or samples it at the frames of a tracker. Immutable, thread safe.
class HandMotion {
 public:
  virtual ~HandMotion() = default;

  [[nodiscard]] virtual const HandModel& model() const = 0;
  [[nodiscard]] virtual Side side() const = 0;

  /// Where the hand exists: ascending, disjoint.
  [[nodiscard]] virtual const std::vector<Interval>& presence() const = 0;
  [[nodiscard]] bool present(double t) const {
    const auto holds = [t](const Interval& i) { return i.begin <= t && t <= i.end; };
    return std::any_of(presence().begin(), presence().end(), holds);
  }

  /// When the hand was seen: where its third derivative may jump, ascending [s]. Empty for a formula.
  [[nodiscard]] virtual std::vector<double> seen() const = 0;

  /// Pose and twist of a phalanx in W; `t` is clamped to the nearest interval of presence (twist zero outside).
  [[nodiscard]] virtual Pose pose(int phalanx, double t) const = 0;
  [[nodiscard]] virtual Twist twist(int phalanx, double t) const = 0;

 protected:
  HandMotion() = default;
  HandMotion(const HandMotion&) = default;
  HandMotion& operator=(const HandMotion&) = default;
};

}  // namespace handhold
