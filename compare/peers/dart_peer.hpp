// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "compare/peers/peer.hpp"

namespace handhold::compare::peers {

/// DART with ODE's collision detector: its own and FCL's know no capsules, and Bullet is not used here. `stiffness` is
/// the error reduction parameter of its contacts (0 to 1), `damping` their constraint force mixing, with the correcting
/// velocity unbounded (0: stock, 0.01 and 1e-5 and 1 mm/s). `iterations` is not used: the solver is Dantzig's.
[[nodiscard]] std::unique_ptr<Peer> make_dart_peer(const PeerModel& model, const PeerSetting& setting, double step);

}  // namespace handhold::compare::peers
