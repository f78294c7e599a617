// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/contacts.hpp"

namespace handhold::reference {

/// Every inequality of the contact law at an accepted step: all witnesses are negative, undamped slip is on its cone.
///
/// Returns whether a witness is a hair above zero (round-off of a quaternion's normalisation after an event), so that
/// its change is due. Throws std::logic_error when more than the integration's errors is wrong: an event was missed.
[[nodiscard]] bool check_invariants(const Contacts& contacts, const Modes& modes, const Evaluation& watched,
                                    double accuracy, double t);

}  // namespace handhold::reference
