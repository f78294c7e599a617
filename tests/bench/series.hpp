// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "compare/measure/timing.hpp"

namespace handhold::bench {

/// One engine on one scene, played several times over.
///
/// Every play does the same work (all engines repeat to the last bit), so whatever a frame took beyond its least time
/// over the plays was somebody else's: percentiles are those of the frames' least times, and what is compared between
/// engines is the least median of a play.
class Series {
 public:
  Series(std::string of_scene, std::string of_engine, std::string its_setting)
      : scene(std::move(of_scene)), engine(std::move(of_engine)), setting(std::move(its_setting)) {}

  void add(const std::vector<double>& seconds);

  [[nodiscard]] double median() const;  ///< least of the plays' medians [s]; NaN if there is none
  [[nodiscard]] compare::FrameTimes times() const { return compare::frame_times(least_); }
  [[nodiscard]] const std::vector<double>& medians() const { return medians_; }

  std::string scene, engine, setting;
  std::string failure{};  ///< why there are no times
  std::string verdict{};  ///< of the play whose poses were looked at: "held", "lost", ...

 private:
  std::vector<double> least_, medians_;
};

}  // namespace handhold::bench
