// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Serves the engines that are the paper's middleware in front of its host: `paper` (L3) and `paper-coulomb` (L2).

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cases/model/scene.hpp"
#include "compare/engine/engine.hpp"
#include "realtime/paper/host.hpp"

namespace handhold::compare {

/// Contact samples on a phalanx that moves as told, as one patch of the middleware.
struct PlayedPatch {
  std::uint8_t hand{}, phalanx{};
  std::vector<Eigen::Vector3d> p_P{};
  std::vector<SampleStart> start{};      ///< empty, or one a sample
  std::function<Pose(double t)> pose{};  ///< X_WP
};

/// A frame begins at t and lasts dt [s]; of the last one only the beginning is recorded.
struct PlayedFrame {
  double t{}, dt{};
};

/// A body with the law in front of it, and all that acts on it.
struct Played {
  realtime::paper::Host host;
  std::vector<PlayedPatch> patches{};
  std::function<Load(double t)> load{};  ///< held over a frame; empty: none
};

/// The middleware's view of a body, and back.
[[nodiscard]] realtime::paper::HostBody host_body(const Inertia& inertia, Mobility mobility, const Pose& X_WO,
                                                  const Twist& V_WO);

/// Anchors every sample at the closest surface point below p − lag, at most `reach` away, and gives it its mode. Throws
/// InputError for a sample that has none.
void seed(Played& played, double reach);

/// At the beginning of every frame: the body's motion there and the contacts with the forces that the law gives there,
/// a change of mode being an event of that instant. Adds them to `recording`.
void play(Played& played, std::span<const PlayedFrame> frames, const Progress& progress, Recording& recording);

}  // namespace handhold::compare
