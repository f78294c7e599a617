// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/frame_times.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

TEST(FrameTimes, RegularOnesEndAtTheEnd) {
  EXPECT_EQ(regular_frames(0.5, 4), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(regular_frames(0.6, 4), (std::vector<double>{0.25, 0.5, 0.6}));
  EXPECT_EQ(regular_frames(1, 90).size(), 90u);  // no sliver, though 90 / 90.0 is reached by rounding
  EXPECT_EQ(regular_frames(0.001, 90), (std::vector<double>{0.001}));
}

TEST(FrameTimes, ThoseOfATraceAreWhenItSawTheHand) {
  const PoseFunction still = [](double) { return std::array<Pose, phalanx_count>{}; };
  const Trace trace = sample_trace("still", Side::right, anatomical_hand(), still, -0.3, 0.9, 10);
  Scene scene;
  scene.duration = 0.45;
  scene.hands = {{std::make_shared<TraceSpline>(trace, 0), {}}};
  const std::vector<double> times = trace_frames(scene);
  ASSERT_EQ(times.size(), 5u);  // 0.1 ... 0.4, and the end
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(times[std::size_t(k)], 0.1 * (k + 1), 1e-15);
  EXPECT_EQ(times.back(), 0.45);
}

TEST(FrameTimes, MustAscendToTheEnd) {
  EXPECT_NO_THROW(validate_frames({0.1, 0.5}, 0.5));
  EXPECT_THROW(validate_frames({0, 0.5}, 0.5), InputError);
  EXPECT_THROW(validate_frames({0.3, 0.2, 0.5}, 0.5), InputError);
  EXPECT_THROW(validate_frames({0.1, 0.4}, 0.5), InputError);
  EXPECT_THROW(validate_frames({}, 0.5), InputError);
}

}  // namespace
}  // namespace handhold
