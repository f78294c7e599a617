// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

#include <Eigen/Core>

// Sentences of errors, for the rooms that may use Eigen and the standard library alone.

namespace handhold {

inline std::string text_of(std::string_view text) { return std::string(text); }

/// A number with the fewest digits that give it back: "0.1", "1e-09", "nan".
template <class Number>
std::enable_if_t<std::is_arithmetic_v<Number>, std::string> text_of(Number value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// "[1, 2, 3]"
inline std::string text_of(const Eigen::Vector3d& v) {
  return "[" + text_of(v.x()) + ", " + text_of(v.y()) + ", " + text_of(v.z()) + "]";
}

/// All of it, one after the other: `sentence("duration ", t, " s: must be > 0")`.
template <class... Parts>
std::string sentence(const Parts&... parts) {
  return (std::string() + ... + text_of(parts));
}

}  // namespace handhold
