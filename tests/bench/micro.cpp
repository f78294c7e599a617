// SPDX-License-Identifier: GPL-3.0-or-later
// What one frame of the real-time path costs, against one quantity at a time (Google Benchmark).

#include <string>

#include <benchmark/benchmark.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/model/input_error.hpp"
#include "realtime/world.hpp"
#include "tests/bench/play.hpp"

namespace handhold::bench {
namespace {

constexpr double frame_rate = 90;  // [Hz]
constexpr int substeps = 4;

/// Plays the scene up to `begin` and then the frames up to `end` over and over: a whole number of shakes, so that the
/// hand comes back to where it was.
void loop(benchmark::State& state, const Scene& scene, double begin, double end) {
  try {
    const HandFrames hands = hand_frames(scene, frame_rate);
    realtime::World world(realtime::world_def_of(scene), {.substeps = substeps});
    const double dt = 1 / frame_rate;
    world.observe(dt, hands[0]);
    world.observe(dt, hands[1]);
    world.start(dt, hands[2]);
    const std::size_t first = 2 + std::size_t(begin * frame_rate + 0.5), last = 2 + std::size_t(end * frame_rate + 0.5);
    for (std::size_t k = 3; k <= first; ++k) world.advance(dt, hands[k]);
    std::size_t k = first;
    for (auto _ : state) {
      k = k == last ? first + 1 : k + 1;
      world.advance(dt, hands[k]);
    }
  } catch (const InputError& error) {
    state.SkipWithError(error.what());
  }
}

constexpr double shake_begin = 9, shake_end = 10;  // at full swing: two periods [s]

void by_phalanges(benchmark::State& state) {
  loop(state, catalogue::two_hand_grip({.phalanges = int(state.range(0))}).scene, shake_begin, shake_end);
}
BENCHMARK(by_phalanges)->ArgName("phalanges")->DenseRange(2, 32, 6)->Unit(benchmark::kMicrosecond);

void by_samples(benchmark::State& state) {
  loop(state, catalogue::two_hand_grip({.phalanges = 6, .samples = int(state.range(0))}).scene, shake_begin, shake_end);
}
BENCHMARK(by_samples)->ArgName("samples")->RangeMultiplier(2)->Range(1, 32)->Unit(benchmark::kMicrosecond);

void by_voxel_size(benchmark::State& state) {
  const double voxel = 1e-6 * double(state.range(0));
  loop(state, catalogue::two_hand_grip({.phalanges = 6, .voxel = voxel}).scene, shake_begin, shake_end);
}
BENCHMARK(by_voxel_size)->ArgName("um")->Arg(1000)->Arg(1500)->Arg(3000)->Arg(6000)->Unit(benchmark::kMicrosecond);

/// Columns of four cubes side by side, at rest.
void by_bodies(benchmark::State& state) {
  const int wide = int(state.range(0));
  state.SetLabel(std::to_string(4 * wide * wide) + " cubes");
  loop(state, catalogue::tower(wide, 4, 2).scene, 1, 2);
}
BENCHMARK(by_bodies)->ArgName("wide")->DenseRange(1, 7, 2)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace handhold::bench

BENCHMARK_MAIN();
