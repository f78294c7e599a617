#include "reference/simbody_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <vector>

#include "reference/simbody_force.hpp"

namespace handhold::reference::simbody {
namespace {

constexpr double window_limit = 1e-9;      // of event times [s]
constexpr double simbody_timescale = 0.1;  // [s], System's default: window = accuracy × timescale × what is asked for
constexpr double slack = 1000;  // of the invariants, in units of the accuracy: drift over accuracy-sized steps
constexpr double never = std::numeric_limits<double>::infinity();
constexpr long steps_between_calls = 500;  // of progress

/// Debian builds Simbody without NDEBUG and its State has members under #ifndef NDEBUG: mixing the two corrupts memory.
void check_library() {
  char built[64] = {};
  SimTK_about_SimTKcommon("debug", int(sizeof built), built);
  const bool library_checks = std::strcmp(built, "debug") == 0;
#ifdef NDEBUG
  const bool we_check = false;
#else
  const bool we_check = true;
#endif
  if (library_checks != we_check)
    throw std::logic_error(
        "Simbody and handhold were built with different NDEBUG: their states differ in memory (see "
        "reference/CMakeLists.txt)");
}

std::string simbody_version() {
  int major = 0, minor = 0, build = 0;
  SimTK_version_SimTKcommon(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

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

SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

SimTK::Rotation to_simbody(const Eigen::Quaterniond& q) {
  const Eigen::Quaterniond unit = q.normalized();
  return SimTK::Rotation(SimTK::Quaternion(unit.w(), unit.x(), unit.y(), unit.z()));
}

/// About O's origin, as Simbody wants it. What a mobility never uses is replaced by something harmless.
SimTK::MassProperties mass_properties(const Body& body) {
  if (body.mobility == Mobility::fixed) return {1, SimTK::Vec3(0), SimTK::Inertia(1)};
  const SimTK::Vec3 center = to_simbody(body.inertia.center);
  const Eigen::Matrix3d& J = body.inertia.about_center;
  const bool rotates = body.mobility == Mobility::free;
  const SimTK::Inertia central = rotates ? SimTK::Inertia(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2))
                                         : SimTK::Inertia(body.inertia.mass);
  return {body.inertia.mass, center, central.shiftFromMassCenter(center, body.inertia.mass)};
}

SimTK::MobilizedBody make_body(SimTK::SimbodyMatterSubsystem& matter, const Body& body) {
  const SimTK::Body::Rigid solid(mass_properties(body));
  if (body.mobility == Mobility::free)
    return SimTK::MobilizedBody::Free(matter.Ground(), SimTK::Transform(), solid, SimTK::Transform());
  // Outboard frame turned back, so that the coordinates are W's.
  const SimTK::Transform turned(~to_simbody(body.X_WO.R));
  return SimTK::MobilizedBody::Translation(matter.Ground(), SimTK::Transform(), solid, turned);
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
  void add_witnesses();
  void find_breaks();
  void advance();
  void advance_to(double frame_end);
  void settle(double window);
  void apply_break(double t);
  void check_invariants();
  void count_step();
  void record_frame();
  [[nodiscard]] double next_break() const { return breaks_.empty() ? never : breaks_.front(); }
  [[nodiscard]] std::string where(double t) const;

  const Scene& scene_;
  const Options& options_;
  const std::function<bool(double t)>& progress_;
  Contacts contacts_;
  Recorder recorder_;
  SimTK::MultibodySystem system_{};
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody body_;
  ContactForce* force_;  // owned by forces_
  SimTK::RungeKuttaMersonIntegrator integrator_{system_};
  std::vector<double> breaks_{};  // ascending; times at which hands come and go or the body is let go
  double held_until_{};
  long steps_{0};
};

World::World(const Scene& scene, const Options& options, const std::function<bool(double t)>& progress)
    : scene_(scene),
      options_(options),
      progress_(progress),
      contacts_(scene, options.accuracy),
      recorder_(scene, options),
      body_(make_body(matter_, scene.bodies.front())),
      force_(new ContactForce(scene, contacts_, forces_, body_)) {
  SimTK::Force::Custom(forces_, force_);
  const Body& body = scene.bodies.front();
  held_until_ = body.mobility == Mobility::fixed ? never : body.held_until;
  recorder_.provenance("simbody", simbody_version());
  add_witnesses();
  find_breaks();
  integrator_.setAccuracy(options.accuracy);
  integrator_.setUseInfinityNorm(true);  // an RMS norm would hide one bad contact among many
  integrator_.setMaximumStepSize(options.max_step);
  integrator_.setReturnEveryInternalStep(true);
  integrator_.setAllowInterpolation(false);  // steps end at frames, whose states are then as accurate as any
}

void World::add_witnesses() {
  const double window = std::min(0.1, window_limit / (options_.accuracy * simbody_timescale));
  for (int slot = 0; slot < contacts_.slots(); ++slot) {
    system_.addEventHandler(new Witness(*force_, Witness::Kind::gap, slot, window));
    system_.addEventHandler(new Witness(*force_, Witness::Kind::friction, slot, window));
  }
  const std::vector<Pad>& pads = contacts_.layout().pads;
  for (int pad = 0; pad < int(pads.size()); ++pad)
    if (!pads[std::size_t(pad)].given)
      system_.addEventHandler(new Witness(*force_, Witness::Kind::nearness, pad, window));
}

void World::find_breaks() {
  const auto add = [&](double t) {
    if (t > 0 && t < scene_.duration) breaks_.push_back(t);
  };
  add(held_until_);
  for (const Hand& hand : scene_.hands)
    for (const Interval& i : hand.motion->presence()) {
      add(i.begin);
      add(i.end);
    }
  std::sort(breaks_.begin(), breaks_.end());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
}

SimTK::State World::initial_state() {
  const Body& body = scene_.bodies.front();
  SimTK::State state = system_.realizeTopology();
  system_.realizeModel(state);
  body_.setQToFitTransform(state, SimTK::Transform(to_simbody(body.X_WO.R), to_simbody(body.X_WO.p)));
  const bool moves = !(held_until_ > 0);
  if (moves) body_.setUToFitVelocity(state, SimTK::SpatialVec(to_simbody(body.V_WO.w), to_simbody(body.V_WO.v)));
  // Modes need sizes before anything is evaluated; the starts of the samples need the pose as Simbody has it.
  Modes modes;
  Anchors anchors;
  BodyMotion motion{body.X_WO.R.normalized().toRotationMatrix(), body.X_WO.p, {0, 0, 0}, {0, 0, 0}};
  contacts_.start(motion, modes, anchors);
  force_->set(state, modes, anchors, {});
  system_.realize(state, SimTK::Stage::Velocity);
  motion = force_->motion(state);
  contacts_.start(motion, modes, anchors);
  modes.held = held_until_ > 0;
  Work ignored;
  (void)contacts_.settle(0, motion, modes, anchors, ignored.dissipated);  // how a scene starts is no event
  force_->set(state, modes, anchors, {});
  return state;
}

/// Carries out what is due in the integrator's state, and has it start afresh from there.
void World::settle(double window) {
  SimTK::State& state = integrator_.updAdvancedState();
  system_.realize(state, SimTK::Stage::Velocity);
  const double t = state.getTime();
  Modes modes = force_->modes(state);
  Anchors anchors = force_->anchors(state);
  Work work = force_->work(state);
  const std::vector<Transition> changes = contacts_.settle(t, force_->motion(state), modes, anchors, work.dissipated);
  recorder_.events(t, window, changes, force_->motion(state), contacts_.layout());
  force_->set(state, modes, anchors, work);
  integrator_.reinitialize(SimTK::Stage::Position, false);
}

void World::apply_break(double t) {
  while (!breaks_.empty() && breaks_.front() <= t) breaks_.erase(breaks_.begin());
  SimTK::State& state = integrator_.updAdvancedState();
  Modes modes = force_->modes(state);
  modes.held = t < held_until_;
  for (std::size_t h = 0; h < scene_.hands.size(); ++h) modes.present[h] = contacts_.present_after(int(h), t);
  force_->set(state, modes, force_->anchors(state), force_->work(state));
  settle(0);
}

/// Every inequality of the contact law at an accepted step: all witnesses are negative, undamped slip is on its cone,
/// anchors are on the surface. A witness a hair above zero (round-off of a quaternion's normalisation after an event)
/// is carried out.
void World::check_invariants() {
  const SimTK::State& state = integrator_.getAdvancedState();
  system_.realize(state, SimTK::Stage::Velocity);
  const Evaluation& e = force_->evaluate(state);
  const ContactParameters& law = scene_.contact;
  const Friction& mu = scene_.bodies.front().friction;
  const double length = slack * options_.accuracy;  // [m] and [m/s]
  const double force = length * (law.stiffness + law.damping) * (1 + mu.mu_static);
  bool due = false;
  const auto broken = [&](std::size_t slot, const char* what) {
    throw std::logic_error(contacts_.describe(int(slot)) + ": " + what + " at t = " + print(state.getTime()) + " s");
  };
  for (std::size_t slot = 0; slot < e.samples.size(); ++slot) {
    const Mode mode = force_->modes(state).mode[slot];
    const Sample& s = e.samples[slot];
    due = due || s.gap > 0 || s.friction > 0;
    if (mode == Mode::apart && s.gap > length * (1 + law.damping / law.stiffness)) broken(slot, "apart, but inside");
    if (mode == Mode::apart) continue;
    if (s.gap > force) broken(slot, "in contact, but pulling");
    const bool undamped_slip = mode == Mode::slip && law.damping == 0;
    if (s.friction > (undamped_slip ? length : force)) broken(slot, "outside its friction cone, or slipping backwards");
    const Response& r = s.response;
    if (undamped_slip && std::abs(r.lag.norm() - mu.mu_dynamic * r.depth) > length)
      broken(slot, "slipping off its cone");
  }
  if (due) settle(integrator_.getPreviousStepSizeTaken());
}

void World::count_step() {
  force_->forget_failure();
  check_invariants();
  if (++steps_ >= options_.step_limit)
    throw Stop{Outcome::stalled, "step limit of " + std::to_string(options_.step_limit) + " reached" +
                                     where(integrator_.getAdvancedTime())};
  const double t = integrator_.getAdvancedTime();
  if (steps_ % steps_between_calls == 0 && progress_ && !progress_(t))
    throw Stop{Outcome::interrupted, "stopped by the caller at t = " + print(t) + " s"};
}

void World::advance_to(double frame_end) {
  using SimTK::Integrator;
  while (integrator_.getAdvancedTime() < frame_end) {
    switch (integrator_.stepTo(frame_end, next_break())) {
      case Integrator::ReachedEventTrigger: {
        const SimTK::Vec2 window = integrator_.getEventWindow();
        settle(window[1] - window[0]);
        break;
      }
      case Integrator::ReachedScheduledEvent:
        apply_break(integrator_.getAdvancedTime());
        break;
      case Integrator::TimeHasAdvanced:
      case Integrator::ReachedReportTime:
        count_step();
        break;
      default:  // StartOfContinuousInterval and other news
        break;
    }
  }
}

void World::record_frame() {
  const SimTK::State& state = integrator_.getAdvancedState();
  system_.realize(state, SimTK::Stage::Velocity);
  recorder_.frame(state.getTime(), force_->motion(state), force_->modes(state), force_->anchors(state),
                  force_->evaluate(state), contacts_, force_->work(state));
}

void World::advance() {
  const SimTK::State start = initial_state();
  integrator_.initialize(start);
  record_frame();
  for (long k = 1; integrator_.getAdvancedTime() < scene_.duration; ++k) {
    if (progress_ && !progress_(integrator_.getAdvancedTime()))
      throw Stop{Outcome::interrupted, "stopped by the caller at t = " + print(integrator_.getAdvancedTime()) + " s"};
    const double t = double(k) / options_.frame_rate;
    const bool last = t > scene_.duration - 1e-9;  // no sliver of a frame at the end
    const double begin = thread_cpu_seconds();
    advance_to(last ? scene_.duration : t);
    recorder_.frame_time(thread_cpu_seconds() - begin);
    record_frame();
  }
}

/// ": at t = ..., body ..., contact ..." of the sample whose anchor moves fastest, which is what stalls an integrator.
std::string World::where(double t) const {
  std::string text = " at t = " + print(t) + " s, body '" + scene_.bodies.front().name + "'";
  const SimTK::State& state = integrator_.getAdvancedState();
  if (state.getSystemStage() < SimTK::Stage::Velocity) return text;
  const Evaluation& e = force_->evaluate(state);
  int fastest = -1;
  double speed = 0;
  for (int slot = 0; slot < int(e.samples.size()); ++slot) {
    const double rate = e.samples[std::size_t(slot)].response.anchor_rate.norm();
    if (rate > speed) fastest = slot, speed = rate;
  }
  return fastest < 0 ? text : text + ", " + contacts_.describe(fastest);
}

Recording World::run() {
  try {
    advance();
    recorder_.end(Outcome::complete, "");
  } catch (const Stop& stop) {
    recorder_.end(stop.outcome, stop.note);
  } catch (const SimTK::Exception::Base& error) {  // the integrator gave up; what was thrown inside the force says why
    const std::string& inside = force_->failure();
    recorder_.end(Outcome::stalled, "the integrator cannot advance" + where(integrator_.getAdvancedTime()) + ": " +
                                        (inside.empty() ? error.getMessage() : inside));
  }
  recorder_.provenance("steps", std::to_string(steps_));
  recorder_.provenance("steps attempted", std::to_string(integrator_.getNumStepsAttempted()));
  return recorder_.take();
}

}  // namespace

Recording simulate(const Scene& scene, const Options& options, const std::function<bool(double t)>& progress) {
  check_library();
  return World(scene, options, progress).run();
}

}  // namespace handhold::reference::simbody
