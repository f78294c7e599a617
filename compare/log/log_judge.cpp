// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/log/log_judge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "compare/log/log_faults.hpp"

namespace handhold::compare {
namespace {

std::vector<Span> between(const std::vector<std::size_t>& jumps, std::size_t frames) {
  std::vector<Span> spans;
  std::size_t begin = 0;
  for (const std::size_t jump : jumps) {
    spans.push_back({begin, jump + 1});
    begin = jump + 1;
  }
  spans.push_back({begin, frames});
  return spans;
}

void judge_object(const LoggedMotion& motion, LogReport& report) {
  if (motion.track().t.size() < 3) return;
  LogFindings findings;
  for (const Span& span : between(find_jumps(motion, findings), motion.track().t.size())) {
    find_free_motion(motion, span, findings);
    find_kicks(motion, span, findings);
  }
  const std::vector<LogGrip> grips = find_grips(motion, findings);
  report.grips.insert(report.grips.end(), grips.begin(), grips.end());
  if (motion.log.drawn_hands) find_penetration(motion, findings);
  for (LogFinding& finding : findings.take()) report.findings.push_back(std::move(finding));
}

}  // namespace

bool LoggedMotion::beside_another(double t) const {
  const auto radius = [&](std::size_t i) { return solids[i].field->bounds().diagonal().norm() / 2; };
  const auto index = [&](const ObjectTrack& o) {
    return std::size_t(std::lower_bound(o.t.begin(), o.t.end(), t) - o.t.begin());
  };
  const std::size_t own = index(track());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const std::size_t at = index(tracks[i]);
    if (i == object || at >= tracks[i].t.size() || own >= track().t.size()) continue;
    if ((tracks[i].center[at] - track().center[own]).norm() < radius(i) + radius(object)) return true;
  }
  return false;
}

double LoggedMotion::fastest_phalanx(int hand, double from, double to) const {
  constexpr double step = 0.005;  // [s]
  double fastest = 0;
  for (double t = from; t <= to; t += step) {
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx)
      fastest = std::max(fastest, hands[std::size_t(hand)]->twist(phalanx, t).v.norm());
  }
  return fastest;
}

std::string LoggedMotion::hand_name(int hand) const {
  return fmt::format("{} hand", to_string(log.trace->hands[std::size_t(hand)].side));
}

void LogFindings::add(LogFinding finding) {
  constexpr double pause = 0.1;  // [s]
  if (!findings_.empty()) {
    LogFinding& last = findings_.back();
    if (last.fault == finding.fault && finding.fault != LogFault::jump && finding.begin - last.end < pause) {
      const double begin = last.begin, end = std::max(last.end, finding.end);
      if (finding.value > last.value) last = std::move(finding);
      last.begin = begin;
      last.end = end;
      return;
    }
  }
  findings_.push_back(std::move(finding));
}

std::string_view to_string(LogFault fault) {
  switch (fault) {
    case LogFault::jump:
      return "jump";
    case LogFault::flight:
      return "flight";
    case LogFault::drift:
      return "drift";
    case LogFault::kick:
      return "kick";
    case LogFault::creep:
      return "creep";
    case LogFault::penetration:
      return "penetration";
  }
  return "";
}

LogReport judge_log(const ObjectLog& log, const std::vector<ObjectTrack>& tracks,
                    const std::vector<LoggedSolid>& solids, const Eigen::Vector3d& gravity) {
  LogReport report;
  const LoggedHands hands = hands_of(log);
  for (std::size_t i = 0; i < tracks.size(); ++i) judge_object({log, hands, tracks, solids, i, gravity}, report);
  std::stable_sort(report.findings.begin(), report.findings.end(),
                   [](const LogFinding& a, const LogFinding& b) { return a.begin < b.begin; });
  std::stable_sort(report.grips.begin(), report.grips.end(),
                   [](const LogGrip& a, const LogGrip& b) { return a.begin < b.begin; });
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.t.size(); ++i) steps.push_back(log.t[i] - log.t[i - 1]);
  report.frames = frame_times(std::move(steps));
  return report;
}

}  // namespace handhold::compare
