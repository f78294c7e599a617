// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Serves scene_file.cpp only: shows toml++, which public headers do not.

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <toml++/toml.h>

#include "cases/input/nearest_name.hpp"
#include "cases/input/scene/scene_file.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::toml_section {

inline constexpr double norm_tolerance = 1e-3;  // of a quaternion typed with four digits
// Nearer to 1 a norm is left alone: normalising would only change the last bit, and to_toml could not round trip.
inline constexpr double unit_already = 1e-14;

inline std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

/// A table of the file with its name for errors. Reading checks types, finiteness and, at once, that every key is
/// known.
class Section {
 public:
  Section(const toml::table& table, std::string source, std::string name, std::vector<std::string> keys)
      : table_(table), source_(std::move(source)), name_(std::move(name)), keys_(std::move(keys)) {
    location_.line = line(table);
    for (const auto& [key, node] : table_) {
      location_.keys[std::string(key.str())] = line(node);
      check_known(std::string(key.str()), int(key.source().begin.line));
    }
  }

  [[nodiscard]] const Location& location() const { return location_; }
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const toml::table& table() const { return table_; }
  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }

  [[noreturn]] void fail(const std::string& key, const std::string& text) const {
    const std::string full = name_.empty() ? key : key.empty() ? name_ : name_ + "." + key;
    const std::string subject = full.empty() ? "" : full + ": ";
    throw InputError(fmt::format("{}:{}: {}{}", source_, location_.of(key), subject, text));
  }

  /// Runs a check that throws InputError, and adds where the value stands.
  template <typename Check>
  void checked(const std::string& key, const Check& check) const {
    try {
      check();
    } catch (const InputError& error) {
      fail(key, error.what());
    }
  }

  void require(const std::string& key, const std::string& what) const {
    if (!has(key)) fail("", fmt::format("'{0}' is missing (add {0} = {1})", key, what));
  }

  void read(const std::string& key, double& value) const {
    if (has(key)) value = number(key, at(key));
  }

  void read(const std::string& key, std::optional<double>& value) const {
    if (has(key)) value = number(key, at(key));
  }

  void read(const std::string& key, int& value) const {
    if (!has(key)) return;
    const toml::value<std::int64_t>* integer = at(key).as_integer();
    if (!integer) fail(key, fmt::format("must be a whole number, not {} (write e.g. 8)", describe(at(key))));
    if (std::abs(double(integer->get())) > double(std::numeric_limits<int>::max())) {
      fail(key, fmt::format("{} is out of range (write a smaller number)", integer->get()));
    }
    value = int(integer->get());
  }

  void read(const std::string& key, std::string& value) const {
    if (!has(key)) return;
    const toml::value<std::string>* text = at(key).as_string();
    if (!text) fail(key, fmt::format("must be a string, not {} (put it in quotes)", describe(at(key))));
    if (text->get().empty()) fail(key, "must not be empty (leave the key out, or fill it in)");
    value = text->get();
  }

  void read(const std::string& key, Eigen::Vector3d& value) const {
    if (has(key)) value = vector(key, at(key));
  }

  void read(const std::string& key, Eigen::Quaterniond& value) const {
    if (!has(key)) return;
    const std::vector<double> q = numbers(key, at(key));
    if (q.size() != 4) fail(key, fmt::format("must be [w, x, y, z], not {} numbers (1, 0, 0, 0 is no turn)", q.size()));
    value = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    const double norm = value.norm();
    if (!(std::abs(norm - 1) <= norm_tolerance)) {
      fail(key, fmt::format("has norm {}: must be a unit quaternion [w, x, y, z] (divide it by its norm)", norm));
    }
    if (std::abs(norm - 1) > unit_already) value.normalize();
  }

  /// One of `names`; `value` is the number of the name.
  template <typename Enum>
  void read(const std::string& key, Enum& value, const std::vector<std::string>& names) const {
    std::string text;
    read(key, text);
    if (text.empty()) return;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == text) {
        value = Enum(int(i));
        return;
      }
    }
    fail(key, fmt::format("'{}' is not one of {} (take one)", text, join_names(names)));
  }

  [[nodiscard]] std::vector<double> numbers(const std::string& key, const toml::node& node) const {
    const toml::array* list = node.as_array();
    if (!list) fail(key, fmt::format("must be a list of numbers, not {} (write [..])", describe(node)));
    std::vector<double> values;
    for (const toml::node& element : *list) values.push_back(number(key, element));
    return values;
  }

  [[nodiscard]] double number(const std::string& key, const toml::node& node) const {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) fail(key, fmt::format("must be a number, not {} (no quotes, SI units)", describe(node)));
    if (!std::isfinite(*value)) fail(key, fmt::format("is {}: must be finite (write a number)", *value));
    return *value;
  }

  [[nodiscard]] Eigen::Vector3d vector(const std::string& key, const toml::node& node) const {
    const std::vector<double> v = numbers(key, node);
    if (v.size() != 3) fail(key, fmt::format("must be three numbers, not {} (write [x, y, z])", v.size()));
    return {v[0], v[1], v[2]};
  }

  /// One point, or a list of points.
  [[nodiscard]] std::vector<Eigen::Vector3d> vectors(const std::string& key) const {
    if (!has(key)) return {};
    const toml::array* list = at(key).as_array();
    if (!list || list->empty()) fail(key, "must be a list of points (write [[x, y, z], ...])");
    if (!list->front().is_array()) return {vector(key, *list)};
    std::vector<Eigen::Vector3d> points;
    for (const toml::node& element : *list) points.push_back(vector(key, element));
    return points;
  }

  /// One boolean, or a list of them.
  [[nodiscard]] std::vector<bool> booleans(const std::string& key) const {
    if (!has(key)) return {};
    if (const toml::value<bool>* one = at(key).as_boolean()) return {one->get()};
    const toml::array* list = at(key).as_array();
    if (!list) fail(key, fmt::format("must be true or false, not {} (or a list of them)", describe(at(key))));
    std::vector<bool> values;
    for (const toml::node& element : *list) {
      const toml::value<bool>* one = element.as_boolean();
      if (!one) fail(key, fmt::format("must be a list of true and false, not of {} (no quotes)", describe(element)));
      values.push_back(one->get());
    }
    return values;
  }

  void require_positive(const std::string& key, double value, const char* unit) const {
    if (!(value > 0)) fail(key, fmt::format("{} {}: must be > 0 (correct it)", value, unit));
  }

  void require_not_negative(const std::string& key, double value, const char* unit) const {
    if (!(value >= 0)) fail(key, fmt::format("{} {}: must be >= 0 (correct it)", value, unit));
  }

  /// A table in this one, under `key`.
  [[nodiscard]] Section inner(const std::string& key, std::vector<std::string> keys) const {
    const toml::table* table = at(key).as_table();
    if (!table) fail(key, fmt::format("must be a table, not {} (write [{}] or {{ .. }})", describe(at(key)), key));
    return {*table, source_, name_.empty() ? key : name_ + "." + key, std::move(keys)};
  }

  /// Calls `visit` for every table of the list of tables `key`.
  template <typename Visit>
  void each(const std::string& key, const std::vector<std::string>& keys, const Visit& visit) const {
    if (!has(key)) return;
    const toml::array* list = at(key).as_array();
    if (!list) fail(key, fmt::format("must be a list of tables, not {} (write [[{}]])", describe(at(key)), key));
    int i = 0;
    for (const toml::node& element : *list) {
      if (!element.is_table())
        fail(key, fmt::format("must hold tables, not {} (write [[{}]])", describe(element), key));
      const std::string name = fmt::format("{}{}[{}]", name_.empty() ? "" : name_ + ".", key, i++);
      visit(Section(*element.as_table(), source_, name, keys));
    }
  }

 private:
  static int line(const toml::node& node) { return int(node.source().begin.line); }
  static std::string describe(const toml::node& node) { return type_name(node); }

  const toml::node& at(const std::string& key) const { return *table_.get(key); }

  void check_known(const std::string& key, int at_line) const {
    for (const std::string& known : keys_) {
      if (key == known) return;
    }
    const std::string nearest = nearest_name(key, keys_);
    const std::string advice =
        nearest.empty() ? "take one of " + join_names(keys_) : fmt::format("did you mean '{}'?", nearest);
    throw InputError(fmt::format("{}:{}: {}{}'{}': no such key ({})", source_, at_line, name_,
                                 name_.empty() ? "" : ": ", key, advice));
  }

  const toml::table& table_;
  std::string source_, name_;
  std::vector<std::string> keys_;
  Location location_;
};

}  // namespace handhold::toml_section
