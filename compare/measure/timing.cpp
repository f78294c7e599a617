// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/timing.hpp"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

namespace handhold::compare {

FrameTimes frame_times(std::vector<double> seconds) {
  FrameTimes times{.frames = seconds.size()};
  if (seconds.empty()) return times;
  gsl_sort(seconds.data(), 1, seconds.size());
  const auto quantile = [&](double q) {
    return gsl_stats_quantile_from_sorted_data(seconds.data(), 1, seconds.size(), q);
  };
  times.p50 = quantile(0.5);
  times.p90 = quantile(0.9);
  times.p99 = quantile(0.99);
  times.p999 = quantile(0.999);
  times.max = seconds.back();
  return times;
}

}  // namespace handhold::compare
