// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/scene.hpp"
#include "tests/cases/input/expect_input_error.hpp"

namespace handhold {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const VoxelField> cube() {
  static const auto field = voxelize(make_box({0.1, 0.1, 0.1}), {0.004, 0.012});
  return field;
}

std::shared_ptr<const HandMotion> still_hand(double begin, double end) {
  const auto still = [](double) { return std::array<Pose, phalanx_count>{}; };
  return std::make_shared<TraceSpline>(sample_trace("still", Side::right, anatomical_hand(), still, begin, end, 50), 0);
}

/// A cube of 0.2 kg: J = m a^2 / 6 about every axis.
Scene good_scene() {
  Scene scene;
  scene.name = "cube";
  Body body;
  body.name = "cube";
  body.field = cube();
  body.inertia = {0.2, {0, 0, 0}, Eigen::Matrix3d::Identity() * (0.2 * 0.01 / 6)};
  scene.bodies = {body};
  Hand hand;
  hand.motion = still_hand(0, 1);
  scene.hands = {hand};
  return scene;
}

/// What `spoil` does to a good scene must be refused with all of `parts`.
template <typename Spoil>
void expect_refused(const Spoil& spoil, const std::vector<std::string>& parts) {
  Scene scene = good_scene();
  spoil(scene);
  expect_input_error([&] { validate(scene); }, parts);
}

TEST(FrictionValidation, AcceptsEqualCoefficientsAndZero) {
  EXPECT_NO_THROW(validate(Friction{0.5, 0.5}));
  EXPECT_NO_THROW(validate(Friction{0, 0}));
}

TEST(FrictionValidation, RefusesDynamicAboveStatic) {
  expect_input_error([] { validate(Friction{0.2, 0.3}); }, {"mu_dynamic = 0.3", "mu_static = 0.2"});
}

TEST(FrictionValidation, RefusesNegative) {
  expect_input_error([] { validate(Friction{0.2, -0.1}); }, {"mu_dynamic = -0.1", ">= 0"});
}

TEST(FrictionValidation, RefusesNanAndInfinity) {
  expect_input_error([] { validate(Friction{nan, 0.1}); }, {"mu_static = nan"});
  expect_input_error([] { validate(Friction{0.4, nan}); }, {"mu_dynamic = nan"});
  expect_input_error([] { validate(Friction{INFINITY, 0.1}); }, {"mu_static = inf"});
}

TEST(ContactValidation, RefusesStiffnessZeroAndNegativeDamping) {
  EXPECT_NO_THROW(validate(ContactParameters{100, 0}));
  expect_input_error([] { validate(ContactParameters{0, 0.5}); }, {"stiffness 0 N/m", "> 0"});
  expect_input_error([] { validate(ContactParameters{nan, 0.5}); }, {"stiffness nan"});
  expect_input_error([] { validate(ContactParameters{100, -1}); }, {"damping -1 N s/m", ">= 0"});
}

TEST(SceneValidation, AcceptsAGoodSceneAndOneWithoutHands) {
  EXPECT_NO_THROW(validate(good_scene()));
  Scene falling = good_scene();
  falling.hands.clear();
  EXPECT_NO_THROW(validate(falling));
}

TEST(SceneValidation, RefusesNoBody) {
  expect_refused([](Scene& s) { s.bodies.clear(); }, {"scene 'cube'", "no body"});
}

TEST(SceneValidation, RefusesDurationAndGravity) {
  expect_refused([](Scene& s) { s.duration = 0; }, {"duration 0 s"});
  expect_refused([](Scene& s) { s.duration = nan; }, {"duration nan s"});
  expect_refused([](Scene& s) { s.gravity.y() = nan; }, {"gravity", "nan"});
}

TEST(SceneValidation, RefusesABodyWithoutNameOrShape) {
  expect_refused([](Scene& s) { s.bodies[0].name.clear(); }, {"body without name"});
  expect_refused([](Scene& s) { s.bodies[0].field.reset(); }, {"body 'cube'", "no shape"});
}

TEST(SceneValidation, RefusesTheSameNameTwice) {
  expect_refused([](Scene& s) { s.bodies.push_back(s.bodies[0]); }, {"body 'cube'", "taken"});
}

TEST(SceneValidation, RefusesMassThatIsNotPositive) {
  for (const double mass : {0.0, -1.0, nan, double(INFINITY)}) {
    expect_refused([&](Scene& s) { s.bodies[0].inertia.mass = mass; }, {"body 'cube'", "mass", "> 0"});
  }
}

TEST(SceneValidation, RefusesAnInertiaThatIsNotSymmetric) {
  expect_refused([](Scene& s) { s.bodies[0].inertia.about_center(0, 1) = 1e-5; }, {"symmetric"});
}

TEST(SceneValidation, RefusesAnInertiaThatIsNotPositive) {
  expect_refused([](Scene& s) { s.bodies[0].inertia.about_center.setZero(); }, {"principal moments", "> 0"});
  expect_refused([](Scene& s) { s.bodies[0].inertia.about_center(2, 2) = -1e-5; }, {"principal moments", "> 0"});
  expect_refused([](Scene& s) { s.bodies[0].inertia.about_center(2, 2) = nan; }, {"inertia must be finite"});
}

// A thin plate has Jz = Jx + Jy exactly: the limit of what a solid can have, whatever its axes.
TEST(SceneValidation, TriangleInequalityHoldsUpToAPlateAndNoFurther) {
  const Eigen::Matrix3d turn = Eigen::Quaterniond(1, 2, 3, 4).normalized().toRotationMatrix();
  const auto turned = [&](double Jz) -> Eigen::Matrix3d {
    return turn * Eigen::Vector3d(1e-4, 2e-4, Jz).asDiagonal() * turn.transpose();
  };
  Scene scene = good_scene();
  scene.bodies[0].inertia.about_center = turned(3e-4);
  EXPECT_NO_THROW(validate(scene));
  expect_refused([&](Scene& s) { s.bodies[0].inertia.about_center = turned(3.0001e-4); }, {"exceeds the sum"});
}

TEST(SceneValidation, FixedBodiesNeedNoMassAndTranslatingOnesNoInertia) {
  Scene scene = good_scene();
  scene.bodies[0].inertia = {};
  scene.bodies[0].mobility = Mobility::fixed;
  EXPECT_NO_THROW(validate(scene));
  scene.bodies[0].inertia.mass = 1;
  scene.bodies[0].mobility = Mobility::translation;
  EXPECT_NO_THROW(validate(scene));
}

TEST(SceneValidation, RefusesVelocitiesThatTheMobilityExcludes) {
  const auto move = [](Scene& s, Mobility mobility, double v, double w) {
    s.bodies[0].mobility = mobility;
    s.bodies[0].V_WO.v.x() = v;
    s.bodies[0].V_WO.w.x() = w;
  };
  expect_refused([&](Scene& s) { move(s, Mobility::fixed, 1, 0); }, {"fixed body has no velocity"});
  expect_refused([&](Scene& s) { move(s, Mobility::translation, 0, 1); }, {"no angular velocity"});
  expect_refused([&](Scene& s) { move(s, Mobility::free, nan, 0); }, {"velocity", "finite"});
}

TEST(SceneValidation, RefusesASupportThatEndsBeforeTheStart) {
  expect_refused([](Scene& s) { s.bodies[0].held_until = -1; }, {"held_until -1 s"});
}

TEST(SceneValidation, RefusesPosesThatAreNone) {
  expect_refused([](Scene& s) { s.bodies[0].X_WO.p.x() = nan; }, {"position", "finite"});
  expect_refused([](Scene& s) { s.bodies[0].X_WO.R.coeffs().setZero(); }, {"orientation of norm 0"});
  expect_refused([](Scene& s) { s.bodies[0].X_WO.R.w() = nan; }, {"orientation of norm nan"});
}

TEST(SceneValidation, NamesTheBodyWhoseFrictionIsWrong) {
  expect_refused([](Scene& s) { s.bodies[0].friction = {0.3, 0.4}; }, {"body 'cube'", "mu_dynamic = 0.4"});
}

TEST(SceneValidation, ChecksContactAndPatchOptions) {
  expect_refused([](Scene& s) { s.contact.stiffness = -1; }, {"stiffness -1"});
  expect_refused([](Scene& s) { s.patch.samples = 0; }, {"0"});
}

TEST(SceneValidation, RefusesAHandThatIsAbsentThroughout) {
  expect_refused([](Scene& s) { s.hands[0].motion = still_hand(1.5, 2); }, {"hand 0", "never present in 0 to 1 s"});
  expect_refused([](Scene& s) { s.hands[0].motion.reset(); }, {"hand 0", "no motion"});
}

TEST(SceneValidation, ChecksGivenPatches) {
  const auto give = [](Scene& s, int phalanx, std::size_t samples, std::size_t starts) {
    GivenPatch patch;
    patch.phalanx = phalanx;
    patch.p_P.resize(samples, Eigen::Vector3d::Zero());
    patch.start.resize(starts);
    s.hands[0].given.push_back(patch);
  };
  Scene good = good_scene();
  give(good, palm, 8, 8);
  give(good, 0, 1, 0);
  EXPECT_NO_THROW(validate(good));
  expect_refused([&](Scene& s) { give(s, 16, 8, 0); }, {"phalanx 16", "0 to 15"});
  expect_refused([&](Scene& s) { give(s, -1, 8, 0); }, {"phalanx -1"});
  expect_refused([&](Scene& s) { give(s, palm, 0, 0); }, {"palm", "0 samples", "1 to 32"});
  expect_refused([&](Scene& s) { give(s, palm, 33, 0); }, {"palm", "33 samples"});
  expect_refused([&](Scene& s) { give(s, palm, 8, 7); }, {"7 starts for 8 samples"});
  expect_refused([&](Scene& s) { give(s, palm, 1, 0), give(s, palm, 1, 0); }, {"two given patches on palm"});
  const auto nan_sample = [&](Scene& s) { give(s, palm, 1, 1), s.hands[0].given[0].p_P[0].x() = nan; };
  expect_refused(nan_sample, {"palm: sample", "nan"});
  const auto nan_lag = [&](Scene& s) { give(s, palm, 1, 1), s.hands[0].given[0].start[0].lag_W.x() = nan; };
  expect_refused(nan_lag, {"palm: lag", "nan"});
}

TEST(SceneValidation, RefusesWhatNoHandCouldBeNear) {
  expect_refused([](Scene& s) { s.bodies[0].inertia.mass = 1e-12; }, {"mass 1e-12 kg", "1e-06 to 10000"});
  expect_refused([](Scene& s) { s.bodies[0].X_WO.p.x() = 1e300; }, {"position", "at most 1000 m"});
  expect_refused([](Scene& s) { s.bodies[0].V_WO.v.z() = 1e200; }, {"velocity", "at most 1000 m/s"});
  expect_refused([](Scene& s) { s.contact.stiffness = 1e300; }, {"stiffness", "at most 1e+09"});
  expect_refused([](Scene& s) { s.contact.damping = 1e300; }, {"damping", "at most 1e+06"});
  expect_refused([](Scene& s) { s.duration = 1e9; }, {"duration", "a day"});
}

}  // namespace
}  // namespace handhold
