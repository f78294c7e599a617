// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "cases/model/pose.hpp"

namespace handhold {

/// How a file's coordinates relate to ours (metres, right-handed, z up).
struct SourceFrame {
  double per_metre{1};      ///< file units in a metre
  char up{'z'};             ///< which of the file's axes points up: 'x', 'y' or 'z'
  bool down{false};         ///< that axis points down instead
  bool left_handed{false};  ///< Unity and its kin; mirrored along z (y if z points up)

  /// x y z -> y z x for x up, x -z y for y up; down: after half a turn about x (y if x points down).
  [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& v) const;
  [[nodiscard]] Eigen::Vector3d position(const Eigen::Vector3d& p) const;
  /// A frame with z towards the fingertip and y dorsal in the file keeps both (left-handed files: x changes its side).
  [[nodiscard]] Eigen::Quaterniond rotation(const Eigen::Quaterniond& q) const;
  /// "mm, y up, right-handed".
  [[nodiscard]] std::string text() const;
};

/// Reads "m", "cm" or "mm"; throws InputError that starts with `where`.
[[nodiscard]] double units_per_metre(std::string_view unit, const std::string& where);
/// Reads "s", "ms", "us" or "ns".
[[nodiscard]] double ticks_per_second(std::string_view unit, const std::string& where);
/// Reads "x", "y", "z", "-x", "-y" or "-z" (points down) into the frame.
void set_up(SourceFrame& frame, std::string_view up, const std::string& where);
/// Reads "right" or "left" into the frame.
void set_handedness(SourceFrame& frame, std::string_view handedness, const std::string& where);

}  // namespace handhold
