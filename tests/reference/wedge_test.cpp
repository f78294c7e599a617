// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/wedge.hpp"

#include <gtest/gtest.h>

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// A hollow edge along z, between faces whose normals are x and y.
const Wedge hollow{.n = {Vector3d::UnitX(), Vector3d::UnitY()}, .away = {Vector3d::UnitY(), Vector3d::UnitX()}};

/// Between the two normals it is the direction out of the sample; beyond either of them, that of the face.
TEST(Wedge, HasANormalOfTheArcBetweenItsFaces) {
  EXPECT_LT((hollow.normal({-3, -4, 7}) - Vector3d(0.6, 0.8, 0)).norm(), 1e-15);
  EXPECT_EQ(hollow.normal({-1, 0.2, 0}), Vector3d::UnitX());
  EXPECT_EQ(hollow.normal({0.2, -1, 0}), Vector3d::UnitY());
}

}  // namespace
}  // namespace handhold::reference
