// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/play.hpp"

#include <chrono>
#include <cmath>

#include "realtime/world.hpp"

namespace handhold::bench {

HandFrames hand_frames(const Scene& scene, double frame_rate) {
  const long frames = std::lround(scene.duration * frame_rate);
  HandFrames all;
  for (long k = -2; k <= frames; ++k) {
    const double t = double(k) / frame_rate;
    std::vector<HandFrame>& now = all.emplace_back(scene.hands.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      const HandMotion& motion = *scene.hands[i].motion;
      now[i].present = motion.present(t);
      if (!now[i].present) continue;
      for (int p = 0; p < phalanx_count; ++p) now[i].X_WP[std::size_t(p)] = motion.pose(p, t);
    }
  }
  return all;
}

std::vector<double> play_realtime(const Scene& scene, const HandFrames& hands, double frame_rate,
                                  const realtime::Options& setting) {
  const double dt = 1 / frame_rate;
  realtime::World world(realtime::world_def_of(scene), setting);
  world.observe(dt, hands[0]);
  world.observe(dt, hands[1]);
  world.start(dt, hands[2]);
  std::vector<double> seconds;
  seconds.reserve(hands.size());
  for (std::size_t k = 3; k < hands.size(); ++k) {
    const auto begin = std::chrono::steady_clock::now();
    world.advance(dt, hands[k]);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return seconds;
}

}  // namespace handhold::bench
