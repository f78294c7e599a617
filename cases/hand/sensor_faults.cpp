// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/sensor_faults.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr double two_pi = 6.28318530717958647692;

/// Deviates from the generator's bits alone: std::normal_distribution differs between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  /// In (0, 1], a multiple of 2^-53.
  double uniform() { return static_cast<double>((bits_() >> 11) + 1) * 0x1p-53; }

  /// Box & Muller 1958, the cosine alone.
  double normal() {
    const double r = std::sqrt(-2 * std::log(uniform()));
    return r * std::cos(two_pi * uniform());
  }
  Eigen::Vector3d normal3() {
    const double x = normal(), y = normal(), z = normal();
    return {x, y, z};
  }

 private:
  std::mt19937_64 bits_;
};

double rounded(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }

void disturb(Pose& X, const SensorFaults& faults, Dice& dice) {
  if (faults.position_noise > 0) X.p += faults.position_noise * dice.normal3();
  if (faults.rotation_noise > 0) {
    const Eigen::Vector3d turn = faults.rotation_noise * dice.normal3();
    const double angle = turn.norm();
    if (angle > 0) X.R = Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * X.R;
  }
  for (int i = 0; i < 3; ++i) X.p[i] = rounded(X.p[i], faults.position_step);
  for (int i = 0; i < 4; ++i) X.R.coeffs()[i] = rounded(X.R.coeffs()[i], faults.quaternion_step);
  X.R.normalize();
}

/// The frames that are neither missing nor repeated.
Trace thinned(const Trace& trace, const SensorFaults& faults, Dice& dice) {
  Trace kept{trace.name, trace.source_frame, {}, {}, trace.warnings};
  for (const TraceHand& hand : trace.hands) kept.hands.push_back({hand.side, hand.model, {}});
  std::size_t missing = 0, repeated = 0;
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    const bool inner = i > 0 && i + 1 < trace.t.size();
    const bool drop = dice.uniform() <= faults.dropout, repeat = dice.uniform() <= faults.duplicate;
    if (inner && (drop || repeat)) {
      ++(drop ? missing : repeated);
      continue;
    }
    kept.t.push_back(trace.t[i]);
    for (std::size_t h = 0; h < trace.hands.size(); ++h) kept.hands[h].samples.push_back(trace.hands[h].samples[i]);
  }
  if (missing > 0) kept.warnings.push_back(fmt::format("{} frames are missing (simulated fault)", missing));
  if (repeated > 0) {
    kept.warnings.push_back(
        fmt::format("{} frames repeat the time stamp of the one before and were dropped (simulated fault)", repeated));
  }
  return kept;
}

std::vector<Interval> all_gaps(const Trace& trace, const SensorFaults& faults, Dice& dice) {
  std::vector<Interval> gaps = faults.gaps;
  if (faults.gap_rate > 0) {
    // Waiting times of a Poisson process.
    for (double t = trace.t.front(); (t -= std::log(dice.uniform()) / faults.gap_rate) < trace.t.back();) {
      gaps.push_back({t, t + faults.gap_length});
    }
  }
  return gaps;
}

void lose(const Trace& trace, TraceHand& hand, const std::vector<Interval>& gaps, const SensorFaults& faults) {
  const auto lost = [](HandSample& sample) { sample.tracked = false, sample.confidence = 0; };
  for (std::size_t i = 1; i + 1 < trace.t.size(); ++i) {
    const double t = trace.t[i];
    const auto in = [t](const Interval& gap) { return gap.begin <= t && t <= gap.end; };
    if (std::any_of(gaps.begin(), gaps.end(), in)) lost(hand.samples[i]);
  }
  for (const double t : faults.id_changes) {
    auto i = static_cast<std::size_t>(std::lower_bound(trace.t.begin(), trace.t.end(), t) - trace.t.begin());
    const std::size_t end = i + static_cast<std::size_t>(faults.id_change_frames);
    for (i = std::max<std::size_t>(i, 1); i < end && i + 1 < trace.t.size(); ++i) lost(hand.samples[i]);
  }
}

void check(const char* name, double value, double most, const char* unit) {
  if (value >= 0 && value <= most) return;  // false for NaN
  throw InputError(fmt::format("sensor fault {} = {}: must be 0 to {}{} (0 switches it off)", name, value, most, unit));
}

}  // namespace

void validate(const SensorFaults& faults) {
  check("position_noise", faults.position_noise, 1, " m");
  check("rotation_noise", faults.rotation_noise, 3, " rad");
  check("gap_rate", faults.gap_rate, 1000, " a second");
  check("gap_length", faults.gap_length, 1e6, " s");
  check("dropout", faults.dropout, 1, "");
  check("duplicate", faults.duplicate, 1, "");
  check("id_change_frames", faults.id_change_frames, 1e6, "");
  check("position_step", faults.position_step, 1, " m");
  check("quaternion_step", faults.quaternion_step, 0.1, "");
  for (const Interval& gap : faults.gaps) {
    if (!(gap.begin <= gap.end)) {
      throw InputError(
          fmt::format("sensor fault gap {} to {} s: must end after it begins (swap them)", gap.begin, gap.end));
    }
  }
}

Trace with_faults(const Trace& trace, const SensorFaults& faults, std::uint64_t seed) {
  validate(trace);
  validate(faults);
  if (trace.t.empty()) return trace;
  Dice dice(seed);
  Trace out = thinned(trace, faults, dice);
  for (TraceHand& hand : out.hands) {
    lose(out, hand, all_gaps(out, faults, dice), faults);
    for (HandSample& sample : hand.samples) {
      if (!sample.tracked) continue;
      for (Pose& X_WP : sample.X_WP) disturb(X_WP, faults, dice);
    }
  }
  return out;
}

}  // namespace handhold
