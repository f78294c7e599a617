#pragma once

#include <memory>
#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// A stretch of time in which a hand exists.
struct Interval {
  double begin{};  ///< [s]
  double end{};    ///< [s]
};

struct HandMotionOptions {
  double longest_bridge{
      0.1};  ///< lost tracking up to this long is bridged by the interpolant [s]; longer: the hand is absent
};

/// One hand of a trace as a C2 function of time: cubic splines of positions and of (sign-continuous, renormalised)
/// quaternion components, natural at the ends of every interval of presence.
///
/// The reference evaluates it anywhere; the real-time path only samples it at its frames. Immutable, thread safe.
class HandMotion {
 public:
  HandMotion(const Trace& trace, std::size_t hand, const HandMotionOptions& options = {});

  [[nodiscard]] const HandModel& model() const { return model_; }  // inline: the real-time path links no splines
  [[nodiscard]] Side side() const;

  /// Where the hand exists: ascending, disjoint; at least two tracked samples each.
  [[nodiscard]] const std::vector<Interval>& presence() const;
  [[nodiscard]] bool present(double t) const;
  /// Bridged gaps, as information for reports.
  [[nodiscard]] const std::vector<Interval>& bridged() const;

  /// When the trace saw the hand: the knots of the splines, ascending [s].
  [[nodiscard]] std::vector<double> seen() const;

  /// Pose and twist of a phalanx in W; `t` is clamped to the nearest interval of presence (twist zero outside).
  [[nodiscard]] Pose pose(int phalanx, double t) const;
  [[nodiscard]] Twist twist(int phalanx, double t) const;

 private:
  struct Splines;
  HandModel model_;
  std::shared_ptr<const Splines> splines_;
};

}  // namespace handhold
