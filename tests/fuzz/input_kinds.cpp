// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/input_kinds.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <utility>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/input/mesh/field_cache.hpp"
#include "cases/input/mesh/mesh_import.hpp"
#include "cases/input/recording/recording_csv.hpp"
#include "cases/input/scene/scene_file.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/input/trace/trace_summary.hpp"
#include "cases/model/voxel_file.hpp"
#include "tests/cases/input/mesh_files.hpp"
#include "tests/cases/input/sample_joints.hpp"
#include "tests/cases/input/trace_fixtures.hpp"

namespace handhold::fuzz {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Mesh box() { return make_box({0.008, 0.006, 0.005}); }  // small, so that its default voxels are few

// Polygons, comments, relative indices, a continued line, and what is passed over.
const char* const obj_of_polygons = R"(# of another program
mtllib box.mtl
v -.004 -.003 -.0025 1 0 0
v .004 -.003 -.0025
v .004 .003 -.0025 # 3
v -4e-3 3e-3 -2.5e-3
v -.004 -.003 .0025
v .004 -.003 .0025
v .004 .003 .0025
v -.004 .003 .0025
vt 0 0
vn 0 0 1
usemtl wood
s off
f 4/1/1 3/1/1 2/1/1 \
  1/1/1
f -4//1 -3//1 -2//1 -1//1
f 1 2 6 5
f 2/1 3/1 7/1 6/1
f 3 4 8 7
f 4 1 5 8
l 1 2
)";

const char* const off_with_colours =
    "COFF\n# colours\n8 6 12\n-.004 -.003 -.0025 1 0 0 1\n.004 -.003 -.0025 1 0 0 1\n.004 .003 -.0025 1 0 0 1\n"
    "-.004 .003 -.0025 1 0 0 1\n-.004 -.003 .0025 1 0 0 1\n.004 -.003 .0025 1 0 0 1\n.004 .003 .0025 1 0 0 1\n"
    "-.004 .003 .0025 1 0 0 1\n4 3 2 1 0\n4 4 5 6 7 1 0 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 3; ++b)
      bits = bits << 8 | (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d) text += i + d > bytes.size() ? '=' : digits[bits >> (18 - 6 * d) & 63];
  }
  return text;
}

std::string gltf() {
  const std::string uri = R"(,"uri":"data:application/octet-stream;base64,)" + base64(files::gltf_buffer(box())) + '"';
  const std::string nodes =
      R"({"children":[1],"scale":[1,1,-1]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]})";
  std::string text = files::gltf_json(box(), nodes, 1, uri);
  return text.replace(text.find("{\"asset\""), 1, R"({"extensionsUsed":["KHR_mesh_quantization"],)");
}

std::string ply_of_others() {
  std::string text = files::ply(box(), false);
  text.replace(text.find("property list"), 0, "property uchar material\n");
  for (std::size_t at = text.find("\n3 "); at != std::string::npos; at = text.find("\n3 ", at + 4))
    text.insert(at + 1, "7 ");
  return text;
}

std::string gzipped(const std::string& text) {
  std::string out(compressBound(uLong(text.size())) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 31, 9, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = uInt(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

// Three frames of a flat hand as LeapJS keeps them: mm and µs.
json leap() {
  json frames = json::array();
  for (int i = 0; i < 3; ++i) {
    json pointables = json::array();
    for (int finger = 0; finger < 5; ++finger) {
      const double x = finger == 0 ? -40 : -30 + 20 * (finger - 1), z = finger == 0 ? 10 : -50;
      json pointable{{"id", 120 + finger}, {"handId", 12}, {"type", finger}, {"width", 18}, {"tool", false}};
      const char* const joints[] = {"mcpPosition", "pipPosition", "dipPosition", "tipPosition"};
      const double ahead[] = {0, 40, 65, 82};
      for (std::size_t j = 0; j < 4; ++j) pointable[joints[j]] = {x, 200 + i, z - ahead[j]};
      pointables.push_back(pointable);
    }
    const json hand{{"id", 12},
                    {"type", "right"},
                    {"palmPosition", {0, 200, -5}},
                    {"direction", {0, 0, -1}},
                    {"palmNormal", {0, -1, 0}},
                    {"confidence", 0.75}};
    frames.push_back({{"timestamp", 1e6 + 2e4 * i}, {"id", i}, {"hands", {hand}}, {"pointables", pointables}});
  }
  return {{"metadata", {{"frames", 3}}}, {"frames", frames}};
}

std::string wide_csv() {
  std::string head = "time", rows;
  const json recording = test::closing_recording("openxr", 4, true);
  for (const json& frame : recording["frames"]) {
    const json& joints = frame["hands"]["right"]["joints"];
    rows += frame["t"].dump();
    for (const json& joint : joints) {
      for (std::size_t axis = 0; axis < 3; ++axis) rows += "," + joint["position"][axis].dump();
    }
    rows += "\n";
  }
  for (const json& joint : recording["frames"][0]["hands"]["right"]["joints"]) {
    for (const char* axis : {"_x", "_y", "_z"}) head += ",right_" + joint["name"].get<std::string>() + axis;
  }
  return head + "\n" + rows;
}

const char* const scene = R"(name = "mug in hand"
duration = 2.0
gravity = [0, 0, -9.81]
[contact]
stiffness = 100
damping = 0.5
[body_contact]
stiffness = 20000
[patch]
samples = 8
finger_radius = 0.003
reference_point = "skin"
[[bodies]]
name = "box"
mesh = "box.obj"
material = "glass"
position = [0.1, 0, 0.2]
orientation = [1, 0, 0, 0]
held_until = 0.6
[[bodies]]
name = "table"
voxel_size = 0.02
shape = { kind = "box", x = 0.5, y = 0.5, z = 0.1 }
mobility = "fixed"
sample_spacing = 0
friction = { mu_static = 0.7, mu_dynamic = 0.6 }
[[hands]]
trace = "hand.csv"
start = 0.5
[[hands.patches]]
phalanx = "index_distal"
samples = [[0, 0, 0.01], [0, 0.001, 0.01]]
lag = [0.001, 0, 0]
slipping = [true, false]
)";

Recording recording() {
  Recording made;
  made.engine = "realtime";
  made.scene = "a scene: with, commas";
  made.note = "line one\nline \\two";
  made.provenance = {{"compiler", "g++ 12"}, {"a:b", "c: d"}};
  made.body_names = {"mug", "lid, \"small\""};
  const ContactState contact{{0, 2, 0, 1}, Mode::stick, 0.001, {1, 2, 3}, {4, 5, 6}, {0, 0, 1}, {0.1, 0.2, 0.3}};
  for (int i = 0; i < 3; ++i) {
    Frame frame;
    frame.t = i / 90.0;
    frame.bodies.resize(2);
    if (i > 0) frame.contacts = {contact};
    made.frames.push_back(frame);
  }
  made.events = {{0.01, 1e-12, EventKind::touch, contact.id, made.frames[0].bodies[0]}};
  made.ambiguities = {{0.015, contact.id, "touches on an edge, \"the first\" face is taken"}};
  made.frame_time = {1e-5, 2e-5};
  return made;
}

std::vector<SeedFile> files_in(const fs::path& folder) {
  std::vector<SeedFile> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    found.push_back({entry.path().filename().string(), {std::istreambuf_iterator<char>(stream), {}}});
  }
  std::sort(found.begin(), found.end(), [](const SeedFile& a, const SeedFile& b) { return a.name < b.name; });
  return found;
}

// What `handhold voxelize` does.
void read_as_mesh(const fs::path& file) {
  const ImportedMesh imported = import_mesh(file);
  (void)describe(imported, *voxelize(imported.mesh));
}

void read_as_trace(const fs::path& file) { (void)to_text(summarize(read_trace(file.string()))); }

InputKind meshes(const std::string& name, std::vector<SeedFile> seeds) {
  return {name, std::move(seeds), {}, read_as_mesh};
}

InputKind scenes() {
  InputKind kind{"scene", {{"a.toml", scene}}, {}, {}};
  kind.beside = {{"box.obj", files::obj(box())}, {"hand.csv", to_csv(test::closing_hand(10))}};
  kind.read = [](const fs::path& file) { (void)build(read_scene(file), file.parent_path()); };
  return kind;
}

InputKind recordings() {
  const files::Folder folder;
  write_recording(recording(), folder.path());
  const std::vector<SeedFile> seeds = files_in(folder.path());
  return {"recording", seeds, seeds, [](const fs::path& file) { (void)read_recording(file.parent_path()); }};
}

// An entry that lies where the cache looks for the box.
InputKind cache_entries() {
  const files::Folder folder, cache;
  const SeedFile object{"box.obj", files::obj(box())};
  (void)import_object(folder.write(object.name, object.bytes), 1, {}, {true, cache.path()});
  return {"cache", files_in(cache.path()), {object}, [](const fs::path& file) {
            const fs::path folder_of_both = file.parent_path();
            (void)import_object(folder_of_both / "box.obj", 1, {}, {true, folder_of_both});
          }};
}

}  // namespace

std::vector<InputKind> input_kinds() {
  const std::string joints = test::closing_recording("openxr", 4).dump();
  return {meshes("obj", {{"a.obj", files::obj(box())}, {"b.obj", obj_of_polygons}}),
          meshes("off", {{"a.off", files::off(box())}, {"b.off", off_with_colours}}),
          meshes("stl", {{"a.stl", files::stl_text(box())}, {"b.stl", files::stl_binary(box())}}),
          meshes("ply",
                 {{"a.ply", files::ply(box(), false)}, {"b.ply", files::ply(box(), true)}, {"c.ply", ply_of_others()}}),
          meshes("gltf", {{"a.gltf", gltf()},
                          {"b.glb", files::glb(box(), R"({"mesh":0},{"mesh":0,"translation":[1,0,0]})", 2)}}),
          {"trace",
           {{"a.json", joints},
            {"b.json", test::closing_recording("mediapipe", 4, true).dump()},
            {"c.json", leap().dump()},
            {"d.csv", to_csv(test::closing_hand(5))},
            {"e.csv", wide_csv()},
            {"f.json.gz", gzipped(joints)},
            {"g.json.lz", "N4IgLiBcDaAMB0BGANAWgEzwKwFNUGYBdAXyA==="}},
           {},
           read_as_trace},
          scenes(),
          recordings(),
          {"voxels",
           {{"a.hhvox", pack_voxels(*voxelize(box(), {0.001, 0}), {{0.004, 0.003, 0.0025}})}},
           {},
           [](const fs::path& file) { (void)read_voxel_file(file); }},
          cache_entries()};
}

}  // namespace handhold::fuzz
