// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/patch.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double right_angle = 1.57079632679489662;
// Exact triangles at a place found to 1e-6 of the finger: on a flat face only rounding is left, where the search moves
// along the surface it counts with 1e-6 * 40 mm and the pull to the middle with 0.1 µm.
constexpr double flat = 1e-12;
constexpr double along = 1e-7;

/// A cube of 60 mm: its faces are at ±30 mm.
const VoxelField& cube() {
  static const std::shared_ptr<const VoxelField> field = voxelize(make_box(Vector3d::Constant(0.06)));
  return *field;
}

constexpr Capsule finger{0.02, 0.008};

/// Lies along x above the cube's top, turned by `tilt` about y so that its +z end (at +x) is the lower one.
Pose lying(double height, double tilt = 0) {
  return {Quaterniond(AngleAxisd(right_angle + tilt, Vector3d::UnitY())), {0, 0, 0.03 + height}};
}

TEST(Nearest, FingerOnAFaceIsNearestInItsMiddle) {
  const Nearest n = nearest(finger, lying(0.009), cube());
  EXPECT_NEAR(n.distance, 0.001, flat);
  EXPECT_LT((n.n_O - Vector3d::UnitZ()).norm(), flat);
  EXPECT_LT((n.axis_O - Vector3d(0, 0, 0.039)).norm(), 1e-7);  // resolution of the search: 1e-6 * 40 mm
  EXPECT_LT((n.skin_O - Vector3d(0, 0, 0.031)).norm(), 1e-7);
}

// Tilted by 0.3 rad its lower end is nearest: height - 20 mm sin 0.3 - radius.
TEST(Nearest, TiltedFingerTouchesWithItsEnd) {
  const Nearest n = nearest(finger, lying(0.015, 0.3), cube());
  EXPECT_NEAR(n.distance, 0.015 - 0.02 * std::sin(0.3) - 0.008, flat);
  EXPECT_LT((n.axis_O - Vector3d(0.02 * std::cos(0.3), 0, 0.045 - 0.02 * std::sin(0.3))).norm(), flat);
}

TEST(Nearest, InsideTheDistanceIsNegativeAndTheNormalStillOut) {
  const Nearest n = nearest(finger, lying(-0.003), cube());  // axis 3 mm below the face
  EXPECT_NEAR(n.distance, -0.003 - 0.008, flat);
  EXPECT_LT((n.n_O - Vector3d::UnitZ()).norm(), flat);
}

// Deeper than any band: the far search still finds the face. Axis at 20 mm below the top, 10 mm off the centre.
TEST(Nearest, DeepInsideIsExact) {
  const Nearest n = nearest(Capsule{0.002, 0.008}, lying(-0.02), cube());
  EXPECT_NEAR(n.distance, -0.02 - 0.008, flat);
}

// The middle of a finger across an edge of the cube: axis along x at (y, z) = (36, 36) mm, edge at (30, 30) mm.
TEST(Nearest, FingerAlongAnEdge) {
  const Pose X_OP{Quaterniond(AngleAxisd(right_angle, Vector3d::UnitY())), {0, 0.036, 0.036}};
  const Nearest n = nearest(finger, X_OP, cube());
  EXPECT_NEAR(n.distance, 0.006 * std::sqrt(2.0) - 0.008, flat);
  EXPECT_LT((n.n_O - Vector3d(0, 1, 1).normalized()).norm(), flat);
}

// Crossing a corner in space: the segment from below passes the vertical edge x = y = 30 mm at a distance of 9 mm, its
// nearest point is in between its ends: where the axis comes nearest to the edge (common perpendicular).
TEST(Nearest, NearestPointInsideTheSegment) {
  const Vector3d u = Vector3d(1, -1, 0.5).normalized();  // crosses in front of the edge
  const Vector3d foot = Vector3d(0.03, 0.03, 0) + 0.009 * Vector3d(1, 1, 0).normalized();
  const Pose X_OP{Quaterniond::FromTwoVectors(Vector3d::UnitZ(), u), foot - 0.007 * u};
  const Nearest n = nearest(finger, X_OP, cube());
  EXPECT_NEAR(n.distance, 0.001, 1e-9);  // second order in the place's 1e-6 of the length, and the pull to the middle
  // The pull to the middle (slope 1e-5 * 7/20) shifts the place by that over the curvature, about 1 / 9 mm: 3e-8 m.
  EXPECT_LT((n.axis_O - foot).norm(), along);
}

TEST(Nearest, FarAwayIsALowerBoundBeyondReach) {
  for (const double height : {0.03, 0.1, 1.0}) {
    const double truth = height - 0.008;
    const double found = nearest(finger, lying(height), cube()).distance;
    EXPECT_LE(found, truth + 1e-9);
    EXPECT_GE(found, std::min(truth, nearest_reach) - 1e-9);
  }
}

TEST(Nearest, APalmLyingOnAFace) {
  const PalmBox box{{0.04, 0.014, 0.0448}};
  // Palm down: y up in O, so that its palmar face is 1 mm above the top.
  const Pose X_OP{Quaterniond(AngleAxisd(right_angle, Vector3d::UnitX())), {0, 0, 0.03 + 0.014 + 0.001}};
  const Nearest n = nearest(box, X_OP, cube());
  EXPECT_NEAR(n.distance, 0.001, flat);
  EXPECT_LT((n.n_O - Vector3d::UnitZ()).norm(), flat);
  EXPECT_LT((n.skin_O - Vector3d(0, 0, 0.031)).norm(), 1e-6);  // resolution 1e-6 * 90 mm, centred
  EXPECT_LT((n.axis_O - Vector3d(0, 0, 0.045)).norm(), 1e-6);
}

// Tilted about its z by 0.2 rad the lower long edge is nearest: half thickness and half breadth, turned.
TEST(Nearest, ATiltedPalmTouchesWithItsEdge) {
  const PalmBox box{{0.02, 0.01, 0.02}};
  const Quaterniond down(AngleAxisd(right_angle, Vector3d::UnitX()));
  const Pose X_OP{Quaterniond(AngleAxisd(0.2, Vector3d::UnitY())) * down, {0, 0, 0.03 + 0.018}};
  const double lowest = 0.02 * std::sin(0.2) + 0.01 * std::cos(0.2);
  EXPECT_NEAR(nearest(box, X_OP, cube()).distance, 0.018 - lowest, flat);
}

TEST(Nearest, AFarPalmIsALowerBound) {
  const PalmBox box{{0.04, 0.014, 0.0448}};
  const Pose X_OP{Quaterniond::Identity(), {0, 0, 0.5}};
  const double found = nearest(box, X_OP, cube()).distance;
  EXPECT_LE(found, 0.5 - 0.03 - 0.0448);
  EXPECT_GT(found, nearest_reach);
}

Patch seed(int phalanx, const Pose& X_OP, const PatchOptions& options = {}) {
  return seed_patch(phalanx, X_OP, nearest(finger, X_OP, cube()), options);
}

TEST(SeedPatch, IsARingInTheTangentPlaneThroughTheSkin) {
  const Pose X_OP = lying(0.009);
  const Patch patch = seed(4, X_OP);
  ASSERT_EQ(patch.count, 8);
  Vector3d mean = Vector3d::Zero();
  for (int i = 0; i < 8; ++i) {
    const Vector3d p_O = X_OP * patch.p_P[static_cast<std::size_t>(i)];
    EXPECT_NEAR(p_O.z(), 0.031, 1e-12);
    EXPECT_NEAR((p_O - Vector3d(0, 0, 0.031)).norm(), 0.003, 1e-7);
    mean += p_O / 8;
  }
  EXPECT_LT((mean - Vector3d(0, 0, 0.031)).norm(), 1e-7);
  // The first lies along the phalanx, which points to +x.
  EXPECT_LT((X_OP * patch.p_P[0] - Vector3d(0.003, 0, 0.031)).norm(), 1e-7);
}

TEST(SeedPatch, ThumbAndPalmAreWider) {
  const auto radius = [](int phalanx) {
    const Patch patch = seed(phalanx, lying(0.009));
    return (patch.p_P[0] - patch.p_P[4]).norm() / 2;
  };
  EXPECT_NEAR(radius(2), 0.0045, 1e-12);
  EXPECT_NEAR(radius(3), 0.003, 1e-12);
  EXPECT_NEAR(radius(palm), 0.02, 1e-12);
}

TEST(SeedPatch, CentroidPutsTheRingAroundTheMiddle) {
  PatchOptions options;
  options.reference_point = ReferencePoint::centroid;
  const Patch patch = seed(3, lying(0.015, 0.3), options);
  EXPECT_LT((patch.p_P[0] + patch.p_P[4]).norm(), 1e-15);
}

TEST(SeedPatch, OneSampleSitsInTheMiddle) {
  PatchOptions options;
  options.samples = 1;
  const Pose X_OP = lying(0.009);
  EXPECT_LT((X_OP * seed(3, X_OP, options).p_P[0] - Vector3d(0, 0, 0.031)).norm(), 1e-7);
}

// A finger that pokes straight down: z along -n, so that x takes over as the first direction.
TEST(SeedPatch, PokingFingerHasADirectionToo) {
  const Pose X_OP{Quaterniond(AngleAxisd(2 * right_angle, Vector3d::UnitY())), {0, 0, 0.03 + 0.029}};
  const Patch patch = seed(5, X_OP);
  for (int i = 0; i < patch.count; ++i) {
    const Vector3d p_O = X_OP * patch.p_P[static_cast<std::size_t>(i)];
    EXPECT_NEAR((p_O - Vector3d(0, 0, 0.031)).norm(), 0.003, 1e-9);
  }
}

TEST(PatchOptions, RangesAreChecked) {
  EXPECT_NO_THROW(validate(PatchOptions{}));
  const auto rejects = [](auto change) {
    PatchOptions options;
    change(options);
    EXPECT_THROW(validate(options), InputError);
  };
  rejects([](PatchOptions& o) { o.samples = 0; });
  rejects([](PatchOptions& o) { o.samples = 33; });
  rejects([](PatchOptions& o) { o.finger_radius = -1; });
  rejects([](PatchOptions& o) { o.thumb_radius = std::nan(""); });
  rejects([](PatchOptions& o) { o.palm_radius = 3; });  // millimetres
  rejects([](PatchOptions& o) { o.contact_offset = 0.02; });
}

/// Radius of the largest ball about the origin inside a convex mesh around it.
double inradius(const Mesh& mesh) {
  double least = 1;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3d &a = mesh.vertices[std::size_t(i)], &b = mesh.vertices[std::size_t(j)];
    least = std::min(least, (b - a).cross(mesh.vertices[std::size_t(k)] - a).normalized().dot(a));
  }
  return least;
}

// Far away the distance is a lower bound, also of a finger that points at the object: its tip is nearer than its
// middle. No point is farther from the polyhedron than from the ball inside it; linear interpolation between nodes 4 mm
// apart overstates the convex distance by up to h² / (4 · 0.14 m) = 28 µm.
TEST(Nearest, FarAwayNeverOverstatesTheDistance) {
  const double R = 0.1;
  const Mesh ball = make_sphere(R, 4);
  const auto field = voxelize(ball, {.voxel_size = 0.004, .band = 0.048});
  const double inside = inradius(ball);
  const Capsule capsule{0.01, 0.007};
  const Eigen::Vector3d outward = Eigen::Vector3d(1, 1, 1).normalized();
  for (const Eigen::Vector3d& axis : {outward, Eigen::Vector3d(Eigen::Vector3d::UnitX()), Eigen::Vector3d(-outward)}) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
    for (double away = 0.02; away < 0.05; away += 0.001) {
      const Pose X_OP{turn, (R + away) * outward};
      double skin = 1;
      for (const double s : {-1.0, -0.5, 0.0, 0.5, 1.0})
        skin = std::min(skin, (X_OP * Eigen::Vector3d(0, 0, s * capsule.half_length)).norm() - inside - capsule.radius);
      EXPECT_LE(nearest(capsule, X_OP, *field).distance, skin + 28e-6) << away;
    }
  }
}

/// How far the points of a segment or of a box's surface, in P, are from a box about the origin: at least [m].
double least_distance(const std::vector<Vector3d>& points, const Pose& X_OP, const Vector3d& half) {
  double least = 1;
  for (const Vector3d& p : points) least = std::min(least, ((X_OP * p).cwiseAbs() - half).cwiseMax(0).norm());
  return least;
}

/// In steps of 1/50 of the half extents.
std::vector<Vector3d> surface_points(const Vector3d& half) {
  constexpr int steps = 50;
  std::vector<Vector3d> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1})
      for (int i = -steps; i <= steps; ++i)
        for (int j = -steps; j <= steps; ++j) {
          Vector3d p;
          p[axis] = side;
          p[(axis + 1) % 3] = double(i) / steps;
          p[(axis + 2) % 3] = double(j) / steps;
          points.push_back(p.cwiseProduct(half));
        }
  return points;
}

// ... in whatever direction it lies, off the grid of the voxels too. Truth: the closed form of a point and a box, the
// least of many points, which is too large at most. What `nearest` may say beyond it: its resolution (1e-6 of the
// phalanx) and, far away, the interpolation's h²/(4 · 10 mm) = 6 µm. A palm's rim is searched at half its thickness.
TEST(Nearest, FromNoDirectionIsTheDistanceOverstated) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.02, 0.08);
  const PalmBox box{{0.04, 0.001, 0.0448}};
  std::vector<Vector3d> axis;
  for (int i = -500; i <= 500; ++i) axis.emplace_back(0, 0, i * finger.half_length / 500);
  const std::vector<Vector3d> palm_points = surface_points(box.half_extents);
  for (int i = 0; i < 400; ++i) {
    const Vector3d way(normal(random), normal(random), normal(random));
    const Pose X_OP{Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized(),
                    (0.03 / way.cwiseAbs().maxCoeff() + uniform(random) / way.norm()) * way};
    const Vector3d half = Vector3d::Constant(0.03);
    EXPECT_LE(nearest(finger, X_OP, cube()).distance, least_distance(axis, X_OP, half) - finger.radius + 6e-6) << i;
    if (i % 10 != 0) continue;  // the palm's points are many
    EXPECT_LE(nearest(box, X_OP, cube()).distance, least_distance(palm_points, X_OP, half) + 6e-6) << i;
  }
}

}  // namespace
}  // namespace handhold
