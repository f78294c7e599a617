// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/sampled_problem.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::compare {
namespace {

using Vectors = std::vector<Eigen::Vector3d>;

constexpr double most_steps = 1e7;
constexpr double block_half = 0.02;   // of the cube that stands on a single foot: hand-sized [m]
constexpr double bead_radius = 0.01;  // of the ball about a foot on a curved surface [m]
constexpr double same = 1e-9;         // two lengths are the same [m]

[[noreturn]] void reject(const std::string& what, const std::string& rule, const std::string& advice) {
  throw InputError(fmt::format("{}: {} ({})", what, rule, advice));
}

Primitive ball(double radius, const Eigen::Vector3d& center_B) {
  return {Primitive::Kind::ball, Eigen::Vector3d::Zero(), radius, {Eigen::Quaterniond::Identity(), center_B}};
}

/// A cube that stands with a face on the foot, which lies in the plane of normal n.
Primitive standing_cube(const Eigen::Vector3d& foot_B, const Eigen::Vector3d& n_B) {
  const Eigen::Quaterniond R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n_B);
  return {Primitive::Kind::box, Eigen::Vector3d::Constant(block_half), 0, {R, foot_B + block_half * n_B}};
}

/// A cube between two opposite faces.
Primitive pinched_cube(const Eigen::Vector3d& foot_B, const Eigen::Vector3d& n_B, double distance) {
  const Eigen::Quaterniond R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n_B);
  const double half = distance / 2;
  return {Primitive::Kind::box, Eigen::Vector3d::Constant(half), 0, {R, foot_B + half * n_B}};
}

Eigen::Vector3d normal_B(const RigidProblem& problem, const RigidSupport& s) {
  return problem.X_WB.R.conjugate() * s.surface.direction.normalized();
}

/// Planes alone, feet alone.
Primitive shape_on_planes(const RigidProblem& problem) {
  const std::vector<RigidSupport>& supports = problem.supports;
  const Eigen::Vector3d foot = supports[0].point_B, n = normal_B(problem, supports[0]);
  if (supports.size() == 1) return standing_cube(foot, n);
  const Eigen::Vector3d across = supports.back().point_B - foot;
  if (supports.size() == 2 && (normal_B(problem, supports[1]) + n).norm() < same &&
      (across - across.dot(n) * n).norm() < same)
    return pinched_cube(foot, n, across.dot(n));
  const double radius = foot.norm();
  const auto on_ball = [&](const RigidSupport& s) { return (s.point_B + radius * normal_B(problem, s)).norm() < same; };
  if (!std::all_of(supports.begin(), supports.end(), on_ball))
    reject(fmt::format("a body on {} planes", supports.size()), "its feet fit neither a cube nor a ball",
           "give its shape");
  return ball(radius, Eigen::Vector3d::Zero());
}

/// The plainest volume that touches where the problem's points and balls do. Where a body does not turn, a shape's
/// place only decides where its force acts, which nobody feels.
std::vector<Primitive> plain_shapes(const RigidProblem& problem) {
  const std::vector<RigidSupport>& supports = problem.supports;
  if (supports.empty()) return {ball(bead_radius, Eigen::Vector3d::Zero())};
  const auto is_ball = [](const RigidSupport& s) { return s.radius > 0; };
  if (std::all_of(supports.begin(), supports.end(), is_ball)) {
    std::vector<Primitive> balls;
    for (const RigidSupport& s : supports)
      if (balls.empty() || balls.back().radius != s.radius || balls.back().X_BS.p != s.point_B)
        balls.push_back(ball(s.radius, s.point_B));
    return balls;
  }
  if (problem.mobility != Mobility::translation || std::any_of(supports.begin(), supports.end(), is_ball))
    reject("a body that turns on feet", "points alone do not say what it looks like", "give its shape");
  const auto is_plane = [](const RigidSupport& s) { return s.surface.kind == RigidSurface::Kind::plane; };
  if (std::all_of(supports.begin(), supports.end(), is_plane)) return {shape_on_planes(problem)};
  return {ball(bead_radius, supports[0].point_B)};
}

SampledMotion sampled(const RigidPath& path, const RigidTurn& turn, double step, int steps) {
  SampledMotion motion;
  if (!path && !turn) return motion;
  for (int k = 0; k <= steps; ++k) {
    const PathPoint point = at(path, k * step);
    motion.p.push_back(point.p);
    motion.v.push_back(point.v);
    if (!turn) continue;
    const TurnPoint attitude = turn(k * step);
    motion.q.push_back(attitude.R);
    motion.w.push_back(attitude.w);
  }
  return motion;
}

/// Looks at the load with another state of the body, too: a load that follows it cannot be written down.
void sample_load(const RigidProblem& problem, double step, int steps, SampledProblem::Body& body) {
  if (!problem.load) return;
  const BodyState start{problem.X_WB, problem.V_WB};
  const BodyState other{{Eigen::Quaterniond(0.8, 0, 0.6, 0), problem.X_WB.p + Eigen::Vector3d(0.1, 0.2, 0.3)},
                        {problem.V_WB.w + Eigen::Vector3d(1, 2, 3), problem.V_WB.v + Eigen::Vector3d(3, 2, 1)}};
  for (int k = 0; k <= steps; ++k) {
    const Load load = problem.load(k * step, start), elsewhere = problem.load(k * step, other);
    if (load.force_W != elsewhere.force_W || load.torque_W != elsewhere.torque_W)
      reject(fmt::format("load at t={:g} s", k * step), "depends on the body's motion, which a file cannot express",
             "leave this problem to engines in C++");
    body.force.push_back(load.force_W);
    body.torque.push_back(load.torque_W);
  }
  const auto is_zero = [](const Eigen::Vector3d& v) { return v.isZero(0); };
  if (std::all_of(body.torque.begin(), body.torque.end(), is_zero)) body.torque.clear();
  if (std::all_of(body.force.begin(), body.force.end(), is_zero)) body.force.clear();
}

SampledProblem::Support sampled_support(const RigidSupport& s, int number, double step, int steps) {
  SampledProblem::Support out{
      fmt::format("support {}", number),     "body", s.surface, s.friction, s.point_B, s.radius, {},
      sampled(s.motion, s.turn, step, steps)};
  out.surface.direction.normalize();
  if (s.normal_force)
    for (int k = 0; k <= steps; ++k) out.normal_force.push_back(s.normal_force(k * step));
  return out;
}

}  // namespace

SampledProblem sample(const RigidProblem& problem, const std::string& name, double step, int frame_every,
                      std::vector<Primitive> shapes) {
  validate(problem);
  if (!(step > 0) || problem.duration / step > most_steps)
    reject(fmt::format("step={} s", step), "must be > 0 and give at most ten million steps", "1/360 s is usual");
  if (frame_every < 1) reject(fmt::format("frame_every={}", frame_every), "must be at least 1", "1 writes every step");
  SampledProblem out;
  out.name = name;
  out.step = step;
  const double frames = problem.duration / (step * frame_every);
  out.steps = frame_every * int(std::ceil(frames - 1e-9));  // a whole number of frames is not to round to one more
  out.frame_every = frame_every;
  out.gravity = problem.gravity;
  out.bodies = {{"body",
                 problem.mass,
                 problem.inertia,
                 problem.mobility == Mobility::free,
                 problem.X_WB,
                 problem.V_WB,
                 shapes.empty() ? plain_shapes(problem) : std::move(shapes),
                 {},
                 {}}};
  sample_load(problem, step, out.steps, out.bodies[0]);
  for (std::size_t i = 0; i < problem.supports.size(); ++i)
    out.supports.push_back(sampled_support(problem.supports[i], int(i), step, out.steps));
  for (const RigidSpring& s : problem.springs)
    out.springs.push_back({"body", s.stiffness, s.point_B, s.anchor_W, sampled(s.motion, {}, step, out.steps)});
  return out;
}

}  // namespace handhold::compare
