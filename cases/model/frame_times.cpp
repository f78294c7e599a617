// SPDX-License-Identifier: Apache-2.0
#include "cases/model/frame_times.hpp"

#include <algorithm>
#include <cmath>

#include "cases/model/input_error.hpp"
#include "cases/model/text.hpp"

namespace handhold {
namespace {

constexpr double sliver = 1e-9;    // [s]
constexpr double shortest = 1e-6;  // [s]

}  // namespace

std::vector<double> regular_frames(double duration, double rate) {
  std::vector<double> times;
  for (long k = 1; times.empty() || times.back() < duration; ++k) {
    const double t = double(k) / rate;
    times.push_back(t > duration - sliver ? duration : t);
  }
  return times;
}

std::vector<double> trace_frames(const Scene& scene) {
  std::vector<double> seen;
  for (const Hand& hand : scene.hands) {
    const std::vector<double> times = hand.motion->seen();
    seen.insert(seen.end(), times.begin(), times.end());
  }
  std::sort(seen.begin(), seen.end());
  std::vector<double> times;
  double last = 0;
  for (const double t : seen) {
    if (t - last < shortest || t > scene.duration - shortest) continue;
    times.push_back(last = t);
  }
  times.push_back(scene.duration);
  return times;
}

void validate_frames(const std::vector<double>& times, double duration) {
  double last = 0;
  for (const double t : times) {
    if (!(t > last)) throw InputError(sentence("frame at ", t, " s after ", last, " s: times must ascend (sort them)"));
    last = t;
  }
  if (!(last == duration))
    throw InputError(sentence("last frame at ", last, " s: must be at the end, ", duration, " s (add it)"));
}

}  // namespace handhold
