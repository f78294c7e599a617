// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace handhold::reports {

inline bool has_type(const nlohmann::json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "null" && value.is_null();
}

/// The part of JSON Schema that our schemas use. Returns where and what is wrong; empty if nothing is.
inline std::string schema_fault(const nlohmann::json& value, const nlohmann::json& schema, const nlohmann::json& root,
                                const std::string& at = "") {
  if (schema.contains("$ref")) {
    const auto pointer = nlohmann::json::json_pointer(schema["$ref"].get<std::string>().substr(1));
    return schema_fault(value, root.at(pointer), root, at);
  }
  if (schema.contains("const") && value != schema["const"]) return at + ": not the constant";
  if (schema.contains("enum") && std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
    return at + ": not in the enum";
  if (schema.contains("minimum") && value < schema["minimum"]) return at + ": below the minimum";
  if (schema.contains("exclusiveMinimum") && !(value > schema["exclusiveMinimum"]))
    return at + ": not above the exclusive minimum";
  if (schema.contains("minItems") && value.size() < schema["minItems"]) return at + ": has too few items";
  if (schema.contains("maxItems") && value.size() > schema["maxItems"]) return at + ": has too many items";
  if (schema.contains("type")) {
    const nlohmann::json types = schema["type"].is_array() ? schema["type"] : nlohmann::json::array({schema["type"]});
    bool good = false;
    for (const auto& type : types) good = good || has_type(value, type);
    if (!good) return at + ": has the wrong type";
  }
  if (schema.contains("anyOf")) {
    for (const auto& option : schema["anyOf"]) {
      if (schema_fault(value, option, root, at).empty()) return "";
    }
    return at + ": fits none of anyOf";
  }
  for (const auto& key : schema.value("required", nlohmann::json::array())) {
    if (!value.contains(key)) return at + ": lacks " + key.get<std::string>();
  }
  const nlohmann::json properties = schema.value("properties", nlohmann::json::object());
  const nlohmann::json additional = schema.value("additionalProperties", nlohmann::json(true));
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) {
      if (!properties.contains(key) && additional == false) return at + ": has the unknown key " + key;
      const nlohmann::json rule = properties.contains(key) ? properties[key]
                                  : additional.is_object() ? additional
                                                           : nlohmann::json::object();
      if (const std::string fault = schema_fault(child, rule, root, at + "/" + key); !fault.empty()) return fault;
    }
  }
  if (value.is_array() && schema.contains("items")) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (const std::string fault = schema_fault(value[i], schema["items"], root, at + "/" + std::to_string(i));
          !fault.empty())
        return fault;
    }
  }
  return "";
}

}  // namespace handhold::reports
