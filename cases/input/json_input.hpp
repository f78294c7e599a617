// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Private to the readers: not for public headers, as it shows nlohmann::json.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/model/input_error.hpp"

namespace handhold {

/// Parses an object; throws InputError with `path`, line and byte.
inline nlohmann::json parse_json(std::string_view text, const std::string& path) {
  try {
    nlohmann::json value = nlohmann::json::parse(text);
    if (value.is_object()) return value;
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t byte = std::min(error.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
    throw InputError(
        fmt::format("{}:{}, byte {}: this is not JSON (the file is damaged: fetch it again)", path, line, byte));
  } catch (const nlohmann::json::out_of_range&) {
    throw InputError(fmt::format("{}: a number in it is beyond 1e308 (correct it)", path));
  }
  throw InputError(fmt::format("{}: the JSON text is no object (is it a recording?)", path));
}

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
