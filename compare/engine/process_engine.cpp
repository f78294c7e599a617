// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/process_engine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::compare {
namespace {

constexpr double probe_step = 1.0 / 360;  // of the run of one step that asks whether a problem can be expressed [s]

class ProcessEngine : public Engine {
 public:
  ProcessEngine(std::string name, ProcessOptions options) : name_(std::move(name)), options_(std::move(options)) {}

  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = name_,
            .version = "as its recordings say",
            .levels = {Level::rigid},
            .errs = {.kind = ErrorModel::Kind::foreign, .step = step(options)},
            .settings = {{"command", options_.command},
                         {"step", fmt::format("{} s", step(options))},
                         {"time limit", fmt::format("{} s", options_.time_limit)}}};
  }

  [[nodiscard]] std::string why_not(const Problem& problem) const override {
    try {
      RigidProblem brief = std::get<RigidProblem>(problem);
      static_cast<void>(
          sample(brief, "probe", probe_step));  // the whole load: a part of it may not show that it follows
      brief.duration = probe_step;
      return play_in_process(sample(brief, "probe", probe_step), options_).not_asked;
    } catch (const InputError& error) {
      return error.what();
    }
  }

  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options, const Progress&) const override {
    if (!options.frame_times.empty())
      throw InputError(
          fmt::format("engine '{}': has a fixed step, and frame times were given (give a frame rate)", name_));
    const SampledProblem sampled = sample(std::get<RigidProblem>(problem), "problem", step(options), options.substeps);
    ProcessAnswer answer = play_in_process(sampled, options_);
    if (answer.recording) return std::move(*answer.recording);
    const std::string note = answer.fault.empty() ? "not asked: " + answer.not_asked : answer.fault;
    return {.engine = name_, .scene = sampled.name, .outcome = Outcome::stalled, .note = note, .body_names = {"body"}};
  }

 private:
  [[nodiscard]] static double step(const EngineOptions& options) { return 1 / (options.frame_rate * options.substeps); }

  std::string name_;
  ProcessOptions options_;
};

RigidProblem sliding_block() {
  RigidProblem problem;
  problem.mass = 0.2;
  problem.mobility = Mobility::translation;
  problem.V_WB.v.x() = 0.8;
  problem.supports = {
      {.surface = make_plane(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()), .friction = {0.4, 0.4}}};
  problem.duration = 0.1;
  return problem;
}

RigidProblem pressed_block() {
  RigidProblem problem = sliding_block();
  problem.V_WB.v.setZero();
  problem.supports.clear();
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d foot(0, 0.03 * side, 0), inward(0, -side, 0);
    problem.supports.push_back({.surface = make_plane(foot, inward),
                                .normal_force = [](double) { return 5.0; },
                                .friction = {0.4, 0.4},
                                .point_B = foot});
  }
  return problem;
}

}  // namespace

std::unique_ptr<Engine> make_process_engine(const std::string& name, const ProcessOptions& options) {
  return std::make_unique<ProcessEngine>(name, options);
}

std::unique_ptr<Engine> process_engine_from(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(fmt::format("'{}': must be NAME=COMMAND (as in mine=python3 mine.py {{problem}} {{out}})", text));
  const ProcessOptions options{.command = text.substr(equals + 1)};
  validate(options);
  return make_process_engine(text.substr(0, equals), options);
}

std::vector<std::string> what_is_missing(const ProcessOptions& options) {
  std::vector<std::string> missing;
  for (const auto& [what, problem] :
       {std::pair("a block that slides", sliding_block()), std::pair("a block that is pressed", pressed_block())}) {
    const ProcessAnswer answer = play_in_process(sample(problem, "check", 1.0 / 360), options);
    if (!answer.not_asked.empty()) missing.push_back(fmt::format("{}: not asked: {}", what, answer.not_asked));
    if (!answer.fault.empty()) missing.push_back(fmt::format("{}: {}", what, answer.fault));
  }
  return missing;
}

}  // namespace handhold::compare
