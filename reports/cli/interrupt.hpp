// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::reports {

/// From now on the first Ctrl-C (SIGINT) or SIGTERM only asks to stop, so that partial results can be written; a second
/// one ends the program at once.
void watch_interrupts();

/// Whether a stop was asked for.
[[nodiscard]] bool interrupted();

}  // namespace handhold::reports
