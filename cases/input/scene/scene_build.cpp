// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/surface_samples.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/moved_trace.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/input/mesh/field_cache.hpp"
#include "cases/input/scene/materials.hpp"
#include "cases/input/scene/scene_file.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;

std::string place(const SceneSpec& spec, int line) {
  const std::string source = spec.source.empty() ? "scene" : spec.source;
  return line > 0 ? fmt::format("{}:{}", source, line) : source;
}

/// Runs `make`; what is wrong with its input is said with the place in the scene that asked for it.
template <typename Make>
auto located(const SceneSpec& spec, int line, const std::string& who, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}: {}", place(spec, line), who, error.what()));
  }
}

fs::path existing_file(const std::string& name, const fs::path& base) {
  const fs::path path = fs::path(name).is_absolute() ? fs::path(name) : base / name;
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) return path;
  throw InputError(
      fmt::format("'{}': there is no such file (paths are relative to the scene's folder)", path.string()));
}

struct Solid {
  Mesh mesh{};
  std::shared_ptr<const VoxelField> field{};
};

Solid make_solid(const BodySpec& body, const fs::path& base) {
  const VoxelOptions options{body.voxel_size, body.band};
  if (body.shape) {
    const Mesh mesh = make_shape(body.shape->kind, body.shape->parameters);
    return {mesh, voxelize(mesh, options)};
  }
  ImportedObject object = import_object(existing_file(body.mesh, base), body.scale, options);
  return {std::move(object.mesh.mesh), std::move(object.field)};
}

double density_of(const BodySpec& body, double volume) {
  if (body.mass) return *body.mass / volume;
  if (body.density) return *body.density;
  if (!body.material.empty()) return material(body.material).density;
  return 1000;  // of water, for a fixed body, which no force moves
}

Inertia weigh(const BodySpec& body, const Mesh& mesh) {
  const SolidProperties solid = solid_properties(mesh);
  const double density = density_of(body, solid.volume);
  return {body.mass ? *body.mass : density * solid.volume, solid.center, density * solid.inertia};
}

Friction friction_of(const BodySpec& body) {
  if (body.friction) return *body.friction;
  return body.material.empty() ? Friction{} : material(body.material).friction();
}

/// `alone`: there is no other body to touch.
double sample_spacing(const BodySpec& spec, const Body& body, bool alone) {
  if (spec.sample_spacing) return *spec.sample_spacing;
  return alone || spec.mobility == Mobility::fixed ? 0 : body.field->bounds().sizes().maxCoeff();
}

Body build_body(const BodySpec& spec, const fs::path& base, bool alone) {
  const Solid solid = make_solid(spec, base);
  Body body;
  body.name = spec.name;
  body.inertia = weigh(spec, solid.mesh);
  body.field = solid.field;
  body.mobility = spec.mobility;
  body.friction = friction_of(spec);
  body.X_WO = {spec.orientation, spec.position};
  body.V_WO = {spec.angular_velocity, spec.velocity};
  body.held_until = spec.held_until;
  const double spacing = sample_spacing(spec, body, alone);
  if (spacing > 0) body.samples_O = surface_samples(solid.mesh, spacing);
  return body;
}

std::size_t find_hand(const HandSpec& spec, const Trace& trace) {
  if (spec.side) {
    const auto is_side = [&](const TraceHand& hand) { return hand.side == *spec.side; };
    const auto found = std::find_if(trace.hands.begin(), trace.hands.end(), is_side);
    if (found != trace.hands.end()) return std::size_t(found - trace.hands.begin());
    throw InputError(
        fmt::format("'{}' has no {} hand (take the other side, or an index)", spec.trace, to_string(*spec.side)));
  }
  const std::size_t index = std::size_t(spec.index.value_or(0));
  if (index < trace.hands.size()) return index;
  throw InputError(
      fmt::format("'{}' has {} hands: no index {} (0 is the first)", spec.trace, trace.hands.size(), index));
}

GivenPatch build_patch(const PatchSpec& spec) {
  GivenPatch patch;
  patch.phalanx = phalanx_from_name(spec.phalanx);
  patch.p_P = spec.samples;
  if (spec.lag.empty() && spec.slipping.empty()) return patch;
  for (std::size_t i = 0; i < spec.samples.size(); ++i) {
    SampleStart start;
    if (!spec.lag.empty()) start.lag_W = spec.lag.size() == 1 ? spec.lag[0] : spec.lag.at(i);
    if (!spec.slipping.empty()) start.slipping = spec.slipping.size() == 1 ? spec.slipping[0] : spec.slipping.at(i);
    patch.start.push_back(start);
  }
  return patch;
}

Hand build_hand(const HandSpec& spec, const fs::path& base) {
  const Trace trace =
      moved(read_trace(existing_file(spec.trace, base).string()), {spec.orientation, spec.position}, spec.start);
  Hand hand;
  hand.motion = std::make_shared<TraceSpline>(trace, find_hand(spec, trace), TraceSplineOptions{spec.longest_bridge});
  for (const PatchSpec& patch : spec.patches) hand.given.push_back(build_patch(patch));
  return hand;
}

int line_of(const BodySpec& body) { return body.location.of(body.shape ? "shape" : "mesh"); }

}  // namespace

Scene build(const SceneSpec& spec, const std::filesystem::path& base) {
  Scene scene;
  scene.name = spec.name;
  scene.duration = spec.duration;
  scene.gravity = spec.gravity;
  scene.contact = spec.contact;
  scene.body_contact = spec.body_contact;
  scene.patch = spec.patch;
  const bool alone = spec.bodies.size() == 1;
  for (const BodySpec& body : spec.bodies) {
    scene.bodies.push_back(located(spec, line_of(body), fmt::format("body '{}'", body.name),
                                   [&] { return build_body(body, base, alone); }));
  }
  for (std::size_t i = 0; i < spec.hands.size(); ++i) {
    const HandSpec& hand = spec.hands[i];
    scene.hands.push_back(
        located(spec, hand.location.of("trace"), fmt::format("hands[{}]", i), [&] { return build_hand(hand, base); }));
  }
  located(spec, 0, fmt::format("scene '{}'", spec.name), [&] { validate(scene); });
  return scene;
}

}  // namespace handhold
