// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "compare/measure/timing.hpp"

namespace handhold::compare {

/// What became of the object once its support let it go.
enum class Hold { held, slipped, dropped, never_touched };

[[nodiscard]] std::string_view to_string(Hold hold);

/// What a recording of a hand with an object says, in numbers a person asks for.
struct GraspSummary {
  std::string engine{};
  int touches{}, breakaways{}, resticks{}, releases{};  ///< events of samples
  int phalanges_in_contact{};                           ///< most at one time
  double slip_distance{};  ///< longest path of one sample's anchor on the object, in contact [m]
  double max_depth{};      ///< of any sample [m]
  double drift{};          ///< of the object in the first hand's palm, from when hands alone hold it to the end [m]
  Hold hold{Hold::never_touched};
  std::optional<double> dropped_at{};  ///< when contact was lost for good [s]
  FrameTimes frame{};
  double carried{};             ///< time in the hand alone: from the support's end to the drop, or to the end [s]
  double energy_unexplained{};  ///< largest |energy book residual| [J]
};

/// `held`: at the end in contact and drifted less than 2 mm plus the elastic lag m g / (k n); `slipped`: in contact but
/// drifted more; `dropped`: out of contact at the end. Drift is 0 while a support still holds the object.
[[nodiscard]] GraspSummary summarize(const Scene& scene, const Recording& recording);

/// How far two recordings of the same scene are apart, at the frames they share up to a time; all NaN if they share
/// none.
struct Difference {
  double max_translation{}, rms_translation{};  ///< of the body's origin [m]
  double max_rotation{};                        ///< [rad]
  double mode_agreement{};    ///< share of (frame, sample) pairs in the same mode, of those present in both
  double first_divergence{};  ///< first time translation differs by more than 1 mm [s]; NaN: never
};

[[nodiscard]] Difference difference(const Recording& a, const Recording& b,
                                    double until = std::numeric_limits<double>::infinity());

}  // namespace handhold::compare
