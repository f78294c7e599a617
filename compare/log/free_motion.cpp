// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "compare/log/log_faults.hpp"
#include "compare/log/motion_fit.hpp"

namespace handhold::compare {
namespace {

double speed(const ObjectTrack& track, std::size_t i) {  // from frame i to the next
  return (track.center[i + 1] - track.center[i]).norm() / (track.t[i + 1] - track.t[i]);
}

/// ", as tracking of the right hand returned": what the hands did within 50 ms of `t`.
std::string tracking_change(const LoggedMotion& motion, double t) {
  constexpr double soon = 0.05;
  for (std::size_t h = 0; h < motion.hands.size(); ++h) {
    for (const Interval& present : motion.hands[h]->presence()) {
      const std::string name = motion.hand_name(int(h));
      if (std::abs(present.begin - t) < soon && present.begin > motion.log.t.front() + soon)
        return fmt::format(", as tracking of the {} returned", name);
      if (std::abs(present.end - t) < soon && present.end < motion.log.t.back() - soon)
        return fmt::format(", as tracking of the {} was lost", name);
    }
  }
  return "";
}

void judge_flight(const LoggedMotion& motion, const Span& window, const MotionFit& fit, LogFindings& findings) {
  constexpr double rising = 0.1;   // [m/s]: slower up or down it may lie on something
  constexpr double smooth = 2e-4;  // [m]: a rougher path has a blow in it
  constexpr double part = 0.05;    // of gravity: drag of the air is far less
  const ObjectTrack& o = motion.track();
  const double begin = o.t[window.begin], end = o.t[window.end - 1];
  const double lift = std::abs(motion.downwards(fit.v));
  const double off = (fit.a - motion.gravity).norm(), limit = part * motion.gravity.norm() + limit_errors * fit.a_error;
  if (lift < rising || fit.residual > smooth || off <= limit || motion.beside_another(begin)) return;
  findings.add(
      {LogFault::flight, o.name, begin, end, off, limit, "m/s^2",
       fmt::format("flies with {:.2f} m/s^2 downwards at {:.2f} m/s where gravity is {:.2f}{}", motion.downwards(fit.a),
                   fit.v.norm(), motion.gravity.norm(),
                   fit.v.dot(fit.a - motion.gravity) > 0 ? ": it gains energy from nothing" : ""),
       "no hand is within 5 mm, and nothing else is in the log; a slope or a floor that it does not show would excuse "
       "it"});
}

void find_drift(const LoggedMotion& motion, const Span& away, LogFindings& findings) {
  constexpr double window = 0.5, slow = 0.1, least = 2e-4;  // [s], [m/s], [m/s]: 0.1 mm in the window
  constexpr double part = 0.02;                             // of gravity: friction stops a slide with more
  const ObjectTrack& o = motion.track();
  for (std::size_t a = away.begin; a < away.end;) {
    std::size_t b = a;
    while (b < away.end && o.t[b] - o.t[a] < window) ++b;
    if (b == away.end || b - a < 8) return;
    const MotionFit fit = fit_motion(o.t, o.center, a, b, true);
    const double limit = least + limit_errors * fit.v_error;
    if (fit.v.norm() > limit && fit.v.norm() < slow && fit.a.norm() < part * motion.gravity.norm() &&
        fit.residual < 1e-3 && !motion.beside_another(o.t[a])) {
      const double down = motion.gravity.norm() > 0 ? motion.downwards(fit.v) : 0;
      findings.add({LogFault::drift, o.name, o.t[a], o.t[b - 1], fit.v.norm(), limit, "m/s",
                    fmt::format("{} at {:.2f} mm/s with no hand near", down > 0.7 * fit.v.norm() ? "sinks" : "drifts",
                                1e3 * fit.v.norm()),
                    "what lies rests; what slides stops within v/(mu g); only what rolls goes on"});
    }
    a += std::max<std::size_t>(1, (b - a) / 2);
  }
}

}  // namespace

std::vector<std::size_t> find_jumps(const LoggedMotion& motion, LogFindings& findings) {
  constexpr double least = 0.02;           // [m]: tracking noise and a fast frame are below
  constexpr double factor = 4, extra = 1;  // [1], [m/s]
  const ObjectTrack& o = motion.track();
  std::vector<std::size_t> jumps;
  for (std::size_t i = 0; i + 1 < o.t.size(); ++i) {
    const double step = (o.center[i + 1] - o.center[i]).norm();
    const double before = i > 0 ? speed(o, i - 1) : 0, after = i + 2 < o.t.size() ? speed(o, i + 1) : 0;
    const double limit = (factor * std::max(before, after) + extra) * (o.t[i + 1] - o.t[i]);
    if (step < std::max(least, limit)) continue;
    jumps.push_back(i);
    findings.add({LogFault::jump, o.name, o.t[i], o.t[i + 1], step, std::max(least, limit), "m",
                  fmt::format("jumps {:.0f} mm in one frame ({:.1f} ms){}", 1e3 * step, 1e3 * (o.t[i + 1] - o.t[i]),
                              tracking_change(motion, o.t[i + 1])),
                  "a body moves on: one frame cannot be four times as fast as its neighbours and 1 m/s more"});
  }
  return jumps;
}

void find_free_motion(const LoggedMotion& motion, const Span& span, LogFindings& findings) {
  constexpr double flight = 0.1;  // [s]
  constexpr std::size_t fewest = 6;
  const ObjectTrack& o = motion.track();
  for (std::size_t i = span.begin; i < span.end;) {
    if (!motion.away(i)) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < span.end && motion.away(end)) ++end;
    for (std::size_t a = i; a < end;) {
      std::size_t b = a;
      while (b < end && (o.t[b] - o.t[a] < flight || b - a < fewest)) ++b;
      if (b - a < fewest || (b == end && o.t[b - 1] - o.t[a] < flight / 2)) break;
      judge_flight(motion, {a, b}, fit_motion(o.t, o.center, a, b, true), findings);
      a += std::max<std::size_t>(1, (b - a) / 2);
    }
    find_drift(motion, {i, end}, findings);
    i = end;
  }
}

void find_kicks(const LoggedMotion& motion, const Span& span, LogFindings& findings) {
  constexpr double before = 0.1, noise = 0.1;  // [s], [m/s]
  const ObjectTrack& o = motion.track();
  for (std::size_t i = span.begin + 1; i + 3 < span.end; ++i) {
    const Nearness& last = o.near[i - 1];
    if (last.hand < 0 || last.depth < -away_distance || !motion.away(i)) continue;
    const double left = (o.center[i + 2] - o.center[i]).norm() / (o.t[i + 2] - o.t[i]);
    const double fastest = motion.fastest_phalanx(last.hand, o.t[i - 1] - before, o.t[i]);
    const double limit = 2 * fastest + motion.gravity.norm() * (o.t[i + 2] - o.t[i - 1]) + noise;
    if (left <= limit || motion.beside_another(o.t[i])) continue;
    findings.add(
        {LogFault::kick, o.name, o.t[i - 1], o.t[i + 2], left, limit, "m/s",
         fmt::format("leaves the {} with {:.2f} m/s, whose fastest phalanx had {:.2f} m/s in the last 100 ms{}",
                     motion.hand_name(last.hand), left, fastest, tracking_change(motion, o.t[i])),
         "the most elastic blow of a hand gives twice its speed; gravity and 0.1 m/s of noise are allowed beside"});
  }
}

}  // namespace handhold::compare
