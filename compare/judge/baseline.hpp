// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

// Accuracy regression: what every gate measured when somebody last looked, and what has moved since. A baseline is a
// regression value and never truth: truth decides which way a value moved, and the gate whether it still holds.

namespace handhold::compare {

/// A gate by name. `order`: of the study of the order of accuracy, not of the claim's value.
struct GateName {
  std::string of_case{}, run{}, claim{}, engine{};
  bool order{};

  [[nodiscard]] friend auto operator<=>(const GateName&, const GateName&) = default;
};

/// What a gate measured, in the unit of its claim; of a study of the order, what it differs by from the order that is
/// asked, whose truth is 0.
struct Measured {
  double truth{};
  double value{std::numeric_limits<double>::quiet_NaN()};  ///< NaN: nothing was measured
  double limit{};                                          ///< of the error
  bool relative{};                                         ///< error and limit are fractions of the truth
  double uncertainty{};                                    ///< of the value: the standard error of an order, else 0
};

using Baseline = std::map<GateName, Measured>;

enum class Movement {
  gone,         ///< a gate that the baseline knows is not there
  added,        ///< a gate that the baseline does not know
  looser,       ///< its limit lets more pass
  tighter,      ///< its limit lets less pass
  other_truth,  ///< what is taken for true is another number
  away,         ///< its value moved away from the truth
  towards,      ///< its value moved towards the truth
};

[[nodiscard]] std::string to_string(Movement movement);

struct Change {
  GateName gate{};
  Movement movement{};
  Measured before{}, now{};
};

/// The distance of the value from the truth [unit of the claim].
[[nodiscard]] double distance(const Measured& measured);

/// What differs, by the name of the gate. A value has moved when it differs by more than 1e-9 of itself or of the truth
/// and by more than 1e-5 of its limit: another compiler or processor, whose sine differs in its last bit, moves it by
/// less. Truths and limits have moved beyond 1e-9, an order beyond its standard error. If `now` has no orders at all,
/// none is missing: they were not asked for.
[[nodiscard]] std::vector<Change> changes(const Baseline& before, const Baseline& now);

/// "C01/slides, slip time, realtime: 0.310002 -> 0.31002, 10 times as far from the truth 0.31 (0.04 -> 0.4 of the
/// limit)"
[[nodiscard]] std::string sentence(const Change& change);

/// "gates: 12 moved away from the truth, 1 have a looser limit", or "nothing moved".
[[nodiscard]] std::string summary(const std::vector<Change>& changes);

}  // namespace handhold::compare
