// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/shared_data.hpp"

namespace handhold::test {

std::string shared_data(const std::string& name) { return HANDHOLD_SHARED_DATA "/" + name; }

}  // namespace handhold::test
