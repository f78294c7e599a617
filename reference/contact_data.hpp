// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What Contacts is given and what it gives.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/model/recording.hpp"
#include "reference/element.hpp"
#include "reference/surface.hpp"

namespace handhold::reference {

/// A change of mode is located within this time [s]: late by it, a run is off by it times a jump of velocity, a tenth
/// of what the integrator may err by a step. No less than the rounding of a time of minutes.
[[nodiscard]] inline double event_window(double accuracy) { return std::clamp(0.1 * accuracy, 1e-13, 1e-9); }

/// Pose and velocity in W of the frame of a body (O) or a phalanx (P).
struct Motion {
  Eigen::Matrix3d R{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d p{Eigen::Vector3d::Zero()};  ///< of the origin [m]
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};  ///< [rad/s]
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< of the origin [m/s]
};

/// Of every body.
using Motions = std::vector<Motion>;

/// On a body, about its origin, in W.
struct Wrench {
  Eigen::Vector3d force{Eigen::Vector3d::Zero()};   ///< [N]
  Eigen::Vector3d torque{Eigen::Vector3d::Zero()};  ///< [N m]
};

/// What changes only at events.
struct Modes {
  std::vector<Mode> mode{};            ///< of every slot
  std::vector<Foothold> hold{};        ///< of every slot: of its anchor; of samples that are nowhere it means nothing
  std::vector<char> kept{};            ///< of every slot: apart, but inside, and its anchor still names its sheet
  std::vector<char> exists{};          ///< of every slot: its patch has been seeded or was given
  std::vector<Eigen::Vector3d> p_P{};  ///< of every slot: the sample's point in its carrier's frame [m]
  std::vector<int> touching{};         ///< of every pad: samples that are not apart, or keep a sheet
  std::vector<char> present{};         ///< of every hand
  std::vector<char> held{};            ///< of every body: a support holds it up
};

/// Anchors C in the frame of the body they are on, one column a slot [m]; those of samples that are nowhere mean
/// nothing.
using Anchors = Eigen::Matrix3Xd;
using AnchorsView = Eigen::Ref<const Anchors>;

/// One sample at one instant; O is the frame of the body it touches.
struct Sample {
  Eigen::Vector3d p_W{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d v_W{Eigen::Vector3d::Zero()};  ///< [m/s]
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d v_O{Eigen::Vector3d::Zero()};  ///< of p in O (relative to the body) [m/s]
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< at the anchor; zero if apart
  Response response{};                           ///< zero if apart
  double gap{-1};       ///< witness: > 0 when an apart sample touches, or one in contact is released
  double friction{-1};  ///< witness: > 0 when stick breaks away or slip sticks again
  double edge{-1};      ///< witness: > 0 when an anchor in slip has left its face
};

/// All contacts at one instant.
struct Evaluation {
  std::vector<Sample> samples{};  ///< of every slot; only those in contact are valid
  std::vector<Wrench> wrench{};   ///< of all contacts on every body
  double hand_power{};            ///< [W]
  double dissipation{};           ///< [W]
  int singular_slot{-1};          ///< where the undamped law has no solution; -1: nowhere

  // Witnesses: the largest of all, > 0 when something is due.
  double release{-1}, friction{-1}, edge{-1};  ///< of samples in contact
  bool watched{false};                         ///< whether the following are known: they do not enter forces
  double touch{-1};                            ///< of apart samples
  int touch_slot{-1};
  double nearness{-1};  ///< of patches due, or to be dropped
};

/// Where the law has no unique continuation for one sample.
struct Undecided {
  int slot{};
  std::string what{};
};

/// A change of mode of one sample.
struct Transition {
  int slot{};
  EventKind kind{};
};

/// What the law cannot decide. Ends a run as Outcome::stalled.
struct CannotAdvance : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace handhold::reference
