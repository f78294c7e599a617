// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "realtime/contact/contacts.hpp"
#include "realtime/rigid_body.hpp"

namespace handhold::realtime {

/// What is known of every pair of bodies: the patches of one's samples on the other, and how far their free samples
/// are from touching. Pairs at rest against each other cost a subtraction a step.
class BodyPairs {
 public:
  void resize(std::size_t bodies);

  /// Makes the patches of the pool free.
  void add_free(const Contacts& contacts, std::size_t first_patch);
  [[nodiscard]] bool exhausted() const { return free_.empty(); }

  /// Patch of the samples of `source` on `target`, -1: none.
  [[nodiscard]] int patch(int target, int source) const { return patch_[index(target, source)]; }
  /// Takes a patch out of the pool.
  int take(const WorldDef& def, int target, int source, Contacts& contacts);
  void give_back(int patch, Contacts& contacts);

  /// No free sample of either body is nearer to the other than this [m], < 0: not known. It is known only for pairs
  /// that were told of in every step since.
  [[nodiscard]] double clearance(int a, int b, std::uint32_t step) const;
  void set_clearance(int a, int b, std::uint32_t step, double clearance);

 private:
  [[nodiscard]] std::size_t index(int a, int b) const { return std::size_t(a) * bodies_ + std::size_t(b); }

  std::size_t bodies_{};
  std::vector<int> patch_{};
  std::vector<double> clearance_{};
  std::vector<std::uint32_t> known_at_{};
  std::vector<int> free_{};
};

}  // namespace handhold::realtime
