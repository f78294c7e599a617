// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "compare/peers/peer.hpp"

namespace handhold::compare::peers {

/// Open Dynamics Engine. `iterations` of its quick stepper (0: 20, its default); `stiffness` and `damping` set ERP and
/// CFM of every contact (0: hard contacts, stock).
[[nodiscard]] std::unique_ptr<Peer> make_ode_peer(const PeerModel& model, const PeerSetting& setting, double step);

}  // namespace handhold::compare::peers
