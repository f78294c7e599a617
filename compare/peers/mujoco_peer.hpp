// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "compare/peers/peer.hpp"

namespace handhold::compare::peers {

/// MuJoCo. A hand is what its documents advise: a free finger of 50 g welded to a mocap body. Its contacts are springs
/// by themselves and creep; against that `stiffness` sets `impratio`, with elliptic cones (0: stock, pyramids and 1),
/// and `damping` the `noslip_iterations` (0: stock). `iterations` of Newton's method (0: 100, its default).
[[nodiscard]] std::unique_ptr<Peer> make_mujoco_peer(const PeerModel& model, const PeerSetting& setting, double step);

}  // namespace handhold::compare::peers
