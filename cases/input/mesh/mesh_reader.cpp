// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <fstream>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "cases/geometry/mesh_cleanup.hpp"
#include "cases/input/mesh/mesh_prescan.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::uintmax_t largest_file = 512ull << 20;

[[noreturn]] void fail(const fs::path& file, const std::string& rule, const char* advice) {
  throw InputError(fmt::format("{}: {} ({})", file.string(), rule, advice));
}

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto known = {".obj", ".stl", ".ply", ".off", ".gltf", ".glb"};
  if (std::find(known.begin(), known.end(), extension) != known.end()) return extension;
  fail(file, fmt::format("no mesh format has the extension '{}'", extension), "use .obj .stl .ply .off .gltf or .glb");
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

// Collects the triangles of a scene, node by node.
struct Collector {
  const aiScene& scene;
  Mesh mesh{};
  std::size_t dropped{};  // points and lines

  void add(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 X = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene.mMeshes[node.mMeshes[i]], X);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], X);
  }

  void add(const aiMesh& part, const aiMatrix4x4& X) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D p = X * part.mVertices[i];
      mesh.vertices.emplace_back(p.x, p.y, p.z);
    }
    // A mirroring transform turns the faces inside out.
    const bool mirrored = aiMatrix3x3(X).Determinant() < 0;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      dropped += face.mNumIndices < 3;
      if (face.mNumIndices != 3) continue;
      std::array<int, 3> corners{};
      for (int c = 0; c < 3; ++c) corners[c] = first + static_cast<int>(face.mIndices[c]);
      if (mirrored) std::swap(corners[1], corners[2]);
      mesh.triangles.push_back(corners);
    }
  }
};

// Assimp's own processing steps trust every index, and abort on polygons without corners: look at them first.
void check_indices(const aiScene& scene, const fs::path& file) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    if (part.mNumFaces == 0) fail(file, fmt::format("its mesh {} has no faces", m), "is it damaged?");
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices == 0) fail(file, fmt::format("face {} has no corners", f), "is it damaged?");
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        if (face.mIndices[c] < part.mNumVertices) continue;
        fail(file, fmt::format("face {} names vertex {}, there are {}", f, face.mIndices[c], part.mNumVertices),
             "correct the file");
      }
    }
  }
}

Mesh load(const fs::path& file, std::size_t& dropped) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (scene && scene->mRootNode) {
    check_indices(*scene, file);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  if (!scene || !scene->mRootNode)
    fail(file, "cannot be read: " + one_line(importer.GetErrorString()), "is it damaged?");
  Collector collector{*scene};
  collector.add(*scene->mRootNode, aiMatrix4x4());
  dropped = collector.dropped;
  return std::move(collector.mesh);
}

void check(const Mesh& mesh, const fs::path& file, double scale) {
  Eigen::AlignedBox3d bounds;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) fail(file, fmt::format("vertex {} is not finite", v), "correct the file");
    bounds.extend(mesh.vertices[v]);
  }
  if (mesh.triangles.size() < 4)
    fail(file, fmt::format("{} triangles, a solid has at least 4", mesh.triangles.size()), "give a closed mesh");
  const double extent = bounds.sizes().maxCoeff();
  if (extent > 1e-9 && extent < 1e3) return;
  fail(file, fmt::format("{:g} m across at scale {:g}: must lie between 1e-9 and 1000 m", extent, scale),
       "set the scale");
}

}  // namespace

std::string read_bytes(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) fail(file, "no such file", "check the path");
  if (!fs::is_regular_file(status)) fail(file, "not a file", "give a file, not a folder");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size == 0) fail(file, "the file is empty", "export it again");
  if (size > largest_file) fail(file, fmt::format("{} MB, the limit is 512", size >> 20), "simplify the mesh");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(size, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    fail(file, "cannot be read", "check its permissions");
  return bytes;
}

Mesh read_mesh(const fs::path& file, double scale, std::vector<std::string>* warnings) {
  if (!(scale > 0 && std::isfinite(scale)))
    fail(file, fmt::format("scale={}: need a number above 0", scale), "0.001 for a file in millimetres");
  const std::string bytes = read_bytes(file);
  const MeshPrescan promised = prescan_mesh(bytes, lower_extension(file), file.string());

  Mesh mesh;
  std::size_t dropped = 0;
  try {
    mesh = load(file, dropped);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {  // bad_alloc on absurd counts and the like
    fail(file, "cannot be read: " + one_line(error.what()), "is it damaged?");
  }
  if (mesh.triangles.size() < promised.triangles) {
    fail(file, fmt::format("only {} of {} triangles can be read", mesh.triangles.size(), promised.triangles),
         "the faces left out are damaged");
  }
  weld(mesh, 0);  // the library gives every face its own corners
  for (Vector3d& v : mesh.vertices) v *= scale;
  check(mesh, file, scale);
  if (dropped > 0 && warnings) warnings->push_back(fmt::format("{} points and lines were dropped", dropped));
  return mesh;
}

}  // namespace handhold
