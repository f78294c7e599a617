#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cases/recording.hpp"
#include "cases/scene/scene.hpp"
#include "realtime/soa.hpp"

namespace handhold::realtime {

/// The samples of one phalanx on one body: `count` slots from `first` on. Slots never move, so sums over them always
/// run in the order of (hand, phalanx, sample), whatever the order of touching.
struct PatchSlot {
  int hand{}, phalanx{}, body{};
  int first{}, count{};
  bool given{false};  ///< points come from the scene and are never dropped
  bool active{false};

  /// Index of the i-th sample in the arrays of Contacts.
  [[nodiscard]] std::size_t slot(int i) const { return std::size_t(first) + std::size_t(i); }
};

/// All samples that a scene can have, structure of arrays.
struct Contacts {
  std::vector<PatchSlot> patches{};
  std::vector<SampleId> id{};
  std::vector<Mode> mode{};
  Vector3Array p_P{};         ///< sample point on the phalanx
  Vector3Array C_O{}, n_O{};  ///< anchor and outward normal there
  Vector3Array lag_O{};       ///< tangential lag e at the end of the last step
  Vector3Array f_W{};         ///< force on the object over the last step
  std::vector<double> depth{};
  std::vector<std::uint8_t> near{};  ///< apart, but close enough to the surface to have an anchor

  [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// Reserves a slot for every sample that can ever exist. A scene's given patches are sorted by phalanx.
[[nodiscard]] Contacts make_contacts(const Scene& scene);

}  // namespace handhold::realtime
