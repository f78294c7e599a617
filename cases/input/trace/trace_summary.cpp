// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/trace_summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

namespace handhold {
namespace {

using Eigen::Vector3d;

constexpr double shortest_phase = 0.1;  // a pinch or fist shorter than this is a flicker [s]

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void summarize_time(const Trace& trace, TraceSummary& summary) {
  summary.frames = trace.t.size();
  if (trace.t.size() < 2) return;
  summary.duration = trace.t.back() - trace.t.front();
  std::vector<double> ticks;
  for (std::size_t i = 1; i < trace.t.size(); ++i) ticks.push_back(trace.t[i] - trace.t[i - 1]);
  summary.tick = quantile(ticks, 0.5);
  double squares = 0;
  std::size_t regular = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (ticks[i] > 1.5 * summary.tick) {
      summary.gaps.push_back({trace.t[i], trace.t[i + 1]});
      continue;
    }
    squares += std::pow(ticks[i] - summary.tick, 2);
    ++regular;
  }
  summary.jitter = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(regular, 1)));
}

/// Stretches of tracked samples for which `holds`, at least `shortest` long.
std::vector<Interval> phases(const Trace& trace, const TraceHand& hand, double shortest,
                             const std::function<bool(const HandSample&)>& holds) {
  std::vector<Interval> found;
  std::optional<Interval> open;
  const auto close = [&] {
    if (open && open->end - open->begin >= shortest) found.push_back(*open);
    open.reset();
  };
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    if (!hand.samples[i].tracked || !holds(hand.samples[i])) {
      close();
      continue;
    }
    if (!open) open = Interval{trace.t[i], trace.t[i]};
    open->end = trace.t[i];
  }
  close();
  return found;
}

std::vector<Interval> losses(const Trace& trace, const TraceHand& hand) {
  std::vector<Interval> lost;
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    if (hand.samples[i].tracked) continue;
    std::size_t end = i;
    while (end + 1 < trace.t.size() && !hand.samples[end].tracked) ++end;
    lost.push_back({trace.t[i > 0 ? i - 1 : 0], trace.t[end]});
    i = end;
  }
  return lost;
}

Vector3d axis_end(const HandModel& model, const HandSample& sample, int phalanx) {
  const auto i = static_cast<std::size_t>(phalanx);
  return sample.X_WP[i] * Vector3d(0, 0, model.capsules[i].half_length);
}

double pinch_distance(const HandModel& model, const HandSample& sample) {
  return (axis_end(model, sample, 2) - axis_end(model, sample, 5)).norm();
}

/// Angle between the palm's axis and a fingertip's, summed over the three joints by way of the middle bone [rad].
double bend(const HandSample& sample, int finger) {
  const auto z = [&sample](int phalanx) -> Vector3d {
    return sample.X_WP[static_cast<std::size_t>(phalanx)].R * Vector3d::UnitZ();
  };
  const auto angle = [](const Vector3d& a, const Vector3d& b) { return std::acos(std::clamp(a.dot(b), -1.0, 1.0)); };
  const int first = 3 * finger;
  return angle(z(palm), z(first)) + angle(z(first), z(first + 1)) + angle(z(first + 1), z(first + 2));
}

bool is_fist(const HandSample& sample) {
  constexpr double enough = 150 * 3.14159265358979323846 / 180;
  for (int finger = 1; finger < 5; ++finger) {
    if (bend(sample, finger) < enough) return false;
  }
  return true;
}

void summarize_palm(const Trace& trace, const TraceHand& hand, HandSummary& summary) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < trace.t.size(); ++i) {
    if (!hand.samples[i].tracked) continue;
    if (last) {
      const double step = (hand.samples[i].X_WP[palm].p - hand.samples[*last].X_WP[palm].p).norm();
      summary.palm_step = std::max(summary.palm_step, step);
      summary.palm_speed = std::max(summary.palm_speed, step / (trace.t[i] - trace.t[*last]));
    }
    last = i;
  }
}

/// Residual of a quadratic fit through nine equally spaced samples at its middle (Savitzky & Golay 1964, 9/2), scaled
/// so that white noise shows its own standard deviation. Only windows without gap, and of these the slowest quarter.
double palm_noise(const Trace& trace, const TraceHand& hand, double tick) {
  constexpr std::array<double, 9> weights{-21, 14, 39, 54, 59, 54, 39, 14, -21};
  constexpr double sum = 231;
  struct Window {
    double speed, residual;
  };
  std::vector<Window> windows;
  for (std::size_t i = 4; i + 4 < trace.t.size(); ++i) {
    bool whole = true;
    Vector3d smooth = Vector3d::Zero();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const std::size_t j = i + k - 4;
      whole = whole && hand.samples[j].tracked && (k == 0 || trace.t[j] - trace.t[j - 1] < 1.5 * tick);
      smooth += weights[k] / sum * hand.samples[j].X_WP[palm].p;
    }
    if (!whole) continue;
    const double way = (hand.samples[i + 4].X_WP[palm].p - hand.samples[i - 4].X_WP[palm].p).norm();
    windows.push_back({way, (hand.samples[i].X_WP[palm].p - smooth).squaredNorm() / 3});
  }
  std::sort(windows.begin(), windows.end(), [](const Window& a, const Window& b) { return a.speed < b.speed; });
  windows.resize((windows.size() + 3) / 4);
  if (windows.empty()) return 0;
  double mean = 0;
  for (const Window& w : windows) mean += w.residual / static_cast<double>(windows.size());
  return std::sqrt(mean / (1 - 59 / sum));
}

HandSummary summarize_hand(const Trace& trace, const TraceHand& hand, double tick) {
  HandSummary summary;
  summary.side = hand.side;
  for (std::size_t i = 0; i < 15; ++i) summary.bones[i] = 2 * hand.model.capsules[i].half_length;
  std::size_t tracked = 0;
  for (std::size_t i = 0; i < hand.samples.size(); ++i) {
    const HandSample& sample = hand.samples[i];
    if (!sample.tracked) continue;
    const double pinch = pinch_distance(hand.model, sample);
    const bool first = tracked++ == 0;
    summary.least_confidence = first ? sample.confidence : std::min(summary.least_confidence, sample.confidence);
    summary.most_confidence = first ? sample.confidence : std::max(summary.most_confidence, sample.confidence);
    summary.pinch_most = std::max(summary.pinch_most, pinch);
    if (first || pinch < summary.pinch_least) summary.pinch_least = pinch, summary.pinch_least_at = trace.t[i];
  }
  if (!trace.t.empty()) summary.tracked = static_cast<double>(tracked) / static_cast<double>(trace.t.size());
  const double touching = hand.model.capsules[2].radius + hand.model.capsules[5].radius + 0.005;
  const auto is_pinch = [&](const HandSample& s) { return pinch_distance(hand.model, s) < touching; };
  summary.pinched = phases(trace, hand, shortest_phase, is_pinch);
  summary.fist = phases(trace, hand, shortest_phase, is_fist);
  summary.lost = losses(trace, hand);
  summarize_palm(trace, hand, summary);
  summary.palm_noise = palm_noise(trace, hand, tick);
  return summary;
}

std::string to_text(const std::vector<Interval>& intervals) {
  constexpr std::size_t most = 8;
  std::string text = fmt::format("{}", intervals.size());
  for (std::size_t i = 0; i < std::min(most, intervals.size()); ++i) {
    text += fmt::format("{}{:.3f} to {:.3f} s", i == 0 ? ": " : ", ", intervals[i].begin, intervals[i].end);
  }
  return intervals.size() > most ? text + ", ..." : text;
}

std::string to_text(const HandSummary& hand) {
  std::string text = fmt::format("{} hand: tracked {:.1f} %, confidence {:.2f} to {:.2f}\n", to_string(hand.side),
                                 100 * hand.tracked, hand.least_confidence, hand.most_confidence);
  text += fmt::format("  lost           {}\n", to_text(hand.lost));
  constexpr std::array<const char*, 5> fingers{"thumb", "index", "middle", "ring", "little"};
  for (std::size_t f = 0; f < fingers.size(); ++f) {
    text += fmt::format("  {:<6} segments {:6.2f} {:6.2f} {:6.2f} mm\n", fingers[f], 1e3 * hand.bones[3 * f],
                        1e3 * hand.bones[3 * f + 1], 1e3 * hand.bones[3 * f + 2]);
  }
  text += fmt::format("  palm           fastest {:.3f} m/s, largest step {:.1f} mm, noise {:.1f} µm rms\n",
                      hand.palm_speed, 1e3 * hand.palm_step, 1e6 * hand.palm_noise);
  text += fmt::format("  thumb-index    {:.1f} to {:.1f} mm, closest at {:.3f} s\n", 1e3 * hand.pinch_least,
                      1e3 * hand.pinch_most, hand.pinch_least_at);
  text += fmt::format("  pinched        {}\n", to_text(hand.pinched));
  return text + fmt::format("  fist           {}\n", to_text(hand.fist));
}

}  // namespace

TraceSummary summarize(const Trace& trace) {
  validate(trace);
  TraceSummary summary;
  summary.name = trace.name;
  summary.source_frame = trace.source_frame;
  summary.warnings = trace.warnings;
  summarize_time(trace, summary);
  for (const TraceHand& hand : trace.hands) summary.hands.push_back(summarize_hand(trace, hand, summary.tick));
  return summary;
}

std::string to_text(const TraceSummary& summary) {
  std::string text = fmt::format("{} ({})\n", summary.name, summary.source_frame);
  const double rate = summary.tick > 0 ? 1 / summary.tick : 0;
  text += fmt::format("{} frames, {:.3f} s, {:.1f} Hz, jitter {:.3f} ms rms\n", summary.frames, summary.duration, rate,
                      1e3 * summary.jitter);
  text += fmt::format("gaps           {}\n", to_text(summary.gaps));
  for (const HandSummary& hand : summary.hands) text += to_text(hand);
  for (const std::string& warning : summary.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

}  // namespace handhold
