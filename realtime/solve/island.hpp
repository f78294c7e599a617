// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "cases/model/friction.hpp"
#include "realtime/contact/element.hpp"
#include "realtime/contact/patch_kernel.hpp"
#include "realtime/solve/body_step.hpp"

namespace handhold::realtime {

/// A sample whose force is not linear in the velocities: what it is given, and what comes out.
struct Slider {
  std::size_t slot{};
  ElementStep element{};
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};    ///< relative velocity at no change; element.v_p is that of the damper
  Eigen::Vector3d arm{Eigen::Vector3d::Zero()};  ///< p − centre of mass of its body, in W [m]
  bool sliding{false};                           ///< in: see Role; out: slides
  bool entering{false};                          ///< in: was apart
  bool acts{false};                              ///< out: has a force
  double cap{}, way{};  ///< limit of friction while it is frozen, and how far it is from μ N [N]
  Trial at_rest{};      ///< if no velocity changes
  Trial trial{};        ///< out: at the solution; before `IslandSystem::end` only N and t*
  Grip grip{};          ///< out
  Eigen::Vector3d f{Eigen::Vector3d::Zero()};        ///< out: force on the object [N]
  Eigen::Vector3d tangent{Eigen::Vector3d::Zero()};  ///< out: its tangential part [N]

  [[nodiscard]] double limit(const Friction& friction) const {
    return sliding ? friction.mu_dynamic : friction.mu_static;
  }
};

/// All patches between two bodies in one step; hands are one body here.
struct PatchStep {
  int target{}, source{-1};           ///< bodies; source -1: hands
  int first_patch{}, patch_count{0};  ///< in Island::slots
  Stiffness stiffness{};
  Friction friction{};
  Eigen::Vector3d offset{Eigen::Vector3d::Zero()};  ///< from the source's centre of mass to the target's
  StickSums sums{};
  int first_slider{}, slider_count{};
  StickResult stuck{};  ///< out: of the linear samples
  bool watches{false};  ///< has samples on watch

  /// Adds a change of the bodies' velocities up to that of p against the target: dv + dw × arm.
  void relative(const std::vector<BodyStep>& bodies, Eigen::Vector3d& dv, Eigen::Vector3d& dw) const;
};

/// Bodies that are coupled through contacts with each other, with all their patches. Without such contacts, one body.
struct Island {
  std::vector<int> bodies{};  ///< those that move
  std::vector<PatchStep> patches{};
  std::vector<SlotStep> slots{};  ///< those of each PatchStep in a row
  std::vector<Slider> sliders{};
};

}  // namespace handhold::realtime
