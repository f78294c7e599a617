// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/paper/hand_contact.hpp"

#include "tests/realtime/paper/rig.hpp"

// Patches of whole hands: when they come and go, and where their centroid is. The law itself is judged by the cases of
// level L3 (cases/catalogue/l3).

namespace handhold::realtime::paper {
namespace {

using testing::frame;

/// Vertical force on the object of one capsule (radius 8 mm) whose centroid is at `height` above the face, after it
/// came down from afar.
struct Approach {
  HandContact contact;
  HandFrame hand{};
  static constexpr double top = 0.03125, radius = 0.008;

  explicit Approach(const Options& options)
      : contact(voxelize(make_box({0.125, 0.125, 0.0625}), {.voxel_size = 1.0 / 256}), Normals::triangle,
                Eigen::Vector3d::Zero(), {0.5, 0.4}, options, {model()}) {
    hand.present = true;
    for (Pose& X : hand.X_WP) X.p.z() = 10;
  }
  static HandModel model() {
    HandModel m = anatomical_hand();
    m.capsules[5] = {0, radius};
    return m;
  }
  double force(double height) {
    hand.X_WP[5].p.z() = top + height;
    return contact.frame(frame, std::span<const HandFrame>(&hand, 1), {}).force.z();
  }
};

TEST(PaperContactOffset, APatchComesAtTheOffsetAndGoesAtTwiceIt) {
  Approach approach({});
  const auto active = [&] { return approach.contact.middleware().patches()[5].active; };
  for (const auto& [gap, expected] : {std::pair{0.0021, false}, std::pair{0.0019, true}, std::pair{0.0039, true},
                                      std::pair{0.0041, false}, std::pair{0.003, false}}) {
    EXPECT_EQ(approach.force(Approach::radius + gap), 0);
    EXPECT_EQ(active(), expected) << gap;
  }
}

TEST(PaperContactOffset, ACapsuleOnItsCentroidFeelsNothingForOneRadius) {
  Options options;
  options.point = Point::centroid;
  Approach approach(options);
  for (int k = 0; k <= 120; ++k) {
    const double height = Approach::radius + 0.002 - k * 1e-4;
    const double depth = height < -1e-15 ? height : 0;  // at the face's own height rounding decides
    EXPECT_NEAR(approach.force(height), 8 * 100 * depth, 1e-13) << height;
  }
}

}  // namespace
}  // namespace handhold::realtime::paper
