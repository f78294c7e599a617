// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/closed_form/shaken_pinch.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// A cube that only translates between thumb and index, which shake along their normals (y) as the closed form's hand;
/// undamped, started in the forced oscillation. Under gravity (along -z) its weight hangs on both fingers alike.
[[nodiscard]] Scene normal_shake_scene(const closed_form::ShakenPinch& pinch, const Friction& friction, double gravity,
                                       double duration);

}  // namespace handhold::catalogue
