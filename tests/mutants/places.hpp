// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace handhold::mutants {

/// Where each defect is planted: name to "realtime/gamma.cpp:43", read from the sources under `root`.
[[nodiscard]] std::map<std::string, std::string> places(const std::string& root);

}  // namespace handhold::mutants
