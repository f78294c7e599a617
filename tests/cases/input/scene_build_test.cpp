// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "cases/hand/moved_trace.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/input/scene/materials.hpp"
#include "cases/input/scene/scene_file.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "tests/cases/input/expect_input_error.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;

/// Every phalanx at (t, 0, 0): where a hand is tells which time it is.
Trace moving_trace(Side side) {
  const auto poses = [](double t) {
    std::array<Pose, phalanx_count> X_WP{};
    for (Pose& X : X_WP) X.p = {t, 0, 0};
    return X_WP;
  };
  return sample_trace("moving", side, anatomical_hand(), poses, -1, 4, 50);
}

class SceneBuild : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("handhold_build_") + info->name());
    fs::create_directories(folder_);
    write_trace_csv(moving_trace(Side::left), (folder_ / "left.csv").string());
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] Scene build_text(const std::string& text) const { return build(parse_scene(text, "s.toml"), folder_); }

  void expect_refused(const std::string& text, const std::vector<std::string>& parts) const {
    expect_input_error([&] { (void)build_text(text); }, parts);
  }

  fs::path folder_;
};

// Coarse voxels: the tests look at mass and pose, and voxelizing at full size would take longer.
const std::string box =
    "[[bodies]]\nname = \"box\"\nvoxel_size = 0.005\nshape = { kind = \"box\", x = 0.1, y = 0.2, z = 0.3 }\n";

TEST_F(SceneBuild, SeveralBodiesTouchWithTheirCorners) {
  const std::string fixed =
      "[[bodies]]\nname = \"table\"\nvoxel_size = 0.01\nmobility = \"fixed\"\n"
      "shape = { kind = \"box\", x = 0.5, y = 0.5, z = 0.1 }\n";
  const Scene alone = build_text(box + "density = 500\n");
  EXPECT_TRUE(alone.bodies.at(0).samples_O.empty());
  const Scene two = build_text(box + "density = 500\n" + fixed);
  EXPECT_EQ(two.bodies.at(0).samples_O.size(), 8u);
  EXPECT_TRUE(two.bodies.at(1).samples_O.empty());
  const Scene none = build_text(box + "density = 500\nsample_spacing = 0\n" + fixed);
  EXPECT_TRUE(none.bodies.at(0).samples_O.empty());
}

TEST_F(SceneBuild, BodiesHaveTheirOwnContactElement) {
  const Scene scene = build_text("[body_contact]\nstiffness = 5000\n" + box + "density = 500\n");
  EXPECT_EQ(scene.body_contact.stiffness, 5000);
  EXPECT_EQ(scene.body_contact.damping, Scene{}.body_contact.damping);
  EXPECT_EQ(scene.contact.stiffness, ContactParameters{}.stiffness);
}

// A cuboid: V = xyz, Jx = m (y² + z²) / 12.
TEST_F(SceneBuild, WeighsABoxByItsDensity) {
  const Scene scene = build_text(box + "density = 500\n");
  const Inertia& inertia = scene.bodies.at(0).inertia;
  EXPECT_NEAR(inertia.mass, 3, 1e-12);  // rounding of the volume integrals
  EXPECT_NEAR(inertia.center.norm(), 0, 1e-12);
  EXPECT_NEAR(inertia.about_center(0, 0), 3 * (0.04 + 0.09) / 12, 1e-12);
  EXPECT_NEAR(inertia.about_center(2, 2), 3 * (0.01 + 0.04) / 12, 1e-12);
}

TEST_F(SceneBuild, WeighsABoxByItsMass) {
  const Scene scene = build_text(box + "mass = 0.6\nmaterial = \"steel\"\n");
  EXPECT_EQ(scene.bodies.at(0).inertia.mass, 0.6);
  EXPECT_NEAR(scene.bodies.at(0).inertia.about_center(1, 1), 0.6 * (0.01 + 0.09) / 12, 1e-12);
}

TEST_F(SceneBuild, TakesWeightAndFrictionFromTheMaterial) {
  const Scene scene = build_text(box + "material = \"nylon\"\n");
  EXPECT_NEAR(scene.bodies.at(0).inertia.mass, 0.006 * material("nylon").density, 1e-9);
  EXPECT_EQ(scene.bodies.at(0).friction.mu_static, 0.37);
}

TEST_F(SceneBuild, GivenFrictionGoesBeforeTheMaterials) {
  const Scene scene = build_text(box + "material = \"nylon\"\nfriction = { mu_static = 0.9, mu_dynamic = 0.1 }\n");
  EXPECT_EQ(scene.bodies.at(0).friction.mu_static, 0.9);
  EXPECT_EQ(scene.bodies.at(0).friction.mu_dynamic, 0.1);
}

TEST_F(SceneBuild, PosesAndVelocitiesArrive) {
  const Scene scene = build_text(box +
                                 "mass = 1\nposition = [1, 2, 3]\norientation = [0, 0, 0, 1]\nvelocity = [4, 5, 6]\n"
                                 "angular_velocity = [7, 8, 9]\n");
  const Body& body = scene.bodies.at(0);
  EXPECT_EQ(body.X_WO.p, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(body.X_WO.R.z(), 1);
  EXPECT_EQ(body.V_WO.v, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(body.V_WO.w, Eigen::Vector3d(7, 8, 9));
}

TEST_F(SceneBuild, ReadsAMeshWithItsScale) {
  std::ofstream(folder_ / "tetrahedron.obj") << "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\n"
                                                "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const Scene scene =
      build_text("[[bodies]]\nname='t'\nmesh='tetrahedron.obj'\nscale=0.001\nvoxel_size=0.005\ndensity=600\n");
  EXPECT_NEAR(scene.bodies.at(0).inertia.mass, 0.1, 1e-9);  // 600 · 0.1³ / 6
}

// The hand is at x = time of the trace, turned by half a turn about z (x -> -x), then moved by (0, 0, 7).
TEST_F(SceneBuild, ShiftsAndMovesTheTrace) {
  const Scene scene = build_text(box +
                                 "mass = 1\n[[hands]]\ntrace = 'left.csv'\nstart = 0.5\nposition = [0, 0, 7]\n"
                                 "orientation = [0, 0, 0, 1]\n");
  const HandMotion& motion = *scene.hands.at(0).motion;
  EXPECT_EQ(motion.side(), Side::left);
  EXPECT_NEAR((motion.pose(palm, 0.25).p - Eigen::Vector3d(-0.75, 0, 7)).norm(), 0, 1e-12);
  EXPECT_NEAR((motion.twist(palm, 0.25).v - Eigen::Vector3d(-1, 0, 0)).norm(), 0, 1e-9);  // of a spline through a line
}

TEST_F(SceneBuild, OneLagServesAllSamples) {
  const Scene scene =
      build_text(box +
                 "mass = 1\n[[hands]]\ntrace = 'left.csv'\n[[hands.patches]]\nphalanx = 'palm'\n"
                 "samples = [[0, 0, 0], [0, 0, 0.01]]\nlag = [0.001, 0, 0]\nslipping = [false, true]\n");
  const GivenPatch& patch = scene.hands.at(0).given.at(0);
  EXPECT_EQ(patch.phalanx, palm);
  ASSERT_EQ(patch.start.size(), 2u);
  EXPECT_EQ(patch.start[1].lag_W.x(), 0.001);
  EXPECT_FALSE(patch.start[0].slipping);
  EXPECT_TRUE(patch.start[1].slipping);
}

TEST_F(SceneBuild, ReadsTheSameSceneFromItsOwnToml) {
  const SceneSpec spec = parse_scene(box + "mass = 1\n[[hands]]\ntrace = 'left.csv'\n", "s.toml");
  const Scene a = build(spec, folder_), b = build(parse_scene(to_toml(spec), "t.toml"), folder_);
  EXPECT_EQ(a.bodies[0].inertia.about_center, b.bodies[0].inertia.about_center);
  EXPECT_EQ(a.hands[0].motion->pose(0, 0.3).p, b.hands[0].motion->pose(0, 0.3).p);
}

TEST_F(SceneBuild, MissingMeshIsNamedWithItsLine) {
  expect_refused("[[bodies]]\nname = 'mug'\nmesh = 'nowhere.obj'\nmass = 1\n",
                 {"s.toml:3: body 'mug'", "nowhere.obj", "no such file"});
}

TEST_F(SceneBuild, MissingTraceIsNamedWithItsLine) {
  expect_refused(box + "mass = 1\n[[hands]]\nindex = 0\ntrace = 'nowhere.json'\n",
                 {"s.toml:8: hands[0]", "nowhere.json", "no such file"});
}

TEST_F(SceneBuild, AFolderIsNoFile) {
  expect_refused("[[bodies]]\nname = 'mug'\nmesh = '.'\nmass = 1\n", {"s.toml:3:", "no such file"});
}

TEST_F(SceneBuild, UnknownShapeIsNamedWithItsLine) {
  expect_refused("[[bodies]]\nname = 'a'\nmass = 1\nshape = { kind = 'blob' }\n",
                 {"s.toml:4: body 'a'", "blob", "sphere"});
  expect_refused("[[bodies]]\nname = 'a'\nmass = 1\nshape = { kind = 'box', size = 1 }\n", {"s.toml:4:", "size"});
  expect_refused("[[bodies]]\nname = 'a'\nmass = 1\nshape = { kind = 'box', x = -1 }\n", {"s.toml:4:", "-1"});
}

TEST_F(SceneBuild, AMeshThatIsNoneIsNamedWithItsLine) {
  std::ofstream(folder_ / "broken.obj") << "nothing of use\n";
  expect_refused("[[bodies]]\nname = 'a'\nmesh = 'broken.obj'\nmass = 1\n", {"s.toml:3: body 'a'", "broken.obj"});
}

TEST_F(SceneBuild, ATraceThatIsNoneIsNamedWithItsLine) {
  std::ofstream(folder_ / "broken.json") << "{ nothing";
  expect_refused(box + "mass = 1\n[[hands]]\ntrace = 'broken.json'\n", {"s.toml:7: hands[0]", "broken.json"});
}

TEST_F(SceneBuild, AHandThatTheTraceLacks) {
  expect_refused(box + "mass = 1\n[[hands]]\ntrace = 'left.csv'\nside = 'right'\n", {"s.toml:7:", "no right hand"});
  expect_refused(box + "mass = 1\n[[hands]]\ntrace = 'left.csv'\nindex = 1\n", {"s.toml:7:", "1 hands", "no index 1"});
}

TEST_F(SceneBuild, AHandThatIsNeverPresent) {
  expect_refused(box + "mass = 1\n[[hands]]\ntrace = 'left.csv'\nstart = 30\n", {"s.toml: scene 's'", "never present"});
}

TEST_F(SceneBuild, AVelocityOfWhatIsFixed) {
  expect_refused(box + "mobility = \"fixed\"\nvelocity = [1, 0, 0]\n", {"s.toml: scene 's'", "no velocity"});
}

TEST(MovedTrace, LeavesTheBitsWhenNothingMoves) {
  const Trace trace = moving_trace(Side::right), same = moved(trace, Pose{}, 0);
  EXPECT_EQ(same.t, trace.t);
  EXPECT_EQ(same.hands[0].samples[3].X_WP[2].p, trace.hands[0].samples[3].X_WP[2].p);
}

TEST(MovedTrace, LeavesLostSamplesAlone) {
  Trace trace = moving_trace(Side::right);
  trace.hands[0].samples[3].tracked = false;
  const Trace there = moved(trace, Pose{Eigen::Quaterniond::Identity(), {1, 0, 0}}, 0);
  EXPECT_EQ(there.hands[0].samples[3].X_WP[2].p, trace.hands[0].samples[3].X_WP[2].p);
  EXPECT_NEAR(there.hands[0].samples[4].X_WP[2].p.x(), trace.hands[0].samples[4].X_WP[2].p.x() + 1, 1e-15);
}

}  // namespace
}  // namespace handhold
