// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/realtime/scenes.hpp"

// A grip whose friction could carry 1 % more than it must does not give way, however many phalanges take part.

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes
using catalogue::edge;
using catalogue::MovingPatch;

constexpr double margin = 1.01, mass = 0.2, weight = mass * 9.81, mu = 0.5;
constexpr int samples = 8;
const auto still = [](double) -> Vector3d { return Vector3d::Zero(); };

/// Of `phalanges` that share the weight and the normal force, each sample starts where its spring takes its share: by
/// `lag` along the weight, by `depth` along the normal.
struct Share {
  double lag, depth;
  Share(int phalanges, double stiffness) : lag(weight / (phalanges * samples * stiffness)), depth(margin * lag / mu) {}
};

/// A cube between two faces of `phalanges`, even, on a grid on its faces y = ±edge/2; at most 16 on each.
Scene gripped(int phalanges, const Share& share) {
  Scene scene;
  std::vector<std::vector<MovingPatch>> hands(phalanges > phalanx_count ? 2 : 1);
  for (int i = 0; i < phalanges; ++i) {
    const int side = i % 2, place = i / 2, of = phalanges / 2,
              columns = std::min(of, 4);  // rows are full: all bear the same
    const double apart = 0.012;           // rings of 4 mm do not meet; four of them side by side are 44 of 62.5 mm
    const double x = apart * (place % columns - 0.5 * (columns - 1));
    const double z = apart * (place / columns - 0.5 * (of / columns - 1));
    const double y = (side ? 1 : -1) * (edge / 2 - share.depth);
    const std::vector<Vector3d> points =
        catalogue::ring({x, y, z}, Vector3d::UnitY(), Vector3d::UnitZ(), 0.004, samples);
    const std::size_t hand = std::size_t(i / phalanx_count);
    hands[hand].push_back({i % phalanx_count, points, {}, still});
    hands[hand].back().start.assign(samples, {.lag_W = share.lag * Vector3d::UnitZ()});
  }
  for (const auto& patches : hands) scene.hands.push_back(catalogue::hand_of(patches, 1));
  return scene;
}

/// One phalanx alone can only press; a load presses the cube onto it and pulls sideways, both through the middle of the
/// patch, so that all samples bear the same.
Scene pressed(const Share& share) {
  Scene scene;
  scene.gravity.setZero();
  const std::vector<Vector3d> points =  // of the springs' ends, where the forces act
      catalogue::ring({0, 0, -edge / 2 + share.depth}, Vector3d::UnitZ(), Vector3d::UnitX(), 0.02, samples);
  scene.hands = {catalogue::hand_of({{palm, points, {}, still}}, 1)};
  scene.hands[0].given[0].start.assign(samples, {.lag_W = -share.lag * Vector3d::UnitX()});
  return scene;
}

Scene held_by(int phalanges) {
  const double k = 1600.0 / (phalanges * samples);  // all together as two fingertips of 100 N/m a sample
  const Share share(phalanges, k);
  Scene scene = phalanges == 1 ? pressed(share) : gripped(phalanges, share);
  scene.name = "held by " + std::to_string(phalanges);
  scene.contact = {.stiffness = k, .damping = 0.5 * k / 100};
  scene.bodies = {catalogue::block({edge, edge, edge}, catalogue::voxel, mass, {mu, mu})};
  if (phalanges > 1) return scene;
  const Vector3d force = weight * Vector3d(1, 0, -margin / mu), arm(0, 0, -edge / 2 + share.depth);
  scene.bodies[0].load = [=](double) { return Load{force, arm.cross(force)}; };
  return scene;
}

using Case = std::tuple<int, int>;  // frames a second, phalanges

class Creep : public ::testing::TestWithParam<Case> {};

/// The element sticks exactly; what may move is rounding: 1e-9 mm/s over 60 s is the bound asked for. At 1 kHz one
/// sub-step a frame is as short as a grip's own time needs by far.
TEST_P(Creep, NoneInAMinute) {
  const auto [rate, phalanges] = GetParam();
  const Scene scene = held_by(phalanges);
  World world = started(scene, {.substeps = rate < 1000 ? 4 : 1}, 1.0 / rate);
  const std::vector<HandFrame> hands = frames(scene, 0);
  for (int k = 0; k < rate; ++k) world.advance(1.0 / rate, hands);
  int sticking = 0;
  for (const Mode mode : world.contacts().mode) sticking += mode == Mode::stick;
  EXPECT_EQ(sticking, phalanges * samples);
  const Vector3d settled = world.body().X_WO.p;
  const Eigen::Quaterniond turned = world.body().X_WO.R;
  for (int k = 0; k < 60 * rate; ++k) world.advance(1.0 / rate, hands);
  EXPECT_LT((world.body().X_WO.p - settled).norm(), 60 * 1e-12);
  EXPECT_LT(world.body().X_WO.R.angularDistance(turned) * edge / 2, 60 * 1e-12);  // of the faces
}

INSTANTIATE_TEST_SUITE_P(Rates, Creep,
                         ::testing::Combine(::testing::Values(60, 90, 120, 1000), ::testing::Values(1, 2, 6, 16, 32)),
                         [](const auto& made) {
                           return std::to_string(std::get<0>(made.param)) + "Hz_" +
                                  std::to_string(std::get<1>(made.param)) + "_phalanges";
                         });

/// The bound can be missed: with 1 % less friction than it must have, the same grip gives way.
TEST(Creep, ThereIsSomeWithoutTheMargin) {
  Scene scene = held_by(6);
  scene.bodies[0].friction = {mu / margin * 0.99, mu / margin * 0.99};
  World world = started(scene, {.substeps = 4}, 1.0 / 90);
  run(world, scene, 90, 1.0 / 90);
  EXPECT_LT(world.body().X_WO.p.z(), -1e-3);
}

}  // namespace
}  // namespace handhold::realtime
