#pragma once

#include "cases/catalogue/case.hpp"

namespace handhold::catalogue {

/// The case with, after its plain runs, each of them turned by an odd rotation and moved away, mirrored, and with
/// bodies, hands, patches, samples, supports and springs in another order (Run::variant "turned", "mirrored",
/// "reordered"). Nature does not care, so that claims and limits are those of the plain run; axes and points are
/// transformed with the scene. Curves and order studies stay with the plain runs. No problem is built before it is
/// played.
[[nodiscard]] Case with_variants(Case plain);

}  // namespace handhold::catalogue
