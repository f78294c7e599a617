// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that touch bodies: closed forms, conservation laws, the energy book.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;
using namespace testing;

const Vector3d up = Vector3d::UnitZ();

/// Four points of the face of the cube to which `n` points, at `half` from its middle.
std::vector<Vector3d> face_points(const Vector3d& n, double half = half_edge / 2) {
  const Vector3d e1 = n.cross(Vector3d(n.y(), n.z(), n.x())), e2 = n.cross(e1);
  std::vector<Vector3d> points;
  for (const double a : {-half, half})
    for (const double b : {-half, half}) points.push_back(half_edge * n + a * e1 + b * e2);
  return points;
}

Body cube(const std::string& name, const Vector3d& position) {
  Body body = cube_scene(1).bodies[0];
  body.name = name;
  body.X_WO.p = position;
  return body;
}

/// A fixed plate whose top is z = 0; voxels of 1/512 m make its field exact, the middle is 32 of them from its faces.
Body table() {
  static const auto field = voxelize(make_box({0.25, 0.125, 0.125}), {1.0 / 512, 24.0 / 512});
  Body body;
  body.name = "table";
  body.field = field;
  body.mobility = Mobility::fixed;
  body.X_WO.p.z() = -1.0 / 16;
  body.friction = {0.5, 0.4};
  return body;
}

constexpr double mass = 0.2, k = 400;

Scene scene_of(std::vector<Body> bodies, double duration, const ContactParameters& contact = {k, 0}) {
  Scene scene;
  scene.name = "bodies";
  scene.duration = duration;
  scene.gravity.setZero();
  scene.body_contact = contact;
  scene.bodies = std::move(bodies);
  return scene;
}

Scene block_on_table(double duration, const ContactParameters& contact = {k, 0}) {
  Body block = cube("block", {0, 0, half_edge - mass * gravity / (4 * contact.stiffness)});  // m g = 4 k d
  block.samples_O = face_points(-up);
  Scene scene = scene_of({table(), block}, duration, contact);
  scene.gravity = -gravity * up;
  return scene;
}

Vector3d momentum(const Scene& scene, const Frame& frame) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].mobility != Mobility::fixed) sum += scene.bodies[i].inertia.mass * frame.bodies[i].V_WO.v;
  return sum;
}

Vector3d angular_momentum(const Scene& scene, const Frame& frame) {  // cubes: the moment is the same about every axis
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Inertia& inertia = scene.bodies[i].inertia;
    const BodyState& b = frame.bodies[i];
    sum += inertia.mass * b.X_WO.p.cross(b.V_WO.v) + inertia.about_center(0, 0) * b.V_WO.w;
  }
  return sum;
}

// Stick: x = v/w sin(w t) with w² = 4 k / m, until 4 k x = mu_s m g; then Coulomb: x'' = −mu_d g.
TEST(SeveralBodies, BlockBreaksAwayOnATable) {
  const double v = 0.3, w = std::sqrt(4 * k / mass), mu_s = 0.5, mu_d = 0.4;
  Scene scene = block_on_table(0.06);
  scene.bodies[1].mobility = Mobility::translation;
  scene.bodies[1].V_WO.v = {v, 0, 0};
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const double onset = std::asin(mu_s * gravity / (w * v)) / w, v1 = v * std::cos(w * onset);
  const double x1 = mu_s * gravity / (w * w), tau = 0.06 - onset;
  ASSERT_EQ(r.events.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(r.events[i].kind, EventKind::breakaway);
    EXPECT_NEAR(r.events[i].t, onset, 1e-9);
    EXPECT_TRUE(r.events[i].id.belongs_to_body());
    EXPECT_EQ(r.events[i].id.phalanx, 1);
    EXPECT_EQ(r.events[i].id.body, 0);
    EXPECT_EQ(r.events[i].body.X_WO.p, scene.bodies[0].X_WO.p);  // of the touched body
  }
  EXPECT_NEAR(r.frames.back().bodies[1].X_WO.p.x(), x1 + v1 * tau - 0.5 * mu_d * gravity * tau * tau, 1e-8);
  EXPECT_LT(energy_residual(r), 1e-9);
}

// Geometric mean of 0.8 and 0.2.
TEST(SeveralBodies, CombineTheirFriction) {
  Scene scene = block_on_table(0.05, {k, 4});
  scene.bodies[0].friction = {0.8, 0.8};
  scene.bodies[1].friction = {0.2, 0.2};
  scene.bodies[1].mobility = Mobility::translation;
  scene.bodies[1].V_WO.v = {0.5, 0, 0};
  const Recording r = simulate(scene, {});
  for (const ContactState& c : r.frames.back().contacts) {
    EXPECT_EQ(c.mode, Mode::slip);
    EXPECT_NEAR(c.f_W.x(), -0.4 * c.f_W.z(), 1e-12);  // f on the table: dragged along, pressed down
  }
}

/// Cube "left" with samples on its right face runs into "right", 1 mm away.
Scene collision(double speed, double right_mass, const ContactParameters& contact, double offset = 0) {
  Body left = cube("left", {0, 0, 0}), right = cube("right", {2 * half_edge + 0.001, offset, 0});
  left.samples_O = face_points(Vector3d::UnitX());
  left.V_WO.v = {speed, 0, 0};
  right.inertia.about_center *= right_mass / mass;
  right.inertia.mass = right_mass;
  return scene_of({left, right}, 0.1, contact);
}

// Elastic: w² = 4 k (1/m1 + 1/m2), half a period long; speeds of the elastic collision of two masses.
TEST(SeveralBodies, CollideElastically) {
  const double v = 0.5, m2 = 0.5;
  const Scene scene = collision(v, m2, {k, 0});
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 8u);
  const double touch = 0.001 / v, release = touch + std::acos(-1.0) / std::sqrt(4 * k * (1 / mass + 1 / m2));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(r.events[i].kind, i < 4 ? EventKind::touch : EventKind::release);
    EXPECT_NEAR(r.events[i].t, i < 4 ? touch : release, 1e-9);
  }
  const Frame& end = r.frames.back();
  EXPECT_NEAR(end.bodies[0].V_WO.v.x(), v * (mass - m2) / (mass + m2), 5e-8);
  EXPECT_NEAR(end.bodies[1].V_WO.v.x(), v * 2 * mass / (mass + m2), 5e-8);  // a hundred steps of 1e-10
  EXPECT_LT(energy_residual(r), 1e-8);
}

// Off centre, spinning, with friction and damping: momenta are kept, what is lost is dissipated, nobody does work.
TEST(SeveralBodies, KeepMomentumAndTheEnergyBook) {
  for (const double damping : {0.0, 2.0}) {
    Scene scene = collision(0.5, 0.5, {k, damping}, 0.008);  // no sample comes to an edge
    scene.bodies[0].V_WO.w = {3, 2, -4};
    scene.bodies[1].V_WO.w = {-2, 1, 3};
    const Recording r = simulate(scene, {});
    ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
    EXPECT_GE(r.events.size(), 4u);
    const Vector3d p = momentum(scene, r.frames[0]), l = angular_momentum(scene, r.frames[0]);
    for (const Frame& frame : r.frames) {
      EXPECT_LT((momentum(scene, frame) - p).norm(), 1e-13);          // sums of equal and opposite forces: round-off
      EXPECT_LT((angular_momentum(scene, frame) - l).norm(), 1e-10);  // accuracy: p × v is not linear in the state
      EXPECT_EQ(frame.energy.hand_work, 0);
    }
    EXPECT_GT(r.frames.back().energy.dissipated, 1e-4);
    EXPECT_LT(energy_residual(r), 1e-8);
  }
}

// The load F on the tray accelerates both, whatever the contact does: (M + m) x_c'' = F.
TEST(SeveralBodies, ATrayCarriesABlock) {
  const double F = 0.8;
  Scene scene = block_on_table(0.2, {k, 2});
  Body& tray = scene.bodies[0];
  tray.mobility = Mobility::translation;
  tray.inertia.mass = 0.6;
  tray.load = [=](double) { return Load{{F, 0, (0.6 + mass) * gravity}, {0, 0, 0}}; };
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const Frame& end = r.frames.back();
  const Vector3d center = (0.6 * end.bodies[0].X_WO.p + mass * end.bodies[1].X_WO.p) / (0.6 + mass);
  EXPECT_NEAR(center.x(), F / (0.6 + mass) * 0.02, 1e-10);
  for (const ContactState& c : end.contacts) EXPECT_EQ(c.mode, Mode::stick);  // 1 m/s² < mu_s g
  EXPECT_LT(energy_residual(r), 1e-9);
}

TEST(SeveralBodies, StackAtRest) {
  Scene scene = block_on_table(5, {k, 20});
  Body top = cube("top", {0.004, 0, 3 * half_edge});
  top.samples_O = face_points(-up);
  scene.bodies[1].samples_O = face_points(-up);
  scene.bodies.push_back(top);
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  double on_table = 0, on_block = 0;
  for (const ContactState& c : r.frames.back().contacts) (c.id.body == 0 ? on_table : on_block) += c.f_W.z();
  EXPECT_NEAR(on_table, -2 * mass * gravity, 1e-7);  // 5 s are 25 times the time constant of rocking
  EXPECT_NEAR(on_block, -mass * gravity, 1e-7);
  EXPECT_LT(energy_residual(r), 1e-9);
}

// Far pairs are bounded, not looked at: a fast body must not slip through.
TEST(SeveralBodies, FarBodiesDoNotMissATouch) {
  Body shot = cube("shot", {0, 0, 20});
  shot.samples_O = {{0, 0, -half_edge}};
  shot.V_WO.v = {0, 0, -100};
  const Recording r = simulate(scene_of({table(), shot}, 0.2), {});
  ASSERT_GE(r.events.size(), 1u);
  EXPECT_EQ(r.events[0].kind, EventKind::touch);
  EXPECT_NEAR(r.events[0].t, (20 - half_edge) / 100, 1e-9);
}

TEST(SeveralBodies, FixedOnesDoNotTouchEachOther) {
  Body table_2 = table();
  table_2.name = "other";
  table_2.X_WO.p.x() = 0.1;  // overlaps
  table_2.samples_O = {{0, 0, 1.0 / 16}, {0.1, 0.05, 0}};
  const Recording r = simulate(scene_of({table(), table_2}, 0.1), {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_EQ(r.frames.size(), 10u);
  for (const Frame& frame : r.frames) EXPECT_TRUE(frame.contacts.empty());
}

// One palm under two blocks: each has its own samples' forces, and events name the block.
TEST(SeveralBodies, AHandCarriesTwo) {
  Scene scene = palm_scene(0.3);
  scene.contact = {400, 0};
  scene.bodies[0].X_WO.p.x() = -0.04;
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "second";
  scene.bodies[1].X_WO.p.x() = 0.04;
  Patch patch;
  for (const double x : {-0.04, 0.04})
    for (const Vector3d& p : square(0.008)) patch.points.push_back(p + Vector3d(x, 0, 0));
  scene.hands[0] = hand_with({patch}, 0.4);
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_TRUE(r.events.empty());
  std::array<double, 2> carried{};
  for (const ContactState& c : r.frames.back().contacts) carried[c.id.body] += c.f_W.z();
  for (const double force : carried) EXPECT_NEAR(force, 0.2 * gravity, 1e-9);
}

// Two hands and two bodies at once: a hand pushes one block, that pushes the other, over a table.
TEST(SeveralBodies, PushEachOther) {
  Scene scene = block_on_table(0.4, {k, 2});
  scene.contact = {400, 2};
  Body second = scene.bodies[1];
  second.name = "second";
  second.X_WO.p.x() = 2 * half_edge + 0.002;
  scene.bodies[1].samples_O = face_points(-up);
  for (const Vector3d& p : face_points(Vector3d::UnitX())) scene.bodies[1].samples_O.push_back(p);
  scene.bodies.push_back(second);
  Patch finger;
  finger.phalanx = 5;
  for (const Vector3d& p : square(0.004)) finger.points.push_back({0, p.x(), p.y()});
  finger.pose = [](double t) {
    return Pose{Eigen::Quaterniond::Identity(), {-half_edge - 0.002 + 0.1 * t, 0, half_edge / 2}};
  };
  scene.hands.push_back(hand_with({finger}, 0.5));
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_GT(r.frames.back().bodies[2].X_WO.p.x(), 2 * half_edge + 0.02);
  EXPECT_LT(energy_residual(r), 1e-8);
  for (std::size_t i = 1; i < r.frames.size(); ++i)
    EXPECT_GE(r.frames[i].energy.dissipated, r.frames[i - 1].energy.dissipated - 1e-12);
}

}  // namespace
}  // namespace handhold::reference
