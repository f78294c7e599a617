// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/contacts.hpp"

namespace handhold::reference {

/// One sample while what is due is carried out.
struct Contacts::Slot {
  std::size_t index;
  const Pad& pad;
  const Element& element;
  const Surface& surface;
  Mode mode;
  Foothold hold;
  Eigen::Vector3d anchor;
  bool kept;
  Sample s;
  std::vector<EventKind> news{};

  void enter(Mode next, EventKind kind) {
    mode = next;
    news.push_back(kind);
  }
  [[nodiscard]] bool undamped() const { return element.damping == 0; }
  [[nodiscard]] Place place() const { return {anchor, hold}; }
  [[nodiscard]] Eigen::Vector3d spring() const { return element.stiffness * (s.p_O - anchor); }  ///< [N]
  /// f* [N], for an anchor at C.
  [[nodiscard]] Eigen::Vector3d pull(const Eigen::Vector3d& C) const {
    return element.stiffness * (s.p_O - C) + element.damping * s.v_O;
  }
  [[nodiscard]] Eigen::Vector3d pull() const { return pull(anchor); }
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& r) const {
    return hold.caught() ? surface.way(r, hold).n : surface.at(anchor, hold, false).n;
  }
  [[nodiscard]] double stored() const {
    const Response& r = s.response;
    return mode == Mode::apart && !kept ? 0 : 0.5 * element.stiffness * (r.depth * r.depth + r.lag.squaredNorm());
  }
};

}  // namespace handhold::reference
