// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/placing_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cases/hand/grip.hpp"
#include "cases/hand/moved_trace.hpp"
#include "cases/hand/trace_spline.hpp"
#include "compare/study/parallel.hpp"
#include "compare/study/substeps.hpp"

namespace handhold::compare {
namespace {

constexpr double turn_lever = 0.01;      // a turn by 1 rad is as unwanted as a drift of 1 cm [m/rad]
constexpr double uneven_weight = 0.001;  // a spread of depth as large as the mean is as bad as 1 mm [m]
constexpr int remedies = 6;              // doublings

bool presses(const ContactState& c) { return c.mode != Mode::apart; }

/// Largest force against gravity that the frame's pressure allows: along each normal N, across it up to mu N.
double strength_of(const Frame& frame, const Eigen::Vector3d& up, double mu) {
  double sum = 0;
  for (const ContactState& c : frame.contacts) {
    if (!presses(c)) continue;
    const double pressure = -c.f_W.dot(c.n_W), lift = -c.n_W.dot(up);
    if (pressure > 0) sum += pressure * (lift + mu * std::sqrt(std::max(0.0, 1 - lift * lift)));
  }
  return std::max(0.0, sum);
}

/// Standard deviation of the pressing samples' depth over its mean.
double unevenness_of(const Frame& frame) {
  double n = 0, sum = 0, squares = 0;
  for (const ContactState& c : frame.contacts) {
    if (!presses(c)) continue;
    n += 1, sum += c.depth, squares += c.depth * c.depth;
  }
  return sum > 0 ? std::sqrt(std::max(0.0, n * squares - sum * sum)) / sum : 0;
}

/// Of the object if it went with the palm: |m (a - g)| by differences over two frames [N].
double load_at(const Scene& scene, double t) {
  constexpr double h = 0.02;  // [s]: over two frames of a tracker, so that its noise is not taken for motion
  const HandMotion& motion = *scene.hands.front().motion;
  const Eigen::Vector3d a =
      (motion.pose(palm, t - h).p - 2 * motion.pose(palm, t).p + motion.pose(palm, t + h).p) / (h * h);
  return scene.bodies.front().inertia.mass * (a - scene.gravity).norm();
}

double end_of_presence(const HandMotion& motion) {
  for (const Interval& present : motion.presence())
    if (present.end > 0) return present.end;
  return 1;
}

double cost(const TriedPlacement& tried) {
  const GraspTrial& trial = tried.trial;
  return tried.placement.cost + trial.drift + turn_lever * trial.turned + uneven_weight * trial.unevenness;
}

bool better(const TriedPlacement& a, const TriedPlacement& b) {
  if (a.trial.held != b.trial.held) return a.trial.held;
  if (!a.trial.held && a.trial.carried != b.trial.carried) return a.trial.carried > b.trial.carried;
  return cost(a) < cost(b);
}

GraspTrial play(const PlacingRequest& request, const Placement& placement, const ContactParameters& contact,
                const Engine& engine) {
  Scene scene = scene_of(request, placement, contact);
  const double until = placement.until - placement.start;
  scene.duration = std::min(scene.duration, until);
  EngineOptions options = request.engine;
  Recording recording = engine.play(scene, options);
  double fastest = fastest_motion(scene, recording);
  long steps = (long(recording.frames.size()) - 1) * options.substeps;
  const int needed = needed_substeps(fastest, options.frame_rate);
  if (request.choose_substeps && needed > options.substeps) {
    options.substeps = needed;
    recording = engine.play(scene, options);
    fastest = fastest_motion(scene, recording);
    steps += (long(recording.frames.size()) - 1) * options.substeps;
  }
  GraspTrial trial = judge_grasp(scene, recording, placement.finger, until);
  trial.fastest = fastest;
  trial.substeps = options.substeps;
  trial.steps = steps;
  return trial;
}

/// The first factor of 2, 4, ... with which `holds`.
template <class Holds>
std::optional<double> first_factor(const Holds& holds) {
  for (int i = 1; i <= remedies; ++i)
    if (holds(std::ldexp(1, i))) return std::ldexp(1, i);
  return {};
}

Remedy find_remedy(const PlacingRequest& request, const TriedPlacement& best, const Engine& engine, long& steps) {
  const auto holds = [&](const PlacingRequest& changed, const ContactParameters& contact) {
    const GraspTrial trial = play(changed, best.placement, contact, engine);
    steps += trial.steps;
    return trial.held;
  };
  Remedy remedy;
  const auto stiffer = first_factor([&](double factor) {
    return holds(request, {factor * best.contact.stiffness, factor * best.contact.damping});
  });
  if (stiffer) remedy.stiffness = *stiffer * best.contact.stiffness;
  const auto lighter = first_factor([&](double factor) {
    PlacingRequest changed = request;
    changed.body.inertia.mass /= factor;
    changed.body.inertia.about_center /= factor;
    return holds(changed, best.contact);
  });
  if (lighter) remedy.mass = request.body.inertia.mass / *lighter;
  return remedy;
}

}  // namespace

GraspTrial judge_grasp(const Scene& scene, const Recording& recording, int finger, double until) {
  const Body& body = scene.bodies.front();
  const Eigen::Vector3d up = -scene.gravity.normalized();
  GraspTrial trial{.asked = std::max(0.0, until - body.held_until),
                   .weight = body.inertia.mass * scene.gravity.norm(),
                   .strength = std::numeric_limits<double>::infinity()};
  const HandMotion& motion = *scene.hands.front().motion;
  std::optional<Eigen::Vector3d> taken_O;  // the point between thumb and finger when the support ends
  Eigen::Quaterniond first_turn = Eigen::Quaterniond::Identity();  // of the object in the palm, then
  int frames = 0;
  bool lost = false;
  for (const Frame& frame : recording.frames) {
    if (frame.t < body.held_until || frame.t > until) continue;
    trial.load = std::max(trial.load, load_at(scene, frame.t));
    const bool touched = std::any_of(frame.contacts.begin(), frame.contacts.end(), presses);
    const Pose& X_WO = frame.bodies.front().X_WO;
    const Eigen::Vector3d middle_W = grip_at(motion, finger, frame.t).middle_W;
    const Eigen::Quaterniond R_palmO = (motion.pose(palm, frame.t).R.conjugate() * X_WO.R).normalized();
    if (!taken_O) taken_O = X_WO.inverse() * middle_W, first_turn = R_palmO;
    const double drift = (X_WO * *taken_O - middle_W).norm();
    lost = lost || !touched || !(drift <= most_drift);
    if (lost) continue;
    trial.carried = frame.t - body.held_until;
    trial.drift = std::max(trial.drift, drift);
    trial.turned = std::max(trial.turned, R_palmO.angularDistance(first_turn));
    trial.strength = std::min(trial.strength, strength_of(frame, up, body.friction.mu_static));
    trial.unevenness += (unevenness_of(frame) - trial.unevenness) / ++frames;
  }
  trial.held = frames > 0 && !lost;
  if (trial.held) trial.carried = trial.asked;  // the last frame may lie before the end
  if (frames == 0) trial.strength = 0;
  return trial;
}

Scene scene_of(const PlacingRequest& request, const Placement& placement, const ContactParameters& contact) {
  Scene scene;
  scene.contact = contact;
  Hand hand;
  hand.motion = std::make_shared<TraceSpline>(moved(*request.trace, Pose{}, placement.start), request.hand);
  scene.duration = end_of_presence(*hand.motion);
  Body body = request.body;
  body.X_WO = placement.X_WO;
  body.held_until = std::max(0.0, placement.held_until - placement.start);
  scene.bodies.push_back(std::move(body));
  scene.hands.push_back(std::move(hand));
  return scene;
}

Placing place_by_trial(const PlacingRequest& request, const Engine& engine) {
  PlacementOptions options = request.placement;
  options.mu_static = request.body.friction.mu_static;
  const Placements offered =
      placements_in_hand(*request.trace, request.hand, *request.body.field, request.tried, options);
  Placing placing{.poses = offered.poses};
  for (const Placement& placement : offered.ranked)
    placing.tried.push_back({placement, request.contact_of ? request.contact_of(placement) : request.contact, {}});
  in_parallel(placing.tried.size(), [&](std::size_t i) {
    TriedPlacement& tried = placing.tried[i];
    tried.trial = play(request, tried.placement, tried.contact, engine);
  });
  for (const TriedPlacement& tried : placing.tried) placing.steps += tried.trial.steps;
  std::stable_sort(placing.tried.begin(), placing.tried.end(), better);
  if (!placing.tried.front().trial.held)
    placing.remedy = find_remedy(request, placing.tried.front(), engine, placing.steps);
  return placing;
}

}  // namespace handhold::compare
