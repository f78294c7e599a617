// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::reference {

/// The samples that one carrier, a phalanx of a hand or a body, can have on one body: slots [first, first + count).
struct Pad {
  int hand{};     ///< SampleId::of_body: the carrier is a body
  int carrier{};  ///< the phalanx, or the body
  int body{};     ///< that is touched
  int first{};
  int count{};
  bool given{};  ///< the points never change; otherwise the patch is seeded when the phalanx comes near
  Eigen::Vector3d middle{Eigen::Vector3d::Zero()};  ///< of the given points, in the carrier's frame [m]
  double reach{};  ///< no point (given), no skin (seeded) is farther than this from `middle` [m]

  [[nodiscard]] bool of_body() const { return hand == SampleId::of_body; }
};

/// Where every sample's state lives. Pads and slots are ascending in SampleId, so that the order in which a scene names
/// its patches changes nothing.
struct Layout {
  std::vector<Pad> pads{};
  std::vector<SampleId> id{};                ///< of every slot
  std::vector<int> pad_of{};                 ///< of every slot
  std::vector<Eigen::Vector3d> given_p_P{};  ///< of every slot; zero if seeded
  std::vector<const SampleStart*> start{};   ///< of every slot; null: none given. Points into the scene
};

/// Counts out the slots of a valid scene: every phalanx on every body, the samples of every body on every other but
/// fixed ones on fixed ones. Throws InputError for more than a hundred thousand.
[[nodiscard]] Layout make_layout(const Scene& scene);

}  // namespace handhold::reference
