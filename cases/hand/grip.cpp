// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/grip.hpp"

#include <algorithm>
#include <cmath>

namespace handhold {
namespace {

struct Line {
  Eigen::Vector3d middle, u;
  double half;
};

Line last_bone(const HandMotion& motion, int finger, double t) {
  const Pose X_WP = motion.pose(last_phalanx(finger), t);
  return {X_WP.p, X_WP.R * Eigen::Vector3d::UnitZ(), motion.model().capsules[last_phalanx(finger)].half_length};
}

double clamp_to(const Line& line, double s) { return std::clamp(s, -line.half, line.half); }

/// Parameters of the closest points of two segments (Ericson 2005, section 5.1.9, for unit directions).
void closest(const Line& a, const Line& b, double& s, double& t) {
  const Eigen::Vector3d r = a.middle - b.middle;
  const double k = a.u.dot(b.u), c = a.u.dot(r), f = b.u.dot(r);
  const double determinant = 1 - k * k;
  s = determinant > 1e-12 ? clamp_to(a, (k * f - c) / determinant) : 0;
  t = k * s + f;
  if (std::abs(t) <= b.half) return;
  t = clamp_to(b, t);
  s = clamp_to(a, k * t - c);
}

}  // namespace

Grip grip_at(const HandMotion& motion, int finger, double t) {
  const Line thumb = last_bone(motion, 0, t), other = last_bone(motion, finger, t);
  const double r_thumb = motion.model().capsules[last_phalanx(0)].radius;
  const double r_other = motion.model().capsules[last_phalanx(finger)].radius;
  double s{}, u{};
  closest(thumb, other, s, u);
  const Eigen::Vector3d from = thumb.middle + s * thumb.u, to = other.middle + u * other.u;
  Grip grip;
  grip.t = t;
  const double distance = (to - from).norm();
  grip.gap = distance - r_thumb - r_other;
  if (distance > 1e-9) grip.axis_W = (to - from) / distance;
  grip.middle_W = from + (r_thumb + grip.gap / 2) * grip.axis_W;
  return grip;
}

std::vector<Grip> sample_grips(const HandMotion& motion, int finger, const Interval& present, double tick) {
  const int count = std::max(1, int(std::ceil((present.end - present.begin) / tick)));
  std::vector<Grip> grips;
  for (int i = 0; i <= count; ++i) {
    grips.push_back(grip_at(motion, finger, present.begin + (present.end - present.begin) * i / count));
  }
  return grips;
}

std::vector<Closing> find_closings(const std::vector<Grip>& grips, int finger, double closed, double open) {
  std::vector<Closing> closings;
  bool was_open = false, inside = false;
  int count = 0;
  for (const Grip& grip : grips) {
    if (grip.gap > closed) {
      inside = false;
      was_open = was_open || grip.gap >= open;
      continue;
    }
    if (!inside && !was_open) continue;  // closed from the start: nothing could have come between
    if (!inside) {
      closings.push_back({finger, grip.t, grip.t, grip.gap});
      count = 1;
    } else {
      Closing& last = closings.back();
      last.end = grip.t;
      last.mean_gap += (grip.gap - last.mean_gap) / ++count;
    }
    inside = true;
    was_open = false;
  }
  return closings;
}

}  // namespace handhold
