// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/prescribed_hand.hpp"

#include <array>
#include <cmath>
#include <memory>

#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"

namespace handhold::catalogue {
namespace {

constexpr double margin = 0.1;  // [s]
const Pose out_of_the_way{Eigen::Quaterniond::Identity(), {0, 0, -10}};

}  // namespace

Hand prescribed_hand(const std::vector<PrescribedPatch>& patches, double duration, double rate) {
  Hand hand;
  for (const PrescribedPatch& patch : patches) hand.given.push_back({patch.phalanx, patch.p_P, patch.start});
  const PoseFunction poses = [patches](double t) {
    std::array<Pose, phalanx_count> X_WP;
    X_WP.fill(out_of_the_way);
    for (const PrescribedPatch& patch : patches) X_WP[std::size_t(patch.phalanx)] = patch.pose(t);
    return X_WP;
  };
  const double before = std::ceil(margin * rate) / rate, after = std::ceil((duration + margin) * rate) / rate;
  const Trace trace = sample_trace("prescribed", Side::right, anatomical_hand(), poses, -before, after, rate);
  hand.motion = std::make_shared<TraceSpline>(trace, 0);
  return hand;
}

}  // namespace handhold::catalogue
