#pragma once

#include "cases/catalogue/case.hpp"
#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::compare {

/// Reads a quantity off a recording; NaN when the recording does not show it (no such event, instant beyond its end).
///
/// Between frames, positions are interpolated by the cubic through both frames' poses and velocities (exact for
/// constant acceleration); at an event, the state that the event carries is taken. Hand motion comes from the scene.
[[nodiscard]] double measure(const Scene& scene, const Recording& recording, const catalogue::Measure& what);

}  // namespace handhold::compare
