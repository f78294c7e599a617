// SPDX-License-Identifier: GPL-3.0-or-later
// Springs without slip: held cube (G10), tray (G07), shaken pinch (G11), pendulum; and the Jenkins loop (G03, G12).
// Figures "of the catalogue" were computed by another program and are copied with their id.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cases/closed_form/held_cube.hpp"
#include "cases/closed_form/jenkins_loop.hpp"
#include "cases/closed_form/pendulum.hpp"
#include "cases/closed_form/shaken_pinch.hpp"
#include "cases/closed_form/tray.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using Eigen::Vector3d;
using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

Eigen::Matrix3d turned(const Vector3d& v) {
  return v.norm() > 0 ? Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() : Eigen::Matrix3d::Identity();
}

/// Energy of springs k from the points of a body, moved by x = (shift, turn), to points in space.
struct Springs {
  double stiffness{};
  std::vector<Vector3d> on_body{}, in_space{};
  Vector3d weight{Vector3d::Zero()}, center{Vector3d::Zero()};  // and a force on a point of the body

  [[nodiscard]] double energy(const Eigen::VectorXd& x) const {
    const Eigen::Matrix3d R = turned(x.tail<3>());
    double sum = -weight.dot(R * center + x.head<3>());
    for (std::size_t i = 0; i < on_body.size(); ++i)
      sum += 0.5 * stiffness * (in_space[i] - x.head<3>() - R * on_body[i]).squaredNorm();
    return sum;
  }
};

/// Second derivative along `direction` by a central difference.
double rigidity(const Springs& springs, int direction, double step) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6);
  const double middle = springs.energy(x);
  x[direction] = step;
  const double up = springs.energy(x);
  x[direction] = -step;
  return (up - 2 * middle + springs.energy(x)) / (step * step);
}

TEST(HeldCube, AgreesWithTheCatalogue) {  // G10, set 0
  const HeldCube cube;
  EXPECT_NEAR(translation_frequency(cube), 89.44271909999159, 1e-12);
  EXPECT_NEAR(roll_frequency(cube), 104.65944773406746, 1e-12);
  EXPECT_NEAR(spin_frequency(cube), 17.527121840165314, 1e-13);
  EXPECT_NEAR(sag(cube), 0.0012262500000000001, 1e-17);
}

TEST(HeldCube, FrequenciesAreThoseOfTheSpringsEnergy) {
  const HeldCube cube{.edge = 0.06, .radius = 0.007, .depth = 0.004};
  Springs springs{.stiffness = cube.stiffness / 8};
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < 8; ++i) {
      const double at = std::numbers::pi * i / 4, x = cube.radius * std::cos(at), z = cube.radius * std::sin(at);
      springs.on_body.emplace_back(x, side * cube.edge / 2, z);
      springs.in_space.emplace_back(x, side * (cube.edge / 2 - cube.depth), z);
    }
  const auto frequency = [&](int direction, double step, double mass) {
    return std::sqrt(rigidity(springs, direction, step) / mass);
  };
  // Differences of an energy of 0.1 J: 1e-16 of it over step², and the step's own square for the turns.
  EXPECT_NEAR(frequency(0, 1e-3, cube.mass) / translation_frequency(cube), 1, 1e-9);
  EXPECT_NEAR(frequency(1, 1e-3, cube.mass) / translation_frequency(cube), 1, 1e-9);
  EXPECT_NEAR(frequency(3, 1e-3, inertia(cube)) / roll_frequency(cube), 1, 1e-6);
  EXPECT_NEAR(frequency(4, 1e-3, inertia(cube)) / spin_frequency(cube), 1, 1e-6);
}

TEST(Pendulum, AgreesWithIntegration) {
  const double w = 11;
  const auto rates = [w](double, const State& y) { return State{y[1], -w * w * std::sin(y[0])}; };
  for (const double t : {0.05, 0.3, 0.9}) {
    EXPECT_NEAR(swing_from_bottom(w, 13, t), integrate(rates, {0, {0, 13}}, t).y[0], 1e-11);
    EXPECT_NEAR(swing_from_rest(w, 1.2, t), integrate(rates, {0, {1.2, 0}}, t).y[0], 1e-11);
  }
  const Point there = integrate_until(
      rates, {0, {0, 13}}, [](double, const State& y) { return y[0] - 1; }, 0.5);
  EXPECT_NEAR(time_to_angle(w, 13, 1), there.t, 1e-12);
  EXPECT_TRUE(std::isnan(time_to_angle(w, 1, 1)));
  const double f = std::sqrt(0.1 * 9.81 * 0.05 / 4e-4);  // F03, sets 0 and 1
  EXPECT_NEAR(swing_period(f, 1.2), 0.6231258548859231, 1e-14);
  EXPECT_NEAR(swing_period(f, 2.8), 1.146606944289626, 1e-13);
}

TEST(Tray, AgreesWithTheCatalogueWhenLevel) {  // G07, set 0
  const Tray tray;
  const double expected[] = {1.3407, 1.0137, 0.9483, 0.6213};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(level_forces(tray)[i], expected[i], 1e-14);
  EXPECT_NEAR(rigid_bounds(tray).low, 0.7194, 1e-14);
  EXPECT_NEAR(rigid_bounds(tray).high, 2.289, 1e-14);
  Tray stiff = tray;
  stiff.stiffness = 1e9;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(vertical_forces(stiff)[i], expected[i], 1e-8);
}

// The rest is the least energy: Newton's method on differences of it, in all six directions.
TEST(Tray, ForcesAreThoseOfTheLeastEnergy) {
  const Tray t{.stiffness = 500};
  Springs springs{.stiffness = t.stiffness};
  springs.weight = {0, 0, -t.mass * t.gravity};
  springs.center = {t.x, t.y, t.height};
  for (const double x : {t.a, -t.a})
    for (const double y : {t.b, -t.b}) {
      springs.on_body.emplace_back(x, y, 0);
      springs.in_space.emplace_back(x, y, 0);
    }
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6);
  const double e = 1e-5;
  const auto slope = [&](Eigen::VectorXd at, int i) {
    at[i] += e;
    const double up = springs.energy(at);
    at[i] -= 2 * e;
    return (up - springs.energy(at)) / (2 * e);
  };
  for (int iteration = 0; iteration < 8; ++iteration) {
    Eigen::VectorXd gradient(6);
    Eigen::MatrixXd hessian(6, 6);
    for (int i = 0; i < 6; ++i) {
      gradient[i] = slope(x, i);
      for (int j = 0; j < 6; ++j) {
        Eigen::VectorXd up = x, down = x;
        up[j] += 1e-3;
        down[j] -= 1e-3;
        hessian(i, j) = (slope(up, i) - slope(down, i)) / 2e-3;
      }
    }
    x -= hessian.fullPivLu().solve(gradient);
  }
  const Eigen::Matrix3d R = turned(x.tail<3>());
  const auto force = vertical_forces(t);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d pull = t.stiffness * (springs.in_space[i] - x.head<3>() - R * springs.on_body[i]);
    EXPECT_NEAR(force[i], pull.z(), 1e-7) << i;  // differences of the energy: 1e-17 J over 1e-5, in springs of 500 N/m
  }
  EXPECT_GT(std::abs(force[0] - level_forces(t)[0]), 1e-3);  // the lean matters
}

TEST(ShakenPinch, AgreesWithTheCatalogueAndIntegration) {  // G11, set 0
  const ShakenPinch p;
  EXPECT_NEAR(relative_amplitude(p), 0.001, 1e-18);
  EXPECT_NEAR(relative_displacement(p, 0.37), 0.0007882520673753163, 1e-16);
  EXPECT_NEAR(p.stiffness * (p.preload - relative_amplitude(p)), 1.6, 1e-14);
  EXPECT_NEAR(critical_amplitude(p), 0.012, 1e-16);
  const auto hand = [&](double t) { return p.amplitude * std::sin(p.frequency * t); };
  const auto rates = [&](double t, const State& y) {  // a finger on either side, pushing only
    const double z = y[0] - hand(t);
    const double first = std::max(0.0, p.preload - z), second = std::max(0.0, p.preload + z);
    return State{y[1], p.stiffness * (first - second) / p.mass};
  };
  const Point end = integrate(rates, {0, {0, start_velocity(p)}}, 0.2);
  EXPECT_NEAR(relative_displacement(p, 0.2), end.y[0] - hand(0.2), 1e-12);
  EXPECT_NEAR(normal_force(p, 0.2), p.stiffness * (p.preload + end.y[0] - hand(0.2)), 1e-9);
}

struct Mapped {
  double force{}, loss{};
};

/// Return mapping of the element over displacements from 0 to `to[0]`, then to[1], ...
Mapped return_mapping(const JenkinsLoop& l, const std::vector<double>& to) {
  Mapped m;
  double anchor = 0, x = 0;
  const int steps = 100000;
  for (const double target : to) {
    const double from = x;
    for (int i = 1; i <= steps; ++i) {
      x = from + (target - from) * i / steps;
      const double trial = l.stiffness * (x - anchor), limit = l.mu * l.normal_force;
      m.force = std::clamp(trial, -limit, limit);
      const double moved = x - m.force / l.stiffness - anchor;
      m.loss += m.force * moved;
      anchor += moved;
    }
  }
  return m;
}

TEST(JenkinsLoop, AgreesWithTheCatalogueAndReturnMapping) {  // G03, sets 0 and 1
  const JenkinsLoop yields, elastic{.amplitude = 0.001};
  EXPECT_NEAR(loss_per_cycle(yields), 0.011, 1e-17);
  EXPECT_NEAR(greatest_force(yields), 1, 1e-16);
  EXPECT_NEAR(reversal_distance(yields), 0.0025, 1e-18);
  EXPECT_EQ(loss_per_cycle(elastic), 0);
  EXPECT_NEAR(greatest_force(elastic), 0.8, 1e-16);
  const double A = yields.amplitude;
  const Mapped quarter = return_mapping(yields, {A}), cycle = return_mapping(yields, {A, -A, A});
  EXPECT_NEAR(quarter.loss, loss_per_cycle(yields) / 4, 1e-12);
  EXPECT_NEAR(cycle.loss - quarter.loss, loss_per_cycle(yields), 1e-12);
  EXPECT_NEAR(return_mapping(yields, {A, 0.003}).force, returning_force(yields, 0.003), 1e-12);
  EXPECT_NEAR(return_mapping(yields, {A, 0.0}).force, returning_force(yields, 0), 1e-12);
  EXPECT_NEAR(return_mapping(elastic, {0.001, -0.0004}).force, returning_force(elastic, -0.0004), 1e-12);
}

}  // namespace
}  // namespace handhold::closed_form
