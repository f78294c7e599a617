// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/trace_doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace handhold {
namespace {

using Eigen::Vector3d;

/// A ratio to the mean adult that no hand has, whole or in one part.
struct Limits {
  double least, most;
};
constexpr Limits size_limits{0.4, 1.8};    // a child of two has half an adult's hand, a giant 1.4 times
constexpr Limits bone_limits{0.35, 2.5};   // of one bone against the others; trackers' own models stretch them
constexpr Limits wrist_limits{0.45, 1.9};  // trackers differ by a carpus in where the wrist is; the elbow is at 4
constexpr Limits radius_limits{0.35, 2.0};
constexpr double meaningless = 5;        // nearer to a unit error of 10 than to a hand
constexpr Limits rate_limits{10, 1000};  // of cameras [Hz]
constexpr std::size_t least_stamps = 5;  // fewer have no rate
constexpr double backwards = -0.4;       // [rad] that the two outer joints of fingers do not bend back
constexpr double fastest_step = 5;       // [m/s] between two frames that ought not to be ...
constexpr double step_outlier = 16;      // ... so many times what is usual around it, twice the most in recordings
constexpr std::size_t around = 10;       // frames on either side

struct Unit {
  double factor;  // how many times too large its numbers are when read as metres (seconds)
  std::string_view name;
};
constexpr std::array<Unit, 9> lengths{Unit{1000, "millimetres"},
                                      Unit{100, "centimetres"},
                                      Unit{39.37, "inches"},
                                      Unit{10, "decimetres"},
                                      Unit{3.28, "feet"},
                                      Unit{0.001, ""},
                                      Unit{0.01, ""},
                                      Unit{0.0254, ""},
                                      Unit{0.1, ""}};
constexpr std::array<Unit, 5> times{Unit{1e3, "milliseconds"}, Unit{1e6, "microseconds"}, Unit{1e9, "nanoseconds"},
                                    Unit{1e-3, ""}, Unit{1e-6, ""}};

bool outside(double ratio, const Limits& limits) { return !(ratio >= limits.least && ratio <= limits.most); }

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// `what` of every tracked sample.
std::vector<double> over(const TraceHand& hand, const std::function<double(const HandSample&)>& what) {
  std::vector<double> values;
  for (const HandSample& sample : hand.samples) {
    if (sample.tracked) values.push_back(what(sample));
  }
  return values;
}

/// Of the four fingers without their tips, whose skin formats measure differently.
double finger_length(const HandModel& model) {
  double sum = 0;
  for (std::size_t i = 3; i < model.capsules.size(); ++i) sum += i % 3 == 2 ? 0 : 2 * model.capsules[i].half_length;
  return sum;
}

double size_ratio(const HandModel& model) { return finger_length(model) / finger_length(anatomical_hand()); }

std::string named(const TraceHand& hand) { return fmt::format("{} hand", to_string(hand.side)); }

std::string rescale(const char* option, double factor) {
  return fmt::format("correct the unit that the file states, or: handhold trace convert FILE OUT.csv {} {:.4g}", option,
                     1 / factor);
}

template <std::size_t count>
const Unit& nearest(const std::array<Unit, count>& units, double factor) {
  const auto off = [factor](const Unit& u) { return std::abs(std::log(u.factor / factor)); };
  return *std::min_element(units.begin(), units.end(), [&](const Unit& a, const Unit& b) { return off(a) < off(b); });
}

void doubt_size(const TraceHand& hand, std::vector<Doubt>& found) {
  const double ratio = size_ratio(hand.model);
  if (!outside(ratio, size_limits)) return;
  const Unit& unit = nearest(lengths, ratio);
  const std::string guess = unit.name.empty() ? "" : fmt::format(", as if {} were read as metres", unit.name);
  const double mean = finger_length(hand.model) / 8;
  found.push_back({fmt::format("{}: finger bones are {:.4g} m long on average, {:.3g} times an adult's{}", named(hand),
                               mean, ratio, guess),
                   rescale("--scale", unit.factor), ratio > meaningless || ratio < 1 / meaningless});
}

/// A joint in another's place makes some of them long.
void doubt_bones(const TraceHand& hand, std::vector<Doubt>& found) {
  std::string wrong;
  for (const int i : odd_bones(hand.model)) {
    wrong += fmt::format("{}{} {:.0f} mm", wrong.empty() ? "" : ", ", phalanx_name(i),
                         2e3 * hand.model.capsules[std::size_t(i)].half_length);
  }
  if (wrong.empty()) return;
  found.push_back({fmt::format("{}: bones do not chain as in a hand: {}", named(hand), wrong),
                   "check the order of the joints, or name each", false});
}

void doubt_wrist(const TraceHand& hand, double size, std::vector<Doubt>& found) {
  const double length = hand.model.palm_box.half_extents.z();
  if (!outside(length / anatomical_hand(size).palm_box.half_extents.z(), wrist_limits)) return;
  found.push_back({fmt::format("{}: the wrist lies {:.0f} mm from the knuckles, as far as the elbow or the "
                               "forearm's end",
                               named(hand), 2e3 * length),
                   "give the joint of the wrist", false});
}

void doubt_radii(const TraceHand& hand, double size, std::vector<Doubt>& found) {
  const HandModel mean = anatomical_hand(size);
  std::size_t worst = 0;
  const auto off = [&](std::size_t i) {
    return std::abs(std::log(hand.model.capsules[i].radius / mean.capsules[i].radius));
  };
  for (std::size_t i = 1; i < mean.capsules.size(); ++i) worst = off(i) > off(worst) ? i : worst;
  const double radius = hand.model.capsules[worst].radius, ratio = radius / mean.capsules[worst].radius;
  if (!outside(ratio, radius_limits)) return;
  const auto same = [&](const Capsule& c) { return std::abs(c.radius - radius) < 1e-3 * radius; };
  const bool all = std::all_of(hand.model.capsules.begin(), hand.model.capsules.end(), same);
  found.push_back({fmt::format("{}: {} has a radius of {:.4g} mm, {:.3g} times that of a hand this size", named(hand),
                               all ? "every bone" : phalanx_name(int(worst)), 1e3 * radius, ratio),
                   "correct the radii, or leave them out: the size of the hand then gives them",
                   ratio > meaningless || ratio < 1 / meaningless});
}

/// Cosine between a bone's own axis and the line to the next bone of its finger.
double alignment(const HandSample& sample) {
  double sum = 0;
  for (std::size_t i = 3; i < palm; ++i) {
    if (i % 3 == 2) continue;
    const Vector3d along = sample.X_WP[i + 1].p - sample.X_WP[i].p;
    sum += along.norm() > 0 ? along.normalized().dot(sample.X_WP[i].R * Vector3d::UnitZ()) / 8 : 0;
  }
  return sum;
}

void doubt_axes(const TraceHand& hand, std::vector<Doubt>& found) {
  constexpr double least = 0.3;  // two bones at a right angle have 0.7
  const double cosine = median(over(hand, alignment));
  if (!(cosine < least)) return;
  found.push_back(
      {fmt::format("{}: the bones' axes do not point along the fingers (mean cosine {:.2f})", named(hand), cosine),
       "check the order of quaternions, here w, x, y, z, and that z points to the fingertip", false});
}

/// Angle by which the outer two joints of the fingers bend towards the palm, mean of the four [rad].
double flexion(const HandSample& sample) {
  const Vector3d hinge = sample.X_WP[palm].R * Vector3d::UnitX();
  double sum = 0;
  for (std::size_t finger = 1; finger < 5; ++finger) {
    for (std::size_t bone = 3 * finger; bone < 3 * finger + 2; ++bone) {
      const Vector3d a = sample.X_WP[bone].R * Vector3d::UnitZ(), b = sample.X_WP[bone + 1].R * Vector3d::UnitZ();
      sum += std::atan2(a.cross(b).dot(hinge), a.dot(b)) / 4;
    }
  }
  return sum;
}

/// Positive where the index knuckle lies on the side of the palm that it has in such a hand [m].
double thumb_side(const TraceHand& hand, const HandSample& sample) {
  const Vector3d across = sample.X_WP[3].p - sample.X_WP[12].p;
  return (hand.side == Side::right ? 1 : -1) * across.dot(sample.X_WP[palm].R * Vector3d::UnitX());
}

void doubt_side(const TraceHand& hand, std::vector<Doubt>& found) {
  std::vector<double> bend = over(hand, flexion);
  if (bend.empty()) return;
  std::sort(bend.begin(), bend.end());
  const double least = bend[bend.size() / 10], most = bend[bend.size() - 1 - bend.size() / 10];
  const bool bent_back = least < backwards && most < -backwards / 2;
  const double across = median(over(hand, [&](const HandSample& s) { return thumb_side(hand, s); }));
  const bool swapped = across < -0.01;  // [m]: knuckles of index and little finger are 60 mm apart
  if (!bent_back && !swapped) return;
  const std::string what = bent_back ? fmt::format("its fingers bend to the back of the hand, by {:.0f} degrees",
                                                   -least * 180 / 3.14159265358979323846)
                                     : "its thumb is on the side of the other hand's";
  found.push_back({fmt::format("{}: {}", named(hand), what),
                   "name the other side, or state left-handed coordinates: \"handedness\": \"left\" in JSON, with "
                   "\"up\": \"-y\" if y points down, # handedness left in CSV",
                   false});
}

void doubt_rate(const Trace& trace, std::vector<Doubt>& found) {
  if (trace.t.size() < least_stamps) return;
  std::vector<double> ticks;
  for (std::size_t i = 1; i < trace.t.size(); ++i) ticks.push_back(trace.t[i] - trace.t[i - 1]);
  const double rate = 1 / median(ticks);
  if (!outside(rate, rate_limits)) return;
  Doubt doubt{fmt::format("{:.4g} frames a second, where trackers take {:g} to {:g}", rate, rate_limits.least,
                          rate_limits.most),
              "check the unit of time, or resample the recording", false};
  const double usual = 60;
  const Unit& unit = nearest(times, usual / rate);
  if (!outside(rate * unit.factor, {rate_limits.least, rate_limits.most / 2})) {
    if (!unit.name.empty()) doubt.evidence += fmt::format(", as if {} were read as seconds", unit.name);
    doubt.cure = rescale("--time-scale", unit.factor);
    doubt.meaningless = true;
  }
  found.push_back(std::move(doubt));
}

/// Steps of the palm to another place, where it stays: another hand, or another tracking.
void doubt_steps(const Trace& trace, const TraceHand& hand, std::vector<Doubt>& found) {
  std::vector<double> steps(trace.t.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 1; i < trace.t.size(); ++i) {
    if (hand.samples[i].tracked && hand.samples[i - 1].tracked)
      steps[i] = (hand.samples[i].X_WP[palm].p - hand.samples[i - 1].X_WP[palm].p).norm();
  }
  std::size_t count = 0, largest = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (!(steps[i] > fastest_step * (trace.t[i] - trace.t[i - 1]))) continue;
    std::vector<double> near;
    for (std::size_t k = i > around ? i - around : 1; k <= i + around && k < steps.size(); ++k) {
      if (k != i && !std::isnan(steps[k])) near.push_back(steps[k]);
    }
    if (near.size() < least_stamps || steps[i] < step_outlier * (median(near) + 2e-3)) continue;
    ++count;
    if (largest == 0 || steps[i] > steps[largest]) largest = i;
  }
  if (count == 0) return;
  found.push_back(
      {fmt::format("{}, frame {} ({:.3f} s): jumps {:.0f} mm in one frame, {:.1f} m/s{}", named(hand), largest,
                   trace.t[largest], 1e3 * steps[largest], steps[largest] / (trace.t[largest] - trace.t[largest - 1]),
                   count > 1 ? fmt::format(", and {} smaller jumps", count - 1) : ""),
       "cut the recording there, or mark the frames lost that are not the hand's", false});
}

}  // namespace

std::vector<int> odd_bones(const HandModel& model) {
  const HandModel mean = anatomical_hand(size_ratio(model));
  std::vector<int> odd;
  for (std::size_t i = 1; i < mean.capsules.size(); ++i) {  // not the metacarpal of the thumb: some files lack it
    const bool tip = i % 3 == 2;                            // measured to the bone, the ball or the skin
    const Limits limits{tip ? 0 : bone_limits.least, tip ? 2 * bone_limits.most : bone_limits.most};
    if (outside(model.capsules[i].half_length / mean.capsules[i].half_length, limits)) odd.push_back(int(i));
  }
  return odd;
}

std::string to_text(const Doubt& doubt) { return fmt::format("{} ({})", doubt.evidence, doubt.cure); }

std::vector<Doubt> doubts(const Trace& trace) {
  std::vector<Doubt> found;
  doubt_rate(trace, found);
  if (trace.t.size() == 1) found.push_back({"there is one frame, which is no motion", "record two or more", false});
  for (const TraceHand& hand : trace.hands) {
    const double size = size_ratio(hand.model);
    doubt_size(hand, found);
    if (!(size > 0)) continue;
    doubt_bones(hand, found);
    doubt_wrist(hand, size, found);
    doubt_radii(hand, size, found);
    doubt_axes(hand, found);
    doubt_side(hand, found);
    doubt_steps(trace, hand, found);
  }
  return found;
}

}  // namespace handhold
