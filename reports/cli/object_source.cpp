// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/object_source.hpp"

#include <charconv>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::reports {
namespace {

constexpr std::string_view shape_prefix = "shape:";

std::pair<std::string, double> parameter(const std::string& source, const std::string& text) {
  const std::size_t equals = text.find('=');
  double value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] =
      std::from_chars(text.data() + (equals == std::string::npos ? text.size() : equals + 1), end, value);
  if (equals == std::string::npos || error != std::errc() || stop != end) {
    throw InputError(fmt::format("'{}': '{}' is no parameter=number (see handhold list --shapes)", source, text));
  }
  return {text.substr(0, equals), value};
}

bool is_shape(const std::string& source) { return source.rfind(shape_prefix, 0) == 0; }

Mesh shape(const std::string& source) {
  std::istringstream words(source.substr(shape_prefix.size()));
  std::string kind, word;
  std::getline(words, kind, ',');
  std::map<std::string, double> parameters;
  while (std::getline(words, word, ',')) parameters.insert(parameter(source, word));
  return make_shape(kind, parameters);
}

}  // namespace

ImportedMesh read_object(const std::string& source, double scale) {
  if (!is_shape(source)) return import_mesh(source, scale);
  ImportedMesh out;
  out.source = source;
  out.scale = scale;
  out.mesh = shape(source);
  for (Eigen::Vector3d& vertex : out.mesh.vertices) vertex *= scale;
  out.repair = repair(out.mesh);
  return out;
}

ImportedObject load_object(const std::string& source, double scale) {
  if (!is_shape(source)) return import_object(source, scale);
  ImportedObject out;
  out.mesh = read_object(source, scale);
  out.field = voxelize(out.mesh.mesh);
  return out;
}

}  // namespace handhold::reports
