// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "cases/model/patch.hpp"

namespace handhold::compare {
namespace {

using catalogue::BenchmarkScene;
using catalogue::Pedigree;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = std::numbers::pi / 180;
constexpr double instant = 1e-9;  // frames whose times differ by less are the same [s]

const Pose& pose(const Frame& frame, std::size_t body) { return frame.bodies[body].X_WO; }

/// The last frame at or before `t`; nothing if the recording ends more than a frame before.
const Frame* frame_at(const Recording& recording, double t) {
  const Frame* found = nullptr;
  for (const Frame& frame : recording.frames)
    if (frame.t <= t + instant) found = &frame;
  const bool reached = !recording.frames.empty() && recording.frames.back().t >= t - instant;
  return reached ? found : nullptr;
}

/// Deepest of the phalanges that take part.
double deepest(const BenchmarkScene& benchmark, const Frame& frame) {
  double depth = 0;
  for (const auto& [hand, phalanx] : benchmark.phalanges) {
    const HandMotion& motion = *benchmark.scene.hands[std::size_t(hand)].motion;
    const Pose X_OP = pose(frame, 0).inverse() * motion.pose(phalanx, frame.t);
    depth = std::max(depth, -nearest(motion.model().shape(phalanx), X_OP, *benchmark.scene.bodies[0].field).distance);
  }
  return depth;
}

/// Slope of a straight line through (t, r), by least squares.
Eigen::Vector3d slope(const std::vector<double>& t, const std::vector<Eigen::Vector3d>& r) {
  double mean = 0, spread = 0;
  for (const double x : t) mean += x / double(t.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < t.size(); ++i) {
    spread += (t[i] - mean) * (t[i] - mean);
    sum += (t[i] - mean) * (r[i] - r.front());
  }
  return sum / spread;
}

/// Gates that hold or not by a word.
Gate yes(const std::string& quantity, bool holds, const std::string& reason) {
  return {.quantity = quantity, .measured = holds ? 1.0 : 0.0, .bound = Bound::at_least, .limit = 1, .reason = reason};
}

std::vector<Gate> gates_of(const catalogue::GripPlan& plan, const BenchmarkScene& benchmark,
                           const Recording& recording) {
  const GripQuality q = grip_quality(benchmark, recording);
  return {
      yes("held through the shake", q.held, "the friction at hand is three times what the shake needs"),
      {"penetration error", std::abs(q.penetration - plan.overlap), Bound::at_most, 1.5e-4, "m", Pedigree::exact,
       "the phalanges are kinematic: 5 % of the overlap they were given, for the object's tilt between rows that do "
       "not face each other"},
      {"shake slip", q.shake_slip, Bound::at_most, 1e-5, "m", Pedigree::exact,
       "within its cone nothing slips; 10 um are invisible"},
      {"creep while held", q.creep, Bound::at_most, 1e-12, "m/s", Pedigree::exact,
       "exactly 0 in the model; rounding of 0.4 m over 5 s is 1e-17"}};
}

std::vector<Gate> gates_of(const catalogue::SlidePlan& plan, const BenchmarkScene& benchmark,
                           const Recording& recording) {
  const SlideQuality q = slide_quality(benchmark, recording);
  if (plan.distance == 0)
    return {{"distance of a block that stays", std::abs(q.distance), Bound::at_most, 1e-4, "m", Pedigree::exact,
             "L1: 0; the springs give by m g sin / K < 0.004 mm"}};
  return {{"distance error", std::abs(q.distance / plan.distance - 1), Bound::at_most, 1e-3, "", Pedigree::exact,
           "L1; the springs' share is below 4e-4: what a block gains until it has its whole friction, and "
           "the lag mu m g / K"},
          {"sideways", q.lateral / plan.distance, Bound::at_most, 1e-3, "", Pedigree::exact,
           "friction is opposite to the velocity: the path is straight"}};
}

std::vector<Gate> gates_of(const catalogue::TowerPlan&, const BenchmarkScene& benchmark, const Recording& recording) {
  const TowerQuality q = tower_quality(benchmark, recording);
  std::vector<Gate> gates{
      yes("stands", q.stands, "it is in balance"),
      {"drift", q.drift, Bound::at_most, 2e-4, "m", Pedigree::exact, "exactly 0 in the model; 0.2 mm are invisible"}};
  if (!benchmark.phalanges.empty()) {
    gates.push_back({"fastest block", q.largest_speed, Bound::at_most, 15, "m/s", Pedigree::exact,
                     "the axe moves at 5.4 m/s at most: an elastic blow gives twice that"});
    gates.push_back({"lowest centre of a block", q.lowest, Bound::at_least, 0, "m", Pedigree::exact, "the ground"});
  }
  return gates;
}

std::vector<Gate> gates_of(const catalogue::SwingPlan& plan, const BenchmarkScene& benchmark,
                           const Recording& recording) {
  const SwingQuality q = swing_quality(benchmark, recording);
  const Gate slip{"pivot slip",
                  q.pivot_slip,
                  Bound::at_most,
                  1e-3,
                  "m",
                  Pedigree::exact,
                  "the fingertips hold the pivot; 1 mm is barely visible"};
  if (plan.half_period == 0)
    return {{"end angle error", std::abs(q.turning_angle - plan.turning_angle) / degree, Bound::at_most, 0.5, "deg",
             Pedigree::exact, "L1; the load that the ring carries besides takes 0.1 degree"},
            slip};
  return {
      {"half period error", std::abs(q.half_period / plan.half_period - 1), Bound::at_most, 1e-3, "", Pedigree::exact,
       "L1; the springs of the pivot change it by 3e-4"},
      {"swing left after 4 s", q.swing_left / degree, Bound::at_least, 80, "deg", Pedigree::exact, "90 without losses"},
      slip};
}

}  // namespace

GripQuality grip_quality(const BenchmarkScene& benchmark, const Recording& recording) {
  const auto& plan = std::get<catalogue::GripPlan>(benchmark.plan);
  GripQuality q{.penetration = nan, .creep = nan, .shake_slip = nan, .largest_deviation = nan};
  const Frame* before = frame_at(recording, plan.shake_begin);
  if (recording.outcome != Outcome::complete || !before || benchmark.phalanges.empty()) return q;
  const auto [hand, phalanx] = benchmark.phalanges.front();
  const HandMotion& motion = *benchmark.scene.hands[std::size_t(hand)].motion;
  const auto relative = [&](const Frame& f) -> Eigen::Vector3d { return pose(f, 0).p - motion.pose(phalanx, f.t).p; };

  std::vector<double> t, depths;
  std::vector<Eigen::Vector3d> r;
  double deviation = 0;
  const Frame* first = nullptr;
  for (const Frame& frame : recording.frames) {
    if (frame.t < plan.hold_begin - instant) continue;
    if (!first) first = &frame;
    deviation = std::max(deviation, (relative(frame) - relative(*first)).norm());
    if (frame.t > plan.hold_end + instant) continue;
    t.push_back(frame.t);
    r.push_back(relative(frame));
    if (t.size() % 10 == 1) depths.push_back(deepest(benchmark, frame));  // a tenth is enough: nothing moves
  }
  const Frame& end = recording.frames.back();
  q.penetration = 0;
  for (const double depth : depths) q.penetration += depth / double(depths.size());
  q.creep = slope(t, r).norm();
  q.shake_slip = (relative(end) - relative(*before)).norm();
  q.largest_deviation = deviation;
  const double turned = pose(end, 0).R.angularDistance(pose(*first, 0).R);
  q.held = (relative(end) - relative(*first)).norm() < 0.010 && deviation < 0.020 && turned < 20 * degree;
  return q;
}

SlideQuality slide_quality(const BenchmarkScene& benchmark, const Recording& recording) {
  const auto& plan = std::get<catalogue::SlidePlan>(benchmark.plan);
  const Frame* end = frame_at(recording, plan.at);
  if (recording.outcome != Outcome::complete || !end) return {nan, nan};
  const Eigen::Vector3d moved = pose(*end, 1).p - benchmark.scene.bodies[1].X_WO.p;
  const Eigen::Vector3d up = benchmark.scene.bodies[0].X_WO.R * Eigen::Vector3d::UnitZ();
  const double distance = moved.dot(plan.direction_W);
  return {distance, std::abs(moved.dot(up.cross(plan.direction_W)))};
}

TowerQuality tower_quality(const BenchmarkScene& benchmark, const Recording& recording) {
  const auto& plan = std::get<catalogue::TowerPlan>(benchmark.plan);
  TowerQuality q{nan, nan, false, nan, nan};
  const Frame* settled = frame_at(recording, plan.settled);
  if (recording.outcome != Outcome::complete || !settled || !frame_at(recording, plan.until)) return q;
  q = {0, 0, true, 0, std::numeric_limits<double>::infinity()};
  const Frame* last = nullptr;
  for (const Frame& frame : recording.frames) {
    for (std::size_t body = 1; body < frame.bodies.size(); ++body) {
      const Eigen::Vector3d& p = pose(frame, body).p;
      if (last) q.largest_speed = std::max(q.largest_speed, (p - pose(*last, body).p).norm() / (frame.t - last->t));
      q.lowest = std::min(q.lowest, p.z());
      if (frame.t > plan.until + instant) continue;
      const double from_start = (p - benchmark.scene.bodies[body].X_WO.p).norm();
      q.stands = q.stands && from_start < 0.010;
      if (&frame == settled) q.sink = std::max(q.sink, from_start);
      if (frame.t > plan.settled) q.drift = std::max(q.drift, (p - pose(*settled, body).p).norm());
    }
    last = &frame;
  }
  return q;
}

SwingQuality swing_quality(const BenchmarkScene& benchmark, const Recording& recording) {
  const auto& plan = std::get<catalogue::SwingPlan>(benchmark.plan);
  constexpr double one_swing = 0.55;  // there and back, at 90 degrees and less [s]
  SwingQuality q{nan, nan, nan, nan};
  const auto& frames = recording.frames;
  if (recording.outcome != Outcome::complete || frames.size() < 3) return q;
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ(), side = plan.axis_W.cross(down);
  const auto angle = [&](const Frame& frame) {
    const Eigen::Vector3d arm = pose(frame, 0).R * -plan.pivot_O;
    return std::atan2(arm.dot(side), arm.dot(down));
  };
  q.swing_left = q.pivot_slip = 0;
  std::vector<double> passes;
  double before = nan, middle = nan;  // of the last two frames
  for (const Frame& frame : frames) {
    const double now = angle(frame);
    const Eigen::Vector3d slip = pose(frame, 0) * plan.pivot_O - plan.pivot_W;
    q.pivot_slip = std::max(q.pivot_slip, (slip - slip.dot(plan.axis_W) * plan.axis_W).norm());
    if (frame.t >= frames.back().t - one_swing) q.swing_left = std::max(q.swing_left, std::abs(now));
    const bool fast = std::abs(now - middle) < 1;  // not the jump from π to −π; false for the first frame
    if (fast && middle * now < 0) {
      const double dt = frame.t - frames[std::size_t(&frame - frames.data()) - 1].t;
      passes.push_back(frame.t - dt * now / (now - middle));
    }
    const double turn = (now - middle) * (middle - before);
    if (std::isnan(q.turning_angle) && middle != before) {
      if (turn < 0)  // the top of the parabola through three frames
        q.turning_angle = std::abs(middle - (now - before) * (now - before) / (8 * (now - 2 * middle + before)));
      if (turn == 0) q.turning_angle = std::abs(middle);  // it stopped dead
    }
    before = middle;
    middle = now;
  }
  if (passes.size() > 1) q.half_period = passes[1] - passes[0];
  return q;
}

std::vector<Gate> quality_gates(const BenchmarkScene& benchmark, const Recording& recording) {
  return std::visit([&](const auto& plan) { return gates_of(plan, benchmark, recording); }, benchmark.plan);
}

}  // namespace handhold::compare
