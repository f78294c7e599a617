// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "cases/model/scene.hpp"
#include "reference/contact_data.hpp"

namespace handhold::reference {

/// What acts on a body besides contacts.
struct Applied {
  Wrench wrench{};
  double dissipation{};  ///< that its support's oil takes [W]
  double given{};        ///< that its load and the carrier of its weight give [W]
};

/// Gravity, or while `held` the support (see support_time) that carries the weight; and the load. Nothing on a fixed
/// body. Throws InputError for a load that is not finite.
[[nodiscard]] Applied applied_to(const Body& body, const Eigen::Vector3d& gravity, const Motion& motion, bool held,
                                 double t);

}  // namespace handhold::reference
