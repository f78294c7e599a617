// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/model/hand_motion.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

struct TraceSplineOptions {
  double longest_bridge{
      0.1};  ///< lost tracking up to this long is bridged by the interpolant [s]; longer: the hand is absent
};

/// One hand of a trace as a C2 function of time: cubic splines of positions and of (sign-continuous, renormalised)
/// quaternion components, natural at the ends of every interval of presence.
///
/// Immutable, thread safe.
class TraceSpline final : public HandMotion {
 public:
  TraceSpline(const Trace& trace, std::size_t hand, const TraceSplineOptions& options = {});

  [[nodiscard]] const HandModel& model() const override { return model_; }
  [[nodiscard]] Side side() const override;

  /// Where the hand exists: ascending, disjoint; at least two tracked samples each.
  [[nodiscard]] const std::vector<Interval>& presence() const override;
  /// Bridged gaps, as information for reports.
  [[nodiscard]] const std::vector<Interval>& bridged() const;

  /// When the trace saw the hand: the knots of the splines, ascending [s].
  [[nodiscard]] std::vector<double> seen() const override;

  /// Pose and twist of a phalanx in W; `t` is clamped to the nearest interval of presence (twist zero outside).
  [[nodiscard]] Pose pose(int phalanx, double t) const override;
  [[nodiscard]] Twist twist(int phalanx, double t) const override;

 private:
  struct Splines;
  HandModel model_;
  std::shared_ptr<const Splines> splines_;
};

}  // namespace handhold
