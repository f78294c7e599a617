// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold {

/// 128 bits that tell byte strings apart (two FNV-1a sums with different starts, in hexadecimal). Not against forgery.
[[nodiscard]] std::string fingerprint(std::string_view bytes);

}  // namespace handhold
