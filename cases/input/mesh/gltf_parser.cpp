// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cases/input/mesh/gltf_document.hpp"

namespace handhold {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;
using Json = GltfDocument::Json;

constexpr std::size_t most_triangles = 2'000'000;

class SceneReader {
 public:
  explicit SceneReader(const GltfDocument& document) : document_(document) {}

  PolygonSoup run() && {
    const std::size_t nodes = document_.list(document_.json(), "nodes").size();
    std::vector<bool> seen(nodes, false);
    std::vector<std::pair<std::size_t, Affine3d>> waiting;
    const auto add = [&](const Json& list, const Affine3d& X) {
      for (const Json& child : list) {
        const std::size_t node = whole_number(child);
        if (node >= nodes) document_.fail("a scene or node names a node that does not exist", "is it damaged?");
        // The rule of glTF that makes its nodes trees: without it a few nodes could show a mesh a billion times.
        if (seen[node]) document_.fail(fmt::format("nodes[{}] is named twice as a child", node), "is it damaged?");
        seen[node] = true;
        waiting.emplace_back(node, X);
      }
    };
    if (document_.list(document_.json(), "scenes").empty())
      document_.fail("there is no scene in it", "export it with one");
    const Json& scene = document_.element("scenes", document_.whole(document_.json(), "scene", 0));
    add(document_.list(scene, "nodes"), Affine3d::Identity());
    while (!waiting.empty()) {
      const auto [index, parent] = waiting.back();
      waiting.pop_back();
      const Json& node = document_.element("nodes", index);
      const Affine3d X = parent * transform(node, index);
      if (const std::size_t mesh = document_.whole(node, "mesh", no_index); mesh != no_index) add_mesh(mesh, X);
      if (document_.object(node, "extensions").contains("EXT_mesh_gpu_instancing"))
        document_.fail("extension EXT_mesh_gpu_instancing is not supported", "export each instance as a node");
      if (node.contains("skin") || node.contains("weights")) posed_ = true;
      add(document_.list(node, "children"), X);
    }
    if (posed_) soup_.warnings.emplace_back("it has a skeleton or morph targets: taken as its vertices were modelled");
    return std::move(soup_);
  }

 private:
  template <int size>
  Eigen::Matrix<double, size, 1> vector(const Json& node, const char* name, std::size_t index,
                                        const Eigen::Matrix<double, size, 1>& otherwise) const {
    if (!node.contains(name)) return otherwise;
    const Json& list = document_.list(node, name);
    Eigen::Matrix<double, size, 1> v = otherwise;
    bool sound = list.size() == size;
    for (int i = 0; sound && i < size; ++i) {
      const Json& item = list[static_cast<std::size_t>(i)];
      sound = item.is_number();
      if (sound) v[i] = item.get<double>();
    }
    if (!sound || !v.allFinite())
      document_.fail(fmt::format("nodes[{}].{} needs {} finite numbers", index, name, size), "is it damaged?");
    return v;
  }

  Affine3d transform(const Json& node, std::size_t index) const {
    Affine3d X = Affine3d::Identity();
    if (node.contains("matrix")) {
      const Eigen::Matrix<double, 16, 1> columns =
          vector<16>(node, "matrix", index, Eigen::Matrix<double, 16, 1>::Zero());
      X.matrix() = Eigen::Map<const Eigen::Matrix4d>(columns.data());
      X.makeAffine();
      return X;
    }
    const Eigen::Vector4d q = vector<4>(node, "rotation", index, {0, 0, 0, 1});
    if (!(q.norm() > 1e-6)) document_.fail(fmt::format("nodes[{}].rotation is zero", index), "is it damaged?");
    X.translate(vector<3>(node, "translation", index, Vector3d::Zero()));
    X.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
    X.scale(vector<3>(node, "scale", index, Vector3d::Ones()));
    return X;
  }

  void add_mesh(std::size_t mesh, const Affine3d& X) {
    for (const Json& primitive : document_.list(document_.element("meshes", mesh), "primitives")) {
      const std::size_t mode = document_.whole(primitive, "mode", 4);
      if (mode > 6) document_.fail(fmt::format("a primitive has mode {}", mode), "is it damaged?");
      const std::size_t accessor = document_.whole(document_.object(primitive, "attributes"), "POSITION", no_index);
      if (mode < 4 || accessor == no_index) {
        ++soup_.dropped;
        check_total();
        continue;
      }
      refuse_compression(primitive, accessor);
      add_triangles(points(accessor, X), indices(primitive), mode, X.linear().determinant() < 0);
    }
  }

  void refuse_compression(const Json& primitive, std::size_t accessor) const {
    if (!document_.object(primitive, "extensions").contains("KHR_draco_mesh_compression")) return;
    if (document_.element("accessors", accessor).contains("bufferView")) return;
    document_.fail("extension KHR_draco_mesh_compression is not supported", "export it without, uncompressed");
  }

  std::size_t points(std::size_t accessor, const Affine3d& X) {
    const bool floats = document_.whole(document_.element("accessors", accessor), "componentType", no_index) == 5126;
    if (!floats && !document_.uses("KHR_mesh_quantization"))
      document_.fail("positions must be floats, or KHR_mesh_quantization be named in extensionsUsed",
                     "export it again");
    const std::vector<double> values = document_.numbers(accessor, "VEC3");
    const std::size_t first = soup_.points.size();
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      soup_.points.push_back(X * Vector3d(values[i], values[i + 1], values[i + 2]));
    check_total();
    return first;
  }

  void check_total(std::size_t more = 0) const {
    if (soup_.ends.size() + soup_.dropped + more <= most_triangles && soup_.points.size() <= 3 * most_triangles) return;
    document_.fail(fmt::format("shows more than {} triangles", most_triangles), "simplify the mesh");
  }

  // Empty if the points stand for themselves.
  std::vector<double> indices(const Json& primitive) const {
    const std::size_t accessor = document_.whole(primitive, "indices", no_index);
    if (accessor == no_index) return {};
    const std::size_t type = document_.whole(document_.element("accessors", accessor), "componentType", no_index);
    if (type != 5121 && type != 5123 && type != 5125) document_.fail("indices are no whole numbers", "is it damaged?");
    return document_.numbers(accessor, "SCALAR");
  }

  void add_triangles(std::size_t first, const std::vector<double>& listed, std::size_t mode, bool mirrored) {
    const std::size_t points = soup_.points.size() - first, count = listed.empty() ? points : listed.size();
    const auto corner = [&](std::size_t i) {
      const double index = listed.empty() ? static_cast<double>(i) : listed[i];
      if (!(index < static_cast<double>(points)))
        document_.fail(fmt::format("a triangle names vertex {}, there are {}", index, points), "correct the file");
      return static_cast<int>(first + static_cast<std::size_t>(index));
    };
    const std::size_t triangles = mode == 4 ? count / 3 : count - std::min<std::size_t>(count, 2);
    check_total(triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
      std::array<std::size_t, 3> at = {3 * t, 3 * t + 1, 3 * t + 2};  // triangle by triangle
      if (mode == 5) at = {t, t + 1 + t % 2, t + 2 - t % 2};          // strip
      if (mode == 6) at = {t + 1, t + 2, 0};                          // fan
      if (mirrored) std::swap(at[1], at[2]);
      for (const std::size_t i : at) soup_.corners.push_back(corner(i));
      soup_.ends.push_back(soup_.corners.size());
    }
  }

  const GltfDocument& document_;
  PolygonSoup soup_;
  bool posed_ = false;
};

}  // namespace

std::vector<std::string> external_buffers(std::string_view bytes, const std::string& file) {
  return GltfDocument(bytes, file).external_uris();
}

PolygonSoup parse_gltf(std::string_view bytes, const GltfBuffers& buffers, const std::string& file) {
  GltfDocument document(bytes, file);
  document.load_buffers(buffers);
  return SceneReader(document).run();
}

}  // namespace handhold
