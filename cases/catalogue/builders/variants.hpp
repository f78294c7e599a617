// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/catalogue/case.hpp"

namespace handhold::catalogue {

/// The case with, after its plain runs, each of them once more as seen from elsewhere: in a mirror, turned by an odd
/// rotation, moved away, and with bodies, hands, patches, samples, supports and springs in another order, all at once.
/// Nature does not care, so that claims and limits are those of the plain run; axes and points are transformed with the
/// scene. Curves and order studies stay with the plain runs. No problem is built before it is played.
[[nodiscard]] Case with_variants(Case plain);

}  // namespace handhold::catalogue
