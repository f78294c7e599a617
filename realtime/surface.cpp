#include "realtime/surface.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::realtime {
namespace {

constexpr double smallest_turn_cosine = 0.5;  // 60 degrees a voxel
constexpr double most_moves = 64;

/// Gradient by central differences over one voxel: continuous, unlike the gradient of the trilinear interpolant, whose
/// jumps from cell to cell turn a normal by 10 degrees on a surface of a few voxels' radius.
Eigen::Vector3d smooth_gradient(const VoxelField& field, const Eigen::Vector3d& p) {
  const double h = field.grid().spacing;
  Eigen::Vector3d g;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
    g[i] = (field.distance(p + step).distance - field.distance(p - step).distance) / (2 * h);
  }
  return g;
}

/// One Newton step of `p` onto the zero of the interpolated distance. False where the clamp at the band's end, felt two
/// cells inwards, would bend the gradient.
bool onto_surface(const VoxelField& field, Eigen::Vector3d& p, Eigen::Vector3d& n) {
  const double distance = field.distance(p).distance;
  if (std::abs(distance) >= field.band() - 3 * field.grid().spacing) return false;
  const Eigen::Vector3d gradient = smooth_gradient(field, p);
  const double squared = gradient.squaredNorm();
  if (!(squared > 0.01)) return false;  // at a ridge of the distance: no way out is nearer than another
  p -= distance / squared * gradient;
  n = gradient / std::sqrt(squared);
  return true;
}

/// Two Newton steps onto the surface from a point that is close to it.
bool follow(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor) {
  Eigen::Vector3d C = p_O, n;
  if (!onto_surface(field, C, n) || !onto_surface(field, C, n)) return false;
  anchor = {C, n};
  return true;
}

}  // namespace

bool foot(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor) {
  if (field.distance(p_O).distance >= 0) return follow(field, p_O, anchor);
  const std::optional<SurfacePoint> nearest = field.closest(p_O, field.band());
  return nearest && follow(field, nearest->p_O, anchor);
}

void slide(const VoxelField& field, const Eigen::Vector3d& step_O, Anchor& anchor) {
  // Voxel by voxel, so that it stays on its sheet and turns with it.
  const double length = step_O.norm();
  if (!std::isfinite(length)) return;
  const int moves = int(std::clamp(std::ceil(length / field.grid().spacing), 1.0, most_moves));
  const double stride = length / moves;
  Eigen::Vector3d direction = length > 0 ? Eigen::Vector3d(step_O / length) : step_O;
  for (int i = 0; i < moves; ++i) {
    Anchor moved;
    if (!follow(field, anchor.C_O + stride * direction, moved)) return;
    if (moved.n_O.dot(anchor.n_O) < smallest_turn_cosine) return;
    const double fell = (moved.C_O - anchor.C_O).norm();         // a tenth of a voxel is the projection's own error
    if (fell > 2 * stride + 0.1 * field.grid().spacing) return;  // onto another sheet
    anchor = moved;
    const Eigen::Vector3d ahead = direction - direction.dot(anchor.n_O) * anchor.n_O;
    if (ahead.squaredNorm() < 1e-12) return;
    direction = ahead.normalized();
  }
}

}  // namespace handhold::realtime
