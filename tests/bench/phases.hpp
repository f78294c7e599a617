// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/scene.hpp"
#include "realtime/phase_clock.hpp"
#include "realtime/world.hpp"
#include "tests/bench/play.hpp"

namespace handhold::bench {

/// Where the time of a frame goes: of each phase the median over the frames of its least time over `rounds` plays [s],
/// less the clock's own share.
[[nodiscard]] realtime::PhaseClock::Seconds time_phases(const Scene& scene, const HandFrames& hands, double frame_rate,
                                                        const realtime::Options& setting, int rounds);

}  // namespace handhold::bench
