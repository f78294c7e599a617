// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cases/model/recording.hpp"
#include "realtime/soa.hpp"
#include "realtime/world_def.hpp"

namespace handhold::realtime {

/// The samples of one phalanx, or of one body, on one body: `count` slots from `first` on. A hand's slots never move,
/// so sums over them always run in the order of (hand, phalanx, sample), whatever the order of touching.
struct PatchSlot {
  int hand{};     ///< SampleId::of_body: the samples are those of body `phalanx`
  int phalanx{};  ///< of the hand; or the body that the samples belong to
  int body{};     ///< that they touch
  int first{}, count{};
  bool given{false};  ///< points come from the definition and are never dropped
  bool active{false};

  [[nodiscard]] bool of_body() const { return hand == SampleId::of_body; }
  /// Index of the i-th sample in the arrays of Contacts.
  [[nodiscard]] std::size_t slot(int i) const { return std::size_t(first) + std::size_t(i); }
};

/// All samples that a world can have, structure of arrays. `first` of every patch is even and what follows an odd
/// `count` is an idle slot, so that loops may take two samples at a time.
struct Contacts {
  std::vector<PatchSlot> patches{};  ///< those of hands by (hand, phalanx, body), then the pool for pairs of bodies
  std::vector<SampleId> id{};
  std::vector<Mode> mode{};
  Vector3Array p_P{};                  ///< sample point, in the frame of its phalanx or of its own body
  Vector3Array C_O{}, n_O{};           ///< anchor and outward normal there; mean nothing while apart
  Vector3Array from_O{}, from_n_O{};   ///< those that a sample which slips had in its last step, before it slid
  std::vector<int> face{};             ///< of the anchor, see Anchor
  std::vector<std::uint8_t> hollow{};  ///< the anchor is in a hollow edge or corner
  /// Of one that is apart: it was let go inside, by its damper, and is still below the sheet that its anchor lies on:
  /// that is where it touches again.
  std::vector<std::uint8_t> kept{};
  Vector3Array f_O{};  ///< force on the object over the last step, in O as that step saw it: see BodyStep
  std::size_t hand_patches{};

  [[nodiscard]] std::size_t size() const { return id.size(); }
  [[nodiscard]] bool touches(const PatchSlot& patch) const {
    for (int i = 0; i < patch.count; ++i)
      if (mode[patch.slot(i)] != Mode::apart) return true;
    return false;
  }
};

/// Reserves a slot for every sample of a hand that can ever exist, and a pool of patches for pairs of bodies.
/// Given patches are sorted by phalanx.
[[nodiscard]] Contacts make_contacts(const WorldDef& def);

/// Doubles the pool for pairs of bodies: the new patches are the last ones.
void grow_pool(const WorldDef& def, Contacts& contacts);

}  // namespace handhold::realtime
