// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reference.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cases/model/frame_times.hpp"
#include "cases/model/input_error.hpp"
#include "reference/simbody_world.hpp"

namespace handhold::reference {
namespace {

constexpr double least_accuracy = 1e-13;  // below it, round-off stops the integrator
constexpr double most_accuracy = 1e-3;    // above it, events are missed (measured)
constexpr double most_frames = 1e7;

void check_scene(const Scene& scene, const Options& options) {
  validate(scene);
  if (!options.frame_times.empty()) validate_frames(options.frame_times, scene.duration);
  if (options.frame_times.empty() && scene.duration * options.frame_rate > most_frames)
    throw InputError(fmt::format("frame_rate={} Hz for {} s: more than {:g} frames (choose a lower rate)",
                                 options.frame_rate, scene.duration, most_frames));
}

}  // namespace

Options preset(std::string_view name) {
  if (name == "reference") return {};
  if (name == "gold") return {.accuracy = 1e-12, .max_step = 5e-4};
  throw InputError(fmt::format("preset '{}': no such preset (there are reference, gold)", name));
}

void validate(const Options& options) {
  if (!(options.accuracy >= least_accuracy && options.accuracy <= most_accuracy))
    throw InputError(fmt::format("accuracy={:g}: must be {:g} to {:g} (1e-10 is the default)", options.accuracy,
                                 least_accuracy, most_accuracy));
  if (!(options.max_step > 0) || !std::isfinite(options.max_step))
    throw InputError(fmt::format("max_step={} s: must be finite and > 0 (1e-3 is the default)", options.max_step));
  if (!(options.frame_rate > 0) || !std::isfinite(options.frame_rate))
    throw InputError(fmt::format("frame_rate={} Hz: must be finite and > 0 (90 is the default)", options.frame_rate));
  if (options.step_limit <= 0)
    throw InputError(fmt::format("step_limit={}: must be > 0 (twenty million is the default)", options.step_limit));
}

Recording simulate(const Scene& scene, const Options& options, const std::function<bool(double t)>& progress) {
  validate(options);
  check_scene(scene, options);
  return simbody::simulate(scene, options, progress);
}

}  // namespace handhold::reference
