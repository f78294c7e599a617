// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/phases.hpp"

#include <algorithm>

#include "realtime/world.hpp"

namespace handhold::bench {
namespace {

using realtime::PhaseClock;

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What a lap costs, by the least of many [s].
double cost_of_lap() {
  double least = 1;
  for (int i = 0; i < 1000; ++i) {
    PhaseClock clock;
    clock.begin();
    for (int k = 0; k < 10; ++k) clock.lap(realtime::Phase::hands);
    least = std::min(least, clock.seconds()[0] / 10);
  }
  return least;
}

}  // namespace

PhaseClock::Seconds time_phases(const Scene& scene, const HandFrames& hands, double frame_rate,
                                const realtime::Options& setting, int rounds) {
  const double dt = 1 / frame_rate;
  const double reading = cost_of_lap();
  std::vector<PhaseClock::Seconds> least(hands.size() - 3);
  for (int round = 0; round < rounds; ++round) {
    realtime::World world(realtime::world_def_of(scene), setting);
    PhaseClock clock;
    world.watch(&clock);
    world.observe(dt, hands[0]);
    world.observe(dt, hands[1]);
    world.start(dt, hands[2]);
    for (std::size_t k = 0; k < least.size(); ++k) {
      clock.begin();
      world.advance(dt, hands[k + 3]);
      for (std::size_t i = 0; i < least[k].size(); ++i) {
        const double seconds = clock.seconds()[i] - reading * clock.laps(realtime::Phase(i));
        least[k][i] = round == 0 ? seconds : std::min(least[k][i], seconds);
      }
    }
  }
  PhaseClock::Seconds all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<double> of_phase;
    for (const PhaseClock::Seconds& frame : least) of_phase.push_back(frame[i]);
    all[i] = std::max(median(of_phase), 0.0);
  }
  return all;
}

}  // namespace handhold::bench
