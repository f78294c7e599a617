// SPDX-License-Identifier: Apache-2.0
#include "realtime/baselines/pinch_state.hpp"

#include <cmath>
#include <string>

#include "cases/model/input_error.hpp"

namespace handhold::realtime::baselines {
namespace {

constexpr std::size_t tip(int finger) { return std::size_t(3 * finger + 2); }

}  // namespace

void validate(const PinchStateOptions& o) {
  const auto require = [](bool holds, const char* what, double given, const char* rule) {
    if (!holds) throw InputError("pinch state: " + std::string(what) + "=" + std::to_string(given) + ": " + rule);
  };
  require(std::isfinite(o.grasp_distance), "grasp_distance", o.grasp_distance, "must be finite (try 0.001 m)");
  require(o.release_distance > o.grasp_distance && o.release_distance < nearest_reach, "release_distance",
          o.release_distance, "must be above grasp_distance and below 0.01 m (try 0.006)");
  require(std::abs(o.opposition) <= 1, "opposition", o.opposition, "must be a cosine (try 0.3)");
}

PinchState::PinchState(const Scene& scene, const PinchStateOptions& options)
    : Baseline(scene), options_(options), finger_(scene.bodies.size(), 1) {
  validate(options);
}

bool PinchState::grasps(std::size_t body, std::size_t, const HandFrame&, const Nearnesses& near) {
  const Nearness& thumb = near[tip(0)];
  if (thumb.distance > options_.grasp_distance) return false;
  for (int finger = 1; finger < 5; ++finger) {
    const Nearness& place = near[tip(finger)];
    if (place.distance > options_.grasp_distance) continue;
    if (-thumb.n_W.dot(place.n_W) < options_.opposition) continue;
    finger_[body] = finger;
    return true;
  }
  return false;
}

bool PinchState::releases(std::size_t body, std::size_t, const HandFrame&, const Nearnesses& near) {
  return near[tip(0)].distance > options_.release_distance ||
         near[tip(finger_[body])].distance > options_.release_distance;
}

Pose PinchState::grip_frame(std::size_t body, const HandFrame& frame) const {
  return {frame.X_WP[palm].R, (frame.X_WP[tip(0)].p + frame.X_WP[tip(finger_[body])].p) / 2};
}

}  // namespace handhold::realtime::baselines
