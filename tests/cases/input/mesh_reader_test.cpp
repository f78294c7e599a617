// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_reader.hpp"

#include <cctype>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cases/geometry/mesh_topology.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/input/mesh_files.hpp"

namespace handhold {
namespace {

class MeshReader : public testing::Test {
 protected:
  // Every format stores the same hammer; 1e-6: binary formats keep coordinates as floats (6e-8 each).
  void expect_hammer(const std::string& name, const std::string& bytes, double scale = 1) {
    const Mesh mesh = read_mesh(folder_.write(name, bytes), scale);
    EXPECT_EQ(mesh.triangles.size(), hammer_.triangles.size()) << name;
    EXPECT_EQ(mesh.vertices.size(), hammer_.vertices.size()) << name;
    EXPECT_TRUE(mesh_topology(mesh).closed_and_oriented()) << name;
    const double cube = scale * scale * scale;
    EXPECT_NEAR(solid_properties(mesh).volume / (cube * solid_properties(hammer_).volume), 1, 1e-6) << name;
  }

  std::string message(const std::string& name, const std::string& bytes) {
    const auto file = folder_.write(name, bytes);
    try {
      (void)read_mesh(file);
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      EXPECT_EQ(text.find(file.string()), 0u) << text;  // the file comes first
      return text.substr(std::min(text.size(), file.string().size()));
    }
    return "accepted";
  }

  void expect_message(const std::string& name, const std::string& bytes, const std::string& part) {
    const std::string text = message(name, bytes);
    EXPECT_NE(text.find(part), std::string::npos) << name << " says" << text;
  }

  files::Folder folder_;
  Mesh hammer_ = make_hammer();
  Mesh box_ = make_box({0.06, 0.04, 0.02});
};

TEST_F(MeshReader, ReadsEveryFormat) {
  expect_hammer("a.obj", files::obj(hammer_));
  expect_hammer("a.off", files::off(hammer_));
  expect_hammer("text.stl", files::stl_text(hammer_));
  expect_hammer("binary.stl", files::stl_binary(hammer_));
  expect_hammer("text.ply", files::ply(hammer_, false));
  expect_hammer("binary.ply", files::ply(hammer_, true));
  expect_hammer("a.glb", files::glb(hammer_, R"({"mesh":0})", 1));
  expect_hammer("UPPER.OBJ", files::obj(hammer_));
  expect_hammer("millimetres.obj", files::obj(hammer_), 0.001);
  expect_hammer("binary that begins with solid.stl", "solid" + files::stl_binary(hammer_).substr(5));
}

TEST_F(MeshReader, ReadsPolygonsAndRelativeIndices) {
  std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  cube += "vn 0 0 1\nvt 0 0\nf 4/1/1 3/1/1 2/1/1 1/1/1\nf -4 -3 -2 -1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const Mesh mesh = read_mesh(folder_.write("cube.obj", cube));
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_NEAR(solid_properties(mesh).volume, 1, 1e-6);
}

// Two nodes: one moved, one mirrored and doubled. Volume of the second: 8 boxes, and right side out.
TEST_F(MeshReader, MergesNodesWithTheirTransforms) {
  const std::string nodes = R"({"mesh":0,"translation":[0.5,0,0]},{"mesh":0,"scale":[-2,2,2]})";
  const Mesh mesh = read_mesh(folder_.write("two.glb", files::glb(box_, nodes, 2)));
  EXPECT_EQ(mesh.triangles.size(), 24u);
  const SolidProperties p = solid_properties(mesh);
  EXPECT_NEAR(p.volume / (9 * 0.06 * 0.04 * 0.02), 1, 1e-6);
  EXPECT_NEAR(p.center.x(), 0.5 / 9, 1e-7);  // the first weighs one in nine
}

TEST_F(MeshReader, DropsLinesWithAWarning) {
  std::vector<std::string> warnings;
  const Mesh mesh = read_mesh(folder_.write("lines.obj", files::obj(box_) + "l 1 2\nl 3 4\n"), 1, &warnings);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "2 points and lines were dropped");
}

TEST_F(MeshReader, NamesFileAndPlaceOfWrongObj) {
  expect_message("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\n", ":2: 'nan' is not a finite number");
  expect_message("huge.obj", "v 0 0 0\nv 1 1e999 0\n", ":2: '1e999' is not a finite number");
  expect_message("short.obj", "v 0 0 0\nv 1 2\n", ":2: a vertex needs three coordinates");
  expect_message("index.obj", files::obj(box_) + "f 1 2 9\n", ":22: face names vertex 9, there are 8");
  expect_message("zero.obj", files::obj(box_) + "f 1 2 0\n", ":22: face names vertex 0");
  expect_message("back.obj", files::obj(box_) + "f 1 2 -9\n", ":22: face names vertex -9");
  expect_message("word.obj", files::obj(box_) + "f 1 2 x\n", ":22: 'x' is not a whole number");
  expect_message("two.obj", files::obj(box_) + "f 1 2\n", ":22: face of 2 corners");
  expect_message("none.obj", "v 0 0 0\n", "no face");
  const std::string whole = files::obj(box_);
  expect_message("cut.obj", whole.substr(0, whole.find("f ")), "no face");
}

TEST_F(MeshReader, NamesFileAndPlaceOfWrongOff) {
  const std::string whole = files::off(box_);
  expect_message("cut.off", whole.substr(0, whole.find("\n3 ") + 1), "ends within the faces");
  expect_message("cut face.off", whole.substr(0, whole.size() - 3), ":22: face of 3 corners names only 2");
  expect_message("nan.off", "OFF\n4 4 0\n0 0 0\n1 inf 0\n", ":4: 'inf' is not a finite number");
  expect_message("index.off", whole.substr(0, whole.size() - 2) + "8\n", ":22: face names vertex 8, there are 8");
  expect_message("many.off", "OFF\n2000000000 4 0\n", "more than the file can hold");
  expect_message("corners.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2000000000 0 1 2\n",
                 ":7: face of 2000000000 corners");
  expect_message("other.off", "ply\n", "does not begin with OFF");
}

TEST_F(MeshReader, RefusesDamagedStl) {
  const std::string text = files::stl_text(box_), binary = files::stl_binary(box_);
  expect_message("cut text.stl", text.substr(0, text.size() / 2), "is the file truncated?");
  expect_message("cut binary.stl", binary.substr(0, binary.size() - 20),
                 "12 triangles announced, 664 bytes instead of 684");
  expect_message("nan text.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", ":4: 'nan'");
  std::string nan = binary;
  const float not_a_number = NAN;
  std::memcpy(nan.data() + 84 + 50 * 3 + 12, &not_a_number, 4);
  expect_message("nan binary.stl", nan, "triangle 3 has a coordinate that is not finite");
  expect_message("tiny.stl", "abc", "less than a header");
}

TEST_F(MeshReader, RefusesDamagedPlyAndGltf) {
  const std::string text = files::ply(box_, false), binary = files::ply(box_, true);
  expect_message("cut text.ply", text.substr(0, text.find("\n3 ") + 1), "ends within the faces");
  EXPECT_NE(message("cut binary.ply", binary.substr(0, binary.size() - 40)), "accepted");
  expect_message("many.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\n", "more than the file can hold");
  std::string damaged = binary;  // once the importer aborted on the rest
  damaged[damaged.find("property", damaged.find("float x")) + 4] = '\0';
  expect_message("damaged.ply", damaged, ":5: a PLY header has no 'prop?rty'");
  damaged = binary;  // as did a list of no corners
  for (std::size_t face = binary.size() - 13 * 12; face < binary.size(); face += 13) damaged[face] = '\0';
  expect_message("no corners.ply", damaged, "a face has no corners");
  expect_message("negative.ply", "ply\nformat ascii 1.0\nelement vertex -4\n", "more than the file can hold");
  std::string index = text;
  index.replace(index.rfind(" ") + 1, 1, "8");
  expect_message("index.ply", index, "face names vertex 8, there are 8");
  std::string wild = binary;
  const std::int32_t far = 1 << 30;
  std::memcpy(wild.data() + wild.size() - 4, &far, 4);
  EXPECT_NE(message("wild binary.ply", wild), "accepted");
  std::string nan = binary;
  const float not_a_number = NAN;
  std::memcpy(nan.data() + nan.find("end_header\n") + 11, &not_a_number, 4);
  expect_message("nan binary.ply", nan, "element 1 ('vertex'): a coordinate is not finite");
  const std::string glb = files::glb(box_, R"({"mesh":0})", 1);
  expect_message("cut.glb", glb.substr(0, glb.size() - 30), "is it truncated?");
  expect_message("cut.gltf", R"({"asset":{"version":"2.0")", "this is not JSON (the text ends too early");
  expect_message("empty scene.gltf", R"({"asset":{"version":"2.0"}})", "there is no scene in it");
}

// A box of 8 vertices and 6 faces in the dialects of others: all mean the same 24 cm³.
class Dialect : public MeshReader {
 protected:
  /// Three lengths in single precision: 3 x 2^-24 of the volume [m^3].
  static constexpr double rounding = 24e-6 * 3 / (1 << 24);

  void expect_box(const std::string& name, const std::string& bytes) {
    const Mesh mesh = read_mesh(folder_.write(name, bytes));
    EXPECT_EQ(mesh.triangles.size(), 12u) << name;
    EXPECT_TRUE(mesh_topology(mesh).closed_and_oriented()) << name;
    EXPECT_NEAR(solid_properties(mesh).volume, 24e-6, rounding) << name;
  }

  static std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
      text.replace(at, what.size(), by);
    return text;
  }

  static std::string utf16(const std::string& text, bool big, bool mark) {
    std::string bytes = !mark ? "" : big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : text) bytes += big ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
  }

  Mesh small_ = make_box({0.02, 0.03, 0.04});
};

TEST_F(Dialect, NumbersAndLinesOfObj) {
  const std::string text = files::obj(small_);
  expect_box("dot.obj", replaced(text, "0.0", ".0"));
  expect_box("exponent.obj", replaced(replaced(text, "0.015", ".15e-1"), " 0.02", " +2.E-2"));
}

TEST_F(Dialect, LinesOfObj) {
  const std::string text = files::obj(small_);
  expect_box("mark.obj", "\xEF\xBB\xBF" + text.substr(text.find('\n') + 1));
  expect_box("cr.obj", replaced(text, "\n", "\r"));
  expect_box("crlf.obj", replaced(text, "\n", "\r\n"));
  expect_box("upper.obj", replaced(replaced(text, "v ", "V "), "f ", "F "));
  expect_box("comment.obj", replaced(text, "\n", " # 1 2 n\n"));
  expect_box("continued.obj", replaced(text, "f ", "f \\\n"));
  expect_box("tabs.obj", replaced(text, " ", "\t"));
  expect_box("wide.obj", utf16(text, false, true));
  expect_box("wide without a mark.obj", utf16(text, false, false));
  expect_box("wide, big.obj", utf16(text, true, true));
  expect_message("four bytes.obj", std::string("v\0\0\0 \0\0\0", 8), "UTF-32");
  expect_message("plus.obj", "v 0 0 +-1\n", ":1: '+-1' is not a finite number");
  expect_message("rest.obj", "v 0 0 0 x\n", ":1: 'x' is not a finite number");
  expect_message("weight.obj", "v 0 0 0 0.5\n", ":1: a vertex of weight 0.5");
  expect_message("qnan.obj", "v 0 0 0\nv 1 0 1.#QNAN\n", ":2: '1.#QNAN' is not a finite number");
  expect_message("comma.obj", "v 0 0 0,5\n", ":1: '0,5' is not a finite number");
}

TEST_F(Dialect, EndsAndLettersOfStl) {
  const std::string text = files::stl_text(small_), binary = files::stl_binary(small_);
  std::string upper = text;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_box("upper.stl", upper);
  expect_box("end solid.stl", replaced(text, "endsolid", "end solid"));
  expect_box("no end.stl", replaced(text, "endsolid test\n", ""));
  expect_box("mark.stl", "\xEF\xBB\xBF" + text);
  expect_box("tail.stl", binary + "xy");
  std::string uncounted = binary;
  uncounted.replace(80, 4, std::string(4, '\0'));
  expect_box("uncounted.stl", uncounted);
}

TEST_F(Dialect, OrdersOfPly) {
  const std::string text = files::ply(small_, false);
  std::string scalar = replaced(text, "property list", "property uchar material\nproperty list");
  scalar = replaced(scalar, "\n3 ", "\n7 3 ");
  expect_box("scalar first.ply", scalar);
  const std::size_t vertex = text.find("element vertex"), face = text.find("element face"),
                    end = text.find("end_header");
  const std::size_t body = end + 11, faces = text.find("\n3 ") + 1;
  expect_box("faces first.ply", text.substr(0, vertex) + text.substr(face, end - face) +
                                    text.substr(vertex, face - vertex) + "end_header\n" + text.substr(faces) +
                                    text.substr(body, faces - body));
  expect_message("qnan.ply", replaced(text, "\n3 ", "\n1.#QNAN "), "'1.#QNAN' is not a whole number");
  std::string bomb = files::ply(small_, true);  // a list that announces more than the file holds
  bomb = replaced(bomb, "list uchar int", "list uint int");
  EXPECT_NE(message("bomb.ply", bomb), "accepted");
}

TEST_F(Dialect, HeadersOfOff) {
  const std::string text = files::off(small_);
  expect_box("comment.off", replaced(text, "\n3 ", "\n# a face\n3 "));
  expect_box("no edges.off", replaced(text, " 12 0\n", " 12\n"));
  expect_box("no keyword.off", text.substr(4));
  expect_box("stuck.off", "OFF" + text.substr(4));
  expect_message("4.off", "4OFF\n8 6 0\n", "more than 3 dimensions");
}

// An L of two squares and one: a fan from its first corner would span the notch. The cap's triangles have its area.
TEST_F(Dialect, CutsConcaveFacesWithinThem) {
  std::string text = "v 0 2 0\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\n";
  text += "v 0 2 1\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 1; i <= 6; ++i) {
    const int next = i % 6 + 1;
    text += "f " + std::to_string(i) + " " + std::to_string(next) + " " + std::to_string(next + 6) + " " +
            std::to_string(i + 6) + "\n";
  }
  const Mesh mesh = read_mesh(folder_.write("l.obj", text));
  EXPECT_NEAR(solid_properties(mesh).volume, 3, 1e-12);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
  EXPECT_NEAR(area, 3 + 3 + 8, 1e-12);
}

// Its sides' corners are 1 apart from a plane: what another diagonal encloses differs, and a word says so.
TEST_F(Dialect, SaysThatFacesAreNotPlanar) {
  std::vector<std::string> warnings;
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 2\nv 0 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\n"
      "f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  (void)read_mesh(folder_.write("skew.obj", text), 1, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1 faces are not planar"), std::string::npos) << warnings[0];
}

class Gltf : public Dialect {
 protected:
  std::string text(const std::string& nodes, int count) {
    const std::string buffer = files::gltf_buffer(small_);
    (void)folder_.write("box.bin", buffer);
    return files::gltf_json(small_, nodes, count, R"(,"uri":"box.bin")");
  }
};

TEST_F(Gltf, ExternalBuffersAreRegularFiles) {
  const std::string good = text(R"({"mesh":0})", 1);
  const Mesh mesh = read_mesh(folder_.write("good.gltf", good));
  EXPECT_NEAR(solid_properties(mesh).volume, 24e-6, rounding);
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  expect_message("pipe.gltf", replaced(good, "box.bin", "pipe"), "is a device or a pipe");
  expect_message("none.gltf", replaced(good, "box.bin", "none.bin"), "no such file");
  expect_message("net.gltf", replaced(good, "box.bin", "http://x/box.bin"), "is no file beside it");
}

TEST_F(Gltf, RefusesWhatCouldChangeTheGeometry) {
  const std::string good = text(R"({"mesh":0})", 1);
  expect_message("meshopt.gltf",
                 replaced(good, "{\"asset\"", R"({"extensionsRequired":["EXT_meshopt_compression"],"asset")"),
                 "extension EXT_meshopt_compression is required and not supported");
  expect_message("old.gltf", replaced(good, "\"2.0\"", "\"1.0\""), "is glTF 1.0 (export it as glTF 2.0)");
  expect_message("shorts.gltf", replaced(good, "5126", "5122"), "KHR_mesh_quantization");
  expect_message("deep.gltf", std::string(100000, '['), "more than 64 levels of lists");
}

TEST_F(Gltf, NodesAreTrees) {
  expect_message("bomb.gltf", replaced(text(R"({"children":[1,1]},{"mesh":0})", 2), "\"nodes\":[0,1]", "\"nodes\":[0]"),
                 "nodes[1] is named twice");
  expect_message("cycle.gltf",
                 replaced(text(R"({"children":[1]},{"children":[0]})", 2), "\"nodes\":[0,1]", "\"nodes\":[0]"),
                 "nodes[0] is named twice");
  std::string chain;
  for (int i = 1; i < 20000; ++i) chain += "{\"children\":[" + std::to_string(i) + "]},";
  const std::string text_of_chain = text(chain + R"({"mesh":0})", 1);
  EXPECT_EQ(read_mesh(folder_.write("chain.gltf", text_of_chain)).triangles.size(), 12u);
}

// Shorts that stand for -1 to 1 of a cube, scaled to 2 cm by its node.
TEST_F(Gltf, DecodesQuantizedPositions) {
  const Mesh cube = make_box({2, 2, 2});
  std::string buffer;
  for (const auto& v : cube.vertices) {
    for (int axis = 0; axis < 3; ++axis) files::append(buffer, static_cast<std::int16_t>(32767 * v[axis]));
  }
  buffer.resize(12 * cube.vertices.size(), '\0');  // the indices begin where those of floats do
  buffer += files::gltf_buffer(cube).substr(12 * cube.vertices.size());
  (void)folder_.write("shorts.bin", buffer);
  std::string json = files::gltf_json(cube, R"({"mesh":0,"scale":[0.01,0.01,0.01]})", 1, R"(,"uri":"shorts.bin")");
  json = replaced(json, "5126", "5122,\"normalized\":true");
  json =
      replaced(json, "{\"asset\"",
               R"({"extensionsRequired":["KHR_mesh_quantization"],"extensionsUsed":["KHR_mesh_quantization"],"asset")");
  EXPECT_NEAR(solid_properties(read_mesh(folder_.write("shorts.gltf", json))).volume, 8e-6, 1e-15);
}

TEST_F(MeshReader, RefusesWhatIsNoMeshFile) {
  expect_message("empty.obj", "", "the file is empty");
  expect_message("a.docx", "x", "no mesh format has the extension '.docx'");
  expect_message("a", "x", "no mesh format has the extension ''");
  EXPECT_THROW((void)read_mesh(folder_.path()), InputError);
  std::filesystem::create_directory(folder_.path() / "folder.obj");
  try {
    (void)read_mesh(folder_.path() / "folder.obj");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("give a file, not a folder"), std::string::npos);
  }
  try {
    (void)read_mesh(folder_.path() / "missing.obj");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("missing.obj: no such file"), std::string::npos);
  }
}

TEST_F(MeshReader, RefusesImplausibleSizes) {
  const auto file = folder_.write("box.obj", files::obj(box_));
  EXPECT_THROW((void)read_mesh(file, 1e6), InputError);
  EXPECT_THROW((void)read_mesh(file, 1e-9), InputError);
  EXPECT_THROW((void)read_mesh(file, 0), InputError);
  EXPECT_THROW((void)read_mesh(file, -1), InputError);
  EXPECT_THROW((void)read_mesh(file, NAN), InputError);
  expect_message("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "1 triangles, a solid has at least 4");
}

// Every prefix of a file and every file with one byte changed ends in a mesh or an InputError, nothing else.
TEST_F(MeshReader, SurvivesMutilation) {
  const std::vector<std::pair<std::string, std::string>> originals = {{"m.obj", files::obj(box_)},
                                                                      {"m.off", files::off(box_)},
                                                                      {"t.stl", files::stl_text(box_)},
                                                                      {"b.stl", files::stl_binary(box_)},
                                                                      {"t.ply", files::ply(box_, false)},
                                                                      {"b.ply", files::ply(box_, true)},
                                                                      {"m.glb", files::glb(box_, R"({"mesh":0})", 1)}};
  unsigned state = 12345;
  const auto random = [&state] { return state = state * 1664525u + 1013904223u, state >> 8; };
  for (const auto& [name, bytes] : originals) {
    for (int trial = 0; trial < 60; ++trial) {
      std::string spoiled = bytes.substr(0, trial % 3 == 0 ? random() % bytes.size() : bytes.size());
      for (int change = 0; trial % 3 != 0 && change < trial % 5 + 1; ++change)
        spoiled[random() % spoiled.size()] = static_cast<char>(trial % 2 ? random() : '0' + random() % 75);
      try {
        const Mesh mesh = read_mesh(folder_.write(name, spoiled));
        (void)mesh_topology(mesh);  // indices in range
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace handhold
