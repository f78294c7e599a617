#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/recording.hpp"
#include "cases/scene/scene.hpp"

namespace handhold::reference {

/// The samples that one phalanx of one hand can have on the body: slots [first, first + count).
struct Pad {
  int hand{};
  int phalanx{};
  int first{};
  int count{};
  bool given{};    ///< the points never change; otherwise the patch is seeded when the phalanx comes near
  double reach{};  ///< no skin point is farther than this from the phalanx's origin [m]
};

/// Where every sample's state lives. Slots are ascending in SampleId.
struct Layout {
  std::vector<Pad> pads{};
  std::vector<SampleId> id{};                ///< of every slot
  std::vector<int> pad_of{};                 ///< of every slot
  std::vector<Eigen::Vector3d> given_p_P{};  ///< of every slot; zero if seeded
  std::vector<const SampleStart*> start{};   ///< of every slot; null: none given. Points into the scene
};

/// Counts out the slots of a valid scene with one body.
[[nodiscard]] Layout make_layout(const Scene& scene);

}  // namespace handhold::reference
