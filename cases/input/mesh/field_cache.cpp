// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/field_cache.hpp"

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "cases/input/mesh/fingerprint.hpp"
#include "cases/input/mesh/mesh_reader.hpp"
#include "cases/input/regular_file.hpp"
#include "cases/model/byte_stream.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/voxel_file.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;

// File: magic, version, then sections: length, CRC-32, bytes. Raise the version whenever a section, or what the
// importer or voxelizer makes of the same input, changes.
constexpr std::string_view magic = "HANDHOLD-FIELD\n";
constexpr std::uint32_t version = 3;

// Of the very bytes that are then parsed, those of external buffers included.
std::string key_of(const MeshFile& file, double scale, const VoxelOptions& options) {
  // Extension: the same bytes mean something else to another reader.
  std::string key = fmt::format("{} {} {} {:a} {:a} {:a}", fingerprint(file.bytes), file.bytes.size(), file.extension,
                                scale, options.voxel_size, options.band);
  for (const auto& [uri, bytes] : file.buffers)
    key += fmt::format(" {} {} {}", fingerprint(uri), fingerprint(bytes), bytes.size());
  return key;
}

template <class Stream, class Imported>
void transfer_import(Stream& stream, Imported& imported) {
  auto& repair = imported.repair;
  stream.value(repair.closed_as_given);
  stream.value(repair.oriented_as_given);
  for (auto* count : {&repair.points_welded, &repair.degenerate_faces, &repair.duplicate_faces, &repair.faces_flipped,
                      &repair.holes_filled, &repair.components, &repair.intersecting_pairs})
    stream.value(*count);
  stream.value(repair.volume_uncertainty);
  stream.text(repair.method);
  stream.text(repair.confidence);
  std::uint64_t warnings = imported.warnings.size();
  stream.value(warnings);
  if constexpr (std::is_same_v<Stream, ByteReader>) {
    for (std::uint64_t i = 0; i < warnings && !stream.failed(); ++i) imported.warnings.emplace_back();
  }
  for (auto& warning : imported.warnings) stream.text(warning);
}

std::string pack(const std::string& key, const ImportedMesh& imported, const VoxelField& field) {
  ByteWriter head, report, file;
  head.text(key);
  transfer_import(report, imported);
  file.value(version);
  for (const std::string& section : {head.bytes(), report.bytes(), pack_voxels(field)}) {
    file.value(crc32(section));
    file.text(section);
  }
  return std::string(magic) + file.bytes();
}

// Nothing unless every byte is as written and made from the same input.
std::optional<ImportedObject> unpack(std::string_view bytes, const std::string& key) {
  if (bytes.substr(0, magic.size()) != magic) return std::nullopt;
  ByteReader file(bytes.substr(magic.size()));
  std::uint32_t written_version = 0;
  file.value(written_version);
  if (written_version != version) return std::nullopt;
  std::array<std::string, 3> sections;
  for (std::string& section : sections) {
    std::uint32_t sum = 0;
    file.value(sum);
    file.text(section);
    if (file.failed() || crc32(section) != sum) return std::nullopt;
  }
  if (!file.done()) return std::nullopt;

  std::string written_key;
  ByteReader(sections[0]).text(written_key);
  if (written_key != key) return std::nullopt;
  ImportedObject object;
  ByteReader report(sections[1]);
  transfer_import(report, object.mesh);
  if (!report.done()) return std::nullopt;
  try {
    object.field = unpack_voxels(sections[2], "cache").field;
  } catch (const InputError&) {
    return std::nullopt;
  }
  object.mesh.mesh = object.field->mesh();
  object.from_cache = true;
  return object;
}

std::optional<std::string> slurp(const fs::path& file) {
  try {
    return read_regular_file(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// Written beside and renamed, so that nobody ever reads half a file.
void store(const fs::path& place, const std::string& bytes) {
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  const fs::path beside = place.string() + fmt::format(".{}.tmp", ::getpid());
  bool written = false;
  {
    std::ofstream stream(beside, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    written = static_cast<bool>(stream.flush());
  }
  if (written) fs::rename(beside, place, error);
  if (!written || error) fs::remove(beside, error);
}

}  // namespace

std::optional<fs::path> cache_folder(const FieldCacheOptions& options) {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value ? value : "");
  };
  if (!options.enabled || variable("HANDHOLD_CACHE") == "off") return std::nullopt;
  if (!options.folder.empty()) return options.folder;
  if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty()) return fs::path(cache) / "handhold";
  if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".cache" / "handhold";
  return std::nullopt;
}

ImportedObject import_object(const fs::path& file, double scale, const VoxelOptions& options,
                             const FieldCacheOptions& cache) {
  const auto start = std::chrono::steady_clock::now();
  const MeshFile given = read_mesh_file(file);
  const std::string key = key_of(given, scale, options);
  const std::optional<fs::path> folder = cache_folder(cache);
  const fs::path place = folder ? *folder / (fingerprint(key) + ".field") : fs::path();

  ImportedObject object;
  if (const auto stored = folder ? slurp(place) : std::nullopt) {
    if (auto found = unpack(*stored, key)) object = std::move(*found);
  }
  if (!object.field) {
    object.mesh = import_mesh(given, scale);
    object.field = voxelize(object.mesh.mesh, options);
    if (folder) store(place, pack(key, object.mesh, *object.field));
  }
  object.mesh.source = file.string();
  object.mesh.scale = scale;
  object.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return object;
}

}  // namespace handhold
