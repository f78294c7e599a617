// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/horizon.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::compare {
namespace {

Scene one_box(Mobility mobility) {
  Scene scene;
  scene.duration = 2;
  Body body;
  body.name = "box";
  body.mobility = mobility;
  body.field = voxelize(make_box(Eigen::Vector3d::Constant(0.06)), {.voxel_size = 0.005});
  scene.bodies = {body};
  return scene;
}

/// Balances on a point: what it starts aside grows as exp(rate t). Knows the closed form of its own horizon.
class Pencil : public Engine {
 public:
  explicit Pencil(double rate) : rate_(rate) {}
  [[nodiscard]] EngineInfo info(const EngineOptions&) const override { return {.name = "pencil"}; }
  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options, const Progress&) const override {
    const Scene& scene = std::get<Scene>(problem);
    Recording r;
    for (int i = 0; i <= int(scene.duration * options.frame_rate); ++i) {
      const double t = i / options.frame_rate;
      BodyState body;
      body.X_WO.p = std::exp(rate_ * t) * scene.bodies[0].X_WO.p;
      r.frames.push_back({.t = t, .bodies = {body}});
    }
    return r;
  }

 private:
  double rate_;
};

TEST(Horizon, IsWhereTheShiftHasGrownAThousandfold) {
  const Scene scene = one_box(Mobility::free);
  const EngineOptions options{.frame_rate = 100};
  const double rate = 10;
  const Pencil engine(rate);
  const Horizon h = horizon(scene, engine, options, engine.play(scene, options, {}));
  EXPECT_TRUE(h.forks);
  EXPECT_NEAR(h.t, std::log(horizon_fork / horizon_shift) / rate, 1 / options.frame_rate);
  EXPECT_LE(h.apart, horizon_fork);
  EXPECT_GT(h.apart, horizon_fork * std::exp(-2 * rate / options.frame_rate));
}

TEST(Horizon, IsTheEndWhereAShiftIsOnlyKept) {
  const Scene scene = one_box(Mobility::free);
  const EngineOptions options{.frame_rate = 100};
  const Pencil engine(0);
  const Horizon h = horizon(scene, engine, options, engine.play(scene, options, {}));
  EXPECT_FALSE(h.forks);
  EXPECT_EQ(h.t, 2);
  EXPECT_NEAR(h.apart, horizon_shift, 1e-20);
}

TEST(Horizon, SeesATurnByWhatItMovesTheBody) {
  const Scene scene = one_box(Mobility::free);
  Recording a;
  a.frames = {{.t = 0, .bodies = {BodyState{}}}, {.t = 1, .bodies = {BodyState{}}}};
  Recording b = a;
  const double corner = 0.03 * std::sqrt(3.0);
  b.frames[1].bodies[0].X_WO.R = Eigen::AngleAxisd(0.9 * horizon_fork / corner, Eigen::Vector3d::UnitX());
  EXPECT_FALSE(horizon(scene, a, b).forks);
  b.frames[1].bodies[0].X_WO.R = Eigen::AngleAxisd(1.1 * horizon_fork / corner, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(horizon(scene, a, b).forks);
  EXPECT_EQ(horizon(scene, a, b).t, 0);
}

// What a run does not show, nobody can rely on.
TEST(Horizon, EndsWhereARunEnds) {
  const Scene scene = one_box(Mobility::free);
  Recording a;
  for (int i = 0; i < 3; ++i) a.frames.push_back({.t = double(i), .bodies = {BodyState{}}});
  Recording b = a;
  b.frames.pop_back();
  EXPECT_EQ(horizon(scene, a, b).t, 1);
  b.frames[1].bodies[0].X_WO.p.x() = std::nan("");
  EXPECT_EQ(horizon(scene, a, b).t, 0);
}

}  // namespace
}  // namespace handhold::compare
