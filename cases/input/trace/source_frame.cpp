// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/source_frame.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

/// Turns the file's axes into ours.
Eigen::Quaterniond turn(char up) {
  const double r = std::sqrt(0.5);
  if (up == 'y') return {r, r, 0, 0};             // a quarter turn about x
  if (up == 'x') return {0.5, -0.5, -0.5, -0.5};  // x -> z -> y -> x
  return Eigen::Quaterniond::Identity();
}

/// About an axis across the one that points up.
Eigen::Quaterniond half_turn(char up) {
  return up == 'x' ? Eigen::Quaterniond(0, 0, 1, 0) : Eigen::Quaterniond(0, 1, 0, 0);
}

/// The axis that a left-handed file is mirrored along: never the one that points up.
int mirror_axis(char up) { return up == 'z' ? 1 : 2; }

}  // namespace

Eigen::Vector3d SourceFrame::direction(const Eigen::Vector3d& v) const {
  Eigen::Vector3d u = v;
  if (left_handed) u[mirror_axis(up)] *= -1;
  if (down) u = half_turn(up) * u;
  if (up == 'y') return {u.x(), -u.z(), u.y()};
  if (up == 'x') return {u.y(), u.z(), u.x()};
  return u;
}

Eigen::Vector3d SourceFrame::position(const Eigen::Vector3d& p) const { return direction(p) / per_metre; }

Eigen::Quaterniond SourceFrame::rotation(const Eigen::Quaterniond& q) const {
  const Eigen::Quaterniond axes = down ? turn(up) * half_turn(up) : turn(up);
  if (!left_handed) return up == 'z' && !down ? q : axes * q;
  // With the mirror M the axes y and z become M R y and M R z, and x = y × z becomes -M R x:
  // R' = M R diag(-1, 1, 1) = (M R M) M diag(-1, 1, 1), and the last two are half a turn about the other one of y and
  // z.
  const bool along_y = mirror_axis(up) == 1;
  const Eigen::Quaterniond mirrored =
      along_y ? Eigen::Quaterniond(q.w(), -q.x(), q.y(), -q.z()) : Eigen::Quaterniond(q.w(), -q.x(), -q.y(), q.z());
  const Eigen::Quaterniond other_way = along_y ? Eigen::Quaterniond(0, 0, 0, 1) : Eigen::Quaterniond(0, 0, 1, 0);
  return axes * mirrored * other_way;
}

std::string SourceFrame::text() const {
  const char* unit = per_metre == 1 ? "m" : per_metre == 100 ? "cm" : "mm";
  return fmt::format("{}, {} {}, {}-handed", unit, up, down ? "down" : "up", left_handed ? "left" : "right");
}

double units_per_metre(std::string_view unit, const std::string& where) {
  if (unit == "m") return 1;
  if (unit == "cm") return 100;
  if (unit == "mm") return 1000;
  throw InputError(fmt::format("{}: unit \"{}\" is unknown (use m, cm or mm)", where, unit));
}

double ticks_per_second(std::string_view unit, const std::string& where) {
  if (unit == "s") return 1;
  if (unit == "ms") return 1e3;
  if (unit == "us") return 1e6;
  if (unit == "ns") return 1e9;
  throw InputError(fmt::format("{}: time \"{}\" is unknown (use s, ms, us or ns)", where, unit));
}

void set_up(SourceFrame& frame, std::string_view up, const std::string& where) {
  const bool down = up.size() == 2 && up[0] == '-';
  const std::string_view axis = down ? up.substr(1) : up;
  if (axis != "x" && axis != "y" && axis != "z")
    throw InputError(fmt::format("{}: up \"{}\" is no axis (use x, y or z, or -x, -y or -z)", where, up));
  frame.up = axis[0];
  frame.down = down;
}

void set_handedness(SourceFrame& frame, std::string_view handedness, const std::string& where) {
  if (handedness != "right" && handedness != "left")
    throw InputError(fmt::format("{}: handedness \"{}\" is not right or left (of the coordinates)", where, handedness));
  frame.left_handed = handedness == "left";
}

}  // namespace handhold
