// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cases/input/scene/scene_file.hpp"

namespace handhold {
namespace {

using Output = std::back_insert_iterator<std::string>;

/// A TOML basic string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (static_cast<unsigned char>(c) < ' ' || c == 127) {
      result += fmt::format("\\u{:04X}", int(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string list(const Eigen::Vector3d& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

std::string list(const Eigen::Quaterniond& q) { return fmt::format("[{}, {}, {}, {}]", q.w(), q.x(), q.y(), q.z()); }

std::string list(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::string> texts;
  for (const Eigen::Vector3d& p : points) texts.push_back(list(p));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string list(const std::vector<bool>& values) {
  std::vector<std::string> texts;
  for (const bool value : values) texts.emplace_back(value ? "true" : "false");
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

/// A key that need not be quoted is not.
std::string key_text(const std::string& key) {
  const auto is_bare = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  return !key.empty() && std::all_of(key.begin(), key.end(), is_bare) ? key : quoted(key);
}

const char* name_of(Mobility mobility) {
  switch (mobility) {
    case Mobility::free:
      return "free";
    case Mobility::translation:
      return "translation";
    case Mobility::fixed:
      return "fixed";
  }
  return "free";
}

std::string shape_text(const ShapeSpec& shape) {
  std::string text = fmt::format("{{ kind = {}", quoted(shape.kind));
  for (const auto& [key, value] : shape.parameters) text += fmt::format(", {} = {}", key_text(key), value);
  return text + " }";
}

void write_body(const BodySpec& body, Output out) {
  fmt::format_to(out, "\n[[bodies]]\nname = {}\n", quoted(body.name));
  if (body.shape) fmt::format_to(out, "shape = {}\n", shape_text(*body.shape));
  if (!body.mesh.empty()) fmt::format_to(out, "mesh = {}\nscale = {}\n", quoted(body.mesh), body.scale);
  fmt::format_to(out, "voxel_size = {}\nband = {}\n", body.voxel_size, body.band);
  if (!body.material.empty()) fmt::format_to(out, "material = {}\n", quoted(body.material));
  if (body.density) fmt::format_to(out, "density = {}\n", *body.density);
  if (body.mass) fmt::format_to(out, "mass = {}\n", *body.mass);
  if (body.friction) {
    fmt::format_to(out, "friction = {{ mu_static = {}, mu_dynamic = {} }}\n", body.friction->mu_static,
                   body.friction->mu_dynamic);
  }
  fmt::format_to(out, "mobility = \"{}\"\nposition = {}\norientation = {}\n", name_of(body.mobility),
                 list(body.position), list(body.orientation));
  fmt::format_to(out, "velocity = {}\nangular_velocity = {}\nheld_until = {}\n", list(body.velocity),
                 list(body.angular_velocity), body.held_until);
  if (body.sample_spacing) fmt::format_to(out, "sample_spacing = {}\n", *body.sample_spacing);
}

void write_patch(const PatchSpec& patch, Output out) {
  fmt::format_to(out, "\n[[hands.patches]]\nphalanx = {}\nsamples = {}\n", quoted(patch.phalanx), list(patch.samples));
  if (!patch.lag.empty()) fmt::format_to(out, "lag = {}\n", list(patch.lag));
  if (!patch.slipping.empty()) fmt::format_to(out, "slipping = {}\n", list(patch.slipping));
}

void write_hand(const HandSpec& hand, Output out) {
  fmt::format_to(out, "\n[[hands]]\ntrace = {}\n", quoted(hand.trace));
  if (hand.side) fmt::format_to(out, "side = \"{}\"\n", to_string(*hand.side));
  if (hand.index) fmt::format_to(out, "index = {}\n", *hand.index);
  fmt::format_to(out, "position = {}\norientation = {}\nstart = {}\nlongest_bridge = {}\n", list(hand.position),
                 list(hand.orientation), hand.start, hand.longest_bridge);
  for (const PatchSpec& patch : hand.patches) write_patch(patch, out);
}

void write_options(const SceneSpec& spec, Output out) {
  fmt::format_to(out, "\n[contact]\nstiffness = {}\ndamping = {}\n", spec.contact.stiffness, spec.contact.damping);
  fmt::format_to(out, "\n[body_contact]\nstiffness = {}\ndamping = {}\n", spec.body_contact.stiffness,
                 spec.body_contact.damping);
  const PatchOptions& patch = spec.patch;
  fmt::format_to(out, "\n[patch]\nsamples = {}\nfinger_radius = {}\nthumb_radius = {}\npalm_radius = {}\n",
                 patch.samples, patch.finger_radius, patch.thumb_radius, patch.palm_radius);
  fmt::format_to(out, "contact_offset = {}\nreference_point = \"{}\"\n", patch.contact_offset,
                 patch.reference_point == ReferencePoint::skin ? "skin" : "centroid");
}

}  // namespace

std::string to_toml(const SceneSpec& spec) {
  std::string text;
  const Output out = std::back_inserter(text);
  if (!spec.name.empty()) fmt::format_to(out, "name = {}\n", quoted(spec.name));
  fmt::format_to(out, "duration = {}\ngravity = {}\n", spec.duration, list(spec.gravity));
  write_options(spec, out);
  for (const BodySpec& body : spec.bodies) write_body(body, out);
  for (const HandSpec& hand : spec.hands) write_hand(hand, out);
  return text;
}

}  // namespace handhold
