// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/detection/fan.hpp"

#include <random>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/edge_scenes.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

/// A pull is split by the cone that the surface is, seen from nearby: for one that is short against the faces the
/// field's own search must find the same nearest point, and the same side.
void agrees_with_the_nearest_point(const VoxelField& field, const Place& place, const Vector3d& C, double length,
                                   std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Vector3d pull = length * Vector3d(normal(random), normal(random), normal(random)).normalized();
  const Pull split_pull = split(field.faces(), place, pull);
  const std::optional<SurfacePoint> nearest = field.closest(C + pull, field.band());
  ASSERT_TRUE(nearest);
  const double rounding = 1e-9 * length;
  EXPECT_NEAR(split_pull.depth, -nearest->distance, rounding);
  if (split_pull.depth <= 0) return;
  // Two points of a convex edge's faces can be as near.
  EXPECT_NEAR((pull - split_pull.w).norm(), split_pull.depth, rounding);
  const std::optional<SurfacePoint> on = field.closest(C + split_pull.w, length);
  ASSERT_TRUE(on);
  EXPECT_LT(std::abs(on->distance), rounding);
  EXPECT_LT((pull - split_pull.w + split_pull.depth * split_pull.n).norm(), rounding);
}

TEST(Fan, SplitsAPullWhereTheSurfaceIsNearest) {
  std::mt19937 random(1);
  const double length = 1e-5;
  for (const Mesh& mesh : {make_box({0.02, 0.03, 0.04}), catalogue::hollow_edge(), catalogue::hollow_corner(),
                           catalogue::convex_edge(2.2), make_cylinder(0.02, 0.03, 7), make_mug({.segments = 48})}) {
    const auto field = voxelize(mesh, {.voxel_size = 0.001});
    const FaceGraph& faces = field->faces();
    for (int f = 0; f < faces.size(); f += 1 + faces.size() / 40)
      for (int i = 0; i < 3; ++i) {
        const Face& face = faces[f];
        const Vector3d &a = face.corner[std::size_t(i)], &b = face.corner[std::size_t(i + 1) % 3];
        const Vector3d middle = 0.3 * face.corner[0] + 0.3 * face.corner[1] + 0.4 * face.corner[2];
        for (int k = 0; k < 20; ++k) {
          agrees_with_the_nearest_point(*field, {.face = f}, middle, length, random);
          agrees_with_the_nearest_point(*field, {.face = f, .side = i}, 0.5 * (a + b), length, random);
          agrees_with_the_nearest_point(*field, {.face = f, .corner = i}, a, length, random);
        }
      }
  }
}

TEST(Fan, FindsThePlaceOfAPoint) {
  const FaceGraph faces(make_box({1, 1, 1}));
  const Face& f = faces[0];
  const double eps = 1e-9;
  const Place inside = place_of(faces, 0, (f.corner[0] + f.corner[1] + f.corner[2]) / 3, eps);
  EXPECT_EQ(inside.side, -1);
  EXPECT_EQ(inside.corner, -1);
  EXPECT_EQ(place_of(faces, 0, 0.5 * (f.corner[1] + f.corner[2]), eps).side, 1);
  EXPECT_EQ(place_of(faces, 0, f.corner[2], eps).corner, 2);
}

TEST(Fan, IsHollowAtHollowEdgesAndTheirEnds) {
  const FaceGraph faces(catalogue::hollow_corner());
  int hollow = 0, corners = 0;
  for (int f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      hollow += is_hollow(faces, {.face = f, .side = i});
      corners += is_hollow(faces, {.face = f, .corner = i}) && faces[f].corner[std::size_t(i)].isZero(0);
    }
  EXPECT_EQ(hollow, 2 * 3);
  EXPECT_GT(corners, 0);
}

}  // namespace
}  // namespace handhold::realtime
