// SPDX-License-Identifier: GPL-3.0-or-later
// The exact triangles: what they are, how anchors go over edges, and what the voxels' spline differs by.

#include "reference/mesh_surface.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reference/spline_surface.hpp"
#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;
using namespace testing;

const double pi = std::acos(-1.0);

Options with(SurfaceModel surface) {
  Options options;
  options.surface = surface;
  return options;
}

Options exact() { return with(SurfaceModel::mesh); }

TEST(MeshSurface, KnowsABox) {
  const MeshSurface surface(cube_field());
  EXPECT_NEAR(surface.value({0.003, 0.001, half_edge + 1e-4}), 1e-4, 1e-17);
  EXPECT_NEAR(surface.value({0.003, 0.001, half_edge - 1e-13}), -1e-13, 1e-17);
  const Foot foot = surface.foot({0.003, -0.002, half_edge - 0.005});
  EXPECT_LT((foot.p_O - Vector3d(0.003, -0.002, half_edge)).norm(), 1e-17);
  EXPECT_EQ(foot.n_O, Vector3d(0, 0, 1));
  EXPECT_NEAR(foot.depth, 0.005, 1e-17);
  EXPECT_FALSE(foot.hold.caught());
}

/// Two legs, 60 mm long and 20 mm wide; the hollow edge is parallel to z.
std::shared_ptr<const VoxelField> l_field() { return voxelize(make_l_shape(0.06, 0.06, 0.02, 0.04), {1e-3, 0.012}); }

/// The hollow edge: the point of the mesh from which both faces go on.
Vector3d hollow_edge(const VoxelField& field) {
  const Vector3d low = field.bounds().min();
  return {low.x() + 0.02, low.y() + 0.02, 0};
}

// The closest surface point of one that lies diagonally behind a hollow edge is on the edge; between the two normals.
TEST(MeshSurface, CatchesAPointBehindAHollowEdge) {
  const auto field = l_field();
  const MeshSurface surface(field);
  const Vector3d edge = hollow_edge(*field), p = edge + Vector3d(-0.003, -0.004, 0.001);
  const Foot foot = surface.foot(p);
  EXPECT_LT((foot.p_O - edge - Vector3d(0, 0, 0.001)).norm(), 1e-15);
  EXPECT_LT((foot.n_O - Vector3d(0.6, 0.8, 0)).norm(), 1e-12);
  EXPECT_NEAR(foot.depth, 0.005, 1e-15);
  ASSERT_TRUE(foot.hold.caught());
  EXPECT_LT((surface.project(p, foot.hold) - foot.p_O).norm(), 1e-15);
  // The faces' normals are x and y: pulled by (-3, -4, 2) N, an anchor goes along the edge; by (3, -4, 2) N along y =
  // 0.
  const Way along = surface.way({-3, -4, 2}, foot.hold);
  EXPECT_TRUE(along.hold.caught());
  EXPECT_LT((along.w - Vector3d(0, 0, 2)).norm(), 1e-12);
  EXPECT_NEAR(along.N, 5, 1e-12);
  EXPECT_LT((along.n - Vector3d(0.6, 0.8, 0)).norm(), 1e-12);
  const Way off = surface.way({3, -4, 2}, foot.hold);
  EXPECT_FALSE(off.hold.caught());
  EXPECT_LT((off.w - Vector3d(3, 0, 2)).norm(), 1e-12);
  EXPECT_NEAR(off.N, 4, 1e-12);
  EXPECT_NEAR(surface.way({3, 4, 2}, foot.hold).N, -3, 1e-12);  // in the cone: as far as it is from the next face
}

// A body with creases is touched on its triangles, a smooth one on its voxels; the recording says which and why.
TEST(MeshSurface, IsWhatABodyWithCreasesGets) {
  const auto ball = voxelize(make_sphere(0.03, 3), {2e-3, 0.024});
  EXPECT_EQ(choose_surface(*cube_field(), SurfaceModel::automatic).model, SurfaceModel::mesh);
  EXPECT_EQ(choose_surface(*ball, SurfaceModel::automatic).model, SurfaceModel::voxels);
  EXPECT_EQ(choose_surface(*ball, SurfaceModel::mesh).model, SurfaceModel::mesh);
  const Recording r = simulate(palm_scene(0.02), {});
  EXPECT_EQ(r.provenance.at("surface"), "cube: triangles, for edges turn by up to 90 degrees");
}

// Faces of a box are exact in both: the same motion, to the integrator's accuracy.
TEST(MeshSurface, IsTheSplineOnABox) {
  for (const double damping : {0.0, 1.0}) {
    Scene scene = palm_scene(0.1, {Vector3d(-1e-3, 0, 0), true});
    scene.bodies[0].V_WO.v = {0.2, 0, 0};
    scene.contact.damping = damping;
    const Recording a = simulate(scene, with(SurfaceModel::voxels)), b = simulate(scene, exact());
    ASSERT_EQ(b.outcome, Outcome::complete) << b.note;
    ASSERT_EQ(a.events.size(), b.events.size());
    for (std::size_t i = 0; i < a.frames.size(); ++i)
      EXPECT_LT((a.frames[i].bodies[0].X_WO.p - b.frames[i].bodies[0].X_WO.p).norm(), 1e-10);
    EXPECT_LT(energy_residual(b), 1e-8);
  }
}

/// One finger sample at depth `depth` under the surface of a fixed body is led along `path`.
Scene led(std::shared_ptr<const VoxelField> field, const Motion& path, double duration, double damping) {
  Scene scene = cube_scene(duration);
  scene.bodies[0].field = std::move(field);
  scene.bodies[0].mobility = Mobility::fixed;
  scene.contact.damping = damping;
  Patch patch;
  patch.phalanx = 5;
  patch.points = {{0, 0, 0}};
  patch.pose = path;
  scene.hands.push_back(hand_with({patch}, duration + 0.1));
  return scene;
}

Motion line(const Vector3d& from, const Vector3d& velocity) {
  return [=](double t) { return Pose{Eigen::Quaterniond::Identity(), from + t * velocity}; };
}

// Undamped, the anchor trails the sample by mu_d d: it reaches the sharp edge, and the contact is released, when the
// sample is that far beyond. That the faces of a box are two triangles each is no event.
TEST(MeshSurface, ReleasesAtASharpEdge) {
  const double depth = 0.002, v = 0.1, mu = 0.4;
  const Scene scene = led(cube_field(), line({0.01, 0.003, half_edge - depth}, {v, 0.013, 0}), 0.3, 0);
  const Recording r = simulate(scene, exact());
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 2u);
  EXPECT_EQ(r.events[0].kind, EventKind::breakaway);
  EXPECT_EQ(r.events[1].kind, EventKind::release);
  const double along = v / std::hypot(v, 0.013);  // the part of the lag towards the edge
  EXPECT_NEAR(r.events[1].t, (half_edge - 0.01 + mu * depth * along) / v, 1e-9);
  EXPECT_LT(energy_residual(r), 1e-10);
}

TEST(MeshSurface, ReleasesAtACorner) {
  const double s = half_edge - 0.01, depth = 0.002;
  for (const double damping : {0.0, 0.5}) {
    const Recording r =
        simulate(led(cube_field(), line({s, s, half_edge - depth}, {0.1, 0.1, 0}), 0.3, damping), exact());
    ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
    EXPECT_EQ(r.events.back().kind, EventKind::release);
    EXPECT_LT(energy_residual(r), 1e-9);
  }
}

// Led round a prism of 24 sides at constant depth under its circle: the contact goes over every edge.
TEST(MeshSurface, GoesOverBluntEdges) {
  const double radius = 0.03, depth = 0.003, duration = 0.5, w = 2;
  const auto field = voxelize(make_cylinder(radius, 0.06, 24), {1e-3, 0.012});
  const Motion circle = [=](double t) {
    const double angle = w * t + 0.01;
    return Pose{Eigen::Quaterniond::Identity(), (radius - depth) * Vector3d(std::cos(angle), std::sin(angle), 0.1)};
  };
  for (const double damping : {0.0, 0.5}) {
    const Recording r = simulate(led(field, circle, duration, damping), exact());
    ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
    const auto count = [&](EventKind kind) {
      return std::count_if(r.events.begin(), r.events.end(), [&](const Event& e) { return e.kind == kind; });
    };
    EXPECT_EQ(count(EventKind::release), 0);
    for (const Frame& frame : r.frames) {
      ASSERT_EQ(frame.contacts.size(), 1u);
      const ContactState& c = frame.contacts[0];
      const Vector3d e = c.p_W - c.C_W + c.depth * c.n_W;
      EXPECT_LE(e.norm(), 0.5 * c.depth + 1e-9 + 0.01 * damping);
      // The normal is a face's: multiples of 15 degrees, off by half of that for where the first face begins.
      const double turn = std::atan2(c.n_W.y(), c.n_W.x()) / (pi / 12);
      EXPECT_NEAR(turn - std::floor(turn), 0.5, 1e-9);
      EXPECT_GT(c.depth, 0.0015);
    }
    EXPECT_GT(r.frames.back().contacts[0].n_W.dot(Vector3d(std::cos(0.9), std::sin(0.9), 0)), 0.95);
    EXPECT_LT(energy_residual(r), 1e-9);
  }
}

// Slides down the leg into the hollow edge: caught there, the force is k (p − C) whatever its angle; on the way back it
// breaks away at the cone of the face it came along.
TEST(MeshSurface, IsCaughtInAHollowEdge) {
  const auto field = l_field();
  const Vector3d edge = hollow_edge(*field);
  const double depth = 0.002, speed = 0.05, mu_s = 0.5;
  // 10 mm towards the edge and 3 mm beyond, then back again.
  const Motion path = [=](double t) {
    const double x = 0.01 - 0.013 * 0.5 * (1 - std::cos(2 * pi * t * speed / 0.05));
    return Pose{Eigen::Quaterniond::Identity(), edge + Vector3d(x, -depth, 0.001)};
  };
  const Scene scene = led(field, path, 1, 0);
  const Recording r = simulate(scene, exact());
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  std::vector<EventKind> kinds;
  for (const Event& event : r.events) kinds.push_back(event.kind);
  using Kind = EventKind;
  ASSERT_EQ(kinds, (std::vector<Kind>{Kind::breakaway, Kind::restick, Kind::breakaway}));
  const ContactState middle = r.frames[45].contacts[0];  // t = 0.5: 3 mm beyond, 2 mm below
  EXPECT_LT((middle.C_W - edge - Vector3d(0, 0, 0.001)).norm(), 1e-9);
  EXPECT_LT((middle.f_W - 400 * Vector3d(-0.003, -0.002, 0)).norm(), 1e-6);
  EXPECT_LT((middle.n_W - Vector3d(3, 2, 0).normalized()).norm(), 1e-6);
  EXPECT_NEAR(0.01 - 0.0065 * (1 - std::cos(2 * pi * r.events[2].t)), mu_s * depth, 1e-9);
  EXPECT_LT(energy_residual(r), 1e-10);
}

// What the voxels cost on a ball: the spline through the voxels' distances against the triangles that they were
// computed from. A spline rounds an edge that turns by a over about two voxels, so by h a / 4 = 16 µm for the 3.7
// degrees between the triangles here. Measured: worst 17.5 µm, mean 2.3 µm.
TEST(MeshSurface, DiffersFromTheSplineOnAPolyhedron) {
  const double radius = 0.03;
  const auto field = voxelize(make_sphere(radius, 4), {1e-3, 0.012});
  const MeshSurface mesh(field);
  const SplineSurface spline(field);
  double worst = 0, sum = 0;
  for (int i = 0; i < 2000; ++i) {
    const double z = -1 + (2 * i + 1) / 2000.0, turn = 2.4 * i, s = std::sqrt(1 - z * z);
    const Foot foot = mesh.foot(0.99 * radius * Vector3d(s * std::cos(turn), s * std::sin(turn), z));
    const double error = std::abs(spline.value(foot.p_O));
    worst = std::max(worst, error);
    sum += error;
  }
  RecordProperty("worst_nm", int(worst * 1e9));
  RecordProperty("mean_nm", int(sum / 2000 * 1e9));
  EXPECT_LT(worst, 2.5e-5) << "mean " << sum / 2000;
  EXPECT_GT(worst, 1e-8);  // they are two surfaces
}

}  // namespace
}  // namespace handhold::reference
