// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/simbody_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "reference/rigid/impact.hpp"
#include "reference/rigid/settle.hpp"
#include "reference/rigid/simbody_model.hpp"
#include "reference/rigid/witnesses.hpp"

namespace handhold::reference::rigid::simbody {
namespace {

constexpr double shortest_step = event_delay;  // an event is not looked for nearer to the beginning of a step [s]
constexpr double window_limit = 2e-15;         // of event times, per second of time past 1
constexpr double loose_projection =
    1e-4;                      // Simbody's own projection stays out of it: the equations recover by themselves
constexpr double slack = 1e4;  // of the invariants, in units of the accuracy
constexpr double met = 1e-9;   // an open gap below this, and closing, is an impact [m]
constexpr int most_events_at_once = 100;
constexpr long steps_between_reports = 500;
constexpr int most_trials = 200;

std::string print(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

/// Below it, directions of sliding are held. A tenth of the root: what it errs by is of second order (slip_direction).
double slow_speed(const Options& options) { return 0.1 * std::sqrt(options.accuracy); }

/// One run.
class Run {
 public:
  Run(const RigidProblem& problem, const Options& options, const std::function<bool(double t)>& progress);
  Trajectory run();

 private:
  using Integrator = SimTK::RungeKuttaMersonIntegrator;

  struct Stop {
    std::string note;
    Outcome outcome{Outcome::stalled};
  };

  /// A state under the present modes, by its values.
  struct Instant {
    double t{};
    SimTK::Vector y{};
    std::vector<Witness> witnesses{};
  };

  void prepare(Integrator& integrator) const;
  void begin();
  void advance_to(double end);
  void report() const;
  [[nodiscard]] Instant instant(const SimTK::State& state) const;
  [[nodiscard]] Instant integrate_from_start(double t);
  [[nodiscard]] int telling(const Instant& now) const;
  [[nodiscard]] double locate(Instant& now);
  double narrow(std::size_t witness, Instant& after, Instant& before);
  void accept(const Instant& now);
  void happen(double window);
  bool strike_touching(std::vector<ContactPoint>& points);
  [[nodiscard]] std::vector<bool> rest(const std::vector<ContactPoint>& points);
  void put_on_surfaces(Motion& motion) const;
  void settle_modes(const std::vector<bool>& stopped, const BodyState& before, double window);
  void check_invariants(const std::vector<Reaction>& reactions) const;

  const RigidProblem& problem_;
  const Options& options_;
  const std::function<bool(double t)>& progress_;
  Tolerances tolerances_{};
  double noise_{};  // of velocities and places at an event, from the integrator [m/s, m]
  Model model_;
  Integrator integrator_, probe_;
  SimTK::State state_{};  // at the last accepted instant, under the present modes
  Instant start_{};       // of the present step: the same instant
  bool restart_{true};
  bool begun_{false};
  int events_at_once_{0};
  Trajectory trajectory_{};
};

Run::Run(const RigidProblem& problem, const Options& options, const std::function<bool(double t)>& progress)
    : problem_(problem),
      options_(options),
      progress_(progress),
      model_(problem, slow_speed(options)),
      integrator_(model_.system()),
      probe_(model_.system()) {
  tolerances_.gap = std::max(1e-9, 100 * options.accuracy);
  noise_ = std::max(event_noise, 100 * options.accuracy);
  prepare(integrator_);
  prepare(probe_);
}

void Run::prepare(Integrator& integrator) const {
  integrator.setAccuracy(options_.accuracy);
  integrator.setConstraintTolerance(loose_projection);
  integrator.setUseInfinityNorm(true);
  integrator.setMaximumStepSize(options_.max_step);
  integrator.setReturnEveryInternalStep(true);
  integrator.setAllowInterpolation(false);
}

Run::Instant Run::instant(const SimTK::State& state) const {
  return {state.getTime(), state.getY(), witnesses(problem_, state.getTime(), model_.modes(), model_.reactions(state))};
}

/// How a problem starts is no event: its first frame shows the modes.
void Run::begin() {
  state_ = model_.start();
  model_.set_modes(state_, model_.modes());
  happen(0);
  begun_ = true;
  trajectory_.frames.push_back(model_.frame(state_));
}

Run::Instant Run::integrate_from_start(double t) {
  SimTK::State state = state_;
  state.updY() = start_.y;
  state.setTime(start_.t);
  probe_.setInitialStepSize(std::max(t - start_.t, shortest_step));
  probe_.initialize(state);
  while (probe_.getAdvancedTime() < t) probe_.stepTo(t, t);
  return instant(probe_.getAdvancedState());
}

int Run::telling(const Instant& now) const {
  for (std::size_t i = 0; i < now.witnesses.size(); ++i)
    if (tells(start_.witnesses[i], now.witnesses[i], noise_)) return int(i);
  return -1;
}

/// Narrows the zero of one witness, which tells at `after`, between `before` and `after` (Illinois with bisections).
/// Returns the window.
double Run::narrow(std::size_t witness, Instant& after, Instant& before) {
  const auto value = [&](const Instant& i) {
    const bool told = tells(start_.witnesses[witness], i.witnesses[witness], noise_);
    return (told ? -1 : 1) * std::abs(i.witnesses[witness].value);
  };
  double fa = value(before), fb = value(after);
  int side = 0;
  for (int trial = 0; trial < most_trials; ++trial) {
    const double a = before.t, b = after.t;
    if (b - a <= window_limit * std::max(1.0, b)) break;
    double t = trial % 4 == 3 || fa == fb ? 0.5 * (a + b) : b - fb * (b - a) / (fb - fa);
    t = std::max(t, start_.t + shortest_step);
    if (!(t > a && t < b)) t = 0.5 * (a + b);
    if (!(t > a && t < b) || t < start_.t + shortest_step) break;
    const Instant middle = integrate_from_start(t);
    const double f = value(middle);
    if (f < 0) {
      after = middle, fb = f;
      if (side == 1) fa *= 0.5;
      side = 1;
    } else {
      before = middle, fa = f;
      if (side == -1) fb *= 0.5;
      side = -1;
    }
  }
  return after.t - before.t;
}

/// Moves `now`, at which some witness tells, back to the first event of the step. Returns the window.
double Run::locate(Instant& now) {
  Instant before = start_;
  double window = now.t - start_.t;
  for (int witness = telling(now); witness >= 0; witness = telling(now)) {
    const std::size_t w = std::size_t(witness);
    // One that did not start on its good side (a slip that never got going) has no zero to find.
    if (!(start_.witnesses[w].value >= 0)) return window;
    before = start_;
    window = narrow(w, now, before);
    if (telling(before) < 0) return window;  // no other one is earlier
    now = before;
  }
  return window;
}

void Run::accept(const Instant& now) {
  Modes modes = model_.modes();
  const std::vector<ContactPoint> points = model_.points(state_);
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (modes[i].mode == Mode::slip && points[i].slip.norm() > slow_speed(options_) &&
        points[i].slip.dot(modes[i].held) > 0)
      modes[i].held = points[i].slip.normalized();
  model_.hold_directions(modes);
  start_ = now;
}

void Run::report() const {
  if (progress_ && !progress_(state_.getTime()))
    throw Stop{"stopped by the caller at t = " + print(state_.getTime()) + " s", Outcome::interrupted};
}

void Run::advance_to(double end) {
  while (state_.getTime() < end) {
    if (restart_) {
      start_ = instant(state_);
      integrator_.initialize(state_);
      restart_ = false;
    }
    integrator_.stepTo(end, end);
    if (integrator_.getAdvancedTime() <= start_.t) continue;  // news of a start
    if (++trajectory_.steps >= options_.step_limit)
      throw Stop{"step limit of " + std::to_string(options_.step_limit) + " reached at t = " + print(start_.t) + " s"};
    if (trajectory_.steps % steps_between_reports == 0) report();
    Instant now = instant(integrator_.getAdvancedState());
    if (telling(now) < 0) {
      state_.setTime(now.t);
      state_.updY() = now.y;
      check_invariants(model_.reactions(integrator_.getAdvancedState()));
      events_at_once_ = 0;
      accept(now);
      continue;
    }
    const double window = locate(now);
    if (now.t > start_.t + 2 * shortest_step) events_at_once_ = 0;
    if (++events_at_once_ > most_events_at_once) throw Stop{"events without end at t = " + print(now.t) + " s"};
    state_.setTime(now.t);
    state_.updY() = now.y;
    happen(window);
    restart_ = true;
  }
}

void Run::check_invariants(const std::vector<Reaction>& reactions) const {
  const double bound = slack * options_.accuracy;
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    const Mode mode = model_.modes()[i].mode;
    const ContactPoint& c = reactions[i].point;
    const bool off = mode != Mode::apart && !problem_.supports[i].normal_force && std::abs(c.gap) > bound;
    if (off || (mode == Mode::stick && c.slip.norm() > bound))
      throw std::logic_error("support " + std::to_string(i) + ": " + (off ? "off its surface" : "creeping") +
                             " at t = " + print(state_.getTime()) + " s");
  }
}

/// An open unilateral support that is met at speed stops the body there. True if one was.
bool Run::strike_touching(std::vector<ContactPoint>& points) {
  int struck = -1, closed = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (problem_.supports[i].normal_force) continue;
    if (model_.modes()[i].mode != Mode::apart ||
        (std::abs(points[i].gap) <= tolerances_.gap && !begun_ && std::abs(points[i].gap_rate) <= noise_)) {
      ++closed;
      continue;
    }
    if (points[i].gap > met || points[i].gap_rate >= -noise_) continue;
    if (struck >= 0) ++closed;
    struck = int(i);
  }
  if (struck < 0) return false;
  const double t = state_.getTime();
  const std::string where = "support " + std::to_string(struck) + " at t = " + print(t) + " s: ";
  if (closed > 0) throw Stop{where + "an impact while another hard contact is closed is not modelled"};
  const ContactPoint& c = points[std::size_t(struck)];
  Motion motion = model_.motion(state_);
  const auto impulse = plastic_impulse(problem_, problem_.supports[std::size_t(struck)], c, motion);
  if (!impulse) throw Stop{where + "an impact whose sliding turns or reverses is not modelled"};
  const double before = model_.kinetic_energy(motion);
  strike(problem_, c.arm, *impulse, motion);
  Work work = model_.load().work(state_);
  const double given = impulse->dot(c.surface_velocity);
  work.outside += given;
  work.dissipated += before + given - model_.kinetic_energy(motion);
  model_.set_motion(state_, motion);
  model_.load().set_work(state_, work);
  points = model_.points(state_);
  return true;
}

void Run::put_on_surfaces(Motion& motion) const {
  for (int sweep = 0; sweep < 20; ++sweep)
    for (const RigidSupport& s : problem_.supports) {
      const ContactPoint c = contact_point(s, state_.getTime(), motion);
      if (s.normal_force || std::abs(c.gap) > tolerances_.gap) continue;
      motion.p -= c.gap * c.normal;
    }
}

/// Removes the noise at an event: gaps and velocities that are zero but for the integrator's error. Returns which slips
/// have come to a stop.
std::vector<bool> Run::rest(const std::vector<ContactPoint>& points) {
  std::vector<bool> stopped(points.size());
  std::vector<Rest> wishes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Contact& contact = model_.modes()[i];
    const ContactPoint& c = points[i];
    const bool pressed = bool(problem_.supports[i].normal_force);
    // A slip is over where its witness says so, or nearly (two contacts that stop together); not merely when it is
    // slow.
    const double noise = begun_ ? noise_ : tolerances_.speed;
    const bool touches = !pressed && std::abs(c.gap) <= tolerances_.gap && std::abs(c.gap_rate) <= noise;
    stopped[i] = contact.mode == Mode::slip && c.slip.norm() <= noise && c.slip.dot(contact.held) <= tolerances_.speed;
    const bool slow = contact.mode == Mode::slip ? bool(stopped[i]) : c.slip.norm() <= noise;
    const bool leaving = contact.mode == Mode::apart && begun_ && !pressed && c.gap_rate >= 0;
    wishes.push_back({c, touches && !leaving, slow && !leaving && (pressed || touches)});
  }
  Motion motion = model_.motion(state_);
  bring_to_rest(problem_, wishes, motion);
  put_on_surfaces(motion);
  model_.set_motion(state_, motion);
  return stopped;
}

void Run::settle_modes(const std::vector<bool>& stopped, const BodyState& before, double window) {
  const Modes old = model_.modes();
  SimTK::State trial_state = state_;
  const Trial trial = [&](const Modes& modes) {
    model_.set_modes(trial_state, modes);
    return model_.reactions(trial_state);
  };
  const auto modes = settle(problem_, state_.getTime(), model_.points(state_), trial, tolerances_);
  if (!modes) throw Stop{"no modes satisfy rigid Coulomb friction at t = " + print(state_.getTime()) + " s"};
  model_.set_modes(state_, *modes);
  if (!begun_) return;
  for (std::size_t i = 0; i < old.size(); ++i) {
    const bool turned = stopped[i] && (*modes)[i].mode == Mode::slip;
    if (old[i].mode == (*modes)[i].mode && !turned) continue;
    trajectory_.events.push_back(
        {state_.getTime(), window, int(i), old[i].mode, (*modes)[i].mode, before, model_.body(state_)});
  }
}

void Run::happen(double window) {
  const BodyState before = model_.body(state_);
  std::vector<ContactPoint> points = model_.points(state_);
  (void)strike_touching(points);
  const std::vector<bool> stopped = rest(points);
  settle_modes(stopped, before, window);
}

Trajectory Run::run() {
  try {
    begin();
    for (long k = 1; state_.getTime() < problem_.duration; ++k) {
      const double t = double(k) / options_.frame_rate;
      const bool last = t > problem_.duration - 1e-9;  // no sliver of a frame at the end
      report();
      advance_to(last ? problem_.duration : t);
      trajectory_.frames.push_back(model_.frame(state_));
    }
  } catch (const Stop& stop) {
    trajectory_.outcome = stop.outcome;
    trajectory_.note = stop.note;
  } catch (const SimTK::Exception::Base& error) {
    trajectory_.outcome = Outcome::stalled;
    trajectory_.note = "the integrator cannot advance at t = " + print(start_.t) +
                       " s: " + (model_.failure().empty() ? error.getMessage() : model_.failure());
  } catch (const std::domain_error& error) {
    trajectory_.outcome = Outcome::stalled;
    trajectory_.note = error.what();
  }
  return trajectory_;
}

}  // namespace

Trajectory simulate(const RigidProblem& problem, const Options& options,
                    const std::function<bool(double t)>& progress) {
  reference::simbody::check_library();
  return Run(problem, options, progress).run();
}

}  // namespace handhold::reference::rigid::simbody
