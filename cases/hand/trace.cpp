// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/trace.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr double unit_tolerance = 1e-6;  // single precision in a file leaves 1e-7
constexpr double latest = 1e11;          // [s]: clocks count 1.8e9 since 1970; more is a wrong unit
constexpr double farthest = 1e6;         // from the origin [m]: beyond it nothing is left of a millimetre in a float

std::string where(const Trace& trace) { return fmt::format("trace \"{}\"", trace.name); }

void check_time(const Trace& trace) {
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    if (!std::isfinite(trace.t[i])) {
      throw InputError(fmt::format("{}: time stamp {} is not finite (drop the frame)", where(trace), i));
    }
    if (std::abs(trace.t[i]) > latest) {
      throw InputError(
          fmt::format("{}: time stamp {} is {:g} s (check the unit of time)", where(trace), i, trace.t[i]));
    }
    if (i > 0 && trace.t[i] <= trace.t[i - 1]) {
      throw InputError(
          fmt::format("{}: time stamp {} is {:.9g} s after {:.9g} s, but time must increase (sort or drop it)",
                      where(trace), i, trace.t[i], trace.t[i - 1]));
    }
  }
}

void check_confidence(const Trace& trace, double confidence, std::size_t hand, std::size_t sample) {
  if (confidence >= 0 && confidence <= 1) return;  // false for NaN
  throw InputError(fmt::format("{}: hand {}, sample {}: confidence {} must be 0 to 1 (scale it, or give 1)",
                               where(trace), hand, sample, confidence));
}

void check_pose(const Trace& trace, const Pose& X_WP, std::size_t hand, std::size_t sample, int phalanx) {
  const double norm = X_WP.R.norm();
  if (X_WP.p.allFinite() && X_WP.p.cwiseAbs().maxCoeff() > farthest) {
    throw InputError(
        fmt::format("{}: hand {}, sample {}, {} lies farther than {:.0f} m from the origin (check the unit)",
                    where(trace), hand, sample, phalanx_name(phalanx), farthest));
  }
  if (X_WP.p.allFinite() && std::isfinite(norm) && std::abs(norm - 1) <= unit_tolerance) return;
  throw InputError(
      fmt::format("{}: hand {}, sample {}, {} has a pose that is not finite or a quaternion of norm {:.9g} "
                  "(mark the sample lost, or normalise)",
                  where(trace), hand, sample, phalanx_name(phalanx), norm));
}

}  // namespace

void validate(const Trace& trace) {
  check_time(trace);
  for (std::size_t h = 0; h < trace.hands.size(); ++h) {
    const std::vector<HandSample>& samples = trace.hands[h].samples;
    if (samples.size() != trace.t.size()) {
      throw InputError(fmt::format("{}: hand {} has {} samples for {} time stamps (one each, lost ones included)",
                                   where(trace), h, samples.size(), trace.t.size()));
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!samples[i].tracked) continue;
      check_confidence(trace, samples[i].confidence, h, i);
      for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
        check_pose(trace, samples[i].X_WP[static_cast<std::size_t>(phalanx)], h, i, phalanx);
      }
    }
  }
}

}  // namespace handhold
