#include "realtime/surface.hpp"

#include <cmath>

namespace handhold::realtime {
namespace {

constexpr double smallest_turn_cosine = 0.5;  // 60 degrees

/// One Newton step of `p` onto the zero of the interpolated distance. False where the clamp at the band's end, felt one cell
/// inwards, would bend the gradient.
bool onto_surface(const VoxelField& field, Eigen::Vector3d& p, Eigen::Vector3d& n) {
  const DistanceSample sample = field.distance(p);
  const double squared = sample.gradient.squaredNorm();
  if (!(squared > 0.01) || std::abs(sample.distance) >= field.band() - 2 * field.grid().spacing) return false;
  p -= sample.distance / squared * sample.gradient;
  n = sample.gradient / std::sqrt(squared);
  return true;
}

}  // namespace

bool follow(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor) {
  Eigen::Vector3d C = p_O, n;
  if (!onto_surface(field, C, n) || !onto_surface(field, C, n)) return false;
  anchor = {C, n};
  return true;
}

void slide(const VoxelField& field, const Eigen::Vector3d& step_O, Anchor& anchor) {
  Anchor moved;
  if (!follow(field, anchor.C_O + step_O, moved)) return;
  if (moved.n_O.dot(anchor.n_O) < smallest_turn_cosine) return;
  anchor = moved;
}

}  // namespace handhold::realtime
