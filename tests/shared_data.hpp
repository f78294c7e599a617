// SPDX-License-Identifier: GPL-3.0-or-later
// Real recordings and meshes that are not in the repository. Tests that want them skip when the folder is absent.
#pragma once

#include <string>

namespace handhold::test {

/// Path of a file or folder below the shared data, e.g. "traces/leapjs/grab.json.lz"; it need not exist.
std::string shared_data(const std::string& name);

}  // namespace handhold::test
