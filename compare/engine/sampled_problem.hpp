// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cases/model/rigid_problem.hpp"

namespace handhold::compare {

/// A volume fixed to a body, for engines that do not touch with points.
struct Primitive {
  enum class Kind { box, ball };
  Kind kind{Kind::box};
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< of a box [m]
  double radius{};                                        ///< of a ball [m]
  Pose X_BS{};                                            ///< in the body's frame
};

/// How a surface or a spring's end moves: X(t) of a frame that is W at path position 0, at t = k step.
struct SampledMotion {
  std::vector<Eigen::Vector3d> p{};     ///< [m]; empty: at rest
  std::vector<Eigen::Vector3d> v{};     ///< of the frame's origin [m/s]
  std::vector<Eigen::Quaterniond> q{};  ///< empty: it does not turn
  std::vector<Eigen::Vector3d> w{};     ///< [rad/s]; empty: it does not turn
};

/// A rigid problem (L1) as a foreign process gets it: every function of time as samples at t = k step, k = 0 ... steps.
/// As a file: problem_json.hpp; what each field means to an engine: docs/engines.md.
struct SampledProblem {
  struct Body {
    std::string name{};
    double mass{1};                                        ///< [kg]
    Eigen::Matrix3d inertia{Eigen::Matrix3d::Identity()};  ///< about the centre of mass, axes of B [kg m²]
    bool turns{true};                                      ///< false: it translates only
    Pose X_WB{};                                           ///< at t = 0; B's origin is the centre of mass
    Twist V_WB{};                                          ///< at t = 0
    std::vector<Primitive> shapes{};
    std::vector<Eigen::Vector3d> force{};   ///< at the centre of mass, in W [N]; empty: none
    std::vector<Eigen::Vector3d> torque{};  ///< in W [N m]; empty: none
  };
  struct Support {
    std::string name{};
    std::string body{};  ///< that it touches
    RigidSurface surface{};
    Friction friction{};
    Eigen::Vector3d point_B{Eigen::Vector3d::Zero()};  ///< foot, or the centre of a ball [m]
    double radius{};                                   ///< of the ball [m]; 0: a foot
    std::vector<double> normal_force{};                ///< N(t) with which it presses [N]; empty: it stands
    SampledMotion motion{};
  };
  struct Spring {
    std::string body{};
    double stiffness{};                                 ///< [N/m]
    Eigen::Vector3d point_B{Eigen::Vector3d::Zero()};   ///< [m]
    Eigen::Vector3d anchor_W{Eigen::Vector3d::Zero()};  ///< [m]
    SampledMotion motion{};
  };
  std::string name{};
  double step{};       ///< h [s]
  int steps{};         ///< to the end
  int frame_every{1};  ///< steps from one frame of the answer to the next
  Eigen::Vector3d gravity{0, 0, -9.81};
  std::vector<Body> bodies{};
  std::vector<Support> supports{};
  std::vector<Spring> springs{};
};

/// Samples the problem at t = k `step` until its duration is reached or just passed by a frame of the answer. `shapes`:
/// what the body looks like; empty: the plainest volume that touches where the problem does (see the source). The body
/// is called "body", supports "support 0" and so on.
///
/// Throws InputError for step <= 0, more than ten million steps, a load that depends on the body's motion (a file has
/// samples of time only), and where no volume can be found: give one.
[[nodiscard]] SampledProblem sample(const RigidProblem& problem, const std::string& name, double step,
                                    int frame_every = 1, std::vector<Primitive> shapes = {});

}  // namespace handhold::compare
