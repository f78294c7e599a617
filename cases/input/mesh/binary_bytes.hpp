// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <string_view>

namespace handhold {

/// The number of type T at byte `at`; the caller has seen that it lies within `bytes`. Little-endian, as the machines
/// that this program is built for are, unless `swapped`.
template <class T>
T number_at(std::string_view bytes, std::size_t at, bool swapped = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + at, sizeof(T));
  if (swapped) std::reverse(raw, raw + sizeof(T));
  T value{};
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

}  // namespace handhold
