// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/problem_json.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/model/input_error.hpp"

namespace handhold::compare {
namespace {

using json = nlohmann::ordered_json;
using Kind = RigidSurface::Kind;
using Vectors = std::vector<Eigen::Vector3d>;

constexpr const char* format = "handhold-problem 1";

// --- writing ---------------------------------------------------------------------------------------------------------

json number(double x) {
  if (!std::isfinite(x))
    throw InputError("a problem with a number that is not finite: JSON has none (check its functions)");
  return x;
}
json to_json(const Eigen::Vector3d& v) { return json::array({number(v.x()), number(v.y()), number(v.z())}); }
json to_json(const Eigen::Quaterniond& q) {
  return json::array({number(q.w()), number(q.x()), number(q.y()), number(q.z())});
}

json to_json(const Primitive& shape);
json to_json(const SampledProblem::Body& body);
json to_json(const SampledProblem::Support& support);
json to_json(const SampledProblem::Spring& spring);

template <class Items>
json list(const Items& items) {
  json out = json::array();
  for (const auto& item : items) out.push_back(to_json(item));
  return out;
}

json to_json(const SampledMotion& motion) {
  json out{{"p", list(motion.p)}, {"v", list(motion.v)}};
  if (motion.q.empty()) return out;
  out["q"] = list(motion.q);
  out["w"] = list(motion.w);
  return out;
}

json to_json(const Primitive& s) {
  json out = s.kind == Primitive::Kind::box ? json{{"type", "box"}, {"half_extents", to_json(s.half_extents)}}
                                            : json{{"type", "ball"}, {"radius", number(s.radius)}};
  out["p"] = to_json(s.X_BS.p);
  out["q"] = to_json(s.X_BS.R);
  return out;
}

json to_json(const SampledProblem::Body& b) {
  json inertia = json::array();
  for (int i = 0; i < 3; ++i) inertia.push_back(to_json(Eigen::Vector3d(b.inertia.row(i))));
  json out{{"name", b.name},          {"mass", number(b.mass)},
           {"inertia", inertia},      {"mobility", b.turns ? "free" : "translation"},
           {"p", to_json(b.X_WB.p)},  {"q", to_json(b.X_WB.R)},
           {"v", to_json(b.V_WB.v)},  {"w", to_json(b.V_WB.w)},
           {"shapes", list(b.shapes)}};
  if (!b.force.empty()) out["force"] = list(b.force);
  if (!b.torque.empty()) out["torque"] = list(b.torque);
  return out;
}

json to_json(const RigidSurface& s) {
  const json p = to_json(s.point);
  if (s.kind == Kind::plane) return {{"type", "plane"}, {"p", p}, {"normal", to_json(s.direction)}};
  if (s.kind == Kind::sphere) return {{"type", "sphere"}, {"p", p}, {"radius", number(s.radius)}, {"hollow", s.hollow}};
  return {{"type", "cylinder"},
          {"p", p},
          {"axis", to_json(s.direction)},
          {"radius", number(s.radius)},
          {"hollow", s.hollow}};
}

json to_json(const SampledProblem::Support& s) {
  json out{{"name", s.name},
           {"body", s.body},
           {"contact", {{"p", to_json(s.point_B)}, {"radius", number(s.radius)}}},
           {"surface", to_json(s.surface)},
           {"mu_static", number(s.friction.mu_static)},
           {"mu_dynamic", number(s.friction.mu_dynamic)}};
  if (!s.normal_force.empty()) {
    for (const double N : s.normal_force) out["normal_force"].push_back(number(N));
  }
  if (!s.motion.p.empty()) out["motion"] = to_json(s.motion);
  return out;
}

json to_json(const SampledProblem::Spring& s) {
  json out{
      {"body", s.body}, {"stiffness", number(s.stiffness)}, {"p", to_json(s.point_B)}, {"anchor", to_json(s.anchor_W)}};
  if (!s.motion.p.empty()) out["motion"] = to_json(s.motion);
  return out;
}

// --- reading ---------------------------------------------------------------------------------------------------------

double real(const json& j) { return j.get<double>(); }
Eigen::Vector3d vector_at(const json& j) { return {real(j.at(0)), real(j.at(1)), real(j.at(2))}; }
Eigen::Quaterniond quaternion_at(const json& j) { return {real(j.at(0)), real(j.at(1)), real(j.at(2)), real(j.at(3))}; }

/// Lists of samples are checked for their length where they are read.
class Reader {
 public:
  explicit Reader(const json& root) : samples_(root.at("steps").get<std::size_t>() + 1) {}

  [[nodiscard]] Vectors vectors(const json& object, const char* key) const {
    Vectors out;
    for (const json& item : samples(object, key)) out.push_back(vector_at(item));
    return out;
  }

  [[nodiscard]] SampledMotion motion(const json& object) const {
    if (!object.contains("motion")) return {};
    const json& j = object.at("motion");
    SampledMotion out{vectors(j, "p"), vectors(j, "v"), {}, vectors(j, "w")};
    for (const json& q : samples(j, "q")) out.q.push_back(quaternion_at(q));
    if (out.p.empty()) throw InputError("a motion without p");
    return out;
  }

  [[nodiscard]] SampledProblem::Body body(const json& j) const {
    SampledProblem::Body b;
    b.name = j.at("name");
    b.mass = j.at("mass");
    for (int i = 0; i < 3; ++i) b.inertia.row(i) = vector_at(j.at("inertia").at(i));
    const std::string mobility = j.at("mobility");
    if (mobility != "free" && mobility != "translation") throw InputError("mobility '" + mobility + "'");
    b.turns = mobility == "free";
    b.X_WB = {quaternion_at(j.at("q")), vector_at(j.at("p"))};
    b.V_WB = {vector_at(j.at("w")), vector_at(j.at("v"))};
    for (const json& s : j.at("shapes")) b.shapes.push_back(shape(s));
    b.force = vectors(j, "force");
    b.torque = vectors(j, "torque");
    return b;
  }

  [[nodiscard]] SampledProblem::Support support(const json& j) const {
    SampledProblem::Support s;
    s.name = j.at("name");
    s.body = j.at("body");
    s.surface = surface(j.at("surface"));
    s.friction = {j.at("mu_static"), j.at("mu_dynamic")};
    s.point_B = vector_at(j.at("contact").at("p"));
    s.radius = j.at("contact").at("radius");
    for (const json& N : samples(j, "normal_force")) s.normal_force.push_back(N);
    s.motion = motion(j);
    return s;
  }

  [[nodiscard]] SampledProblem::Spring spring(const json& j) const {
    return {j.at("body"), j.at("stiffness"), vector_at(j.at("p")), vector_at(j.at("anchor")), motion(j)};
  }

 private:
  [[nodiscard]] json samples(const json& object, const char* key) const {
    if (!object.contains(key)) return json::array();
    const json& found = object.at(key);
    if (!found.is_array() || found.size() != samples_)
      throw InputError(fmt::format("'{}' has {} samples, not steps + 1 = {}", key, found.size(), samples_));
    return found;
  }

  static Primitive shape(const json& j) {
    Primitive s;
    const std::string type = j.at("type");
    if (type != "box" && type != "ball") throw InputError("shape of type '" + type + "'");
    s.kind = type == "box" ? Primitive::Kind::box : Primitive::Kind::ball;
    if (type == "box") s.half_extents = vector_at(j.at("half_extents"));
    if (type == "ball") s.radius = j.at("radius");
    s.X_BS = {quaternion_at(j.at("q")), vector_at(j.at("p"))};
    return s;
  }

  static RigidSurface surface(const json& j) {
    const std::string type = j.at("type");
    if (type == "plane") return {Kind::plane, vector_at(j.at("p")), vector_at(j.at("normal")), 0, false};
    RigidSurface s{Kind::sphere, vector_at(j.at("p")), Eigen::Vector3d::UnitZ(), j.at("radius"), j.at("hollow")};
    if (type == "sphere") return s;
    if (type != "cylinder") throw InputError("surface of type '" + type + "'");
    s.kind = Kind::cylinder;
    s.direction = vector_at(j.at("axis"));
    return s;
  }

  std::size_t samples_;
};

SampledProblem from_json(const json& root) {
  if (root.at("format") != format) throw InputError(fmt::format("not of format '{}'", format));
  const Reader reader(root);
  SampledProblem out;
  out.name = root.at("name");
  out.step = root.at("step");
  out.steps = root.at("steps");
  out.frame_every = root.at("frame_every");
  out.gravity = vector_at(root.at("gravity"));
  for (const json& j : root.at("bodies")) out.bodies.push_back(reader.body(j));
  for (const json& j : root.at("supports")) out.supports.push_back(reader.support(j));
  for (const json& j : root.at("springs")) out.springs.push_back(reader.spring(j));
  return out;
}

}  // namespace

std::string problem_json(const SampledProblem& problem) {
  const json root{{"format", format},
                  {"name", problem.name},
                  {"step", number(problem.step)},
                  {"steps", problem.steps},
                  {"frame_every", problem.frame_every},
                  {"gravity", to_json(problem.gravity)},
                  {"bodies", list(problem.bodies)},
                  {"supports", list(problem.supports)},
                  {"springs", list(problem.springs)}};
  return root.dump() + "\n";
}

SampledProblem read_problem_json(std::string_view text, const std::string& path) {
  try {
    return from_json(json::parse(text));
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: {} (see problem.schema.json)", path, error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {} (see problem.schema.json)", path, error.what()));
  }
}

}  // namespace handhold::compare
