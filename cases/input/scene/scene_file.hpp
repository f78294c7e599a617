// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cases/model/pose.hpp"
#include "cases/model/scene.hpp"

// A scene as a file (TOML): docs/scene-file.md shows one. Names in the structs below are the keys of the file; units
// are SI, frames as in scene.hpp. A key that is not listed here is an error.

namespace handhold {

/// Where something stands in its file, for errors. Not written, and no part of what the scene means.
struct Location {
  int line{0};                        ///< 0: built in code
  std::map<std::string, int> keys{};  ///< line of every key of the table

  [[nodiscard]] int of(const std::string& key) const;  ///< line of `key`, or of the table
};

/// `shape = { kind = "box", x = 0.1, y = 0.1, z = 0.1 }`: a procedural solid, as make_shape (geometry/shapes.hpp) knows
/// it.
struct ShapeSpec {
  std::string kind{};
  std::map<std::string, double> parameters{};  ///< those that are absent have their defaults
};

/// One `[[bodies]]`.
struct BodySpec {
  std::string name{};                  ///< required, unique
  std::optional<ShapeSpec> shape{};    ///< either this ...
  std::string mesh{};                  ///< ... or a mesh file, relative to the scene's folder
  double scale{1};                     ///< of the mesh: file units to metres, > 0
  double voxel_size{0};                ///< [m]; 0 chooses, see VoxelOptions
  double band{0};                      ///< [m]; 0 chooses, see VoxelOptions
  std::string material{};              ///< of materials.hpp: gives friction and density; may be absent
  std::optional<double> density{};     ///< [kg/m³], > 0, instead of the material's
  std::optional<double> mass{};        ///< [kg], > 0, instead of a density
  std::optional<Friction> friction{};  ///< `friction = { mu_static, mu_dynamic }`, instead of the material's
  Mobility mobility{Mobility::free};   ///< "free", "translation" or "fixed"
  Eigen::Vector3d position{Eigen::Vector3d::Zero()};  ///< of O in W at t = 0 [m]
  Eigen::Quaterniond orientation{
      Eigen::Quaterniond::Identity()};                        ///< of O in W at t = 0, `[w, x, y, z]`, norm 1 +- 1e-3
  Eigen::Vector3d velocity{Eigen::Vector3d::Zero()};          ///< of O's origin in W at t = 0 [m/s]
  Eigen::Vector3d angular_velocity{Eigen::Vector3d::Zero()};  ///< in W at t = 0 [rad/s]
  double held_until{0};  ///< a support holds the body up, as in thick oil, until then [s], >= 0
  /// Of the surface samples that touch other bodies [m]; 0: none. Absent: the longest side in a scene of several bodies
  /// (corners of a box), none for a fixed body or one alone.
  std::optional<double> sample_spacing{};
  Location location{};
};

/// One `[[hands.patches]]`: sample points given in place of the seeded ones.
struct PatchSpec {
  std::string phalanx{};                   ///< "thumb_distal" ... "palm", required
  std::vector<Eigen::Vector3d> samples{};  ///< points in the phalanx's frame [m], 1 to 32, required
  std::vector<Eigen::Vector3d> lag{};      ///< tangential lag in W [m]: none, one for all samples, or one a sample
  std::vector<bool> slipping{};            ///< start in slip: none (false), one for all samples, or one a sample
  Location location{};
};

/// One `[[hands]]`.
struct HandSpec {
  std::string trace{};         ///< trace file, relative to the scene's folder, required
  std::optional<Side> side{};  ///< "left" or "right": the first such hand of the trace; either this ...
  std::optional<int> index{};  ///< ... or the number of the hand in the trace, from 0; neither: the first
  Eigen::Vector3d position{Eigen::Vector3d::Zero()};  ///< the whole trace is turned, then moved by this [m]
  Eigen::Quaterniond orientation{Eigen::Quaterniond::Identity()};  ///< `[w, x, y, z]`, norm 1 +- 1e-3
  double start{0};                                                 ///< time of the trace that becomes t = 0 [s]
  double longest_bridge{0.1};  ///< lost tracking up to this long is bridged [s], >= 0
  std::vector<PatchSpec> patches{};
  Location location{};
};

/// A scene as written in a file: names of files instead of their contents.
struct SceneSpec {
  std::string name{};                                    ///< default: the file's name without extension
  double duration{1};                                    ///< [s], > 0
  Eigen::Vector3d gravity{0, 0, -9.81};                  ///< [m/s²]
  ContactParameters contact{};                           ///< `[contact]`: stiffness [N/m], damping [N s/m]
  ContactParameters body_contact{Scene{}.body_contact};  ///< `[body_contact]`: the same, of bodies with each other
  PatchOptions patch{};  ///< `[patch]`: keys as in PatchOptions, lengths [m]; reference_point "skin", "centroid"
  std::vector<BodySpec> bodies{};  ///< `[[bodies]]`
  std::vector<HandSpec> hands{};   ///< `[[hands]]`
  std::string source{};            ///< the file, for errors
};

/// The scene in the text `text`; `source` names it in errors. Throws InputError with source and line for what is no
/// TOML, an unknown key (with the nearest valid one), a wrong type, NaN, and every number out of the range given above.
[[nodiscard]] SceneSpec parse_scene(std::string_view text, const std::string& source);

/// The scene in the file `path`. Also throws InputError if it cannot be read or is larger than 16 MB.
[[nodiscard]] SceneSpec read_scene(const std::filesystem::path& path);

/// The scene as TOML: parse_scene gives the same back, to the last bit. Every key is written, but those that are
/// absent.
[[nodiscard]] std::string to_toml(const SceneSpec& spec);

/// Reads and voxelizes the shapes, reads the traces, and weighs the bodies; relative files are looked up in `base`. The
/// result has passed validate(Scene). Throws InputError naming the file and line of the scene at fault.
[[nodiscard]] Scene build(const SceneSpec& spec, const std::filesystem::path& base);

}  // namespace handhold
