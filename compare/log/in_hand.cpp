// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "compare/log/log_faults.hpp"
#include "compare/log/motion_fit.hpp"

namespace handhold::compare {
namespace {

using Eigen::Vector3d;

/// The object's centre in the palm, less the mean of the phalanges that touch throughout.
std::vector<Vector3d> in_the_grip(const LoggedMotion& motion, const Span& span, int hand) {
  const ObjectTrack& o = motion.track();
  unsigned touching = ~0u;
  for (std::size_t i = span.begin; i < span.end; ++i) touching &= o.near[i].touching;
  std::vector<Vector3d> out;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    const HandMotion& moved = *motion.hands[std::size_t(hand)];
    const Pose X_PW = moved.pose(palm, o.t[i]).inverse();
    Vector3d mean = Vector3d::Zero();
    int count = 0;
    for (int phalanx = 0; phalanx < palm; ++phalanx) {
      if ((touching >> unsigned(phalanx) & 1u) == 0) continue;
      mean += X_PW * moved.pose(phalanx, o.t[i]).p;
      ++count;
    }
    out.emplace_back(X_PW * o.center[i] - (count > 0 ? Vector3d(mean / count) : Vector3d(Vector3d::Zero())));
  }
  return out;
}

void find_creep(const LoggedMotion& motion, LogGrip& grip, LogFindings& findings) {
  constexpr double window = 0.5, least = 5e-4;  // [s], [m/s]
  constexpr double still = 0.1;                 // [m/s]: tracking noise of 0.5 mm from frame to frame is below
  const ObjectTrack& o = motion.track();
  const auto first = std::lower_bound(o.t.begin(), o.t.end(), grip.begin) - o.t.begin();
  const auto last = std::upper_bound(o.t.begin(), o.t.end(), grip.end) - o.t.begin();
  double stillest = std::numeric_limits<double>::infinity();
  for (std::size_t a = std::size_t(first); a < std::size_t(last);) {
    std::size_t b = a;
    while (b < std::size_t(last) && o.t[b] - o.t[a] < window) ++b;
    if (b == std::size_t(last) || b - a < 8) return;
    const std::vector<double> t(o.t.begin() + std::ptrdiff_t(a), o.t.begin() + std::ptrdiff_t(b));
    const std::vector<Vector3d> p = in_the_grip(motion, {a, b}, grip.hand);
    const MotionFit line = fit_motion(t, p, 0, t.size(), false), bent = fit_motion(t, p, 0, t.size(), true);
    if (bent.residual < stillest) stillest = bent.residual, grip.jitter = bent.residual;
    // Steady: the same way through the whole window, at a speed that changes by less than half.
    const double limit = least + limit_errors * line.v_error;
    const bool steady = bent.a.norm() * (t.back() - t.front()) < line.v.norm();
    const double moved = line.v.norm() * (t.back() - t.front());
    if (line.v.norm() > limit && steady && moved > 2 * line.residual &&
        motion.fastest_phalanx(grip.hand, t.front(), t.back()) < still)
      findings.add({LogFault::creep, o.name, t.front(), t.back(), line.v.norm(), limit, "m/s",
                    fmt::format("creeps at {:.2f} mm/s through the {} that keeps still", 1e3 * line.v.norm(),
                                motion.hand_name(grip.hand)),
                    "inside the friction cone nothing slides, and beyond it nothing slides steadily"});
    a += std::max<std::size_t>(1, (b - a) / 2);
  }
}

}  // namespace

std::vector<LogGrip> find_grips(const LoggedMotion& motion, LogFindings& findings) {
  constexpr double gap = 0.1, least = 0.2;  // [s]
  const ObjectTrack& o = motion.track();
  std::vector<LogGrip> grips;
  std::size_t last = 0;  // frame of the last touch
  for (std::size_t i = 0; i < o.t.size(); ++i) {
    if (o.near[i].hand < 0 || o.near[i].depth < -touch_distance) continue;
    const bool goes_on =
        !grips.empty() && grips.back().hand == o.near[i].hand && (i == last + 1 || o.t[i] - o.t[last] <= gap);
    if (!goes_on) grips.push_back({o.name, motion.object, o.near[i].hand, o.t[i], o.t[i], 0, std::nan("")});
    grips.back().end = o.t[i];
    last = i;
    if (o.near[i].phalanx != palm) grips.back().depth = std::max(grips.back().depth, o.near[i].depth);
  }
  grips.erase(std::remove_if(grips.begin(), grips.end(), [](const LogGrip& g) { return g.end - g.begin < least; }),
              grips.end());
  for (LogGrip& grip : grips) find_creep(motion, grip, findings);
  return grips;
}

void find_penetration(const LoggedMotion& motion, LogFindings& findings) {
  constexpr double least = 0.03;  // [s]: a blow may be drawn late
  const ObjectTrack& o = motion.track();
  for (std::size_t i = 0; i < o.t.size(); ++i) {
    const Nearness& near = o.near[i];
    if (near.hand < 0 || near.phalanx == palm) continue;
    const double radius =
        motion.log.trace->hands[std::size_t(near.hand)].model.capsules[std::size_t(near.phalanx)].radius;
    if (near.depth <= radius) continue;
    const std::size_t first = i;
    double deepest = near.depth;
    while (i + 1 < o.t.size() && o.near[i + 1].hand == near.hand && o.near[i + 1].depth > radius)
      deepest = std::max(deepest, o.near[++i].depth);
    if (o.t[i] - o.t[first] < least) continue;
    findings.add({LogFault::penetration, o.name, o.t[first], o.t[i], deepest, radius, "m",
                  fmt::format("{} of the drawn {} is {:.1f} mm deep in it", phalanx_name(near.phalanx),
                              motion.hand_name(near.hand), 1e3 * deepest),
                  fmt::format("{:.1f} mm is the phalanx's radius: its bone is inside", 1e3 * radius)});
  }
}

}  // namespace handhold::compare
