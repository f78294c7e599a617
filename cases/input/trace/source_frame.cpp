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

/// The axis that a left-handed file is mirrored along: never the one that points up.
int mirror_axis(char up) { return up == 'z' ? 1 : 2; }

}  // namespace

Eigen::Vector3d SourceFrame::direction(const Eigen::Vector3d& v) const {
  Eigen::Vector3d u = v;
  if (left_handed) u[mirror_axis(up)] *= -1;
  if (up == 'y') return {u.x(), -u.z(), u.y()};
  if (up == 'x') return {u.y(), u.z(), u.x()};
  return u;
}

Eigen::Vector3d SourceFrame::position(const Eigen::Vector3d& p) const { return direction(p) / per_metre; }

Eigen::Quaterniond SourceFrame::rotation(const Eigen::Quaterniond& q) const {
  if (!left_handed) return up == 'z' ? q : turn(up) * q;
  // With the mirror M the axes y and z become M R y and M R z, and x = y × z becomes -M R x:
  // R' = M R diag(-1, 1, 1) = (M R M) M diag(-1, 1, 1), and the last two are half a turn about the other one of y and
  // z.
  const bool along_y = mirror_axis(up) == 1;
  const Eigen::Quaterniond mirrored =
      along_y ? Eigen::Quaterniond(q.w(), -q.x(), q.y(), -q.z()) : Eigen::Quaterniond(q.w(), -q.x(), -q.y(), q.z());
  const Eigen::Quaterniond half_turn = along_y ? Eigen::Quaterniond(0, 0, 0, 1) : Eigen::Quaterniond(0, 0, 1, 0);
  return turn(up) * mirrored * half_turn;
}

std::string SourceFrame::text() const {
  const char* unit = per_metre == 1 ? "m" : per_metre == 100 ? "cm" : "mm";
  return fmt::format("{}, {} up, {}-handed", unit, up, left_handed ? "left" : "right");
}

double units_per_metre(std::string_view unit, const std::string& where) {
  if (unit == "m") return 1;
  if (unit == "cm") return 100;
  if (unit == "mm") return 1000;
  throw InputError(fmt::format("{}: unit \"{}\" is unknown (use m, cm or mm)", where, unit));
}

char up_axis(std::string_view up, const std::string& where) {
  if (up == "x" || up == "y" || up == "z") return up[0];
  throw InputError(fmt::format("{}: up \"{}\" is no axis (use x, y or z)", where, up));
}

}  // namespace handhold
