// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Mesh files made on the spot for the reader's tests.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "cases/model/mesh.hpp"

namespace handhold::files {

// A folder of this process's own that goes away with it.
class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("handhold_geometry_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::filesystem::path path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

inline std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", x);
  return text;
}

inline std::string point(const Eigen::Vector3d& p) { return number(p.x()) + " " + number(p.y()) + " " + number(p.z()); }

inline std::string obj(const Mesh& mesh) {
  std::string text = "# made by a test\n";
  for (const auto& v : mesh.vertices) text += "v " + point(v) + "\n";
  for (const auto& t : mesh.triangles) {
    text += "f";
    for (const int v : t) text += " " + std::to_string(v + 1);
    text += "\n";
  }
  return text;
}

inline std::string off(const Mesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const auto& v : mesh.vertices) text += point(v) + "\n";
  for (const auto& t : mesh.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text;
}

inline std::string stl_text(const Mesh& mesh) {
  std::string text = "solid test\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : t) text += "vertex " + point(mesh.vertices[v]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid test\n";
}

inline std::string stl_binary(const Mesh& mesh) {
  std::string bytes(80, '\0');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
    for (const int v : t) {
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(mesh.vertices[v][axis]));
    }
    append(bytes, std::uint16_t(0));
  }
  return bytes;
}

inline std::string ply(const Mesh& mesh, bool binary) {
  std::string bytes = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
                      " 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& v : mesh.vertices) {
    for (int axis = 0; binary && axis < 3; ++axis) append(bytes, static_cast<float>(v[axis]));
    if (!binary) bytes += point(v) + "\n";
  }
  for (const auto& t : mesh.triangles) {
    if (binary) append(bytes, std::uint8_t(3));
    if (!binary) bytes += "3";
    for (const int v : t) {
      if (binary) append(bytes, std::int32_t(v));
      if (!binary) bytes += " " + std::to_string(v);
    }
    if (!binary) bytes += "\n";
  }
  return bytes;
}

// JSON of a glTF scene with one mesh (positions and 32-bit indices in one buffer) and the given nodes.
inline std::string gltf_json(const Mesh& mesh, const std::string& nodes, int node_count, const std::string& uri) {
  const std::size_t positions = 12 * mesh.vertices.size(), indices = 12 * mesh.triangles.size();
  std::ostringstream json;
  json << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)";
  for (int n = 0; n < node_count; ++n) json << (n ? "," : "") << n;
  json << R"(]}],"nodes":[)" << nodes
       << R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":)"
       << positions + indices << uri << R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" << positions
       << R"(},{"buffer":0,"byteOffset":)" << positions << R"(,"byteLength":)" << indices
       << R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" << mesh.vertices.size()
       << R"(,"min":[-1,-1,-1],"max":[1,1,1]},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)"
       << 3 * mesh.triangles.size() << "}]}";
  return json.str();
}

inline std::string gltf_buffer(const Mesh& mesh) {
  std::string buffer;
  for (const auto& v : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) append(buffer, static_cast<float>(v[axis]));
  }
  for (const auto& t : mesh.triangles) {
    for (const int v : t) append(buffer, static_cast<std::uint32_t>(v));
  }
  return buffer;
}

inline std::string glb(const Mesh& mesh, const std::string& nodes, int node_count) {
  std::string json = gltf_json(mesh, nodes, node_count, "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer(mesh);
  std::string bytes = "glTF";
  append(bytes, std::uint32_t(2));
  append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<std::uint32_t>(buffer.size()));
  bytes += std::string("BIN\0", 4) + buffer;
  return bytes;
}

}  // namespace handhold::files
