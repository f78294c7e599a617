// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/mjcf.hpp"

#include <fmt/format.h>

namespace handhold::compare {
namespace {

const Eigen::Vector3d plate(0.1, 0.1, 0.005);  // half extents of a plate that presses [m]

std::string text(const Eigen::Vector3d& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

std::string place(const Pose& X) {
  return fmt::format("pos=\"{}\" quat=\"{} {} {} {}\"", text(X.p), X.R.w(), X.R.x(), X.R.y(), X.R.z());
}

std::string escaped(const std::string& s) {
  std::string out;
  for (const char c : s) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

/// A comment may not hold two hyphens.
std::string comment(std::string s) {
  for (std::size_t at = s.find("--"); at != std::string::npos; at = s.find("--")) s.replace(at, 2, "- -");
  return "    <!-- " + s + " -->\n";
}

Pose towards(const Eigen::Vector3d& z, const Eigen::Vector3d& p) {
  return {Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z), p};
}

/// The friction of a pair is the larger of two: bodies have none of their own.
std::string shape_text(const Primitive& s) {
  if (s.kind == Primitive::Kind::box)
    return fmt::format("      <geom type=\"box\" size=\"{}\" {} friction=\"0 0 0\"/>\n", text(s.half_extents),
                       place(s.X_BS));
  return fmt::format("      <geom type=\"sphere\" size=\"{}\" {} friction=\"0 0 0\"/>\n", s.radius, place(s.X_BS));
}

std::string body_text(const SampledProblem::Body& b, const SampledProblem& problem) {
  const Eigen::Matrix3d& I = b.inertia;
  std::string out = fmt::format("    <body name=\"{}\" {}>\n", escaped(b.name), place(b.X_WB));
  if (b.turns) out += "      <freejoint/>\n";
  for (int i = 0; i < 3 && !b.turns; ++i)  // slides along the axes of W, which a body's joints are not
    out += fmt::format("      <joint type=\"slide\" axis=\"{}\"/>\n",
                       text(b.X_WB.R.conjugate() * Eigen::Vector3d::Unit(i)));
  out += fmt::format("      <inertial pos=\"0 0 0\" mass=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>\n", b.mass, I(0, 0),
                     I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  for (const Primitive& s : b.shapes) out += shape_text(s);
  for (std::size_t i = 0; i < problem.springs.size(); ++i)
    if (problem.springs[i].body == b.name)
      out += fmt::format("      <site name=\"spring {}\" pos=\"{}\"/>\n", i, text(problem.springs[i].point_B));
  return out + "    </body>\n";
}

std::string finger_text(const SampledProblem::Support& s) {
  const Pose X = towards(s.surface.direction, s.surface.point - plate.z() * s.surface.direction);
  return fmt::format(
      "    <body name=\"{0}\" {1} gravcomp=\"1\">\n      <joint name=\"{0}\" type=\"slide\" axis=\"0 0 1\"/>\n"
      "      <geom type=\"box\" size=\"{2}\" mass=\"0.1\" friction=\"{3} 0 0\" contype=\"2\" conaffinity=\"1\"/>\n"
      "    </body>\n",
      escaped(s.name), place(X), text(plate), s.friction.mu_dynamic);
}

std::string support_text(const SampledProblem::Support& s) {
  std::string out;
  if (!s.motion.p.empty()) out += comment(s.name + " moves in the problem; here it stands where it is at t = 0");
  if (!s.normal_force.empty()) return out + finger_text(s);
  if (s.surface.hollow) return comment(s.name + " is hollow, which no primitive of MuJoCo is: left out");
  const bool plane = s.surface.kind == RigidSurface::Kind::plane, sphere = s.surface.kind == RigidSurface::Kind::sphere;
  const std::string size = plane    ? "1 1 0.01"
                           : sphere ? fmt::format("{}", s.surface.radius)
                                    : fmt::format("{} 1", s.surface.radius);
  return out +
         fmt::format(
             "    <geom name=\"{}\" type=\"{}\" size=\"{}\" {} friction=\"{} 0 0\" contype=\"2\" conaffinity=\"1\"/>\n",
             escaped(s.name),
             plane    ? "plane"
             : sphere ? "sphere"
                      : "capsule",
             size, place(towards(s.surface.direction, s.surface.point)), s.friction.mu_dynamic);
}

std::string anchors(const SampledProblem& problem) {
  std::string out;
  for (std::size_t i = 0; i < problem.springs.size(); ++i)
    out += fmt::format("    <site name=\"anchor {}\" pos=\"{}\"/>\n", i, text(problem.springs[i].anchor_W));
  return out;
}

/// Springs of no length between sites.
std::string tendons(const SampledProblem& problem) {
  std::string out;
  for (std::size_t i = 0; i < problem.springs.size(); ++i)
    out += fmt::format(
        "    <spatial stiffness=\"{}\" springlength=\"0\"><site site=\"anchor {}\"/><site site=\"spring "
        "{}\"/></spatial>\n",
        problem.springs[i].stiffness, i, i);
  return out.empty() ? "" : "  <tendon>\n" + out + "  </tendon>\n";
}

std::string motors(const SampledProblem& problem) {
  std::string out;
  for (const SampledProblem::Support& s : problem.supports)
    if (!s.normal_force.empty()) out += fmt::format("    <motor joint=\"{}\"/>\n", escaped(s.name));
  return out.empty() ? "" : "  <actuator>\n" + out + "  </actuator>\n";
}

/// qpos is the model's own: only velocities and the motors' forces are told.
std::string keyframe(const SampledProblem& problem) {
  std::string velocity, force;
  for (const SampledProblem::Body& b : problem.bodies) {
    velocity += text(b.V_WB.v) + " ";
    if (b.turns) velocity += text(b.X_WB.R.conjugate() * b.V_WB.w) + " ";
  }
  for (const SampledProblem::Support& s : problem.supports) {
    if (s.normal_force.empty()) continue;
    velocity += "0 ";
    force += fmt::format("{} ", s.normal_force.front());
  }
  return fmt::format("  <keyframe>\n    <key name=\"start\" qvel=\"{}\"{}/>\n  </keyframe>\n", velocity,
                     force.empty() ? "" : fmt::format(" ctrl=\"{}\"", force));
}

}  // namespace

std::string mjcf(const SampledProblem& problem) {
  std::string out = fmt::format(
      "<mujoco model=\"{}\">\n  <compiler angle=\"radian\"/>\n  <option timestep=\"{}\" gravity=\"{}\" "
      "cone=\"elliptic\"/>\n"
      "  <worldbody>\n",
      escaped(problem.name), problem.step, text(problem.gravity));
  for (const SampledProblem::Body& b : problem.bodies) out += body_text(b, problem);
  for (const SampledProblem::Support& s : problem.supports) out += support_text(s);
  out += anchors(problem) + "  </worldbody>\n";
  return out + tendons(problem) + motors(problem) + keyframe(problem) + "</mujoco>\n";
}

}  // namespace handhold::compare
