// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/surface_samples.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

TEST(SurfaceSamples, ABoxOfThatEdgeGetsItsCorners) {
  const auto points = surface_samples(make_box({0.04, 0.04, 0.04}), 0.04);
  ASSERT_EQ(points.size(), 8u);
  for (const auto& p : points) EXPECT_NEAR(p.cwiseAbs().minCoeff(), 0.02, 1e-15);
}

TEST(SurfaceSamples, HalfTheEdgeAddsMiddlesOfEdgesAndFaces) {  // counted by hand: 8 corners, 12 edges, 6 faces
  EXPECT_EQ(surface_samples(make_box({0.04, 0.04, 0.04}), 0.02).size(), 26u);
}

TEST(SurfaceSamples, CoverASphereEvenly) {
  const double spacing = 0.015;
  const auto points = surface_samples(make_sphere(0.03, 4), spacing);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].norm(), 0.03, 1e-3);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE((points[i] - points[j]).norm(), 0.75 * spacing);
  }
  // Discs of half the least distance cannot overlap, discs of the whole distance must cover: 4 R^2 / d^2 is between.
  EXPECT_GE(points.size(), std::size_t(4 * std::pow(0.03 / spacing, 2)));
  EXPECT_LE(points.size(), std::size_t(16 * std::pow(0.03 / (0.75 * spacing), 2)));
}

TEST(SurfaceSamples, RefusesWhatCannotBe) {
  EXPECT_THROW((void)surface_samples(make_box({1, 1, 1}), 0), InputError);
  EXPECT_THROW((void)surface_samples(make_box({1, 1, 1}), std::nan("")), InputError);
  EXPECT_THROW((void)surface_samples(make_sphere(0.03, 4), 1e-3), InputError);
}

}  // namespace
}  // namespace handhold
