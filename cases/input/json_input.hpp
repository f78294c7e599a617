// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Private to the readers: not for public headers, as it shows nlohmann::json.

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace handhold {

/// Parses one object or list, or several of them (one a line: a list of them is returned). NaN, inf and Infinity, which
/// are not JSON but what Python and others write, are read as null. Throws InputError with `path`, line and byte for
/// broken text and for more than 64 levels of nesting: nothing that visits or copies the value can use up the stack.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& path);

/// Throws InputError that names the first member of `object` that is not among `known`, with the nearest of them.
void check_keys(const nlohmann::json& object, const std::vector<std::string>& known, const std::string& where);

/// Member `name`, if it is a number.
inline double number_or(const nlohmann::json& object, const char* name, double otherwise) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

/// The same for whole numbers; those beyond 2^53 count as absent.
inline long integer_or(const nlohmann::json& object, const char* name, long otherwise) {
  const double value = number_or(object, name, std::nan(""));
  return std::abs(value) <= 9007199254740992.0 ? static_cast<long>(value) : otherwise;
}

/// Member `name` if it is a list, else an empty one.
inline const nlohmann::json& list_of(const nlohmann::json& object, const char* name) {
  static const nlohmann::json empty = nlohmann::json::array();
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_array() ? *found : empty;
}

/// `size` numbers; NaN for whatever is missing, null or no number.
template <int size>
Eigen::Matrix<double, size, 1> numbers_of(const nlohmann::json& list) {
  Eigen::Matrix<double, size, 1> v;
  v.setConstant(std::numeric_limits<double>::quiet_NaN());
  if (!list.is_array() || list.size() != size) return v;
  for (int i = 0; i < size; ++i) {
    const nlohmann::json& item = list[static_cast<std::size_t>(i)];
    if (item.is_number()) v[i] = item.get<double>();
  }
  return v;
}

inline Eigen::Vector3d vector_of(const nlohmann::json& object, const char* name) {
  return numbers_of<3>(list_of(object, name));
}

}  // namespace handhold
