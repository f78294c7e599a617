#include "compare/measure/contact_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace handhold::compare {
namespace {

using catalogue::Measure;
using Kind = Measure::Kind;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double same_instant = 1e-12;  // [s]: rounding of a frame's time

bool chosen(const ContactState& contact, const Measure& what) {
  return contact.id.body == 0 && (what.phalanx < 0 || contact.id.phalanx == what.phalanx) &&
         (what.sample < 0 || contact.id.sample == what.sample) && (!what.mode || contact.mode == *what.mode);
}

/// Sum over the chosen contacts of a frame.
template <class Value>
double sum(const Frame& frame, const Measure& what, const Value& value) {
  double total = 0;
  for (const ContactState& c : frame.contacts)
    if (chosen(c, what)) total += value(c);
  return total;
}

/// Frames from `from` (or `at`) to `at`; none if there are no frames at these instants.
std::span<const Frame> window(const Recording& recording, const Measure& what) {
  const Frame* last = what.at ? frame_at(recording, *what.at) : nullptr;
  const Frame* first = what.from ? frame_at(recording, *what.from) : last;
  if (!first || !last || first > last) return {};
  return {first, last + 1};
}

template <class Value>
double sum(std::span<const Frame> frames, const Measure& what, const Value& value) {
  if (frames.empty()) return nan;
  double total = 0;
  for (const Frame& frame : frames) total += sum(frame, what, value);
  return total;
}

const ContactState* find(const Frame& frame, const SampleId& id) {
  const auto found = std::ranges::find(frame.contacts, id, &ContactState::id);
  return found == frame.contacts.end() ? nullptr : &*found;
}

/// Trapezoidal rule, exact where force and way are linear between frames.
double work(std::span<const Frame> frames, const Measure& what) {
  if (frames.size() < 2) return nan;
  double total = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    total -= sum(frames[i], what, [&](const ContactState& c) {
      const ContactState* before = find(frames[i - 1], c.id);
      return before ? (c.p_W - before->p_W).dot(c.f_W + before->f_W) / 2 : 0.0;
    });
  }
  return total;
}

double growth(std::span<const Frame> frames, const Measure& what) {
  if (frames.size() < 4) return nan;
  const auto x = [&](std::size_t n) { return what.axis.dot(frames[n].bodies.front().X_WO.p); };
  const auto area = [&](std::size_t n) { return x(n + 1) * x(n + 1) - x(n) * x(n + 2); };
  const std::size_t last = frames.size() - 3;
  return std::pow(area(last) / area(0), 1 / (2 * double(last)));
}

}  // namespace

const Frame* frame_at(const Recording& recording, double t) {
  const auto found =
      std::ranges::find_if(recording.frames, [&](const Frame& f) { return std::abs(f.t - t) < same_instant; });
  return found == recording.frames.end() ? nullptr : &*found;
}

double contact_measure(const Recording& recording, const Measure& what) {
  const std::span<const Frame> frames = window(recording, what);
  switch (what.kind) {
    case Kind::force:
    case Kind::force_sum:
      return sum(frames, what, [&](const ContactState& c) { return what.axis.dot(c.f_W); });
    case Kind::torque:
      return sum(frames, what, [&](const ContactState& c) {
        return what.axis.dot((c.C_W - what.point).cross(c.f_W));
      });
    case Kind::mode_count:
      return sum(frames, what, [](const ContactState&) { return 1.0; });
    case Kind::lag: {
      const double count = sum(frames, what, [](const ContactState&) { return 1.0; });
      return sum(frames, what, [&](const ContactState& c) { return what.axis.dot(c.p_W - c.C_W); }) / count;
    }
    case Kind::work:
      return work(frames, what);
    case Kind::growth:
      return growth(frames, what);
    default:
      return nan;
  }
}

}  // namespace handhold::compare
