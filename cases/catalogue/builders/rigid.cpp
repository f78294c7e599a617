// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/rigid.hpp"

#include <cmath>
#include <numbers>

namespace handhold::catalogue::rigid {

RigidProblem block(double mass, const Friction& friction, double duration) {
  RigidProblem p;
  p.mass = mass;
  p.mobility = Mobility::translation;
  p.gravity = -g * z_axis;
  p.duration = duration;
  RigidSupport floor;
  floor.surface = make_plane(Eigen::Vector3d::Zero(), z_axis);
  floor.friction = friction;
  p.supports = {floor};
  return p;
}

RigidProblem sprung_block(double mass, double stiffness, const Friction& friction, double x, double duration) {
  RigidProblem p = block(mass, friction, duration);
  p.X_WB.p.x() = x;
  p.springs = {{stiffness, {0, 0, 0}, {0, 0, 0}, {}}};
  return p;
}

RigidProblem grip(int fingers, double mass, const Friction& friction, const std::function<double(double)>& N,
                  const RigidPath& hand, double duration) {
  RigidProblem p = block(mass, friction, duration);
  p.supports.clear();
  for (int i = 0; i < fingers; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.25 * fingers) / fingers;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0);
    RigidSupport finger;
    finger.surface = make_plane(0.03 * out, -out);
    finger.motion = hand;
    finger.normal_force = N;
    finger.friction = friction;
    finger.point_B = 0.03 * out;
    p.supports.push_back(finger);
  }
  return p;
}

RigidProblem ball(double mass, double radius, double beta, double mu, double duration) {
  RigidProblem p = block(mass, {mu, mu}, duration);
  p.mobility = Mobility::free;
  p.inertia = Eigen::Matrix3d::Identity() * beta * mass * radius * radius;
  p.X_WB.p = radius * z_axis;
  p.supports[0].radius = radius;
  return p;
}

RigidProblem ball_between_plates(double mass, double radius, double beta, double N, double mu, const RigidPath& upper,
                                 const RigidPath& lower, double duration) {
  RigidProblem p = ball(mass, radius, beta, mu, duration);
  p.gravity.setZero();
  p.X_WB.p.setZero();
  p.supports[0].surface = make_plane(-radius * z_axis, z_axis);
  p.supports[0].motion = lower;
  RigidSupport top = p.supports[0];
  top.surface = make_plane(radius * z_axis, -z_axis);
  top.motion = upper;
  top.normal_force = constant(N);
  p.supports.push_back(top);
  return p;
}

Eigen::Vector3d tilted_gravity(double slope, double gravity) {
  return gravity * Eigen::Vector3d(std::sin(slope), 0, -std::cos(slope));
}

std::function<double(double)> constant(double value) {
  return [=](double) { return value; };
}

RigidPath sine(const Eigen::Vector3d& axis, double amplitude, double frequency, double phase) {
  return [=](double t) {
    const double angle = frequency * t + phase;
    return PathPoint{amplitude * std::sin(angle) * axis, amplitude * frequency * std::cos(angle) * axis,
                     -amplitude * frequency * frequency * std::sin(angle) * axis};
  };
}

RigidPath steady(const Eigen::Vector3d& velocity) {
  return [=](double t) { return PathPoint{t * velocity, velocity, Eigen::Vector3d::Zero()}; };
}

RigidPath accelerating(const Eigen::Vector3d& acceleration) {
  return [=](double t) { return PathPoint{0.5 * t * t * acceleration, t * acceleration, acceleration}; };
}

RigidPath jerking(const Eigen::Vector3d& jerk) {
  return [=](double t) { return PathPoint{t * t * t / 6 * jerk, t * t / 2 * jerk, t * jerk}; };
}

RigidTurn turning(const Eigen::Vector3d& axis, double rate, double acceleration) {
  return [=](double t) {
    const double angle = rate * t + acceleration * t * t / 2;
    return TurnPoint{Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), (rate + acceleration * t) * axis,
                     acceleration * axis};
  };
}

}  // namespace handhold::catalogue::rigid
