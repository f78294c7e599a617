// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/frames_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace handhold::compare {
namespace {

using catalogue::Measure;
using Kind = Measure::Kind;
using Frames = std::span<const Frame>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// From the frame at `from` (or at `at`) to the one at `at`; empty if one of them is not there.
Frames window(const Recording& recording, const Measure& what) {
  const auto frame_at = [&](double t) {
    return std::ranges::find_if(recording.frames, [=](const Frame& f) { return std::abs(f.t - t) < 1e-12; });
  };
  const double end = what.at.value_or(nan);
  const auto first = frame_at(what.from.value_or(end)), last = frame_at(end);
  if (last == recording.frames.end() || first > last) return {};
  return {first, last + 1};
}

/// Sum of a value over the chosen contacts of body 0.
template <class Value>
double sum(const Frame& frame, const Measure& what, const Value& value) {
  double total = 0;
  for (const ContactState& c : frame.contacts) {
    const bool chosen = c.id.body == 0 && (what.phalanx < 0 || c.id.phalanx == what.phalanx) &&
                        (what.sample < 0 || c.id.sample == what.sample) && (!what.mode || c.mode == *what.mode);
    if (chosen) total += value(c);
  }
  return total;
}

template <class Value>
double sum(Frames frames, const Measure& what, const Value& value) {
  double total = 0;
  for (const Frame& frame : frames) total += sum(frame, what, value);
  return total;
}

double count(Frames frames, const Measure& what) {
  return sum(frames, what, [](const ContactState&) { return 1.0; });
}

/// Trapezoidal rule: exact where force and way are linear between frames.
double work(Frames frames, const Measure& what) {
  double total = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto& before = frames[i - 1].contacts;
    total -= sum(frames[i], what, [&](const ContactState& c) {
      const auto was = std::ranges::find(before, c.id, &ContactState::id);
      return was == before.end() ? 0.0 : (c.p_W - was->p_W).dot(c.f_W + was->f_W) / 2;
    });
  }
  return total;
}

double growth(Frames frames, const Measure& what) {
  if (frames.size() < 4) return nan;
  const auto x = [&](std::size_t n) { return what.axis.dot(frames[n].bodies.front().X_WO.p); };
  const auto area = [&](std::size_t n) { return x(n + 1) * x(n + 1) - x(n) * x(n + 2); };
  const std::size_t last = frames.size() - 3;
  return std::pow(area(last) / area(0), 1 / (2 * double(last)));
}

}  // namespace

double frames_measure(const Recording& recording, const Measure& what) {
  const Frames frames = window(recording, what);
  if (frames.empty()) return nan;
  switch (what.kind) {
    case Kind::force_sum:
      return sum(frames, what, [&](const ContactState& c) { return what.axis.dot(c.f_W); });
    case Kind::mode_count:
      return count(frames, what);
    case Kind::lag:
      return sum(frames, what, [&](const ContactState& c) { return what.axis.dot(c.p_W - c.C_W); }) /
             count(frames, what);
    case Kind::work:
      return work(frames, what);
    case Kind::growth:
      return growth(frames, what);
    default:
      return nan;
  }
}

}  // namespace handhold::compare
