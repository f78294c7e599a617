// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "compare/engine/engine.hpp"
#include "reference/rigid/rigid.hpp"

namespace handhold::compare {
namespace {

namespace rigid = reference::rigid;

/// A support is one sample: it touches, breaks away, sticks again and lets go as the samples of a patch do. Two kinds
/// at one instant where it lands and slides on, or turns its sliding round.
std::vector<EventKind> kinds_of(Mode from, Mode to) {
  if (to == Mode::apart) return {EventKind::release};
  if (from == Mode::apart && to == Mode::stick) return {EventKind::touch};
  if (from == Mode::apart) return {EventKind::touch, EventKind::breakaway};
  if (from == Mode::slip && to == Mode::slip) return {EventKind::restick, EventKind::breakaway};
  return {to == Mode::slip ? EventKind::breakaway : EventKind::restick};
}

SampleId id_of(std::size_t support) { return {.phalanx = std::uint8_t(support)}; }

Frame frame_of(const RigidProblem& problem, const rigid::Frame& from) {
  Frame frame{.t = from.t, .bodies = {from.body}, .energy = from.energy};
  for (std::size_t i = 0; i < from.supports.size(); ++i) {
    const rigid::SupportState& s = from.supports[i];
    if (s.mode == Mode::apart) continue;
    const RigidSupport& support = problem.supports[i];
    const Eigen::Vector3d foot = from.body.X_WO * support.point_B;
    const Eigen::Vector3d n = proximity(support, from.t, foot).normal;
    const Eigen::Vector3d C = foot - support.radius * n;
    frame.contacts.push_back({.id = id_of(i),
                              .mode = s.mode,
                              .p_W = C,
                              .C_W = C,
                              .n_W = -n,  // outward from the body, as a sample's is
                              .f_W = s.normal_force * n + s.friction_W});
  }
  return frame;
}

std::vector<Event> events_of(const rigid::Trajectory& trajectory) {
  std::vector<Event> events;
  if (!trajectory.frames.empty()) {
    const rigid::Frame& start = trajectory.frames.front();
    for (std::size_t i = 0; i < start.supports.size(); ++i)
      if (start.supports[i].mode == Mode::slip)
        events.push_back({start.t, 0, EventKind::breakaway, id_of(i), start.body});
  }
  for (const rigid::Event& e : trajectory.events)
    for (const EventKind kind : kinds_of(e.from, e.to))
      events.push_back({e.t, e.window, kind, id_of(std::size_t(e.support)), e.after});
  return events;
}

class RigidEngine : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "rigid",
            .version = HANDHOLD_VERSION,
            .levels = {Level::rigid},
            .errs = {.kind = ErrorModel::Kind::controlled,
                     .accuracy = options.accuracy,
                     .noise = rigid::event_noise,
                     .delay = rigid::event_delay,
                     .recovery = rigid::recovery,
                     .rounding = std::numeric_limits<double>::epsilon() / options.max_step},
            .records = {.contacts = true, .events = true, .energy = true},
            .settings = {{"accuracy", fmt::format("{}", options.accuracy)},
                         {"longest step", fmt::format("{} s", options.max_step)},
                         {"counts as none at an event", fmt::format("{} m, m/s", rigid::event_noise)},
                         {"contacts recover at", fmt::format("{} /s", rigid::recovery)}}};
  }

  [[nodiscard]] Recording play(const Problem& given, const EngineOptions& options,
                               const Progress& progress) const override {
    const auto& problem = std::get<RigidProblem>(given);
    const rigid::Trajectory t = rigid::simulate(
        problem, {.accuracy = options.accuracy, .max_step = options.max_step, .frame_rate = options.frame_rate},
        progress);
    Recording recording{.engine = "rigid",
                        .outcome = t.outcome,
                        .note = t.note,
                        .provenance = info(options).settings,
                        .body_names = {"body"}};
    for (const rigid::Frame& frame : t.frames) recording.frames.push_back(frame_of(problem, frame));
    recording.events = events_of(t);
    return recording;
  }
};

}  // namespace

std::unique_ptr<Engine> make_rigid_engine() { return std::make_unique<RigidEngine>(); }

}  // namespace handhold::compare
