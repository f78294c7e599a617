// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/face_graph.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

TEST(FaceGraph, GoesOverEachSideAndBack) {
  for (const Mesh& mesh :
       {make_box({1, 2, 3}), make_mug(), make_torus(0.05, 0.01), make_l_shape(0.08, 0.06, 0.02, 0.04)}) {
    const FaceGraph faces(mesh);
    ASSERT_EQ(faces.size(), int(mesh.triangles.size()));
    for (int f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const Face& beyond = faces[faces[f].beyond[i]];
        EXPECT_TRUE(std::ranges::count(beyond.beyond, f) == 1);
        EXPECT_NEAR(faces[f].out[i].dot(faces[f].n), 0, 1e-15);
        EXPECT_LT(faces[f].inside(i, faces[f].corner[i] + faces[f].out[i]), 0);
        EXPECT_GT(faces[f].inside(i, faces[f].corner[(i + 2) % 3]), 0);
      }
    for (int v = 0; v < int(mesh.vertices.size()); ++v)
      for (const int f : faces.around(v)) EXPECT_EQ(std::ranges::count(faces[f].vertex, v), 1);
  }
}

int creases(const Mesh& mesh) { return FaceGraph(mesh).crease_count(); }

TEST(FaceGraph, HasTheEdgesOfAnObjectAndNotThoseOfItsFacets) {
  EXPECT_EQ(creases(make_box({1, 2, 3})), 12);
  EXPECT_EQ(creases(make_cylinder(0.03, 0.06, 64)), 128);  // both rims
  EXPECT_EQ(creases(make_cylinder(0.03, 0.06, 10)), 20);
  EXPECT_EQ(creases(make_cylinder(0.03, 0.06, 6)), 18);  // a hexagon has edges
  EXPECT_EQ(creases(make_sphere(0.03, 2)), 0);
  EXPECT_EQ(creases(make_torus(0.05, 0.01, 24, 12)), 0);
  EXPECT_EQ(creases(make_cup(0.04, 0.08, 0.003, 96)), 4 * 96);  // both sides of the rim, the foot, the floor's
}

TEST(FaceGraph, TellsHollowFromConvex) {
  const FaceGraph faces(make_l_shape(0.08, 0.06, 0.02, 0.04));
  int hollow = 0, convex = 0;
  for (int f = 0; f < faces.size(); ++f)
    for (const EdgeKind kind : faces[f].edge) {
      hollow += kind == EdgeKind::hollow;
      convex += kind == EdgeKind::convex;
    }
  EXPECT_EQ(hollow, 2);  // one edge, seen from both sides
  EXPECT_EQ(convex, 2 * 17);
}

/// Two boxes that share an edge and nothing else: each face goes on in its own box, for the outside is what lies
/// between.
TEST(FaceGraph, GoesOnWhereTheOutsideEnds) {
  Mesh mesh = make_box({1, 1, 1});
  const Mesh other = make_box({1, 1, 1});
  const int count = int(mesh.vertices.size());
  for (const Vector3d& v : other.vertices) {
    const Vector3d moved = v + Vector3d(1, 1, 0);
    mesh.vertices.push_back(moved);
  }
  const auto same = [&](int v) {  // welds the shared edge x = y = 1/2
    for (int w = 0; w < count; ++w)
      if (mesh.vertices[std::size_t(w)].isApprox(mesh.vertices[std::size_t(v)])) return w;
    return v;
  };
  for (std::array<int, 3> t : other.triangles) {
    for (int& v : t) v = same(v + count);
    mesh.triangles.push_back(t);
  }
  const FaceGraph faces(mesh);
  for (int f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d middle = 0.5 * (faces[f].corner[i] + faces[f].corner[(i + 1) % 3]);
      const bool shared = middle.head<2>().isApprox(Eigen::Vector2d(0.5, 0.5));
      const bool crosses = (f < 12) != (faces[f].beyond[i] < 12);
      EXPECT_EQ(crosses, shared) << f << ' ' << i;
      if (shared) {
        EXPECT_EQ(faces[f].edge[i], EdgeKind::hollow);
      }
    }
}

}  // namespace
}  // namespace handhold
