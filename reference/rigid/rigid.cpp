// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/rigid.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "reference/rigid/simbody_run.hpp"

namespace handhold::reference::rigid {
namespace {

constexpr double least_accuracy = 1e-13, most_accuracy = 1e-3;
constexpr double most_frames = 1e7;

}  // namespace

void validate(const Options& o) {
  if (!(o.accuracy >= least_accuracy && o.accuracy <= most_accuracy))
    throw InputError(fmt::format("accuracy={:g}: must be {:g} to {:g} (1e-10 is the default)", o.accuracy,
                                 least_accuracy, most_accuracy));
  if (!(o.max_step > 0) || !std::isfinite(o.max_step))
    throw InputError(fmt::format("max_step={} s: must be finite and > 0 (1e-3 is the default)", o.max_step));
  if (!(o.frame_rate > 0) || !std::isfinite(o.frame_rate))
    throw InputError(fmt::format("frame_rate={} Hz: must be finite and > 0 (100 is the default)", o.frame_rate));
  if (o.step_limit <= 0)
    throw InputError(fmt::format("step_limit={}: must be > 0 (twenty million is the default)", o.step_limit));
}

Trajectory simulate(const RigidProblem& problem, const Options& options,
                    const std::function<bool(double t)>& progress) {
  validate(options);
  validate(problem);
  if (problem.duration * options.frame_rate > most_frames)
    throw InputError(fmt::format("frame_rate={} Hz for {} s: more than {:g} frames (choose a lower rate)",
                                 options.frame_rate, problem.duration, most_frames));
  return simbody::simulate(problem, options, progress);
}

}  // namespace handhold::reference::rigid
