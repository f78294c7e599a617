// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Private to the glTF reader: not for public headers, as it shows nlohmann::json.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cases/input/mesh/mesh_formats.hpp"

namespace handhold {

/// The JSON of a glTF 2.0 file and its buffers' bytes, checked as far as reads of it rely on. All functions throw
/// InputError naming the file and the member that is wrong.
class GltfDocument {
 public:
  using Json = nlohmann::json;

  GltfDocument(std::string_view bytes, const std::string& file);

  [[nodiscard]] const Json& json() const { return json_; }
  [[nodiscard]] std::vector<std::string> external_uris() const;
  void load_buffers(const GltfBuffers& external);

  /// Element `index` of the list `name` at the top.
  [[nodiscard]] const Json& element(const char* name, std::size_t index) const;
  /// Member `name` of `object` as an index or count; `otherwise` if it is absent.
  [[nodiscard]] std::size_t whole(const Json& object, const char* name, std::size_t otherwise) const;
  /// The member `name` of `object`, itself an object; an empty one if it is absent.
  [[nodiscard]] const Json& object(const Json& object, const char* name) const;
  /// The list `name` of `object`; an empty one if it is absent.
  [[nodiscard]] const Json& list(const Json& object, const char* name) const;
  [[nodiscard]] bool uses(const char* extension) const;

  /// All numbers of an accessor of `type` ("SCALAR", "VEC3"), row by row, integers scaled as KHR_mesh_quantization
  /// says.
  [[nodiscard]] std::vector<double> numbers(std::size_t accessor, const std::string& type) const;

  [[noreturn]] void fail(const std::string& rule, const std::string& advice) const;

 private:
  struct Span {
    std::string_view bytes;
    std::size_t stride;  // 0: tightly packed
  };

  std::string_view open_glb(std::string_view bytes);
  void check_version() const;
  void check_extensions() const;
  [[nodiscard]] Span view(std::size_t index) const;
  [[nodiscard]] std::vector<double> unpack(const Span& span, std::size_t offset, std::size_t count,
                                           std::size_t components, std::size_t type, bool normalized) const;
  void apply_sparse(const Json& sparse, std::size_t components, std::size_t type, bool normalized,
                    std::vector<double>& values) const;

  std::string file_;
  Json json_;
  std::string_view chunk_;  // binary chunk of a GLB
  std::vector<std::string> buffers_;
};

constexpr std::size_t no_index = ~std::size_t{0};

/// `value` as an index or count; `no_index` if it is none.
[[nodiscard]] std::size_t whole_number(const nlohmann::json& value);

}  // namespace handhold
