// SPDX-License-Identifier: Apache-2.0
#include "cases/model/rigid_problem.hpp"

#include <cmath>
#include <string>

#include <Eigen/Eigenvalues>

#include "cases/model/input_error.hpp"
#include "cases/model/rotation.hpp"
#include "cases/model/text.hpp"

namespace handhold {
namespace {

constexpr std::size_t most_supports = 5;    // modes are tried in all combinations
constexpr double path_tolerance = 1e-4;     // of derivatives against central differences
constexpr double overlap_tolerance = 1e-9;  // [m]

[[noreturn]] void reject(const std::string& what, const std::string& rule, const std::string& advice) {
  throw InputError(sentence(what, ": ", rule, " (", advice, ")"));
}

void check_body(const RigidProblem& p) {
  if (!(p.mass > 0) || !std::isfinite(p.mass)) reject(sentence("mass=", p.mass, " kg"), "must be > 0", "weigh it");
  if (p.mobility == Mobility::fixed) reject("mobility=fixed", "nothing to simulate", "choose free or translation");
  if (!p.inertia.allFinite() || !p.inertia.isApprox(p.inertia.transpose(), 1e-12))
    reject("inertia", "must be finite and symmetric", "give it about the centre of mass");
  const Eigen::Vector3d J = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(p.inertia).eigenvalues();
  if (!(J[0] > 0) || J[0] + J[1] < J[2] * (1 - 1e-12))
    reject(sentence("inertia with principal moments ", J[0], ", ", J[1], ", ", J[2], " kg m²"),
           "no solid has it: all > 0, none greater than the other two together", "give it about the centre of mass");
}

void check_start(const RigidProblem& p) {
  const double length = p.X_WB.R.norm();
  if (!p.X_WB.p.allFinite() || !(std::abs(length - 1) < 1e-6))
    reject("X_WB", "must be a finite place and a unit quaternion", "normalise it");
  if (!p.V_WB.v.allFinite() || !p.V_WB.w.allFinite()) reject("V_WB", "must be finite", "check the start velocity");
  if (p.mobility == Mobility::translation && !p.V_WB.w.isZero(0))
    reject("V_WB.w of a translating body", "must be zero", "use mobility free");
  if (!p.gravity.allFinite()) reject("gravity", "must be finite", "9.81 downwards is usual");
  if (!(p.duration > 0) || !std::isfinite(p.duration))
    reject(sentence("duration=", p.duration, " s"), "must be finite and > 0", "give seconds");
}

/// v = dp/dt and a = dv/dt by central differences at three instants.
void check_path(const RigidPath& path, double duration, const std::string& name) {
  for (const double t : {0.1 * duration, 0.45 * duration, 0.9 * duration}) {
    const double h = 1e-6 * duration;
    const PathPoint before = at(path, t - h), here = at(path, t), after = at(path, t + h);
    if (!here.p.allFinite() || !here.v.allFinite() || !here.a.allFinite())
      reject(sentence(name, " at t=", t, " s"), "its path must be finite", "check the path function");
    const double v_error = ((after.p - before.p) / (2 * h) - here.v).norm() / (1 + here.v.norm());
    const double a_error = ((after.v - before.v) / (2 * h) - here.a).norm() / (1 + here.a.norm());
    if (v_error > path_tolerance || a_error > path_tolerance)
      reject(sentence(name, " at t=", t, " s"), "v and a must be the derivatives of its path's p",
             "check the path function");
  }
}

/// w from R and alpha from w, in the same way.
void check_turn(const RigidTurn& turn, double duration, const std::string& name) {
  for (const double t : {0.1 * duration, 0.45 * duration, 0.9 * duration}) {
    const double h = 1e-6 * duration;
    const TurnPoint before = at(turn, t - h), here = at(turn, t), after = at(turn, t + h);
    if (!here.w.allFinite() || !here.alpha.allFinite() || !(std::abs(here.R.norm() - 1) < 1e-6))
      reject(sentence(name, " at t=", t, " s"), "its turn must be finite and R a unit quaternion", "normalise it");
    const Eigen::Vector3d w = rotation_vector(after.R * before.R.conjugate()) / (2 * h);
    const double w_error = (w - here.w).norm() / (1 + here.w.norm());
    const double a_error = ((after.w - before.w) / (2 * h) - here.alpha).norm() / (1 + here.alpha.norm());
    if (!(w_error <= path_tolerance) || !(a_error <= path_tolerance))
      reject(sentence(name, " at t=", t, " s"), "w and alpha must be the rates of its turn's R, in W",
             "check the turn function");
  }
}

void check_surface(const RigidSupport& s, const std::string& name) {
  const RigidSurface& surface = s.surface;
  if (!surface.point.allFinite() || !surface.direction.allFinite() || !(surface.direction.norm() > 0))
    reject(name, "its surface needs a finite place and a direction", "give the normal, or the axis");
  if (surface.kind != RigidSurface::Kind::plane && !(surface.radius > 0 && std::isfinite(surface.radius)))
    reject(sentence(name, " of radius ", surface.radius, " m"), "must be > 0", "or use a plane");
  if (surface.kind != RigidSurface::Kind::plane && surface.hollow && s.radius >= surface.radius)
    reject(sentence(name, ", hollow, of radius ", surface.radius, " m"), "must be wider than the ball in it",
           "use a smaller ball");
}

void check_pressed(const RigidProblem& p, const RigidSupport& s, const std::string& name) {
  if (!s.normal_force) return;
  if (s.surface.kind != RigidSurface::Kind::plane) reject(name, "only planes can press", "leave normal_force empty");
  if (s.turn) reject(name, "a plane that presses cannot turn", "leave normal_force or turn empty");
  if (p.mobility == Mobility::free && s.radius == 0)
    reject(name, "a pressing plane on a foot of a body that rotates does not say where the finger is",
           "use mobility translation, or a ball");
  for (const double t : {0.0, 0.5 * p.duration, p.duration})
    if (!std::isfinite(s.normal_force(t)))
      reject(sentence(name, " at t=", t, " s"), "normal_force must be finite", "check the function");
}

void check_overlap(const RigidProblem& p, const RigidSupport& s, const std::string& name) {
  if (s.normal_force) return;
  const double gap = proximity(s, 0, p.X_WB * s.point_B).distance - s.radius;
  if (gap < -overlap_tolerance)
    reject(sentence(name, " with a gap of ", gap, " m at t=0"), "the body starts inside it", "move it out");
}

void check_support(const RigidProblem& p, const RigidSupport& s, const std::string& name) {
  validate(s.friction);
  if (!s.point_B.allFinite() || !(s.radius >= 0) || !std::isfinite(s.radius))
    reject(name, "needs a finite point of the body and a ball radius >= 0", "0 is a foot");
  check_surface(s, name);
  if (s.motion) check_path(s.motion, p.duration, name);
  if (s.turn) check_turn(s.turn, p.duration, name);
  check_pressed(p, s, name);
  check_overlap(p, s, name);
}

void check_spring(const RigidProblem& p, const RigidSpring& s, const std::string& name) {
  if (!(s.stiffness >= 0) || !std::isfinite(s.stiffness) || !s.point_B.allFinite() || !s.anchor_W.allFinite())
    reject(name, "needs a stiffness >= 0 and finite points", "check it");
  if (s.motion) check_path(s.motion, p.duration, name);
}

}  // namespace

PathPoint at(const RigidPath& path, double t) { return path ? path(t) : PathPoint(); }

TurnPoint at(const RigidTurn& turn, double t) { return turn ? turn(t) : TurnPoint(); }

Proximity proximity(const RigidSupport& support, double t, const Eigen::Vector3d& x_W) {
  const Eigen::Vector3d from = x_W - at(support.motion, t).p;
  if (!support.turn) return proximity(support.surface, from);
  const Eigen::Matrix3d R = support.turn(t).R.toRotationMatrix();
  const Proximity in_S = proximity(support.surface, R.transpose() * from);
  return {in_S.distance, R * in_S.normal, R * in_S.curvature * R.transpose()};
}

void validate(const RigidProblem& problem) {
  check_body(problem);
  check_start(problem);
  if (problem.supports.size() > most_supports)
    reject(sentence(problem.supports.size(), " supports"), sentence("at most ", most_supports),
           "rigid contacts beyond symmetry have no unique forces");
  for (std::size_t i = 0; i < problem.supports.size(); ++i)
    check_support(problem, problem.supports[i], sentence("support ", i));
  for (std::size_t i = 0; i < problem.springs.size(); ++i)
    check_spring(problem, problem.springs[i], sentence("spring ", i));
  if (!problem.load) return;
  const Load load = problem.load(0, {problem.X_WB, problem.V_WB});
  if (!load.force_W.allFinite() || !load.torque_W.allFinite())
    reject("load at t=0", "must be finite", "check the function");
}

}  // namespace handhold
