// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/moved_trace.hpp"

namespace handhold {
namespace {

void move(HandSample& sample, const Pose& X_WT) {
  for (Pose& pose : sample.X_WP) {
    pose = X_WT * pose;
    pose.R.normalize();  // a product of unit quaternions drifts by an ulp
  }
}

}  // namespace

Trace moved(Trace trace, const Pose& X_WT, double start) {
  for (double& t : trace.t) t -= start;
  const bool stays = X_WT.p.isZero(0) && X_WT.R.vec().isZero(0);
  if (stays) return trace;  // the same bits
  for (TraceHand& hand : trace.hands) {
    for (HandSample& sample : hand.samples) {
      if (sample.tracked) move(sample, X_WT);
    }
  }
  return trace;
}

Trace scaled(Trace trace, double length, double time) {
  for (double& t : trace.t) t *= time;
  for (TraceHand& hand : trace.hands) {
    for (Capsule& capsule : hand.model.capsules) capsule = {length * capsule.half_length, length * capsule.radius};
    hand.model.palm_box.half_extents *= length;
    for (HandSample& sample : hand.samples) {
      for (Pose& X : sample.X_WP) X.p *= length;
    }
  }
  return trace;
}

}  // namespace handhold
