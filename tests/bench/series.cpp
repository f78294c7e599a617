// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/series.hpp"

#include <algorithm>

namespace handhold::bench {

void Series::add(const std::vector<double>& seconds) {
  medians_.push_back(compare::frame_times(seconds).p50);
  if (least_.empty()) least_ = seconds;
  const std::size_t count = std::min(least_.size(), seconds.size());
  for (std::size_t i = 0; i < count; ++i) least_[i] = std::min(least_[i], seconds[i]);
}

double Series::median() const {
  if (medians_.empty()) return std::numeric_limits<double>::quiet_NaN();
  return *std::min_element(medians_.begin(), medians_.end());
}

}  // namespace handhold::bench
