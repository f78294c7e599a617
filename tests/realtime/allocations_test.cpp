// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/realtime/allocations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "tests/realtime/scenes.hpp"

// Counts every operator new of the program, so that a frame can be shown to make none.
namespace {
std::size_t count = 0;
}
// Not inline: gcc would take the pair for plain malloc and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++count;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
// std::stable_sort asks this way; a sanitizer brings its own, whose memory std::free must not take.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace handhold::realtime {

std::size_t testing::allocations() { return count; }

namespace {

using namespace testing;  // NOLINT: this file's scenes

constexpr double dt = 1.0 / 90;
#ifdef __SANITIZE_ADDRESS__
constexpr int frames_asked = 500;  // each costs twenty times as much, and allocates where it would without
#else
constexpr int frames_asked = 10000;
#endif

/// Every scene in which engines are compared (docs/benchmarks.md).
class Frames : public ::testing::TestWithParam<std::string> {
 protected:
  catalogue::BenchmarkScene made_ = catalogue::benchmark_scene(GetParam());
  bool tower_ = std::holds_alternative<catalogue::TowerPlan>(made_.plan);
  int there_ = int(std::lround(made_.scene.duration / dt));

  /// The frame of the scene that the k-th frame shows. Grips are played forwards, and then backwards and forwards
  /// again: hands let go of what they held and come back for it. An axe that swings on through rubble costs fifty times
  /// what a frame should: where it is at the end of S4a, it stays.
  [[nodiscard]] int shown(int k) const {
    return tower_ ? std::min(k, there_) : there_ - std::abs(k % (2 * there_) - there_);
  }

  /// Allocations in `asked` frames; what the scene's own hand needs for its poses is not counted.
  [[nodiscard]] std::size_t allocated(int order, int asked) const {
    World world = started(made_.scene, {.substeps = 1, .order = order}, dt);
    std::size_t sum = 0;
    for (int k = 1; k <= asked; ++k) {
      const std::vector<HandFrame> hands = frames(made_.scene, shown(k) * dt);
      const std::size_t before = allocations();
      world.advance(dt, hands);
      sum += allocations() - before;
    }
    for (const RigidBody& body : world.bodies()) EXPECT_TRUE(body.X_WO.p.allFinite());
    return sum;
  }
};

TEST_P(Frames, AllocateNothing) { EXPECT_EQ(allocated(1, frames_asked), 0); }

/// Towers at order two are played for their blow alone: all else they do at order one, too, and they cost the most.
TEST_P(Frames, AllocateNothingAtOrderTwo) { EXPECT_EQ(allocated(2, tower_ ? frames_asked / 50 : frames_asked), 0); }

INSTANTIATE_TEST_SUITE_P(Benchmarks, Frames, ::testing::ValuesIn(catalogue::benchmark_ids()), [](const auto& made) {
  std::string name = made.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Allocations, AreCounted) {
  const std::size_t before = allocations();
  ::operator delete(::operator new(1));  // a new-expression might be left out
  EXPECT_EQ(allocations(), before + 1);
}

TEST(Allocations, NoneWithSeveralBodiesThatFall) {
  Scene scene = blocks(4, 3);
  const auto path = [](double t) -> Vector3d { return {0, 0.3 * std::clamp(t, 0.0, 1.0), 0}; };
  scene.hands = {finger(path, {0.002, -0.06, 0.035}, 1)};
  World world = started(scene, {.substeps = 1}, dt);
  std::vector<std::vector<HandFrame>> hands;
  for (int k = 0; k <= 1000; ++k) hands.push_back(frames(scene, std::min(k * dt, 1.0)));
  const std::size_t before = allocations();
  for (const auto& frame : hands) world.advance(dt, frame);
  EXPECT_EQ(allocations(), before);
  EXPECT_LT(world.bodies().back().X_WO.p.z(), 0.04);  // the top layer has come down
}

}  // namespace
}  // namespace handhold::realtime
