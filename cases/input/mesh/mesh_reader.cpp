// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_reader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cases/geometry/cgal_triangulate.hpp"
#include "cases/geometry/mesh_cleanup.hpp"
#include "cases/input/mesh/text_lines.hpp"
#include "cases/input/regular_file.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr std::size_t most_corners = 100'000;  // of one face: to cut it takes half a kilobyte a corner
constexpr std::size_t largest_total = std::size_t{512} << 20;

[[noreturn]] void fail(const fs::path& file, const std::string& rule, const std::string& advice) {
  throw InputError(fmt::format("{}: {} ({})", file.string(), rule, advice));
}

std::string lower_extension(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  const auto known = {".obj", ".stl", ".ply", ".off", ".gltf", ".glb"};
  if (std::find(known.begin(), known.end(), extension) != known.end()) return extension;
  fail(file, fmt::format("no mesh format has the extension '{}'", extension), "use .obj .stl .ply .off .gltf or .glb");
}

// The file that a URI names: %20 is a blank, and nothing is fetched from a network.
fs::path local_path(const fs::path& file, const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool code = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                      std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    name += code ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (code) i += 2;
  }
  if (name.empty() || name.find("://") != std::string::npos || name.find('\0') != std::string::npos)
    fail(file, fmt::format("its buffer '{}' is no file beside it", printable(uri)), "put it there");
  return file.parent_path() / name;
}

PolygonSoup parse(const MeshFile& file) {
  const std::string name = file.path.string();
  if (file.extension == ".obj") return parse_obj(file.bytes, name);
  if (file.extension == ".off") return parse_off(file.bytes, name);
  if (file.extension == ".stl") return parse_stl(file.bytes, name);
  if (file.extension == ".ply") return parse_ply(file.bytes, name);
  return parse_gltf(file.bytes, file.buffers, name);
}

struct Cut {
  std::size_t skew{}, crossed{};
  double ambiguity{};
};

void add_polygon(const PolygonSoup& soup, std::size_t begin, std::size_t end, Mesh& mesh, Cut& cut) {
  const int* corner = soup.corners.data() + begin;
  if (end - begin == 3) {
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
    return;
  }
  std::vector<Vector3d> points;
  for (std::size_t i = begin; i < end; ++i) points.push_back(soup.points[static_cast<std::size_t>(soup.corners[i])]);
  const CutPolygon polygon = cut_polygon(points);
  for (const auto& [a, b, c] : polygon.triangles) mesh.triangles.push_back({corner[a], corner[b], corner[c]});
  cut.crossed += !polygon.sound;
  cut.skew += polygon.ambiguity > 0;
  cut.ambiguity += polygon.ambiguity;
}

// Says so if the ways to cut the polygons matter: by a thousandth of the volume.
std::vector<std::string> remarks(const Cut& cut, const Mesh& mesh) {
  std::vector<std::string> out;
  const double volume = std::abs(solid_properties(mesh).volume);
  if (volume > 0 && cut.ambiguity > 1e-3 * volume) {
    out.push_back(
        fmt::format("{} faces are not planar: cut along other diagonals the volume differs by up to {:.3g} % "
                    "(cut them into triangles in a mesh editor)",
                    cut.skew, 100 * cut.ambiguity / volume));
  }
  if (cut.crossed > 0)
    out.push_back(fmt::format("{} faces cross themselves (cut them into triangles in a mesh editor)", cut.crossed));
  return out;
}

Mesh triangulated(PolygonSoup soup, const fs::path& file, Cut& cut) {
  Mesh mesh;
  std::size_t begin = 0;
  for (const std::size_t end : soup.ends) {
    if (end - begin > most_corners)
      fail(file, fmt::format("face of {} corners, the limit is {}", end - begin, most_corners),
           "cut it into triangles");
    add_polygon(soup, begin, end, mesh, cut);
    begin = end;
  }
  mesh.vertices = std::move(soup.points);
  return mesh;
}

// Before anything is computed from the coordinates. Vertices that no face names do not count for the size.
void check_size(const PolygonSoup& soup, const fs::path& file, double scale) {
  if (soup.ends.empty()) fail(file, "there are no faces in it", "give a closed mesh");
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (!(scale * soup.points[v].cwiseAbs().maxCoeff() < 1e30))
      fail(file, fmt::format("vertex {} lies beyond 1e30 m", v), "correct the file");
  }
  Eigen::AlignedBox3d bounds;
  for (const int corner : soup.corners) bounds.extend(soup.points[static_cast<std::size_t>(corner)]);
  const double extent = scale * bounds.sizes().maxCoeff();
  if (extent > 1e-9 && extent < 1e3) return;
  fail(file, fmt::format("{:g} m across at scale {:g}: must lie between 1e-9 and 1000 m", extent, scale),
       extent < 1 ? "set the scale" : "is it in millimetres? --scale 0.001");
}

}  // namespace

MeshFile read_mesh_file(const fs::path& path) {
  MeshFile file;
  file.path = path;
  file.bytes = read_regular_file(path);
  if (file.bytes.empty()) fail(path, "the file is empty", "export it again");
  file.extension = lower_extension(path);
  if (file.extension != ".gltf" && file.extension != ".glb") return file;
  std::size_t total = file.bytes.size();
  for (const std::string& uri : external_buffers(file.bytes, path.string())) {
    if (file.buffers.count(uri)) continue;
    try {
      total += (file.buffers[uri] = read_regular_file(local_path(path, uri))).size();
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: its buffer {}", path.string(), error.what()));
    }
    if (total > largest_total) fail(path, "with its buffers larger than 512 MiB", "simplify the mesh");
  }
  return file;
}

Mesh read_mesh(const MeshFile& file, double scale, std::vector<std::string>* warnings) {
  if (!(scale > 0 && std::isfinite(scale)))
    fail(file.path, fmt::format("scale={}: need a number above 0", scale), "0.001 for a file in millimetres");
  PolygonSoup soup = parse(file);
  std::vector<std::string> said = std::move(soup.warnings);
  if (soup.dropped > 0) said.push_back(fmt::format("{} points and lines were dropped", soup.dropped));
  check_size(soup, file.path, scale);
  Cut cut;
  Mesh mesh = triangulated(std::move(soup), file.path, cut);
  if (mesh.triangles.size() < 4)
    fail(file.path, fmt::format("{} triangles, a solid has at least 4", mesh.triangles.size()), "give a closed mesh");
  weld(mesh, 0);  // most formats give every face its own corners
  for (std::string& remark : remarks(cut, mesh)) said.push_back(std::move(remark));
  for (Vector3d& v : mesh.vertices) v *= scale;
  if (warnings) warnings->insert(warnings->end(), said.begin(), said.end());
  return mesh;
}

Mesh read_mesh(const fs::path& file, double scale, std::vector<std::string>* warnings) {
  return read_mesh(read_mesh_file(file), scale, warnings);
}

}  // namespace handhold
