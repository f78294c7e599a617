// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_reader.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/mesh_topology.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/input/mesh_files.hpp"

namespace handhold {
namespace {

class MeshReader : public testing::Test {
 protected:
  // Every format stores the same hammer; 1e-6: assimp keeps coordinates as floats (6e-8 each).
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
  expect_message("cut.off", whole.substr(0, whole.find("\n3 ") + 1), "ends too early");
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
  expect_message("cut text.stl", text.substr(0, text.size() / 2), "no 'endsolid'");
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
  expect_message("no corners.ply", damaged, "face 0 has no corners");
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
  expect_message("nan binary.ply", nan, "vertex 0 is not finite");
  const std::string glb = files::glb(box_, R"({"mesh":0})", 1);
  expect_message("cut.glb", glb.substr(0, glb.size() - 30), "is it truncated?");
  expect_message("cut.gltf", R"({"asset":{"version":"2.0")", "cannot be read");
  expect_message("empty scene.gltf", R"({"asset":{"version":"2.0"}})", "GLTF: No scene");
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
