// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Core>

#include "reference/element.hpp"

namespace handhold::reference {

/// A hollow edge between two flat faces, as an anchor caught in it sees it: the limit of a fillet whose radius goes to
/// 0.
///
/// On the fillet an anchor would hardly move while its normal turns; in the limit it rests in the edge, and its normal
/// is the one of the arc between the two faces that is nearest to −(p − C). It leaves along a face when the force is
/// outside that face's cone and does not press against the other. It does not slide along the edge: a sample that is
/// dragged in a groove drags the object, as if the groove were rough.
struct Wedge {
  std::array<Eigen::Vector3d, 2> n{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};     ///< of the faces, outward
  std::array<Eigen::Vector3d, 2> away{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< in each, from the edge

  /// The normal at an anchor from which the sample lies at r.
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& r) const;
};

/// The element caught in a wedge: as in stick; `friction` > 0 when it leaves along a face.
[[nodiscard]] Response respond(const Element& element, const Approach& approach, const Wedge& wedge);

/// The face, 0 or 1, along which it leaves.
[[nodiscard]] int way_out(const Element& element, const Approach& approach, const Wedge& wedge);

}  // namespace handhold::reference
