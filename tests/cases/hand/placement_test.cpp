// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/placement.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/grasp_places.hpp"
#include "cases/hand/grip.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/input/mesh/mesh_import.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "tests/cases/input/expect_input_error.hpp"
#include "tests/shared_data.hpp"

namespace handhold {
namespace {

constexpr double begin = 0, end = 2;

/// Gap between the skins of thumb and index: 100 mm open, closes linearly over 0.5 to 1 s, stays `least` until 1.6 s,
/// opens.
double gap_at(double t, double least) {
  const double open = 0.1;
  if (t < 0.5) return open;
  if (t < 1) return open + (least - open) * (t - 0.5) / 0.5;
  if (t < 1.6) return least;
  return std::min(open, least + (t - 1.6) * 0.3);
}

/// Thumb and index tips stand along z, opposite on the x axis about (0.2, 0.1, 0.3); everything else is a metre away.
Trace pinch(double least) {
  const HandModel model = anatomical_hand();
  const double r_thumb = model.capsules[last_phalanx(0)].radius, r_index = model.capsules[last_phalanx(1)].radius;
  const auto poses = [=](double t) {
    std::array<Pose, phalanx_count> X_WP{};
    for (Pose& X : X_WP) X.p = {0, 0, -1};
    X_WP[last_phalanx(0)].p = {0.2 - gap_at(t, least) / 2 - r_thumb, 0.1, 0.3};
    X_WP[last_phalanx(1)].p = {0.2 + gap_at(t, least) / 2 + r_index, 0.1, 0.3};
    return X_WP;
  };
  return sample_trace("pinch", Side::right, model, poses, begin, end, 200);
}

double depth_of(const Placement& placement, int phalanx) {
  for (const Touch& touch : placement.touches) {
    if (touch.phalanx == phalanx) return touch.depth;
  }
  return 0;
}

TEST(Grip, MeasuresTheGapBetweenTheTips) {
  const TraceSpline motion(pinch(0.02), 0);
  const Grip grip = grip_at(motion, 1, 0.25);
  EXPECT_NEAR(grip.gap, 0.1, 1e-9);  // built so; the splines of a constant are constant
  EXPECT_NEAR((grip.middle_W - Eigen::Vector3d(0.2, 0.1, 0.3)).norm(), 0, 1e-9);
  EXPECT_NEAR((grip.axis_W - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-9);
}

TEST(Grip, FindsTheClosing) {
  const TraceSpline motion(pinch(0.02), 0);
  const auto grips = sample_grips(motion, 1, motion.presence().at(0), 0.005);
  const auto closings = find_closings(grips, 1, 0.03, 0.05);
  ASSERT_EQ(closings.size(), 1u);
  EXPECT_NEAR(closings[0].begin, 0.5 + 0.5 * 70 / 80, 0.006);  // where the ramp passes 30 mm, to one tick
  EXPECT_NEAR(closings[0].end, 1.6 + 0.01 / 0.3, 0.006);
  EXPECT_TRUE(find_closings(grips, 1, 0.03, 0.2).empty());  // never as open as that before
  EXPECT_TRUE(find_closings(grips, 1, 0.01, 0.05).empty());
}

TEST(Grip, AHandClosedFromTheStartIsNoClosing) {
  std::vector<Grip> grips(10);
  for (std::size_t i = 0; i < grips.size(); ++i) grips[i].t = double(i), grips[i].gap = 0.01;
  EXPECT_TRUE(find_closings(grips, 1, 0.02, 0.05).empty());
}

// A box is 20, 60 and 80 mm thick, faces opposite each other exactly.
TEST(GraspPlaces, AreTheFacesOfABox) {
  const auto field = voxelize(make_box({0.02, 0.06, 0.08}), {0.002, 0.008});
  const auto places = find_grasp_places(*field, 0.07, 200);
  EXPECT_GT(places.size(), 100u);  // the faces of 20 and 60 mm have 86 % of the area
  for (const GraspPlace& place : places) {
    const bool thin = std::abs(place.n_O.x()) > 0.5;
    EXPECT_NEAR(place.thickness, thin ? 0.02 : 0.06, 1e-9);
    EXPECT_NEAR(place.opposition, 1, 1e-12);
    EXPECT_NEAR(place.center_O.dot(place.n_O), 0, 1e-9);
  }
}

TEST(Placement, PutsABoxBetweenTheTips) {
  const auto field = voxelize(make_box({0.03, 0.05, 0.07}), {0.002, 0.008});
  const Placement placement = place_in_hand(pinch(0.02), 0, *field);
  EXPECT_EQ(placement.finger, 1);
  // 30 mm is thinnest, so it lies along x; closure where the gap is 30 - 8 = 22 mm, at 0.9875 s; one tick of 5 ms
  // closes by 0.8 mm, so that depths are 4 to 4.4 mm.
  EXPECT_NEAR(placement.thickness, 0.03, 1e-9);
  EXPECT_NEAR(placement.closure, 0.9875, 0.006);
  EXPECT_NEAR(std::abs((placement.X_WO.R * Eigen::Vector3d::UnitX()).x()), 1, 1e-9);
  EXPECT_NEAR(placement.X_WO.p.x(), 0.2, 1e-4);
  EXPECT_NEAR(depth_of(placement, last_phalanx(0)), 0.0042, 0.0003);
  EXPECT_NEAR(depth_of(placement, last_phalanx(1)), depth_of(placement, last_phalanx(0)), 1e-6);
  EXPECT_NEAR(placement.opposition, 1, 1e-9);
  EXPECT_EQ(placement.excess, 0);
  EXPECT_EQ(placement.touches.size(), 2u);
  EXPECT_EQ(placement.note, "");
}

TEST(Placement, StartsClearAndHoldsUntilAfterClosure) {
  const auto field = voxelize(make_box({0.03, 0.05, 0.07}), {0.002, 0.008});
  const PlacementOptions options;
  const Placement placement = place_in_hand(pinch(0.02), 0, *field, options);
  EXPECT_NEAR(placement.held_until - placement.closure, options.hold, 1e-12);
  // 5 mm of air a side is a gap of 40 mm, at 0.875 s; searched every 10 ms, then the lead of 50 ms.
  EXPECT_NEAR(placement.start, 0.875 - 0.05, 0.0101);
}

TEST(Placement, KeepsASphereUprightBetweenTheTips) {
  const auto field = voxelize(make_sphere(0.02), {0.002, 0.008});
  const Placement placement = place_in_hand(pinch(0.02), 0, *field);
  EXPECT_GT(depth_of(placement, last_phalanx(0)), 0.002);
  EXPECT_LT(depth_of(placement, last_phalanx(0)), 0.008);
  EXPECT_NEAR(depth_of(placement, last_phalanx(1)), depth_of(placement, last_phalanx(0)), 5e-4);
  EXPECT_GT(placement.opposition, 0.95);
}

/// A prism along z with a triangle 40 mm wide and 75 mm high (30 degrees at the edge): no two faces are parallel within
/// reach.
Mesh wedge() {
  Mesh mesh;
  for (const double z : {-0.08, 0.08}) {
    mesh.vertices.insert(mesh.vertices.end(), {{-0.02, 0, z}, {0.02, 0, z}, {0, 0.075, z}});
  }
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return mesh;
}

// Laid in the middle of the grip, oblique faces meet the tips at different depths; only moving the wedge evens them
// out.
TEST(Placement, MovesAnUnevenObjectUntilBothTipsAreAsDeep) {
  const Placement placement = place_in_hand(pinch(0.015), 0, *voxelize(wedge(), {0.002, 0.008}));
  EXPECT_NEAR(depth_of(placement, last_phalanx(1)), depth_of(placement, last_phalanx(0)), 1e-5) << placement.report();
  EXPECT_GT(depth_of(placement, last_phalanx(0)), 0.002) << placement.report();
  EXPECT_NEAR(placement.opposition, std::cos(2 * std::atan(20.0 / 75)), 1e-6);  // of the two faces
}

// The hand closes to 20 mm; on 60 mm that is (60 - 20) / 2 = 20 mm a side, 12 more than the 8 that are wanted. The mean
// is over the closing, whose ramps from 52 mm raise it.
TEST(Placement, SaysWhenTheHandClosesTooFar) {
  const auto field = voxelize(make_box({0.06, 0.07, 0.08}), {0.002, 0.008});
  const Placement placement = place_in_hand(pinch(0.02), 0, *field);
  EXPECT_GT(placement.excess, 0.006);
  EXPECT_LT(placement.excess, 0.012);
  EXPECT_NE(placement.note.find("too far"), std::string::npos);
  EXPECT_NEAR(depth_of(placement, last_phalanx(0)), 0.0042, 0.0003);  // at closure all is well
}

TEST(Placement, IsTheSameEveryTime) {
  const auto field = voxelize(make_cylinder(0.015, 0.08), {0.002, 0.008});
  const Placement a = place_in_hand(pinch(0.02), 0, *field), b = place_in_hand(pinch(0.02), 0, *field);
  EXPECT_EQ(a.X_WO.p, b.X_WO.p);
  EXPECT_EQ(a.X_WO.R.coeffs(), b.X_WO.R.coeffs());
  EXPECT_EQ(a.report(), b.report());
}

TEST(Placement, RefusesWhatTheHandNeverClosesOn) {
  const auto thin = voxelize(make_box({0.01, 0.2, 0.2}), {0.002, 0.008});  // the gap stays at 20 mm
  expect_input_error([&] { (void)place_in_hand(pinch(0.02), 0, *thin); }, {"'pinch'", "never closes", "--place"});
  const auto huge = voxelize(make_box({0.2, 0.2, 0.2}), {0.004, 0.012});  // wider than the hand opens
  expect_input_error([&] { (void)place_in_hand(pinch(0.02), 0, *huge); }, {"never closes"});
}

// Microseconds read as seconds: searching days of motion every 5 ms took all memory.
TEST(Placement, RefusesATraceOfDays) {
  const auto field = voxelize(make_box({0.03, 0.05, 0.07}), {0.002, 0.008});
  Trace trace = pinch(0.02);
  for (double& t : trace.t) t *= 1e6;
  expect_input_error([&] { (void)place_in_hand(trace, 0, *field); }, {"at most 3600 s", "unit of time"});
}

TEST(Placement, RefusesWrongOptionsAndHands) {
  const auto field = voxelize(make_box({0.03, 0.05, 0.07}), {0.004, 0.012});
  PlacementOptions options;
  options.depth = 0.01;
  expect_input_error([&] { (void)place_in_hand(pinch(0.02), 0, *field, options); }, {"depth 0.01 m", "most_depth"});
  options.depth = NAN;
  expect_input_error([&] { validate(options); }, {"nan"});
  expect_input_error([&] { (void)place_in_hand(pinch(0.02), 1, *field); }, {"1 hands", "no hand 1"});
}

// A real grasp: the mug must be taken by the thumb from one side and by a finger from the other.
TEST(Placement, PutsAMugIntoARecordedGrab) {
  const std::string trace = test::shared_data("traces/leapjs/grab.json.lz");
  const std::string mesh = test::shared_data("meshes/mug_grab.obj");
  if (!std::filesystem::exists(trace) || !std::filesystem::exists(mesh))
    GTEST_SKIP() << "no shared data beside the repository";
  const Placement placement = place_in_hand(read_trace(trace), 0, *voxelize(import_mesh(mesh).mesh, {0.0015, 0.006}));
  for (const int phalanx : {last_phalanx(0), last_phalanx(placement.finger)}) {
    EXPECT_GT(depth_of(placement, phalanx), 0.002) << placement.report();
    EXPECT_LT(depth_of(placement, phalanx), 0.008) << placement.report();
  }
  EXPECT_GT(placement.opposition, 0.8) << placement.report();  // what a place of the surface must have
  EXPECT_LT(depth_of(placement, palm), 0.005) << placement.report();
  EXPECT_LT(placement.start, placement.closure);
}

TEST(ParsePlacement, ReadsPositionAndQuaternion) {
  EXPECT_EQ(parse_placement("1, -2.5,3e-1").p, Eigen::Vector3d(1, -2.5, 0.3));
  EXPECT_EQ(parse_placement("1,2,3").R.w(), 1);
  EXPECT_NEAR(parse_placement("1,2,3,0.7071,0.7071,0,0").R.x(), std::sqrt(0.5), 1e-15);
}

TEST(ParsePlacement, RefusesEverythingElse) {
  for (const char* text : {"", "1,2", "1,2,3,4", "a,b,c", "1,2,3,", "1,,3", "1,2,nan", "1,2,inf", "1,2,3,1,1,0,0",
                           "1,2,3,0,0,0,0", "1,2,3mm"}) {
    expect_input_error([&] { (void)parse_placement(text); }, {std::string("place '") + text + "'"});
  }
}

}  // namespace
}  // namespace handhold
