// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/trace_builder.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {

Trace sample_trace(const std::string& name, Side side, const HandModel& model, const PoseFunction& poses, double begin,
                   double end, double rate) {
  if (!(end > begin) || !(rate > 0) || !std::isfinite(end - begin) || !std::isfinite(rate)) {
    throw InputError(
        fmt::format("trace \"{}\": begin {} s, end {} s, rate {} Hz must be finite, begin < end, rate > 0 "
                    "(give a stretch of time to sample)",
                    name, begin, end, rate));
  }
  const long intervals = std::max(1L, std::lround((end - begin) * rate));
  Trace trace{name, "built, m, z up, right-handed", {}, {{side, model, {}}}, {}};
  for (long i = 0; i <= intervals; ++i) {
    // Not begin + i / rate: both ends are hit exactly, and no rounding adds up.
    const double t = begin + (end - begin) * (double(i) / double(intervals));
    trace.t.push_back(t);
    trace.hands[0].samples.push_back({poses(t), 1.0, true});
  }
  validate(trace);
  return trace;
}

}  // namespace handhold
