// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/gltf_document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cases/input/json_input.hpp"
#include "cases/input/mesh/binary_bytes.hpp"
#include "cases/input/mesh/text_lines.hpp"
#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Json = GltfDocument::Json;

constexpr std::size_t most_elements = 6'000'000;  // the corners of 2 million triangles

// Extensions that cannot change where the triangles are.
bool is_harmless(const std::string& name) {
  const auto families = {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_",
                         "KHR_xmp",        "EXT_lights_",  "KHR_audio",    "KHR_animation_"};
  return name == "KHR_mesh_quantization" || std::any_of(families.begin(), families.end(), [&name](const char* family) {
           return name.rfind(family, 0) == 0;
         });
}

std::string decode_base64(std::string_view text, bool& sound) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values;
  values.fill(64);
  for (std::size_t d = 0; d < digits.size(); ++d)
    values[static_cast<unsigned char>(digits[d])] = static_cast<std::uint8_t>(d);
  for (const char c : text) {
    const std::uint32_t digit = values[static_cast<unsigned char>(c)];
    if (digit > 63) sound = false;
    bits = bits << 6 | (digit & 63);
    if ((count += 6) >= 8) bytes.push_back(static_cast<char>(bits >> (count -= 8) & 255));
  }
  return bytes;
}

std::size_t bytes_of(std::size_t type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

// One component, with the glTF specification's rule for normalised integers (3.6.2.2 and KHR_mesh_quantization).
double component(std::string_view bytes, std::size_t at, std::size_t type, bool normalized) {
  const auto scaled = [normalized](auto value) {
    if (!normalized) return static_cast<double>(value);
    return std::max(-1.0, static_cast<double>(value) / std::numeric_limits<decltype(value)>::max());
  };
  switch (type) {
    case 5120:
      return scaled(number_at<std::int8_t>(bytes, at));
    case 5121:
      return scaled(number_at<std::uint8_t>(bytes, at));
    case 5122:
      return scaled(number_at<std::int16_t>(bytes, at));
    case 5123:
      return scaled(number_at<std::uint16_t>(bytes, at));
    case 5125:
      return number_at<std::uint32_t>(bytes, at);
    default:
      return number_at<float>(bytes, at);
  }
}

}  // namespace

// The specification allows 3.0 for 3.
std::size_t whole_number(const Json& value) {
  const double number = value.is_number() ? value.get<double>() : -1;
  const bool whole = number >= 0 && number < 9007199254740992.0 && number == std::floor(number);
  return whole ? static_cast<std::size_t>(number) : no_index;
}

GltfDocument::GltfDocument(std::string_view bytes, const std::string& file) : file_(file) {
  const std::string_view text = bytes.substr(0, 4) == "glTF" ? open_glb(bytes) : bytes;
  json_ = parse_json(plain_text(std::string(text)), file);
  if (!json_.is_object()) fail("its JSON is no object", "is it another format?");
  check_version();
  check_extensions();
}

// The JSON of a GLB; keeps its binary chunk.
std::string_view GltfDocument::open_glb(std::string_view bytes) {
  if (bytes.size() < 20) fail("is a GLB of less than a header", "is it truncated?");
  const auto version = number_at<std::uint32_t>(bytes, 4), length = number_at<std::uint32_t>(bytes, 8);
  if (version != 2) fail(fmt::format("is glTF {}", version), "export it as glTF 2.0");
  if (length > bytes.size() || length < 20)
    fail(fmt::format("announces {} bytes, has {}", length, bytes.size()), "is it truncated?");
  bytes = bytes.substr(0, length);
  const std::size_t json_size = number_at<std::uint32_t>(bytes, 12);
  if (bytes.substr(16, 4) != "JSON" || json_size > bytes.size() - 20)
    fail("its first chunk is no JSON of the announced size", "is it damaged?");
  const std::string_view rest = bytes.substr(20 + json_size), json = bytes.substr(20, json_size);
  if (rest.size() >= 8 && rest.substr(4, 4) == std::string_view("BIN\0", 4)) {
    const std::size_t size = number_at<std::uint32_t>(rest, 0);
    if (size > rest.size() - 8) fail("its binary chunk is larger than the file", "is it truncated?");
    chunk_ = rest.substr(8, size);
  }
  return json.substr(0, json.find_last_not_of('\0') + 1);  // some writers fill up with zeros instead of blanks
}

void GltfDocument::check_version() const {
  const auto asset = json_.find("asset");
  const bool named = asset != json_.end() && asset->is_object() && asset->contains("version");
  const std::string version = named && asset->at("version").is_string() ? asset->at("version").get<std::string>() : "";
  if (version.rfind("2.", 0) == 0) return;
  if (version.empty()) fail("names no version of glTF in 'asset'", "is it another format?");
  fail(fmt::format("is glTF {}", printable(version)), "export it as glTF 2.0");
}

void GltfDocument::check_extensions() const {
  for (const Json& name : list(json_, "extensionsRequired")) {
    const std::string text = name.is_string() ? name.get<std::string>() : "?";
    if (is_harmless(text)) continue;
    fail(fmt::format("extension {} is required and not supported", text.substr(0, 60)),
         "export it without, uncompressed");
  }
}

std::vector<std::string> GltfDocument::external_uris() const {
  std::vector<std::string> uris;
  for (const Json& buffer : list(json_, "buffers")) {
    const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
    if (uri == buffer.end() || !uri->is_string()) continue;
    if (const std::string text = uri->get<std::string>(); text.rfind("data:", 0) != 0) uris.push_back(text);
  }
  return uris;
}

void GltfDocument::load_buffers(const GltfBuffers& external) {
  for (const Json& buffer : list(json_, "buffers")) {
    const std::size_t index = buffers_.size(), size = whole(buffer, "byteLength", no_index);
    const auto uri = buffer.find("uri");
    std::string bytes;
    if (uri == buffer.end()) {
      if (index == 0) bytes = chunk_;
    } else if (const std::string text = uri->is_string() ? uri->get<std::string>() : ""; text.rfind("data:", 0) == 0) {
      const std::size_t start = text.find(";base64,");
      bool sound = start != std::string::npos;
      if (sound) bytes = decode_base64(std::string_view(text).substr(start + 8), sound);
      if (!sound) fail(fmt::format("buffers[{}].uri is no base64 data", index), "is it damaged?");
    } else if (const auto found = external.find(text); found != external.end()) {
      bytes = found->second;
    }
    if (size == no_index || bytes.size() < size) {
      fail(fmt::format("buffers[{}] announces {} bytes, has {}", index, size == no_index ? 0 : size, bytes.size()),
           "is it truncated, or compressed?");
    }
    buffers_.push_back(std::move(bytes));
  }
}

const Json& GltfDocument::element(const char* name, std::size_t index) const {
  const Json& elements = list(json_, name);
  if (index < elements.size() && elements[index].is_object()) return elements[index];
  if (index == no_index) fail(fmt::format("an index into '{}' is missing", name), "is it damaged?");
  fail(fmt::format("{}[{}] is missing, there are {}", name, index, elements.size()), "is it damaged?");
}

std::size_t GltfDocument::whole(const Json& object, const char* name, std::size_t otherwise) const {
  const auto found = object.is_object() ? object.find(name) : object.end();
  if (found == object.end()) return otherwise;
  if (const std::size_t value = whole_number(*found); value != no_index) return value;
  fail(fmt::format("'{}' is no whole number of 0 or more", name), "is it damaged?");
}

const Json& GltfDocument::object(const Json& object, const char* name) const {
  static const Json empty = Json::object();
  const auto found = object.is_object() ? object.find(name) : object.end();
  if (found == object.end()) return empty;
  if (!found->is_object()) fail(fmt::format("'{}' is no object", name), "is it damaged?");
  return *found;
}

const Json& GltfDocument::list(const Json& object, const char* name) const {
  static const Json empty = Json::array();
  const auto found = object.is_object() ? object.find(name) : object.end();
  if (found == object.end()) return empty;
  if (!found->is_array()) fail(fmt::format("'{}' is no list", name), "is it damaged, or glTF 1.0?");
  return *found;
}

bool GltfDocument::uses(const char* extension) const {
  const auto names = [&](const char* key) {
    const Json& listed = list(json_, key);
    return std::find(listed.begin(), listed.end(), Json(extension)) != listed.end();
  };
  return names("extensionsUsed") || names("extensionsRequired");
}

GltfDocument::Span GltfDocument::view(std::size_t index) const {
  const Json& view = element("bufferViews", index);
  const std::size_t buffer = whole(view, "buffer", no_index), offset = whole(view, "byteOffset", 0);
  const std::size_t length = whole(view, "byteLength", no_index), stride = whole(view, "byteStride", 0);
  if (buffer >= buffers_.size()) fail(fmt::format("bufferViews[{}] names no buffer", index), "is it damaged?");
  const std::string_view bytes = buffers_[buffer];
  if (offset > bytes.size() || length > bytes.size() - offset || stride > 252)
    fail(fmt::format("bufferViews[{}] reaches beyond its buffer", index), "is it truncated?");
  return {bytes.substr(offset, length), stride};
}

std::vector<double> GltfDocument::unpack(const Span& span, std::size_t offset, std::size_t count,
                                         std::size_t components, std::size_t type, bool normalized) const {
  const std::size_t size = bytes_of(type), row = components * size, stride = span.stride > 0 ? span.stride : row;
  const std::size_t room = offset + row <= span.bytes.size() ? (span.bytes.size() - offset - row) / stride + 1 : 0;
  if (count > room || stride < row)
    fail(fmt::format("an accessor of {} elements reaches beyond its bytes, which hold {}", count, room),
         "is it truncated?");
  std::vector<double> values;
  values.reserve(count * components);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < components; ++c)
      values.push_back(component(span.bytes, offset + i * stride + c * size, type, normalized));
  }
  return values;
}

std::vector<double> GltfDocument::numbers(std::size_t index, const std::string& type) const {
  const Json& accessor = element("accessors", index);
  const std::size_t components = type == "VEC3" ? 3 : 1, count = whole(accessor, "count", no_index);
  const std::size_t kind = whole(accessor, "componentType", no_index),
                    view_index = whole(accessor, "bufferView", no_index);
  const auto normal = accessor.find("normalized");
  const bool sparse = accessor.contains("sparse");
  const bool normalized = normal != accessor.end() && *normal == true;
  if (const auto named = accessor.find("type"); named == accessor.end() || *named != type)
    fail(fmt::format("accessors[{}] is not of type {}", index, type), "is it damaged?");
  if (bytes_of(kind) == 0) fail(fmt::format("accessors[{}] has no known componentType", index), "is it damaged?");
  std::size_t bytes = 0;
  for (const std::string& buffer : buffers_) bytes += buffer.size();
  if (count == 0 || count > bytes)
    fail(fmt::format("accessors[{}] has {} elements, its buffers {} bytes", index, count, bytes), "is it damaged?");
  if (count > most_elements)
    fail(fmt::format("accessors[{}] has {} elements, the limit is {}", index, count, most_elements),
         "simplify the mesh");
  std::vector<double> values;
  if (view_index != no_index) {
    values = unpack(view(view_index), whole(accessor, "byteOffset", 0), count, components, kind, normalized);
  } else if (!sparse) {
    fail(fmt::format("accessors[{}] has no data", index), "is it compressed? export it without");
  } else {
    values.assign(count * components, 0);
  }
  if (sparse) apply_sparse(object(accessor, "sparse"), components, kind, normalized, values);
  return values;
}

void GltfDocument::apply_sparse(const Json& sparse, std::size_t components, std::size_t type, bool normalized,
                                std::vector<double>& values) const {
  const std::size_t count = whole(sparse, "count", no_index);
  const Json &places = object(sparse, "indices"), &contents = object(sparse, "values");
  const std::size_t place_type = whole(places, "componentType", no_index);
  if (place_type != 5121 && place_type != 5123 && place_type != 5125)
    fail("a sparse accessor's indices have no known componentType", "is it damaged?");
  const std::vector<double> at =
      unpack(view(whole(places, "bufferView", no_index)), whole(places, "byteOffset", 0), count, 1, place_type, false);
  const std::vector<double> given = unpack(view(whole(contents, "bufferView", no_index)),
                                           whole(contents, "byteOffset", 0), count, components, type, normalized);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!(at[i] >= 0 && at[i] < static_cast<double>(values.size() / components)))
      fail("a sparse accessor's index is beyond its count", "is it damaged?");
    std::copy_n(given.begin() + static_cast<std::ptrdiff_t>(components * i), components,
                values.begin() + static_cast<std::ptrdiff_t>(components * static_cast<std::size_t>(at[i])));
  }
}

void GltfDocument::fail(const std::string& rule, const std::string& advice) const {
  throw InputError(fmt::format("{}: {} ({})", file_, rule, advice));
}

}  // namespace handhold
