// SPDX-License-Identifier: Apache-2.0
#include "cases/model/patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double resolution = 1e-6;  // of a length searched

/// Weight of the distance from the middle. A finger flat on a face touches everywhere at once: rounding would pick the
/// place, and pick another one the next frame. It moves a minimum on a curved surface by 1e-5 of its way and adds at
/// most 0.1 µm.
constexpr double centering = 1e-5;

/// Distance to the field's solid: interpolated within its band, exact beyond, and `cap` (a lower bound) where that is
/// farther.
struct Distance {
  const VoxelField& field;

  [[nodiscard]] double operator()(const Eigen::Vector3d& p_O, double cap) const {
    const double interpolated = field.distance(p_O).distance;
    if (std::abs(interpolated) < 0.999 * field.band()) return interpolated;
    if (interpolated > cap) return cap;
    const std::optional<SurfacePoint> surface = interpolated < 0 ? search(p_O) : field.closest(p_O, cap);
    return surface ? surface->distance : cap;
  }

  /// The exact nearest surface point from deep inside, searched from near to far: the cost grows with the cube of the
  /// reach.
  [[nodiscard]] std::optional<SurfacePoint> search(const Eigen::Vector3d& p_O) const {
    const double diagonal = field.bounds().diagonal().norm() + field.band();
    for (double reach = 2 * field.band();; reach *= 2) {
      std::optional<SurfacePoint> surface = field.closest(p_O, reach);
      if (surface || reach > diagonal) return surface;
    }
  }
};

/// Exact place below (or above) the point `axis_O`, whose skin lies `radius` away. Out of reach no more is said than
/// that: other points of the phalanx may be nearer.
Nearest place_at(const Distance& distance, const Eigen::Vector3d& axis_O, double radius) {
  const double interpolated = distance.field.distance(axis_O).distance;
  const double reach = radius + nearest_reach;
  std::optional<SurfacePoint> surface;
  if (interpolated < 0) surface = distance.search(axis_O);
  if (interpolated >= 0 && interpolated <= reach) surface = distance.field.closest(axis_O, reach);
  if (surface) return {surface->distance - radius, axis_O - radius * surface->n_O, axis_O, surface->n_O};
  const Eigen::Vector3d away = axis_O - distance.field.bounds().center();
  const Eigen::Vector3d n = away.norm() > 0 ? away.normalized() : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  return {nearest_reach, axis_O - radius * n, axis_O, n};
}

/// The segment a + s u, |s| <= half.
struct Segment {
  Eigen::Vector3d middle, u;
  double half;

  [[nodiscard]] Eigen::Vector3d at(double s) const { return middle + s * u; }
};

/// Derivative of the exact distance along the segment (its gradient is the outward normal), with the pull to the
/// middle. The surface is known to lie within `reach`.
double slope(const Distance& distance, const Segment& segment, double s, double reach) {
  const std::optional<SurfacePoint> surface = distance.field.closest(segment.at(s), reach);
  return (surface ? surface->n_O.dot(segment.u) : 0.0) + centering * s / segment.half;
}

/// Where the slope changes sign in [low, high]: false position, with a bisection at every third step because the slope
/// jumps where the nearest feature changes.
double flattest(const Distance& distance, const Segment& segment, double low, double high, double reach) {
  constexpr double rounding = 1e-12;
  double at_low = slope(distance, segment, low, reach), at_high = slope(distance, segment, high, reach);
  if (at_low >= 0) return low;
  if (at_high <= 0) return high;
  for (int step = 1; high - low > resolution * 2 * segment.half; ++step) {
    const double secant = (low * at_high - high * at_low) / (at_high - at_low);
    const double s = step % 3 == 0 ? (low + high) / 2 : secant;
    const double at_s = slope(distance, segment, s, reach);
    if (std::abs(at_s) < rounding) return s;
    if (at_s > 0) {
      high = s, at_high = at_s;
    } else {
      low = s, at_low = at_s;
    }
  }
  return (low + high) / 2;
}

Nearest nearest_of_capsule(const Capsule& capsule, const Pose& X_OP, const VoxelField& field) {
  const Distance distance{field};
  const Segment segment{X_OP.p, X_OP.R * Eigen::Vector3d::UnitZ(), capsule.half_length};
  const double reach = capsule.radius + nearest_reach;
  const double far = field.distance(segment.middle).distance - segment.half;
  if (far > reach) {
    Nearest bound = place_at(distance, segment.middle, capsule.radius);
    bound.distance = far - capsule.radius;  // an end may be nearer than the middle by half the length
    return bound;
  }
  if (segment.half <= 0) return place_at(distance, segment.middle, capsule.radius);

  // A coarse look first: a bent object can be near at several places, by half a spacing nearer between two looks.
  constexpr int steps = 8;
  const double spacing = 2 * segment.half / steps, look = reach + 0.5 * spacing;
  double best = infinity, best_s = 0;
  for (int i = 0; i <= steps; ++i) {
    const double s = -segment.half + i * spacing;
    const double d = distance(segment.at(s), std::min(look, best + spacing)) + centering * s * s / (2 * segment.half);
    if (d < best) best = d, best_s = s;
  }
  const double low = std::max(-segment.half, best_s - spacing), high = std::min(segment.half, best_s + spacing);
  // From the best place the surface is |best| away, so from anywhere in the bracket at most a spacing farther (and the
  // interpolation's error, less than a voxel).
  const double within = std::abs(best) + spacing + field.grid().spacing;
  const double s = best < look ? flattest(distance, segment, low, high, within) : best_s;
  return place_at(distance, segment.at(s), capsule.radius);
}

/// A point of the palm's skin: on its dorsal or palmar face (side ±1), or on its rim at half thickness (side 0).
struct PalmPoint {
  double x{}, z{};
  int side{};
};

struct PalmSearch {
  const Distance distance;
  const Pose& X_OP;
  const Eigen::Vector3d half;

  [[nodiscard]] Eigen::Vector3d skin(const PalmPoint& p) const {
    return X_OP * Eigen::Vector3d(p.x, p.side * half.y(), p.z);
  }
  [[nodiscard]] double value(const PalmPoint& p, double cap) const {
    const double x = p.x / half.x(), z = p.z / half.z();
    return distance(skin(p), cap) + 0.1 * centering * half.norm() * (x * x + z * z);  // at most 0.2 µm
  }
  [[nodiscard]] bool contains(const PalmPoint& p) const {
    const double slack = 1e-12;
    return std::abs(p.x) <= half.x() + slack && std::abs(p.z) <= half.z() + slack;
  }
};

/// Nearer than this somewhere on the grid of `coarse`, if a point of a face between its nodes is within reach.
double look(const PalmSearch& search) { return nearest_reach + std::hypot(search.half.x(), search.half.z()) / 8; }

/// Best point of a 9 x 9 grid over both faces and the rim.
PalmPoint coarse(const PalmSearch& search, double& best) {
  constexpr int steps = 8;
  const double spacing = 2 * std::max(search.half.x(), search.half.z()) / steps;
  PalmPoint found;
  for (const int side : {-1, 1, 0}) {
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; k <= steps; ++k) {
        const bool rim = i == 0 || i == steps || k == 0 || k == steps;
        if (side == 0 && !rim) continue;
        const PalmPoint p{search.half.x() * (2.0 * i / steps - 1), search.half.z() * (2.0 * k / steps - 1), side};
        const double d = search.value(p, std::min(look(search), best + spacing));
        if (d < best) best = d, found = p;
      }
    }
  }
  return found;
}

/// Pattern search on the face (or along the rim), halving the step until it is 1e-6 of the palm.
PalmPoint refine(const PalmSearch& search, PalmPoint p, double best) {
  for (double step = 1.0 / 8; step > resolution;) {
    if (best - 2 * step * search.half.norm() > nearest_reach) return p;  // nor will it be within reach
    bool moved = false;
    for (const auto& direction : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
      const PalmPoint q{p.x + direction[0] * step * search.half.x(), p.z + direction[1] * step * search.half.z(),
                        p.side};
      const bool off_rim = q.side == 0 && std::abs(q.x) < search.half.x() && std::abs(q.z) < search.half.z();
      if (off_rim || !search.contains(q)) continue;
      const double d = search.value(q, best + step * search.half.norm());
      if (d < best) best = d, p = q, moved = true;
    }
    if (!moved) step /= 2;
  }
  return p;
}

Nearest nearest_of_palm(const PalmBox& box, const Pose& X_OP, const VoxelField& field) {
  const PalmSearch search{Distance{field}, X_OP, box.half_extents};
  const double far = field.distance(X_OP.p).distance - box.half_extents.norm();
  if (far > nearest_reach) {
    Nearest bound = place_at(search.distance, X_OP.p, 0);
    bound.distance = far;
    return bound;
  }
  double best = infinity;
  PalmPoint p = coarse(search, best);
  if (best < look(search)) p = refine(search, p, best);
  Nearest found = place_at(search.distance, search.skin(p), 0);
  found.axis_O = X_OP * Eigen::Vector3d(p.x, 0, p.z);
  return found;
}

void check_range(const char* name, double value, double low, double high, const char* advice) {
  if (value >= low && value <= high) return;  // false for NaN
  throw InputError(std::string("patch option ") + name + " = " + std::to_string(value) + ": must be " +
                   std::to_string(low) + " to " + std::to_string(high) + " (" + advice + ")");
}

double ring_radius(int phalanx, const PatchOptions& options) {
  if (phalanx == palm) return options.palm_radius;
  return phalanx < 3 ? options.thumb_radius : options.finger_radius;
}

}  // namespace

Nearest nearest(const PhalanxShape& shape, const Pose& X_OP, const VoxelField& field) {
  if (const PalmBox* box = std::get_if<PalmBox>(&shape)) return nearest_of_palm(*box, X_OP, field);
  return nearest_of_capsule(std::get<Capsule>(shape), X_OP, field);
}

void validate(const PatchOptions& options) {
  check_range("samples", options.samples, 1, max_samples, "8 is the paper's");
  check_range("finger_radius", options.finger_radius, 0, 0.1, "in metres: 0.003 is 3 mm");
  check_range("thumb_radius", options.thumb_radius, 0, 0.1, "in metres: 0.0045 is 4.5 mm");
  check_range("palm_radius", options.palm_radius, 0, 0.1, "in metres: 0.02 is 20 mm");
  check_range("contact_offset", options.contact_offset, 0, nearest_reach, "in metres: 0.002 is 2 mm");
}

Patch seed_patch(int phalanx, const Pose& X_OP, const Nearest& nearest, const PatchOptions& options) {
  const bool centroid = options.reference_point == ReferencePoint::centroid;
  const Eigen::Vector3d center_O = centroid ? X_OP.p : nearest.skin_O;
  const Eigen::Vector3d& n = nearest.n_O;
  Eigen::Vector3d along = X_OP.R * Eigen::Vector3d::UnitZ();
  // A fingertip that pokes straight in has no direction along itself in the tangent plane: its x axis takes over. The
  // bound is far from both, so that neither is normalised from rounding errors.
  if (std::abs(along.dot(n)) > 0.99) along = X_OP.R * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d e1 = (along - along.dot(n) * n).normalized();
  const Eigen::Vector3d e2 = n.cross(e1);

  const Pose X_PO = X_OP.inverse();
  const double radius = options.samples == 1 ? 0.0 : ring_radius(phalanx, options);  // one sample sits in the middle
  Patch patch;
  patch.count = options.samples;
  for (int i = 0; i < patch.count; ++i) {
    const double angle = 2 * pi * i / patch.count;
    const Eigen::Vector3d p_O = center_O + radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
    patch.p_P[static_cast<std::size_t>(i)] = X_PO * p_O;
  }
  return patch;
}

}  // namespace handhold
