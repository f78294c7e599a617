// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/simbody_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <utility>
#include <vector>

#include "cases/model/frame_times.hpp"
#include "reference/breaks.hpp"
#include "reference/invariants.hpp"
#include "reference/simbody_force.hpp"
#include "reference/simbody_locator.hpp"

namespace handhold::reference::simbody {
namespace {

constexpr int most_landings = 4;         // on one event: its window is then what it is
constexpr double least_advance = 1e-12;  // from event to event [s]
constexpr double never = std::numeric_limits<double>::infinity();
constexpr long steps_between_calls = 500;  // of progress

/// As many events as this without time passing, and modes change for ever. A patch's samples have one each.
constexpr long most_events_at_once = 2000;
constexpr double no_time = 1e-9;  // [s]

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

std::string print(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

/// One run.
class World {
 public:
  World(const Scene& scene, const Options& options, const std::function<bool(double t)>& progress);
  Recording run();

 private:
  struct Stop {
    Outcome outcome;
    std::string note;
  };

  [[nodiscard]] SimTK::State initial_state();
  void settle_start(SimTK::State& state);
  void advance();
  void advance_to(double frame_end);
  void step_to(double target);
  void land_on_event();
  void check_step();
  void settle(double window);
  void apply_break(double t);
  void count_event();
  void spend_one();
  void record_frame(const SimTK::State& state);
  void stalled(const std::string& why);
  [[nodiscard]] bool held_after(std::size_t body, double t) const;
  [[nodiscard]] double next_break() const { return breaks_.empty() ? never : breaks_.front(); }
  [[nodiscard]] std::string where() const;

  const Scene& scene_;
  const Options& options_;
  const std::function<bool(double t)>& progress_;
  Contacts contacts_;
  Recorder recorder_;
  SimTK::MultibodySystem system_{};
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  Bodies bodies_;
  ContactForce* force_;  // owned by forces_
  SimTK::RungeKuttaMersonIntegrator integrator_{system_};
  Locator locator_;
  std::vector<double> breaks_{};  // ascending; times at which hands come and go or bodies are let go
  double time_{0};                // that has been reached [s]
  bool running_{false};           // Simbody aborts when an integrator is asked for anything earlier
  long steps_{0};
  long events_{0};
  long events_at_once_{0};
  double last_event_{-1};  // [s]
};

World::World(const Scene& scene, const Options& options, const std::function<bool(double t)>& progress)
    : scene_(scene),
      options_(options),
      progress_(progress),
      contacts_(scene, options.accuracy, options.surface),
      recorder_(scene, options),
      bodies_(scene, matter_),
      force_(new ContactForce(scene, contacts_, bodies_, forces_)),
      locator_(system_, *force_) {
  SimTK::Force::Custom(forces_, force_);
  recorder_.provenance("simbody", version());
  breaks_ = breaks_of(scene);
  integrator_.setAccuracy(options.accuracy);
  integrator_.setUseInfinityNorm(true);  // an RMS norm would hide one bad contact among many
  integrator_.setMaximumStepSize(options.max_step);
  integrator_.setReturnEveryInternalStep(true);
  integrator_.setAllowInterpolation(false);  // steps end at frames, whose states are then as accurate as any
}

bool World::held_after(std::size_t body, double t) const { return t < scene_.bodies[body].held_until; }

/// Poses and velocities, as Simbody has them; no contacts yet.
SimTK::State World::initial_state() {
  SimTK::State state = system_.realizeTopology();
  system_.realizeModel(state);
  Modes modes;
  Anchors anchors = Anchors::Zero(3, contacts_.slots());
  contacts_.clear(modes);
  force_->set(state, modes, anchors, {});
  bodies_.set_start(state);
  system_.realize(state, SimTK::Stage::Velocity);
  return state;
}

/// How a scene starts is no event.
void World::settle_start(SimTK::State& state) {
  system_.realize(state, SimTK::Stage::Velocity);
  Modes modes;
  Anchors anchors;
  Motions motions;
  bodies_.read_motions(state, motions);
  contacts_.start(motions, modes, anchors);
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) modes.held[i] = held_after(i, 0);
  Contacts::Settling now{0, motions, modes, anchors};
  contacts_.settle(now);
  recorder_.undecided(0, now.undecided, contacts_.layout());
  force_->set(state, std::move(modes), anchors, {});
}

/// Carries out what is due in the integrator's state, and has it start afresh from there.
void World::settle(double window) {
  count_event();
  SimTK::State& state = integrator_.updAdvancedState();
  system_.realize(state, SimTK::Stage::Velocity);
  const double t = state.getTime();
  Modes modes = force_->modes(state);
  Anchors anchors = force_->anchors(state);
  Work work = force_->work(state);
  Motions motions;
  bodies_.read_motions(state, motions);
  Contacts::Settling now{t, motions, modes, anchors};
  contacts_.settle(now);
  work.dissipated += now.dissipated;
  recorder_.events(t, window, now.changes, motions, contacts_.layout());
  recorder_.undecided(t, now.undecided, contacts_.layout());
  force_->set(state, std::move(modes), anchors, work);
  integrator_.reinitialize(SimTK::Stage::Position, false);
}

void World::apply_break(double t) {
  while (!breaks_.empty() && breaks_.front() <= t) breaks_.erase(breaks_.begin());
  SimTK::State& state = integrator_.updAdvancedState();
  Modes modes = force_->modes(state);
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) modes.held[i] = held_after(i, t);
  for (std::size_t h = 0; h < scene_.hands.size(); ++h) modes.present[h] = contacts_.present_after(int(h), t);
  force_->set(state, std::move(modes), force_->anchors(state), force_->work(state));
  settle(0);
}

void World::stalled(const std::string& why) { throw Stop{Outcome::stalled, why + where()}; }

/// Steps and events both count against the limit.
void World::spend_one() {
  const double t = integrator_.getAdvancedTime();
  const long spent = steps_ + events_;
  if (spent >= options_.step_limit) stalled("step limit of " + std::to_string(options_.step_limit) + " reached");
  if (spent % steps_between_calls == 0 && progress_ && !progress_(t))
    throw Stop{Outcome::interrupted, "stopped by the caller at t = " + print(t) + " s"};
}

void World::count_event() {
  ++events_;
  const double t = integrator_.getAdvancedTime();
  events_at_once_ = t - last_event_ < no_time ? events_at_once_ + 1 : 0;
  if (events_at_once_ == 0) last_event_ = t;
  if (events_at_once_ > most_events_at_once) stalled("modes of contacts change for ever");
  spend_one();
}

/// An accepted step without event: its end obeys the law.
void World::check_step() {
  const SimTK::State& state = integrator_.getAdvancedState();
  const Evaluation& watched = force_->watch(state).contacts;
  const bool due = check_invariants(contacts_, force_->modes(state), watched, options_.accuracy, state.getTime());
  if (due) settle(integrator_.getPreviousStepSizeTaken());
}

/// Goes back to the begin of the step and integrates up to the first change of mode, until the end of the step is
/// where it happens, to within the window, by the integration itself.
void World::land_on_event() {
  const double least = event_window(options_.accuracy);
  double window = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_landings && window > least; ++i) {
    const Locator::Window found = locator_.narrow(least / 2);
    SimTK::State& state = integrator_.updAdvancedState();
    locator_.rewind(state);
    integrator_.reinitialize(SimTK::Stage::Position, false);
    const double begin = integrator_.getAdvancedTime();
    const double target = std::max(found.high, begin + least_advance);
    while (integrator_.getAdvancedTime() == begin) (void)integrator_.stepTo(target);  // at first news, but no step
    if (!locator_.rises(integrator_.getAdvancedState())) return check_step();  // the step was shorter, or falls short
    window = locator_.at_end(least) ? least : integrator_.getAdvancedTime() - begin;
  }
  settle(window);
}

void World::step_to(double target) {
  const double begin = time_ = integrator_.getAdvancedTime();
  locator_.begin(integrator_.getAdvancedState());
  while (integrator_.getAdvancedTime() == begin)
    (void)integrator_.stepTo(target);  // at first it may say that it starts
  force_->forget_failure();
  if (locator_.rises(integrator_.getAdvancedState()))
    land_on_event();
  else
    check_step();
  ++steps_;
  spend_one();
}

void World::advance_to(double frame_end) {
  while (integrator_.getAdvancedTime() < frame_end) {
    step_to(std::min(frame_end, next_break()));
    if (integrator_.getAdvancedTime() >= next_break()) apply_break(integrator_.getAdvancedTime());
  }
}

void World::record_frame(const SimTK::State& state) {
  system_.realize(state, SimTK::Stage::Velocity);
  const Instant& instant = force_->evaluate(state);
  recorder_.frame(state.getTime(), instant.motions, force_->modes(state), force_->anchors(state), instant.contacts,
                  contacts_, force_->work(state));
}

void World::advance() {
  SimTK::State start = initial_state();
  try {
    settle_start(start);
  } catch (const CannotAdvance&) {
    record_frame(start);  // a recording has at least the start
    throw;
  }
  record_frame(start);
  integrator_.initialize(start);
  running_ = true;
  for (const double t :
       options_.frame_times.empty() ? regular_frames(scene_.duration, options_.frame_rate) : options_.frame_times) {
    if (progress_ && !progress_(integrator_.getAdvancedTime()))
      throw Stop{Outcome::interrupted, "stopped by the caller at t = " + print(integrator_.getAdvancedTime()) + " s"};
    const double begin = thread_cpu_seconds();
    advance_to(t);
    recorder_.frame_time(thread_cpu_seconds() - begin);
    record_frame(integrator_.getAdvancedState());
  }
}

/// " at t = ..., CONTACT" of the sample whose anchor moves fastest, which is what stalls an integrator; or of the
/// fastest body.
std::string World::where() const {
  if (!running_) return " at t = 0 s";
  const SimTK::State& state = integrator_.getAdvancedState();
  std::string text = " at t = " + print(state.getTime()) + " s";
  if (state.getSystemStage() < SimTK::Stage::Velocity) return text;
  const Instant& instant = force_->evaluate(state);
  const Modes& modes = force_->modes(state);
  int slot = -1, body = 0;
  double fastest = -1;
  for (int i = 0; i < contacts_.slots(); ++i) {
    if (modes.mode[std::size_t(i)] == Mode::apart) continue;
    const double rate = instant.contacts.samples[std::size_t(i)].response.anchor_rate.norm();
    if (rate > fastest) fastest = rate, slot = i;
  }
  if (slot >= 0) return text + ", " + contacts_.describe(slot);
  for (int i = 0; i < int(instant.motions.size()); ++i)
    if (instant.motions[std::size_t(i)].v.norm() > instant.motions[std::size_t(body)].v.norm()) body = i;
  return text + ", body '" + scene_.bodies[std::size_t(body)].name + "'";
}

Recording World::run() {
  try {
    advance();
    recorder_.end(Outcome::complete, "");
  } catch (const Stop& stop) {
    recorder_.end(stop.outcome, stop.note);
  } catch (const CannotAdvance& error) {
    recorder_.end(Outcome::stalled, std::string(error.what()) + " at t = " + print(time_) + " s");
  } catch (const SimTK::Exception::Base& error) {  // the integrator gave up; what was thrown inside the force says why
    const std::string why = force_->failure_text(error.getMessage());
    recorder_.end(Outcome::stalled, "the integrator cannot advance" + where() + ": " + why);
  }
  recorder_.provenance("steps", std::to_string(steps_));
  if (running_) recorder_.provenance("steps attempted", std::to_string(integrator_.getNumStepsAttempted()));
  return recorder_.take();
}

}  // namespace

Recording simulate(const Scene& scene, const Options& options, const std::function<bool(double t)>& progress) {
  check_library();
  return World(scene, options, progress).run();
}

}  // namespace handhold::reference::simbody
