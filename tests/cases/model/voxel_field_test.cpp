// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/voxel_field.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/model/input_error.hpp"
#include "tests/cases/geometry/brute_force.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const VoxelField> coarse(const Mesh& mesh) {
  VoxelOptions options;
  options.voxel_size = brute::bounds(mesh).sizes().maxCoeff() / 40;
  options.band = 5 * options.voxel_size;
  return voxelize(mesh, options);
}

Eigen::AlignedBox3d grown(const Eigen::AlignedBox3d& box, double part) {
  const Vector3d margin = part * box.sizes();
  return {box.min() - margin, box.max() + margin};
}

class EveryShapeField : public testing::TestWithParam<std::string> {};

// Against every triangle in long double; 1e-12 of 0.1 m coordinates, amplified by thin triangles' barycentric
// coordinates.
TEST_P(EveryShapeField, ClosestPointEqualsBruteForce) {
  const Mesh mesh = make_shape(GetParam());
  const auto field = coarse(mesh);
  std::mt19937 random(11);
  for (int sample = 0; sample < 300; ++sample) {
    const Vector3d p = brute::random_in(grown(brute::bounds(mesh), sample % 3 == 0 ? 1.0 : 0.1), random);
    const double exact = brute::distance(mesh, p);
    const auto found = field->closest(p, 10);
    ASSERT_TRUE(found);
    ASSERT_NEAR(std::abs(found->distance), exact, 1e-11);
    EXPECT_NEAR((p - found->p_O).norm(), exact, 1e-11);
    EXPECT_LT(brute::distance(mesh, found->p_O), 1e-12);
    EXPECT_NEAR(found->n_O.norm(), 1, 1e-12);
    if (exact > 1e-6) {
      EXPECT_LT((found->p_O + found->distance * found->n_O - p).norm(), 1e-11);
    }
    EXPECT_FALSE(field->closest(p, 0.999 * exact - 1e-12));
    EXPECT_TRUE(field->closest(p, 1.001 * exact + 1e-12));
  }
}

// The sign by pseudonormals against the rasteriser's, which knows nothing of normals, at every node near the surface.
TEST_P(EveryShapeField, SignOfClosestPointIsOccupancy) {
  const auto field = coarse(make_shape(GetParam()));
  const Grid& grid = field->grid();
  std::size_t checked = 0;
  for (int k = 0; k < grid.size.z(); ++k) {
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x(); ++i) {
        const double stored = field->data().distance[grid.index(i, j, k)];
        if (std::abs(stored) > 1.5 * grid.spacing || std::abs(stored) < 1e-9) continue;
        const auto found = field->closest(grid.node(i, j, k), field->band());
        ASSERT_TRUE(found);
        ASSERT_EQ(found->distance < 0, field->occupied(i, j, k)) << grid.node(i, j, k).transpose();
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 1000u);
}

// Random rays against Moeller-Trumbore in long double over all triangles.
TEST_P(EveryShapeField, RayHitsWhatBruteForceHits) {
  const Mesh mesh = make_shape(GetParam());
  const auto field = coarse(mesh);
  const Eigen::AlignedBox3d around = grown(brute::bounds(mesh), 0.3);
  std::mt19937 random(5);
  int hits = 0;
  for (int sample = 0; sample < 1500; ++sample) {
    const Vector3d origin = brute::random_in(around, random);
    const Vector3d direction = sample % 4 == 0
                                   ? Vector3d((brute::random_in(field->bounds(), random) - origin).normalized())
                                   : brute::random_direction(random);
    const double exact = brute::raycast(mesh, origin, direction, 0);
    const auto hit = field->raycast(origin, direction, 1);
    ASSERT_EQ(bool(hit), std::isfinite(exact)) << origin.transpose() << " along " << direction.transpose();
    if (!hit) continue;
    ++hits;
    ASSERT_NEAR(hit->t, exact,
                1e-12 / std::max(1e-3, std::abs(hit->n_O.dot(direction))));  // a grazing hit magnifies rounding
    EXPECT_LT((origin + hit->t * direction - hit->p_O).norm(), 1e-15);
    EXPECT_FALSE(field->raycast(origin, direction, 0.999 * hit->t));
  }
  EXPECT_GT(hits, 100);
}

// Rays along axes, straight at vertices and at the middles of edges, from outside: none may slip through.
TEST_P(EveryShapeField, NoRaySlipsBetweenTriangles) {
  const Mesh mesh = make_shape(GetParam());
  const auto field = coarse(mesh);
  const auto expect_hit = [&](const Vector3d& target) {
    for (const Vector3d& from :
         {Vector3d(target + Vector3d(0.5, 0, 0)), Vector3d(0.01, 0.02, -0.7), Vector3d(0.3, -0.4, 0.2)}) {
      const double length = (target - from).norm();
      const auto hit = field->raycast(from, (target - from) / length, 1);
      ASSERT_TRUE(hit) << target.transpose() << " from " << from.transpose();
      EXPECT_LE(hit->t, length + 1e-9);
    }
  };
  std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 300);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const auto& [a, b, c] = mesh.triangles[t];
    // Aim a hair inside the solid: a silhouette vertex may be passed rightly by one rounding.
    const auto within = [&](const Vector3d& p) {
      const auto at = field->closest(p, 1);
      return Vector3d(p - 1e-9 * at->n_O);
    };
    expect_hit(within(mesh.vertices[a]));
    expect_hit(within((mesh.vertices[b] + mesh.vertices[c]) / 2));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryShapeField,
                         testing::Values("box", "sphere", "cylinder", "l_shape", "torus", "plate_with_hole", "cup",
                                         "mug", "hammer", "axe", "pawn"),
                         [](const auto& shape) { return shape.param; });

class BoxField : public testing::Test {
 protected:
  const std::shared_ptr<const VoxelField> field_ = [] {
    VoxelOptions options;
    options.voxel_size = 0.001;
    return voxelize(make_box({0.06, 0.04, 0.02}), options);
  }();
};

// Over a face the distance is linear, so the interpolant is exact: 1e-9 is the float's rounding at 12 mm.
TEST_F(BoxField, DistanceOverAFaceIsExact) {
  for (const double z : {-0.004, -0.00033, 0.0, 0.0021, 0.0112}) {
    const DistanceSample sample = field_->distance({0.0012, 0.0034, 0.01 + z});
    EXPECT_NEAR(sample.distance, z, 1e-9);
    EXPECT_LT((sample.gradient - Vector3d::UnitZ()).norm(), 1e-5);  // of values rounded to 1e-9 m over 1e-3 m
  }
}

TEST_F(BoxField, GradientIsTheInterpolants) {
  std::mt19937 random(2);
  for (int sample = 0; sample < 1000; ++sample) {
    const Vector3d p = brute::random_in(grown(field_->bounds(), 0.2), random);
    const double step = 1e-8;
    const DistanceSample at = field_->distance(p);
    for (int axis = 0; axis < 3; ++axis) {
      const double slope = (field_->distance(p + step * Vector3d::Unit(axis)).distance -
                            field_->distance(p - step * Vector3d::Unit(axis)).distance) /
                           (2 * step);
      const double place = (p[axis] - field_->grid().origin[axis]) / field_->grid().spacing;
      if (std::abs(place - std::round(place)) < 1e-4) continue;  // the gradient jumps from cell to cell
      ASSERT_NEAR(at.gradient[axis], slope, 1e-6);  // central difference of a trilinear: rounding 1e-16 / step
    }
  }
}

TEST_F(BoxField, BeyondTheBandAndOffTheGrid) {
  const double band = field_->band();
  const DistanceSample beyond = field_->distance({0, 0, 0.01 + band + 0.0015});
  EXPECT_FLOAT_EQ(float(beyond.distance), float(band));
  EXPECT_EQ(beyond.gradient, Vector3d::Zero());
  const Grid& grid = field_->grid();
  const Vector3d corner = grid.node(grid.size.x() - 1, grid.size.y() - 1, grid.size.z() - 1);
  const DistanceSample off = field_->distance(corner + Vector3d(0.3, 0.4, 0));
  EXPECT_NEAR(off.distance, band + 0.5, 1e-12);
  EXPECT_LT((off.gradient - Vector3d(0.6, 0.8, 0)).norm(), 1e-12);
  EXPECT_FLOAT_EQ(float(field_->distance(corner).distance), float(band));  // the last node belongs to the grid
  EXPECT_TRUE(std::isnan(field_->distance({NAN, 0, 0}).distance));
}

// On the surface the direction to the query does not exist: the pseudonormals of a box's features are known.
TEST_F(BoxField, NormalsOnTheSurfaceArePseudonormals) {
  const auto normal = [this](double x, double y, double z) { return field_->closest({x, y, z}, 0.01)->n_O; };
  EXPECT_LT((normal(0.001, 0.002, 0.01) - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((normal(0.03, 0.002, 0.01) - Vector3d(1, 0, 1).normalized()).norm(), 1e-12);
  EXPECT_LT((normal(-0.03, -0.02, -0.01) + Vector3d(1, 1, 1).normalized()).norm(), 1e-12);  // angle weighted: no bias
  EXPECT_LT((normal(0.03 + 2e-9, 0.002, 0.001) - Vector3d::UnitX()).norm(), 1e-6);
}

// A ray down the diagonal edge of a face hits two triangles at once.
TEST_F(BoxField, TiesGoToTheLowestTriangle) {
  const auto hit = field_->raycast({0, 0, 0.1}, {0, 0, -1}, 1);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 10);  // the top is triangles 10 and 11
  EXPECT_EQ(hit->n_O, Vector3d::UnitZ());
  EXPECT_NEAR(hit->t, 0.09, 1e-16);
  EXPECT_FALSE(field_->raycast({0, 0, 0.1}, {0, 0, 1}, 1));
  EXPECT_NEAR(field_->raycast({0, 0, 0}, {0, 0, 1}, 1)->t, 0.01, 1e-16);  // from inside
  EXPECT_EQ(field_->raycast({0.001, 0.002, 0.01}, {0, 0, -1}, 1)->t, 0);  // from the surface itself
  EXPECT_FALSE(field_->raycast({0, 0, 0.1}, {0, 0, -1}, 0.08));
}

TEST_F(BoxField, ClosestOfNothing) {
  EXPECT_FALSE(field_->closest({1, 0, 0}, 0.5));
  EXPECT_FALSE(field_->closest({NAN, 0, 0}, 1));
  EXPECT_FALSE(field_->closest({0, 0, 0}, -1));
  EXPECT_NEAR(field_->closest({100, 0, 0}, 1000)->distance, 99.97, 1e-12);
}

// Where a run that diverges may ask from: 1e14 m away the next number is 2^-6 m on, more than a cell, so that a search
// that widens cell by cell would stand still.
TEST_F(BoxField, ClosestFromVeryFar) {
  for (const double far : {1e13, 1e14, 1e15, 1e16, 1e100}) {
    const std::optional<SurfacePoint> found = field_->closest({0, 0, far}, 2 * far);
    ASSERT_TRUE(found) << far;
    EXPECT_NEAR(found->distance, far, 1e-15 * far + 0.01);
  }
}

TEST_F(BoxField, RayOfNothing) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {double(NAN), infinity, -infinity}) {
    EXPECT_FALSE(field_->raycast({bad, 0, 0}, {1, 0, 0}, 1));
    EXPECT_FALSE(field_->raycast({0, 0, 0.1}, {0, bad, -1}, 1));
  }
  EXPECT_FALSE(field_->raycast({0, 0, 0.1}, {0, 0, -1}, NAN));
}

TEST_F(BoxField, DataThatDoesNotFitIsRefused) {
  const auto refused = [this](auto spoil) {
    VoxelField::Data data = field_->data();
    spoil(data);
    EXPECT_THROW(VoxelField{data}, InputError);
  };
  refused([](auto& d) { d.distance.pop_back(); });
  refused([](auto& d) { d.occupied.pop_back(); });
  refused([](auto& d) { d.cell_start.pop_back(); });
  refused([](auto& d) { d.cell_triangles.back() = 12; });
  refused([](auto& d) { std::swap(d.cell_start[10], d.cell_start.back()); });
  refused([](auto& d) { d.mesh.triangles[0][0] = 8; });
  refused([](auto& d) { d.grid.spacing = 0; });
  refused([](auto& d) { d.band = NAN; });
}

}  // namespace
}  // namespace handhold
