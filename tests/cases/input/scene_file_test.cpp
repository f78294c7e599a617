// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/scene/scene_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cases/input/expect_input_error.hpp"

namespace handhold {
namespace {

/// Every key once; the lines are counted in the tests below.
const std::string full = R"(name = "mug and ball"
duration = 3
gravity = [0, 0.5, -9.81]

[contact]
stiffness = 250
damping = 0

[patch]
samples = 6
finger_radius = 0.002
thumb_radius = 0.004
palm_radius = 0.01
contact_offset = 0.001
reference_point = "centroid"

[[bodies]]
name = "mug"
mesh = "mug.obj"
scale = 0.001
voxel_size = 0.0007
band = 0.005
material = "glass"
mass = 0.3
friction = { mu_static = 0.7, mu_dynamic = 0.6 }
mobility = "translation"
position = [0.1, 0.2, 0.3]
orientation = [0.5, 0.5, 0.5, 0.5]
velocity = [1, 2, 3]

[[bodies]]
name = "ball"
shape = { kind = "sphere", radius = 0.03, subdivisions = 3 }
density = 300
angular_velocity = [0.1, 0.2, 0.3]
held_until = 0.25

[[hands]]
trace = "grab.json"
side = "left"
position = [1, 2, 3]
orientation = [0, 1, 0, 0]
start = -0.5
longest_bridge = 0.2

[[hands.patches]]
phalanx = "index_distal"
samples = [[0, 0, 0.01], [0, 0.001, 0.01]]
lag = [0.001, 0, 0]
slipping = [true, false]

[[hands.patches]]
phalanx = "palm"
samples = [[0, -0.01, 0]]

[[hands]]
trace = "other.json"
index = 1
)";

std::string edited(const std::string& from, const std::string& to) {
  std::string text = full;
  EXPECT_NE(text.find(from), std::string::npos) << from;
  return text.replace(text.find(from), from.size(), to);
}

/// The full scene with `from` replaced by `to` must be refused with all of `parts`.
void expect_refused(const std::string& from, const std::string& to, const std::vector<std::string>& parts) {
  const std::string text = edited(from, to);
  expect_input_error([&] { (void)parse_scene(text, "s.toml"); }, parts);
}

TEST(SceneFile, ReadsEveryKey) {
  const SceneSpec spec = parse_scene(full, "folder/s.toml");
  EXPECT_EQ(spec.name, "mug and ball");
  EXPECT_EQ(spec.duration, 3);
  EXPECT_EQ(spec.gravity, Eigen::Vector3d(0, 0.5, -9.81));
  EXPECT_EQ(spec.contact.stiffness, 250);
  EXPECT_EQ(spec.contact.damping, 0);
  EXPECT_EQ(spec.patch.samples, 6);
  EXPECT_EQ(spec.patch.finger_radius, 0.002);
  EXPECT_EQ(spec.patch.thumb_radius, 0.004);
  EXPECT_EQ(spec.patch.palm_radius, 0.01);
  EXPECT_EQ(spec.patch.contact_offset, 0.001);
  EXPECT_EQ(spec.patch.reference_point, ReferencePoint::centroid);
  ASSERT_EQ(spec.bodies.size(), 2u);
  ASSERT_EQ(spec.hands.size(), 2u);
}

TEST(SceneFile, ReadsBodies) {
  const SceneSpec spec = parse_scene(full, "s.toml");
  const BodySpec& mug = spec.bodies[0];
  EXPECT_EQ(mug.name, "mug");
  EXPECT_EQ(mug.mesh, "mug.obj");
  EXPECT_EQ(mug.scale, 0.001);
  EXPECT_EQ(mug.voxel_size, 0.0007);
  EXPECT_EQ(mug.band, 0.005);
  EXPECT_EQ(mug.material, "glass");
  EXPECT_EQ(mug.mass, 0.3);
  EXPECT_FALSE(mug.density);
  EXPECT_EQ(mug.friction->mu_static, 0.7);
  EXPECT_EQ(mug.friction->mu_dynamic, 0.6);
  EXPECT_EQ(mug.mobility, Mobility::translation);
  EXPECT_EQ(mug.position, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(mug.orientation.coeffs(), Eigen::Vector4d(0.5, 0.5, 0.5, 0.5));
  EXPECT_EQ(mug.velocity, Eigen::Vector3d(1, 2, 3));
  const BodySpec& ball = spec.bodies[1];
  EXPECT_EQ(ball.shape->kind, "sphere");
  EXPECT_EQ(ball.shape->parameters.at("radius"), 0.03);
  EXPECT_EQ(ball.shape->parameters.at("subdivisions"), 3);
  EXPECT_EQ(ball.density, 300);
  EXPECT_EQ(ball.angular_velocity, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(ball.held_until, 0.25);
}

TEST(SceneFile, ReadsHands) {
  const SceneSpec spec = parse_scene(full, "s.toml");
  const HandSpec& left = spec.hands[0];
  EXPECT_EQ(left.trace, "grab.json");
  EXPECT_EQ(left.side, Side::left);
  EXPECT_EQ(left.position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(left.orientation.x(), 1);  // the file has w first
  EXPECT_EQ(left.start, -0.5);
  EXPECT_EQ(left.longest_bridge, 0.2);
  ASSERT_EQ(left.patches.size(), 2u);
  EXPECT_EQ(left.patches[0].phalanx, "index_distal");
  EXPECT_EQ(left.patches[0].samples.at(1), Eigen::Vector3d(0, 0.001, 0.01));
  EXPECT_EQ(left.patches[0].lag, (std::vector<Eigen::Vector3d>{{0.001, 0, 0}}));
  EXPECT_EQ(left.patches[0].slipping, (std::vector<bool>{true, false}));
  EXPECT_EQ(spec.hands[1].index, 1);
  EXPECT_FALSE(spec.hands[1].side);
}

TEST(SceneFile, RemembersWhereKeysStand) {
  const SceneSpec spec = parse_scene(full, "s.toml");
  EXPECT_EQ(spec.bodies[0].location.line, 17);
  EXPECT_EQ(spec.bodies[0].location.of("mass"), 24);
  EXPECT_EQ(spec.bodies[0].location.of("no such"), 17);
  EXPECT_EQ(spec.source, "s.toml");
}

TEST(SceneFile, DefaultsAreThoseOfTheStructs) {
  const SceneSpec spec = parse_scene("[[bodies]]\nname='a'\nmesh='a.obj'\nmass=1\n", "folder/first.toml");
  EXPECT_EQ(spec.name, "first");
  EXPECT_EQ(spec.duration, SceneSpec{}.duration);
  EXPECT_EQ(spec.contact.stiffness, ContactParameters{}.stiffness);
  EXPECT_EQ(spec.bodies[0].scale, 1);
  EXPECT_EQ(spec.bodies[0].mobility, Mobility::free);
  EXPECT_TRUE(spec.hands.empty());
}

TEST(SceneFile, WritesWhatItReads) {
  const std::string once = to_toml(parse_scene(full, "s.toml"));
  EXPECT_EQ(to_toml(parse_scene(once, "s.toml")), once);
  const SceneSpec spec = parse_scene(once, "s.toml");
  EXPECT_EQ(spec.name, "mug and ball");
  EXPECT_EQ(spec.bodies[1].shape->parameters.at("subdivisions"), 3);
  EXPECT_EQ(spec.hands[0].patches[0].slipping, (std::vector<bool>{true, false}));
  EXPECT_EQ(spec.patch.reference_point, ReferencePoint::centroid);
}

TEST(SceneFile, RoundTripKeepsEveryBit) {
  SceneSpec spec = parse_scene(full, "s.toml");
  spec.name = "quote \" backslash \\ tab \t line\nend";
  spec.duration = 1 / 3.0;
  spec.gravity = {1e-300, 1e300, 123456789012345680.0};
  spec.bodies[0].orientation = Eigen::Quaterniond(0.1, -0.2, 0.3, 0.7).normalized();
  spec.bodies[0].mass = 0.1 + 0.2;
  spec.bodies[0].sample_spacing = 0.01 / 3;
  spec.body_contact = {1e5 / 3, 1 / 7.0};
  const SceneSpec read = parse_scene(to_toml(spec), "s.toml");
  EXPECT_EQ(read.name, spec.name);
  EXPECT_EQ(read.duration, spec.duration);
  EXPECT_EQ(read.gravity, spec.gravity);
  EXPECT_EQ(read.bodies[0].orientation.coeffs(), spec.bodies[0].orientation.coeffs());
  EXPECT_EQ(read.bodies[0].mass, spec.bodies[0].mass);
  EXPECT_EQ(read.bodies[0].sample_spacing, spec.bodies[0].sample_spacing);
  EXPECT_EQ(read.body_contact.stiffness, spec.body_contact.stiffness);
  EXPECT_EQ(read.body_contact.damping, spec.body_contact.damping);
}

TEST(SceneFile, NormalisesAQuaternionTypedWithFewDigits) {
  const SceneSpec spec = parse_scene(edited("[0.5, 0.5, 0.5, 0.5]", "[0.7071, 0.7071, 0, 0]"), "s.toml");
  EXPECT_NEAR(spec.bodies[0].orientation.norm(), 1, 1e-15);
  EXPECT_NEAR(spec.bodies[0].orientation.w(), std::sqrt(0.5), 1e-15);
}

TEST(SceneFileErrors, BrokenTomlIsNamedWithItsLine) {
  expect_refused("duration = 3", "duration = = 3", {"s.toml:2:", "TOML"});
  expect_refused("duration = 3", "duration = 3\nduration = 4", {"s.toml:3:", "TOML"});
}

TEST(SceneFileErrors, UnknownKeyNamesTheNearest) {
  expect_refused("duration =", "durration =", {"s.toml:2: 'durration'", "did you mean 'duration'?"});
  expect_refused("held_until =", "held_untill =", {"s.toml:36: bodies[1]: 'held_untill'", "'held_until'"});
  expect_refused("stiffness", "stifness", {"s.toml:6: contact: 'stifness'", "'stiffness'"});
  expect_refused("mu_static = 0.7", "mu_statc = 0.7", {"s.toml:25: bodies[0].friction", "'mu_static'"});
  expect_refused("phalanx =", "phalange =", {"s.toml:47: hands[0].patches[0]", "'phalanx'"});
}

TEST(SceneFileErrors, UnknownKeyLikeNoOtherListsThem) {
  expect_refused("damping = 0", "qqqqqqq = 0", {"s.toml:7:", "take one of stiffness, damping"});
}

TEST(SceneFileErrors, WrongTypes) {
  expect_refused("duration = 3", "duration = \"3\"", {"s.toml:2: duration", "a number", "a string"});
  expect_refused("samples = 6", "samples = 6.5", {"s.toml:10: patch.samples", "whole number"});
  expect_refused("samples = 6", "samples = 60000000000", {"s.toml:10: patch.samples", "out of range"});
  expect_refused("name = \"mug\"", "name = 3", {"s.toml:18: bodies[0].name", "a string", "a number"});
  expect_refused("[1, 2, 3]", "[1, 2]", {"s.toml:29: bodies[0].velocity", "three numbers, not 2"});
  expect_refused("[1, 2, 3]", "[1, 2, \"3\"]", {"s.toml:29: bodies[0].velocity", "a string"});
  expect_refused("[1, 2, 3]", "5", {"s.toml:29: bodies[0].velocity", "list"});
  expect_refused("gravity = [0, 0.5, -9.81]", "gravity = 1979-05-27", {"s.toml:3: gravity", "a date"});
  expect_refused("[contact]\nstiffness = 250\ndamping = 0", "contact = 5", {"s.toml:5: contact", "a table"});
  expect_refused("friction = { mu_static = 0.7, mu_dynamic = 0.6 }", "friction = 0.5", {"s.toml:25:", "a table"});
  expect_refused("slipping = [true, false]", "slipping = [1, 0]", {"s.toml:50:", "true and false"});
  expect_refused("slipping = [true, false]", "slipping = 1", {"s.toml:50:", "true or false"});
  expect_refused("{ kind = \"sphere\", radius = 0.03, subdivisions = 3 }", "\"sphere\"", {"s.toml:33:", "a table"});
  expect_refused("kind = \"sphere\"", "kind = 3", {"s.toml:33:", "kind must be a string"});
  expect_refused("kind = \"sphere\", ", "", {"s.toml:33:", "no kind"});
}

TEST(SceneFileErrors, ListsOfTables) {
  expect_input_error([] { (void)parse_scene("bodies = 3", "s.toml"); }, {"s.toml:1: bodies", "list of tables"});
  expect_input_error([] { (void)parse_scene("bodies = [3]", "s.toml"); }, {"s.toml:1: bodies", "must hold tables"});
}

TEST(SceneFileErrors, NoBody) {
  expect_input_error([] { (void)parse_scene("duration = 1", "s.toml"); }, {"s.toml:1: scene has no body"});
  expect_input_error([] { (void)parse_scene("", "s.toml"); }, {"s.toml:", "no body"});
}

TEST(SceneFileErrors, NanAndInfinity) {
  expect_refused("mass = 0.3", "mass = nan", {"s.toml:24: bodies[0].mass", "nan", "finite"});
  expect_refused("duration = 3", "duration = inf", {"s.toml:2: duration", "inf", "finite"});
  expect_refused("position = [0.1, 0.2, 0.3]", "position = [0.1, nan, 0.3]", {"s.toml:27:", "nan"});
  expect_refused("radius = 0.03", "radius = nan", {"s.toml:33:", "nan"});
}

TEST(SceneFileErrors, NegativeMass) {
  expect_refused("mass = 0.3", "mass = -0.3", {"s.toml:24: bodies[0].mass: -0.3 kg", "> 0"});
  expect_refused("mass = 0.3", "mass = 0", {"s.toml:24: bodies[0].mass: 0 kg", "> 0"});
  expect_refused("density = 300", "density = -1", {"s.toml:34: bodies[1].density: -1 kg/m^3", "> 0"});
}

TEST(SceneFileErrors, BothMassAndDensity) {
  expect_refused("density = 300", "density = 300\nmass = 1", {"s.toml:35: bodies[1].mass", "density are both given"});
}

TEST(SceneFileErrors, NoWeightAtAll) {
  expect_refused("density = 300\n", "", {"s.toml:31: bodies[1]", "no weight"});
  EXPECT_NO_THROW((void)parse_scene(edited("density = 300", "mobility = \"fixed\""), "s.toml"));
}

TEST(SceneFileErrors, DynamicFrictionAboveStatic) {
  expect_refused("mu_dynamic = 0.6", "mu_dynamic = 0.8", {"s.toml:25: bodies[0].friction", "0.8", "0.7"});
  expect_refused(", mu_dynamic = 0.6", "", {"s.toml:25: bodies[0].friction", "'mu_dynamic' is missing"});
}

TEST(SceneFileErrors, UnknownMaterialListsThem) {
  expect_refused("\"glass\"", "\"glas\"", {"s.toml:23: bodies[0].material", "'glas'", "glass", "wood"});
}

TEST(SceneFileErrors, ShapeAndMeshExcludeEachOther) {
  expect_refused("density = 300", "density = 300\nmesh = \"a.obj\"", {"s.toml:35: bodies[1].mesh", "shape are both"});
  expect_refused("density = 300", "density = 300\nscale = 2", {"s.toml:35: bodies[1].scale", "for a mesh"});
  expect_refused("mesh = \"mug.obj\"\n", "", {"s.toml:17: bodies[0]", "neither shape nor mesh"});
}

TEST(SceneFileErrors, NumbersOutOfRange) {
  expect_refused("duration = 3", "duration = 0", {"s.toml:2: duration: 0 s", "> 0"});
  expect_refused("scale = 0.001", "scale = 0", {"s.toml:20: bodies[0].scale", "> 0"});
  expect_refused("voxel_size = 0.0007", "voxel_size = -1", {"s.toml:21: bodies[0].voxel_size", ">= 0"});
  expect_refused("band = 0.005", "band = -1", {"s.toml:22: bodies[0].band", ">= 0"});
  expect_refused("held_until = 0.25", "held_until = -1", {"s.toml:36: bodies[1].held_until", ">= 0"});
  expect_refused("longest_bridge = 0.2", "longest_bridge = -1", {"s.toml:44: hands[0].longest_bridge", ">= 0"});
  expect_refused("stiffness = 250", "stiffness = -1", {"s.toml:5: contact", "stiffness -1"});
  expect_refused("samples = 6", "samples = 33", {"s.toml:9: patch", "33"});
}

TEST(SceneFileErrors, QuaternionThatIsNoRotation) {
  expect_refused("[0.5, 0.5, 0.5, 0.5]", "[1, 1, 0, 0]", {"s.toml:28: bodies[0].orientation", "norm", "unit"});
  expect_refused("[0.5, 0.5, 0.5, 0.5]", "[0, 0, 0, 0]", {"s.toml:28:", "norm 0"});
  expect_refused("[0.5, 0.5, 0.5, 0.5]", "[1, 0, 0]", {"s.toml:28:", "[w, x, y, z]", "3 numbers"});
}

TEST(SceneFileErrors, NamesOutsideTheirList) {
  expect_refused("\"translation\"", "\"sliding\"", {"s.toml:26: bodies[0].mobility", "free, translation, fixed"});
  expect_refused("\"left\"", "\"lefft\"", {"s.toml:40: hands[0].side", "left, right"});
  expect_refused("\"index_distal\"", "\"index_dist\"", {"s.toml:47: hands[0].patches[0].phalanx", "index_distal"});
  expect_refused("\"centroid\"", "\"center\"", {"s.toml:15: patch.reference_point", "skin, centroid"});
}

TEST(SceneFileErrors, DuplicateNames) {
  expect_refused("name = \"ball\"", "name = \"mug\"", {"s.toml:32: body 'mug'", "line 18"});
}

TEST(SceneFileErrors, EmptyNamesAndMissingKeys) {
  expect_refused("name = \"ball\"", "name = \"\"", {"s.toml:32: bodies[1].name", "empty"});
  expect_refused("name = \"ball\"\n", "", {"s.toml:31: bodies[1]", "'name' is missing"});
  expect_refused("trace = \"other.json\"\n", "", {"s.toml:56: hands[1]", "'trace' is missing"});
  expect_refused("samples = [[0, -0.01, 0]]", "", {"s.toml:52: hands[0].patches[1]", "'samples' is missing"});
}

TEST(SceneFileErrors, SideAndIndexExcludeEachOther) {
  expect_refused("index = 1", "index = 1\nside = \"left\"", {"s.toml:58: hands[1].index", "side are both"});
  expect_refused("index = 1", "index = -1", {"s.toml:58: hands[1].index", ">= 0"});
}

TEST(SceneFileErrors, PatchCountsThatDoNotFit) {
  expect_refused("lag = [0.001, 0, 0]", "lag = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]", {"s.toml:49:", "3 for 2 samples"});
  expect_refused("slipping = [true, false]", "slipping = [true, false, true]", {"s.toml:50:", "3 for 2 samples"});
  std::string many = "samples = [[0, 0, 0]";
  for (int i = 0; i < 32; ++i) many += ", [0, 0, 0]";
  expect_refused("samples = [[0, -0.01, 0]]", many + "]", {"s.toml:54:", "33 points: at most 32"});
  expect_refused("samples = [[0, -0.01, 0]]", "samples = []", {"s.toml:54:", "list of points"});
}

TEST(SceneFileErrors, ControlCharactersDoNotBreakTheLine) {
  expect_refused("\"glass\"", "\"gl\\nass\"", {"s.toml:23:", "gl ass"});
}

TEST(SceneFileErrors, MissingFileAndFolder) {
  expect_input_error([] { (void)read_scene("no/such/scene.toml"); }, {"no/such/scene.toml", "No such file"});
  expect_input_error([] { (void)read_scene(testing::TempDir()); }, {"(give a scene file)"});
}

TEST(SceneFileErrors, AFileThatIsTooLargeIsNotRead) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "handhold_large.toml";
  std::ofstream(path) << "x";
  std::filesystem::resize_file(path, std::uintmax_t(17) << 20);
  expect_input_error([&] { (void)read_scene(path); }, {"at most 16 MB"});
  std::filesystem::remove(path);
}

// The example that readers copy.
TEST(SceneFile, TheDocumentedExampleIsASceneForBothEngines) {
  std::ifstream file(HANDHOLD_SCENE_DOCUMENT);
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t begin = page.find("```toml\n"), end = page.find("\n```\n", begin);
  ASSERT_NE(end, std::string::npos);
  const SceneSpec spec = parse_scene(page.substr(begin + 8, end - begin - 8), "example.toml");
  EXPECT_EQ(spec.bodies.size(), 1u);  // neither engine takes more
  EXPECT_EQ(spec.hands.size(), 1u);
}

TEST(SceneFile, ReadsAFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "handhold_scene.toml";
  std::ofstream(path) << full;
  EXPECT_EQ(read_scene(path).bodies.size(), 2u);
  std::filesystem::remove(path);
}

// The TOML library follows dotted keys and nesting by recursion.
TEST(SceneFile, DeepKeysAndNestingAreRefusedBeforeTheLibrarySeesThem) {
  std::string key = "a", list = "x = ", tables = "x = ";
  for (int i = 0; i < 31'000; ++i) key += ".a", list += '[', tables += "{a = ";
  for (const std::string& line : {key + " = 1\n", "[" + key + "]\n", "x = {" + key + " = 1}\n"})
    expect_input_error([&] { (void)parse_scene("name = \"a.b\"\n" + line, "s.toml"); },
                       {"s.toml:2: a key has more than 32 parts"});
  for (const std::string& text : {list, tables})
    expect_input_error([&] { (void)parse_scene(text, "s.toml"); },
                       {"s.toml:1: lists and tables are nested more than 32 deep"});
}

}  // namespace
}  // namespace handhold
