#pragma once

// Problems with closed forms, and how far a run is from them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "cases/model/friction.hpp"
#include "reference/rigid/rigid.hpp"

namespace handhold::reference::rigid::testing {

inline constexpr double g = 9.81;
inline const Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX(), y_axis = Eigen::Vector3d::UnitY(),
                             z_axis = Eigen::Vector3d::UnitZ();

/// The greatest deviation from what is expected, relative to it or to a given scale.
class Worst {
 public:
  void add(double got, double expected) { add(got, expected, std::abs(expected)); }
  void add(double got, double expected, double scale) {
    const double error = std::abs(got - expected) / scale;
    worst_ = error <= worst_ ? worst_ : error;  // also true of NaN: it stays
  }
  void require(bool held) {
    if (!held) worst_ = std::numeric_limits<double>::infinity();
  }
  /// kinetic + potential + elastic + dissipated − hand_work − start, over all frames.
  void add_energy(const Trajectory& t, double scale) {
    const auto sum = [](const Energy& e) { return e.kinetic + e.potential + e.elastic + e.dissipated - e.hand_work; };
    for (const Frame& f : t.frames) add(sum(f.energy), sum(t.frames.front().energy), scale);
  }
  [[nodiscard]] double value() const { return worst_; }

 private:
  double worst_{0};
};

/// A case of the catalogue: how far a run with these options is from its closed form.
struct RigidCase {
  std::string name{};
  std::function<double(const Options&)> worst{};
  double smallness{1};  ///< how much smaller than a few centimetres the case is
};

inline std::ostream& operator<<(std::ostream& out, const RigidCase& c) { return out << c.name; }

/// At accuracies 1e-8, 1e-10 and 1e-12. The project's bound for L1 is 1e-9, asked for at 1e-12. Accuracy is absolute
/// and of a step; runs take some hundred steps over a tenth of a metre: a hundred times it, relative, is what is asked
/// for at the others.
class ClosedForm : public ::testing::TestWithParam<std::tuple<RigidCase, double>> {
 protected:
  void check() {
    const auto& [rigid_case, accuracy] = GetParam();
    const double worst = rigid_case.worst({accuracy, 1e-3, 100});
    RecordProperty("worst", std::to_string(worst * 1e12) + "e-12");
    std::printf("[  figure  ] %s at accuracy %.0e: %.1e\n", rigid_case.name.c_str(), accuracy, worst);
    EXPECT_LE(worst, rigid_case.smallness * std::max(1e-9, 100 * accuracy));
  }
};

inline std::string case_name(const ::testing::TestParamInfo<std::tuple<RigidCase, double>>& info) {
  const auto& [rigid_case, accuracy] = info.param;
  return rigid_case.name + "_1em" + std::to_string(int(std::lround(-std::log10(accuracy))));
}

inline auto at_all_accuracies(const std::vector<RigidCase>& cases) {
  return ::testing::Combine(::testing::ValuesIn(cases), ::testing::Values(1e-8, 1e-10, 1e-12));
}

/// A run that must come to its end.
inline Trajectory run(const RigidProblem& problem, const Options& options) {
  Trajectory t = simulate(problem, options);
  if (t.outcome != Outcome::complete) throw std::runtime_error("the run stalled: " + t.note);
  return t;
}

/// A small block on the plane z = 0.
inline RigidProblem block(double mass, const Friction& friction, double duration) {
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

/// Gravity as seen from a slope that falls towards +x.
inline Eigen::Vector3d tilted_gravity(double slope, double gravity = g) {
  return gravity * Eigen::Vector3d(std::sin(slope), 0, -std::cos(slope));
}

/// `amplitude` sin(frequency t + phase) along an axis.
inline RigidPath sine(const Eigen::Vector3d& axis, double amplitude, double frequency, double phase = 0) {
  return [=](double t) {
    const double angle = frequency * t + phase;
    return PathPoint{amplitude * std::sin(angle) * axis, amplitude * frequency * std::cos(angle) * axis,
                     -amplitude * frequency * frequency * std::sin(angle) * axis};
  };
}

inline RigidPath steady(const Eigen::Vector3d& velocity) {
  return [=](double t) { return PathPoint{t * velocity, velocity, Eigen::Vector3d::Zero()}; };
}

/// Fingers evenly around the z axis that press inwards with N(t) each, on feet of a body that does not turn.
inline RigidProblem grip(int fingers, double mass, const Friction& friction, const std::function<double(double)>& N,
                         const RigidPath& hand, double duration) {
  RigidProblem p;
  p.mass = mass;
  p.mobility = Mobility::translation;
  p.gravity = -g * z_axis;
  p.duration = duration;
  for (int i = 0; i < fingers; ++i) {
    const double angle = 2 * std::acos(-1.0) * (i + 0.25 * fingers) / fingers;  // two fingers: along y
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

/// A ball of inertia β m r² that touches the plane z = 0.
inline RigidProblem ball(double mass, double radius, double beta, double mu, double duration) {
  RigidProblem p = block(mass, {mu, mu}, duration);
  p.mobility = Mobility::free;
  p.inertia = Eigen::Matrix3d::Identity() * beta * mass * radius * radius;
  p.X_WB.p = radius * z_axis;
  p.supports[0].radius = radius;
  return p;
}

}  // namespace handhold::reference::rigid::testing
