// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/input/mesh/field_cache.hpp"

namespace handhold::reports {

/// What a user names as an object: a mesh file, or "shape:<kind>[,<parameter>=<number>...]", e.g.
/// "shape:mug,height=0.09". `scale` turns the file's units into metres, > 0. Throws InputError.
[[nodiscard]] ImportedMesh read_object(const std::string& source, double scale);

/// The same with its voxels at the default size; of a mesh file, both come from the cache when it has been seen before.
[[nodiscard]] ImportedObject load_object(const std::string& source, double scale);

}  // namespace handhold::reports
