// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/independent/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace handhold::independent {
namespace {

/// Of every sample, by its id's key.
using Lists = std::map<std::uint32_t, std::vector<Happening>>;

Lists by_sample(const std::vector<Happening>& events) {
  Lists lists;
  for (const Happening& e : events) lists[SampleId::key(e.id)].push_back(e);
  return lists;
}

std::string told(const std::vector<Happening>& events) {
  std::string out;
  for (const Happening& e : events) out += fmt::format(" {} {:.9f}", to_string(e.kind), double(e.t));
  return out.empty() ? " none" : out;
}

void compare_events(const Lists& a, const Lists& b, Agreement& out) {
  static const std::vector<Happening> none;
  Lists all = a;
  all.insert(b.begin(), b.end());
  for (const auto& [key, unused] : all) {
    const auto& ours = a.count(key) ? a.at(key) : none;
    const auto& theirs = b.count(key) ? b.at(key) : none;
    const bool same = std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                 [](const Happening& x, const Happening& y) { return x.kind == y.kind; });
    if (!same) {
      out.events_differ +=
          fmt::format("phalanx {} sample {}:{} | {}\n", key >> 16 & 255, key & 255, told(ours), told(theirs));
      continue;
    }
    for (std::size_t i = 0; i < ours.size(); ++i)
      out.event_time = std::max(out.event_time, double(std::abs(ours[i].t - theirs[i].t)));
  }
}

}  // namespace

Agreement agreement(const Result& a, const Result& b) {
  Agreement out;
  out.position = double((a.p_WO - b.p_WO).norm());
  out.rotation = double(2 * (a.R_WO.conjugate() * b.R_WO).vec().norm());
  compare_events(by_sample(a.events), by_sample(b.events), out);
  return out;
}

Agreement agreement(const Result& truth, const Recording& recording) {
  Result other;
  const Pose& X_WO = recording.frames.back().bodies.front().X_WO;
  other.p_WO = X_WO.p.cast<Real>();
  other.R_WO = X_WO.R.cast<Real>().normalized();
  for (const Event& e : recording.events) other.events.push_back({e.t, e.id, e.kind});
  return agreement(truth, other);
}

std::string text(const Agreement& a, std::size_t events) {
  return fmt::format("position {:.1e} m, rotation {:.1e} rad, event times {:.1e} s, {} {} events", a.position,
                     a.rotation, a.event_time, a.events_differ.empty() ? "the same" : "NOT the same", events);
}

}  // namespace handhold::independent
