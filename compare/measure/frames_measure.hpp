// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/catalogue/claim.hpp"
#include "cases/model/recording.hpp"

namespace handhold::compare {

/// The measures over frames from `from` to `at` as they were recorded: force_sum, mode_count, lag, work, growth. NaN
/// when there are no frames at these instants, and for any other measure.
///
/// Growth: the places x_n of body 0 along the axis obey x_{n+2} = tr x_{n+1} − det x_n as long as nothing but springs
/// and dampers acts along it, so x_{n+1}² − x_n x_{n+2} grows by det a frame, and the oscillation by sqrt(det).
[[nodiscard]] double frames_measure(const Recording& recording, const catalogue::Measure& what);

}  // namespace handhold::compare
