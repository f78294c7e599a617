// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/field_cache.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/input/mesh/fingerprint.hpp"
#include "cases/model/byte_stream.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/input/mesh_files.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;

// Check values of the published definitions.
TEST(Checksums, MatchTheirDefinitions) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(crc32(""), 0u);
  EXPECT_EQ(fingerprint("a").substr(0, 16), "af63dc4c8601ec8c");  // FNV-1a, 64 bits
}

class FieldCache : public testing::Test {
 protected:
  void SetUp() override {
    options_.voxel_size = 0.002;
    cache_.folder = folder_.path() / "cache";
    file_ = folder_.write("box.obj", files::obj(make_box({0.06, 0.04, 0.02})));
    ::unsetenv("HANDHOLD_CACHE");
  }

  ImportedObject import() { return import_object(file_, 1, options_, cache_); }

  fs::path only_entry() const {
    fs::path found;
    for (const auto& entry : fs::directory_iterator(cache_.folder)) {
      EXPECT_TRUE(found.empty());
      found = entry.path();
    }
    return found;
  }

  static std::string slurp(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  files::Folder folder_;
  fs::path file_;
  VoxelOptions options_;
  FieldCacheOptions cache_;
};

TEST_F(FieldCache, GivesBackWhatWasBuilt) {
  const ImportedObject built = import(), found = import();
  EXPECT_FALSE(built.from_cache);
  ASSERT_TRUE(found.from_cache);
  const VoxelField::Data &a = built.field->data(), &b = found.field->data();
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.occupied, b.occupied);
  EXPECT_EQ(a.cell_start, b.cell_start);
  EXPECT_EQ(a.cell_triangles, b.cell_triangles);
  EXPECT_EQ(a.cell_origin, b.cell_origin);
  EXPECT_EQ(a.cell_count, b.cell_count);
  EXPECT_EQ(a.cell_size, b.cell_size);
  EXPECT_EQ(a.band, b.band);
  EXPECT_EQ(a.grid.origin, b.grid.origin);
  EXPECT_EQ(a.grid.size, b.grid.size);
  EXPECT_EQ(a.grid.spacing, b.grid.spacing);
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(built.mesh.mesh.vertices, found.mesh.mesh.vertices);
  EXPECT_EQ(built.mesh.repair.confidence, found.mesh.repair.confidence);
  EXPECT_EQ(built.mesh.repair.components, found.mesh.repair.components);
  EXPECT_EQ(built.mesh.source, found.mesh.source);
}

TEST_F(FieldCache, KeepsWarnings) {
  file_ = folder_.write("lines.obj", files::obj(make_box({0.06, 0.04, 0.02})) + "l 1 2\n");
  EXPECT_EQ(import().mesh.warnings, import().mesh.warnings);
  const ImportedObject found = import();
  EXPECT_TRUE(found.from_cache);
  ASSERT_EQ(found.mesh.warnings.size(), 1u);
}

TEST_F(FieldCache, OtherInputIsBuiltAnew) {
  (void)import();
  EXPECT_FALSE(import_object(file_, 0.5, options_, cache_).from_cache);
  VoxelOptions other = options_;
  other.band = 0.01;
  EXPECT_FALSE(import_object(file_, 1, other, cache_).from_cache);
  std::ofstream(file_, std::ios::app) << "# one more byte\n";
  EXPECT_FALSE(import().from_cache);
  EXPECT_TRUE(import().from_cache);
}

// The file stays, its buffer changes: what is kept belongs to both.
TEST_F(FieldCache, ExternalBuffersBelongToTheKey) {
  const Mesh box = make_box({0.06, 0.04, 0.02});
  file_ = folder_.write("box.gltf", files::gltf_json(box, R"({"mesh":0})", 1, R"(,"uri":"box.bin")"));
  (void)folder_.write("box.bin", files::gltf_buffer(box));
  const double volume = solid_properties(import().mesh.mesh).volume;
  EXPECT_TRUE(import().from_cache);
  (void)folder_.write("box.bin", files::gltf_buffer(make_box({0.03, 0.04, 0.02})));
  const ImportedObject other = import();
  EXPECT_FALSE(other.from_cache);
  EXPECT_NEAR(solid_properties(other.mesh.mesh).volume / volume, 0.5, 1e-6);
}

TEST_F(FieldCache, DamagedEntriesAreNeverUsed) {
  const std::vector<float> distance = import().field->data().distance;
  const fs::path entry = only_entry();
  const std::string sound = slurp(entry);
  unsigned state = 99;
  for (int trial = 0; trial < 60; ++trial) {
    state = state * 1664525u + 1013904223u;
    std::string spoiled = sound;
    const std::size_t place = trial < 20 ? std::size_t(trial) * 7 : (state >> 4) % sound.size();
    if (trial % 4 == 0)
      spoiled.resize(place);
    else
      spoiled[place] = static_cast<char>(spoiled[place] ^ (1 << trial % 8));
    if (trial == 1) spoiled = sound + "x";
    std::ofstream(entry, std::ios::binary | std::ios::trunc) << spoiled;
    const ImportedObject object = import();
    ASSERT_FALSE(object.from_cache) << "trial " << trial << " at byte " << place << " of " << sound.size();
    ASSERT_EQ(object.field->data().distance, distance);
    ASSERT_EQ(slurp(entry), sound);  // and put right again
  }
}

TEST_F(FieldCache, LeavesNothingBeside) {
  (void)import();
  EXPECT_EQ(only_entry().extension(), ".field");
}

TEST_F(FieldCache, CanBeSwitchedOff) {
  cache_.enabled = false;
  (void)import();
  EXPECT_FALSE(import().from_cache);
  EXPECT_FALSE(fs::exists(cache_.folder));
  cache_.enabled = true;
  ::setenv("HANDHOLD_CACHE", "off", 1);
  (void)import();
  EXPECT_FALSE(import().from_cache);
  ::unsetenv("HANDHOLD_CACHE");
  EXPECT_FALSE(import().from_cache);
  EXPECT_TRUE(import().from_cache);
}

TEST_F(FieldCache, AFolderThatCannotBeWrittenIsNoError) {
  cache_.folder = file_ / "inside a file";
  EXPECT_FALSE(import().from_cache);
  EXPECT_TRUE(import().field);
}

TEST_F(FieldCache, FolderFollowsTheEnvironment) {
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  const std::string saved = xdg ? xdg : "";
  ::setenv("XDG_CACHE_HOME", "/somewhere", 1);
  EXPECT_EQ(cache_folder({}), fs::path("/somewhere/handhold"));
  ::unsetenv("XDG_CACHE_HOME");
  if (const char* home = std::getenv("HOME")) {
    EXPECT_EQ(cache_folder({}), fs::path(home) / ".cache" / "handhold");
  }
  if (xdg) ::setenv("XDG_CACHE_HOME", saved.c_str(), 1);
}

TEST_F(FieldCache, WrongInputIsStillWrong) {
  EXPECT_THROW((void)import_object(folder_.path() / "missing.obj", 1, options_, cache_), InputError);
}

}  // namespace
}  // namespace handhold
