// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/scene/scene_file.hpp"

#include <map>
#include <system_error>

#include <fmt/format.h>

#include "cases/input/regular_file.hpp"
#include "cases/input/scene/materials.hpp"
#include "cases/input/scene/toml_bounds.hpp"
#include "cases/input/scene/toml_section.hpp"
#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using toml_section::Section;

constexpr std::uintmax_t largest_file = 16u << 20;  // a scene is a few kB; anything larger is another file by mistake

ShapeSpec read_shape(const Section& body) {
  const toml::node& node = *body.table().get("shape");
  if (!node.is_table()) body.fail("shape", "must be a table (write { kind = \"box\", x = 0.1, y = 0.1, z = 0.1 })");
  ShapeSpec shape;
  for (const auto& [key, value] : *node.as_table()) {
    const std::string name(key.str());
    if (name == "kind") {
      const toml::value<std::string>* kind = value.as_string();
      if (!kind || kind->get().empty()) body.fail("shape", "kind must be a string (write kind = \"box\")");
      shape.kind = kind->get();
      continue;
    }
    shape.parameters[name] = body.number("shape", value);
  }
  if (shape.kind.empty()) body.fail("shape", "has no kind (write kind = \"box\")");
  return shape;
}

Friction read_friction(const Section& body) {
  const Section section = body.inner("friction", {"mu_static", "mu_dynamic"});
  section.require("mu_static", "0.5");
  section.require("mu_dynamic", "0.4");
  Friction friction;
  section.read("mu_static", friction.mu_static);
  section.read("mu_dynamic", friction.mu_dynamic);
  section.checked("mu_dynamic", [&] { validate(friction); });
  return friction;
}

void read_weight(const Section& section, BodySpec& body) {
  section.read("material", body.material);
  section.read("density", body.density);
  section.read("mass", body.mass);
  if (section.has("material")) section.checked("material", [&] { (void)material(body.material); });
  if (body.density) section.require_positive("density", *body.density, "kg/m^3");
  if (body.mass) section.require_positive("mass", *body.mass, "kg");
  if (body.density && body.mass) section.fail("mass", "and density are both given (remove one)");
  if (body.mobility == Mobility::fixed || body.density || body.mass || !body.material.empty()) return;
  section.fail("", "has no weight (give it a mass, a density or a material, or mobility = \"fixed\")");
}

void read_body_shape(const Section& section, BodySpec& body) {
  section.read("mesh", body.mesh);
  section.read("scale", body.scale);
  section.read("voxel_size", body.voxel_size);
  section.read("band", body.band);
  if (section.has("shape")) body.shape = read_shape(section);
  if (body.shape && !body.mesh.empty()) section.fail("mesh", "and shape are both given (remove one)");
  if (!body.shape && body.mesh.empty()) section.fail("", "has neither shape nor mesh (add one)");
  if (body.shape && section.has("scale")) section.fail("scale", "is for a mesh (give the shape its true size)");
  section.require_positive("scale", body.scale, "m per unit of the mesh");
  section.require_not_negative("voxel_size", body.voxel_size, "m");
  section.require_not_negative("band", body.band, "m");
}

BodySpec read_body(const Section& section) {
  BodySpec body;
  body.location = section.location();
  section.require("name", "\"..\"");
  section.read("name", body.name);
  section.read("mobility", body.mobility, {"free", "translation", "fixed"});
  read_body_shape(section, body);
  read_weight(section, body);
  if (section.has("friction")) body.friction = read_friction(section);
  section.read("position", body.position);
  section.read("orientation", body.orientation);
  section.read("velocity", body.velocity);
  section.read("angular_velocity", body.angular_velocity);
  section.read("held_until", body.held_until);
  section.require_not_negative("held_until", body.held_until, "s");
  section.read("sample_spacing", body.sample_spacing);
  section.require_not_negative("sample_spacing", body.sample_spacing.value_or(0), "m");
  return body;
}

PatchSpec read_patch(const Section& section) {
  PatchSpec patch;
  patch.location = section.location();
  section.require("phalanx", "\"index_distal\"");
  section.require("samples", "[[0, 0, 0]]");
  section.read("phalanx", patch.phalanx);
  section.checked("phalanx", [&] { (void)phalanx_from_name(patch.phalanx); });
  patch.samples = section.vectors("samples");
  patch.lag = section.vectors("lag");
  patch.slipping = section.booleans("slipping");
  const std::size_t n = patch.samples.size();
  if (n > std::size_t(max_samples))
    section.fail("samples", fmt::format("{} points: at most {} (leave some out)", n, max_samples));
  const auto fits = [n](std::size_t count) { return count <= 1 || count == n; };
  if (!fits(patch.lag.size())) {
    section.fail("lag",
                 fmt::format("{} for {} samples: must be one, or one a sample (correct it)", patch.lag.size(), n));
  }
  if (!fits(patch.slipping.size())) {
    section.fail("slipping",
                 fmt::format("{} for {} samples: must be one, or one a sample (correct it)", patch.slipping.size(), n));
  }
  return patch;
}

HandSpec read_hand(const Section& section) {
  HandSpec hand;
  hand.location = section.location();
  section.require("trace", "\"file\"");
  section.read("trace", hand.trace);
  if (section.has("side") && section.has("index")) section.fail("index", "and side are both given (remove one)");
  if (section.has("side")) section.read("side", hand.side.emplace(), {"left", "right"});
  if (section.has("index")) section.read("index", hand.index.emplace());
  if (hand.index && *hand.index < 0)
    section.fail("index", fmt::format("{}: must be >= 0 (0 is the first)", *hand.index));
  section.read("position", hand.position);
  section.read("orientation", hand.orientation);
  section.read("start", hand.start);
  section.read("longest_bridge", hand.longest_bridge);
  section.require_not_negative("longest_bridge", hand.longest_bridge, "s");
  section.each("patches", {"phalanx", "samples", "lag", "slipping"},
               [&](const Section& patch) { hand.patches.push_back(read_patch(patch)); });
  return hand;
}

void read_contact(const Section& section, ContactParameters& contact) {
  section.read("stiffness", contact.stiffness);
  section.read("damping", contact.damping);
  section.checked("", [&] { validate(contact); });
}

void read_patch_options(const Section& section, PatchOptions& patch) {
  section.read("samples", patch.samples);
  section.read("finger_radius", patch.finger_radius);
  section.read("thumb_radius", patch.thumb_radius);
  section.read("palm_radius", patch.palm_radius);
  section.read("contact_offset", patch.contact_offset);
  section.read("reference_point", patch.reference_point, {"skin", "centroid"});
  section.checked("", [&] { validate(patch); });
}

void check_names(const SceneSpec& spec) {
  std::map<std::string, int> line_of;
  for (const BodySpec& body : spec.bodies) {
    const auto [other, is_new] = line_of.emplace(body.name, body.location.of("name"));
    if (is_new) continue;
    throw InputError(fmt::format("{}:{}: body '{}': the name is taken in line {} (give every body its own)",
                                 spec.source, body.location.of("name"), body.name, other->second));
  }
}

SceneSpec read_spec(const Section& root) {
  SceneSpec spec;
  spec.source = root.source();
  spec.name = std::filesystem::path(spec.source).stem().string();
  root.read("name", spec.name);
  root.read("duration", spec.duration);
  root.require_positive("duration", spec.duration, "s");
  root.read("gravity", spec.gravity);
  if (root.has("contact")) read_contact(root.inner("contact", {"stiffness", "damping"}), spec.contact);
  if (root.has("body_contact")) read_contact(root.inner("body_contact", {"stiffness", "damping"}), spec.body_contact);
  if (root.has("patch")) {
    read_patch_options(root.inner("patch", {"samples", "finger_radius", "thumb_radius", "palm_radius", "contact_offset",
                                            "reference_point"}),
                       spec.patch);
  }
  root.each("bodies",
            {"name", "shape", "mesh", "scale", "voxel_size", "band", "material", "density", "mass", "friction",
             "mobility", "position", "orientation", "velocity", "angular_velocity", "held_until", "sample_spacing"},
            [&](const Section& body) { spec.bodies.push_back(read_body(body)); });
  root.each("hands", {"trace", "side", "index", "position", "orientation", "start", "longest_bridge", "patches"},
            [&](const Section& hand) { spec.hands.push_back(read_hand(hand)); });
  if (spec.bodies.empty()) root.fail("", "scene has no body (add [[bodies]])");
  check_names(spec);
  return spec;
}

}  // namespace

int Location::of(const std::string& key) const {
  const auto found = keys.find(key);
  return found == keys.end() ? line : found->second;
}

SceneSpec parse_scene(std::string_view text, const std::string& source) {
  check_toml_bounds(text, source);
  toml::table table;
  try {
    table = toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}: must be TOML (correct the line)", source, error.source().begin.line,
                                 error.description()));
  }
  return read_spec(Section(table, source, "",
                           {"name", "duration", "gravity", "contact", "body_contact", "patch", "bodies", "hands"}));
}

SceneSpec read_scene(const std::filesystem::path& path) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (failed) throw InputError(fmt::format("{}: {} (give a scene file)", path.string(), failed.message()));
  if (size > largest_file) {
    throw InputError(fmt::format("{}: {} bytes: a scene is at most 16 MB (give a scene file)", path.string(), size));
  }
  return parse_scene(plain_text(read_regular_file(path)), path.string());
}

}  // namespace handhold
