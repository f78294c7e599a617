// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/trace_glitches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr std::size_t longest = 3;         // frames: what stays longer is a motion, or another tracking
constexpr std::size_t around = 10;         // frames on either side that say what is usual
constexpr std::size_t least_around = 4;    // fewer say nothing
constexpr double outlier = 8;              // times what is usual
constexpr double least_acceleration = 50;  // [m/s²]: a quick tap, seen by a slow camera, needs less
constexpr double chord_share = 0.25;       // of the hand's own motion, which bends the line
constexpr double resolution = 1e-3;        // of trackers [m]
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double median_tick(const std::vector<double>& t) {
  std::vector<double> ticks;
  for (std::size_t i = 1; i < t.size(); ++i) ticks.push_back(t[i] - t[i - 1]);
  if (ticks.empty()) return 0;
  std::nth_element(ticks.begin(), ticks.begin() + std::ptrdiff_t(ticks.size() / 2), ticks.end());
  return ticks[ticks.size() / 2];
}

/// The path of one phalanx, looked at through windows of `count` samples between two others.
class Path {
 public:
  Path(const Trace& trace, const TraceHand& hand, std::size_t phalanx, std::size_t count, double tick)
      : t_(trace.t), samples_(hand.samples), phalanx_(phalanx), count_(count), excursions_(t_.size(), nan) {
    for (std::size_t i = 1; i + count < t_.size(); ++i) {
      if (seen(i, tick)) excursions_[i] = excursion(i);
    }
  }

  /// Of samples i to i + count - 1; NaN where tracking has a gap.
  [[nodiscard]] double distance(std::size_t i) const { return excursions_[i]; }

  [[nodiscard]] bool is_outlier(std::size_t i) const {
    const double r = excursions_[i];
    const double T = t_[std::min(i + count_, t_.size() - 1)] - t_[i > 0 ? i - 1 : 0];
    if (!(r > outlier * resolution) || !(8 * r > least_acceleration * T * T)) return false;
    const double chord = (p(i + count_) - p(i - 1)).norm();
    return r > outlier * (usual(i) + chord_share * chord + resolution);
  }

 private:
  [[nodiscard]] const Vector3d& p(std::size_t i) const { return samples_[i].X_WP[phalanx_].p; }

  [[nodiscard]] bool seen(std::size_t i, double tick) const {
    for (std::size_t k = i - 1; k <= i + count_; ++k) {
      if (!samples_[k].tracked) return false;
    }
    return t_[i + count_] - t_[i - 1] < 1.5 * double(count_ + 1) * tick;
  }
  [[nodiscard]] double excursion(std::size_t i) const {
    const Vector3d &from = p(i - 1), &to = p(i + count_);
    double most = 0;
    for (std::size_t k = i; k < i + count_; ++k) {
      const double share = (t_[k] - t_[i - 1]) / (t_[i + count_] - t_[i - 1]);
      most = std::max(most, (p(k) - from - share * (to - from)).norm());
    }
    return most;
  }
  /// Median of the excursions nearby that do not share a sample with this one; infinite if there are too few.
  [[nodiscard]] double usual(std::size_t i) const {
    std::vector<double> near;
    for (std::size_t k = i > around ? i - around : 1; k <= i + around && k < excursions_.size(); ++k) {
      const std::size_t apart = k > i ? k - i : i - k;
      if (apart > count_ && !std::isnan(excursions_[k])) near.push_back(excursions_[k]);
    }
    if (near.size() < least_around) return std::numeric_limits<double>::infinity();
    std::nth_element(near.begin(), near.begin() + std::ptrdiff_t(near.size() / 2), near.end());
    return near[near.size() / 2];
  }

  const std::vector<double>& t_;
  const std::vector<HandSample>& samples_;
  std::size_t phalanx_, count_;
  std::vector<double> excursions_;
};

void find(const Trace& trace, std::size_t hand, std::size_t count, double tick, std::vector<bool>& known,
          std::vector<Glitch>& found) {
  std::map<std::size_t, Glitch> by_sample;
  for (std::size_t phalanx = 0; phalanx < phalanx_count; ++phalanx) {
    const Path path(trace, trace.hands[hand], phalanx, count, tick);
    for (std::size_t i = 1; i + count < trace.t.size(); ++i) {
      const auto begin = known.begin() + std::ptrdiff_t(i) - 1;
      if (!path.is_outlier(i) || std::count(begin, begin + std::ptrdiff_t(count) + 2, true) > 0) continue;
      Glitch& glitch = by_sample.try_emplace(i, Glitch{hand, i, count, {}, 0}).first->second;
      glitch.phalanges.set(phalanx);
      glitch.distance = std::max(glitch.distance, path.distance(i));
    }
  }
  for (const auto& [i, glitch] : by_sample) {
    found.push_back(glitch);
    for (std::size_t k = i; k < i + count; ++k) known[k] = true;
  }
}

/// Phalanges of one finger hang together, and all of them on the palm.
std::bitset<phalanx_count> with_neighbours(const std::bitset<phalanx_count>& phalanges) {
  std::bitset<phalanx_count> all = phalanges;
  if (phalanges.test(palm)) return all.set();
  for (std::size_t i = 0; i < palm; ++i) {
    if (phalanges.test(i)) all.set(i / 3 * 3).set(i / 3 * 3 + 1).set(i / 3 * 3 + 2);
  }
  return all;
}

}  // namespace

std::vector<Glitch> find_glitches(const Trace& trace) {
  std::vector<Glitch> found;
  const double tick = median_tick(trace.t);
  for (std::size_t hand = 0; hand < trace.hands.size(); ++hand) {
    std::vector<bool> known(trace.t.size() + longest);
    for (std::size_t count = 1; count <= longest; ++count) find(trace, hand, count, tick, known, found);
  }
  std::sort(found.begin(), found.end(), [](const Glitch& a, const Glitch& b) { return a.first < b.first; });
  return found;
}

void bridge(Trace& trace, const std::vector<Glitch>& glitches) {
  for (const Glitch& glitch : glitches) {
    std::vector<HandSample>& samples = trace.hands[glitch.hand].samples;
    const HandSample before = samples[glitch.first - 1], after = samples[glitch.first + glitch.count];
    const double begin = trace.t[glitch.first - 1], end = trace.t[glitch.first + glitch.count];
    const std::bitset<phalanx_count> moved = with_neighbours(glitch.phalanges);
    for (std::size_t k = glitch.first; k < glitch.first + glitch.count; ++k) {
      const double share = (trace.t[k] - begin) / (end - begin);
      for (std::size_t i = 0; i < phalanx_count; ++i) {
        if (!moved.test(i)) continue;
        const Pose &a = before.X_WP[i], &b = after.X_WP[i];
        samples[k].X_WP[i] = {a.R.slerp(share, b.R).normalized(), a.p + share * (b.p - a.p)};
      }
    }
  }
}

std::string to_text(const Trace& trace, const Glitch& glitch) {
  std::string what;
  for (std::size_t i = 0; i < phalanx_count; ++i) {
    if (glitch.phalanges.test(i)) what += (what.empty() ? "" : ", ") + std::string(phalanx_name(int(i)));
  }
  if (glitch.phalanges.count() > 8) what = "the hand";
  return fmt::format("{} hand, frame {} ({:.3f} s): {} jumps {:.0f} mm aside for {} frame{}",
                     to_string(trace.hands[glitch.hand].side), glitch.first, trace.t[glitch.first], what,
                     1e3 * glitch.distance, glitch.count, glitch.count == 1 ? "" : "s");
}

}  // namespace handhold
