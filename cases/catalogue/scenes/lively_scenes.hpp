// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/model/scene.hpp"

// Scenes in which much happens at once and for which no closed form exists: what can be asked of an engine is that
// nothing explodes, that the invariants hold, and that the outcome makes sense. Coarse voxels, few seconds.

namespace handhold::catalogue {

/// A box lies on an open palm between curled fingers and the thumb, and is shaken harder than it can be held.
[[nodiscard]] Scene box_in_hand();

/// One hand lifts a cube by a pinch, a second one takes it, the first lets go, and the second carries it away.
[[nodiscard]] Scene hand_to_hand();

/// A hand knocks ten cubes that stand on each other, another one stands behind them.
[[nodiscard]] Scene knocked_tower();

[[nodiscard]] const std::vector<std::string>& lively_ids();

/// By its id, "box-in-hand", "hand-to-hand", "knocked-tower"; throws InputError listing the ids for another.
[[nodiscard]] Scene lively_scene(std::string_view id);

}  // namespace handhold::catalogue
