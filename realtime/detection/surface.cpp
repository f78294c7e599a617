// SPDX-License-Identifier: Apache-2.0
#include "realtime/detection/surface.hpp"

#include <algorithm>
#include <cmath>

#include "realtime/detection/fan.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

constexpr double smallest_turn_cosine = 0.5;  // 60 degrees a voxel
constexpr int most_strides = 64;
constexpr int most_faces = 256;           // that a step goes over
constexpr double projection_error = 0.1;  // of `settle` [voxels]
constexpr double no_motion = 1e-9;        // a shorter way has no direction [voxels]
constexpr double on_feature = 1e-6;       // a point this near to an edge or a corner lies on it [voxels]

/// A body with creases is touched on its triangles.
bool has_creases(const VoxelField& field) { return field.faces().crease_count() > 0; }

/// The same at the rim of the grid, where not all neighbours exist: six more queries.
Vector3d central_differences(const VoxelField& field, const Vector3d& p) {
  const double h = field.grid().spacing;
  Vector3d g;
  for (int i = 0; i < 3; ++i) {
    const Vector3d step = h * Vector3d::Unit(i);
    g[i] = (field.distance(p + step).distance - field.distance(p - step).distance) / (2 * h);
  }
  return g;
}

/// One Newton step of `p` onto the zero of the interpolated distance. False where the clamp at the band's end, felt two
/// cells inwards, would bend the gradient.
bool onto_surface(const VoxelField& field, Vector3d& p, Vector3d& n) {
  const SmoothDistance at = smooth_distance(field, p);
  if (std::abs(at.distance) >= field.band() - 3 * field.grid().spacing) return false;
  const double squared = at.gradient.squaredNorm();
  if (!(squared > 0.01)) return false;  // at a ridge of the distance: no way out is nearer than another
  p -= at.distance / squared * at.gradient;
  n = at.gradient / std::sqrt(squared);
  return true;
}

/// Two Newton steps onto the surface from a point that is close to it.
bool settle(const VoxelField& field, const Vector3d& p_O, Anchor& anchor) {
  Vector3d C = p_O, n;
  if (!onto_surface(field, C, n) || !onto_surface(field, C, n)) return false;
  anchor = {C, n};
  return true;
}

/// The exact nearest surface point from inside, searched from near to far: the cost grows with the cube of the reach.
std::optional<SurfacePoint> nearest_from_inside(const VoxelField& field, const Vector3d& p_O) {
  const double farthest = field.bounds().diagonal().norm() + field.band();
  for (double reach = field.band();; reach *= 2) {
    const std::optional<SurfacePoint> nearest = field.closest(p_O, reach);
    if (nearest || reach > farthest) return nearest;
  }
}

/// An anchor on a triangle: with the normal of the face, or, in a hollow edge, the one towards a point inside.
Anchor on_triangle(const VoxelField& field, const Vector3d& C_O, int face, const Vector3d& pull_O) {
  const FaceGraph& faces = field.faces();
  Anchor anchor{C_O, faces[face].n, face};
  anchor.hollow = is_hollow(faces, place_of(faces, face, C_O, on_feature * field.grid().spacing));
  if (anchor.hollow) turn_normal(field, pull_O, anchor);
  return anchor;
}

/// An anchor at a point of the surface: with its smooth normal, unless the surface is sharper there than voxels can
/// tell.
Anchor anchor_at(const VoxelField& field, const Vector3d& p_O, int face, const Vector3d& pull_O, TouchNormal normal) {
  Anchor smooth;
  if (normal == TouchNormal::smooth && !has_creases(field) && settle(field, p_O, smooth) &&
      smooth.n_O.dot(field.faces()[face].n) > smallest_turn_cosine &&
      (smooth.C_O - p_O).norm() < 0.5 * field.grid().spacing)
    return smooth;
  return on_triangle(field, p_O, face, pull_O);
}

/// One stride of a slide, to the surface below its end. False (and `anchor` untouched) where the surface does not go
/// on: at the end of the band, onto another sheet, or where it turns by more than voxels can tell.
bool go_on(const VoxelField& field, const Vector3d& stride, Anchor& anchor) {
  Anchor moved;
  if (!settle(field, anchor.C_O + stride, moved)) return false;
  if (moved.n_O.dot(anchor.n_O) < smallest_turn_cosine) return false;
  const Vector3d way = moved.C_O - anchor.C_O;
  const double slack = projection_error * field.grid().spacing;
  if (way.norm() > 2 * stride.norm() + slack) return false;
  if (way.dot(stride) < -slack * stride.norm()) return false;  // an edge that smooth distances round off
  anchor = moved;
  return true;
}

/// A slide under way. The implicit step of the law slips s = (|w| − μ_d depth) k / (k + c/h) of the pull where it ends;
/// on a flat surface that is the planned step, and where the surface turns it differs by what that changes.
class Sliding {
 public:
  Sliding(const VoxelField& field, const Slip& slip, const Anchor& anchor)
      : field_(field), slip_(slip), anchor_(anchor), length_(slip.step_O.norm()), direction_(slip.step_O / length_) {
    const Vector3d pull = slip.pull_O - anchor.C_O;
    const double depth = -pull.dot(anchor.n_O);
    excess_ = (pull + depth * anchor.n_O).norm() - slip.mu * depth;
    rest_ = length_;
  }

  [[nodiscard]] const Anchor& anchor() const { return anchor_; }

  /// False if nothing presses any more.
  bool go() { return has_creases(field_) || anchor_.face >= 0 ? walk() : glide(); }

 private:
  /// On a smooth body, stride by stride of a voxel; the rest by triangles where voxels cannot tell.
  bool glide() {
    const double voxel = field_.grid().spacing, longest = std::max(voxel, length_ / most_strides);
    for (int i = 0; i < 4 * most_strides; ++i) {
      const double stride = std::min(rest_, longest);
      if (!go_on(field_, stride * direction_, anchor_)) return walk();
      slid_ += stride;
      const Vector3d pull = slip_.pull_O - anchor_.C_O;
      const double depth = -pull.dot(anchor_.n_O);
      if (depth <= 0) return false;
      if (stride == rest_ || !has_rest(pull + depth * anchor_.n_O, depth)) return true;
    }
    return walk();
  }

  /// From triangle to triangle.
  bool walk() {
    const FaceGraph& faces = field_.faces();
    const double eps = on_feature * field_.grid().spacing;
    if (anchor_.face < 0 && !set_down()) return true;
    Place place = place_of(faces, anchor_.face, anchor_.C_O, eps);
    bool at_start = !is_hollow(faces, place);
    for (int i = 0; i < most_faces; ++i) {
      if (at_start) {
        place = {.face = anchor_.face};
      } else {
        const Pull pull = split(faces, place, slip_.pull_O - anchor_.C_O);
        anchor_.face = pull.place.face;
        anchor_.n_O = pull.n;
        if (!(pull.depth > 0)) return false;
        if (!has_rest(pull.w, pull.depth)) return stay();
        place = pull.place;
      }
      at_start = false;
      if (!cross(place, eps)) return stay();
    }
    return true;
  }

  /// From the smooth surface onto its triangles: no way at all where they are flat, a fraction of a voxel where they
  /// round it off.
  bool set_down() {
    const std::optional<SurfacePoint> at = field_.closest(anchor_.C_O, 4 * field_.grid().spacing);
    if (!at) return false;
    const FaceGraph& faces = field_.faces();
    const Place place = place_of(faces, at->triangle, at->p_O, on_feature * field_.grid().spacing);
    const int face = face_along(faces, place, anchor_.n_O);
    anchor_ = {at->p_O, faces[face].n, face};
    return true;
  }

  /// Goes on along the face of `place`, or its side, to where that ends, and leaves the place there; false if the slide
  /// ends before.
  bool cross(Place& place, double eps) {
    const Face& f = field_.faces()[place.face];
    const Vector3d ahead = direction_ - direction_.dot(f.n) * f.n;
    if (!(ahead.norm() > no_motion)) return false;
    direction_ = ahead.normalized();
    double way = rest_;
    int end = -1;
    for (int k = 0; k < 3; ++k) {
      const double rate = direction_.dot(f.out[std::size_t(k)]);
      if (k == place.side || rate < no_motion) continue;
      const double to_side = std::max(0.0, f.inside(std::size_t(k), anchor_.C_O)) / rate;
      if (to_side < way) way = to_side, end = k;
    }
    anchor_.C_O += way * direction_;
    anchor_.face = place.face;
    slid_ += way;
    rest_ -= way;
    if (end < 0) return false;
    const Place arrived = place_of(field_.faces(), place.face, anchor_.C_O, eps);
    place = arrived.corner >= 0 ? arrived : Place{.face = place.face, .side = end};
    return true;
  }

  /// The end of a slide: against what the pull presses there.
  bool stay() {
    const FaceGraph& faces = field_.faces();
    anchor_.hollow = is_hollow(faces, place_of(faces, anchor_.face, anchor_.C_O, on_feature * field_.grid().spacing));
    anchor_.n_O = faces[anchor_.face].n;
    if (anchor_.hollow) turn_normal(field_, slip_.pull_O, anchor_);
    return true;
  }

  /// Whether the pull exceeds friction here, by w along the surface; sets out along it.
  bool has_rest(const Vector3d& w, double depth) {
    const double along = w.norm();
    rest_ = length_ - slid_ + slip_.share * (along - slip_.mu * depth - (excess_ - slid_));
    if (!(rest_ > 0 && along > 0)) return false;
    direction_ = w / along;
    return true;
  }

  const VoxelField& field_;
  const Slip& slip_;
  Anchor anchor_;
  double length_{};         // of the step as planned [m]
  double excess_{};         // |w| − μ_d depth of the pull as it began [m]
  double slid_{}, rest_{};  // [m]
  Vector3d direction_{Vector3d::Zero()};
};

}  // namespace

SmoothDistance smooth_distance(const VoxelField& field, const Vector3d& p_O) {
  // A central difference of the trilinear interpolant over one voxel is the trilinear interpolant of the nodes' central
  // differences: 4 x 4 x 4 nodes without the corners hold it all.
  const Grid& grid = field.grid();
  const double per_metre = 1 / grid.spacing;
  const Vector3d x = (p_O - grid.origin) * per_metre;
  const Eigen::Array3d last = grid.size.cast<double>().array() - 2;
  if (!((x.array() >= 1).all() && (x.array() < last).all()))
    return {field.distance(p_O).distance, central_differences(field, p_O)};
  const int i = int(x.x()), j = int(x.y()), k = int(x.z());
  const double u = x.x() - i, v = x.y() - j, w = x.z() - k;
  const std::ptrdiff_t dy = grid.size.x(), dz = dy * grid.size.y();
  const float* const node = field.data().distance.data() + grid.index(i, j, k);
  // Along x at (y, z): value, and differences of both ends.
  const auto at = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
    const float* const p = node + y * dy + z * dz;
    return p[0] + u * (double(p[1]) - p[0]);
  };
  const auto slope = [&](std::ptrdiff_t y, std::ptrdiff_t z) {
    const float* const p = node + y * dy + z * dz;
    const double low = double(p[1]) - p[-1], high = double(p[2]) - p[0];
    return low + u * (high - low);
  };
  const auto bilinear = [&](double c00, double c10, double c01, double c11) {
    const double c0 = c00 + v * (c10 - c00), c1 = c01 + v * (c11 - c01);
    return c0 + w * (c1 - c0);
  };
  const double c00 = at(0, 0), c10 = at(1, 0), c01 = at(0, 1), c11 = at(1, 1);
  SmoothDistance s;
  s.distance = bilinear(c00, c10, c01, c11);
  s.gradient.x() = bilinear(slope(0, 0), slope(1, 0), slope(0, 1), slope(1, 1));
  s.gradient.y() = bilinear(c10 - at(-1, 0), at(2, 0) - c00, c11 - at(-1, 1), at(2, 1) - c01);
  s.gradient.z() = bilinear(c01 - at(0, -1), c11 - at(1, -1), at(0, 2) - c00, at(1, 2) - c10);
  s.gradient *= 0.5 * per_metre;
  return s;
}

bool foot(const VoxelField& field, const Vector3d& p_O, Anchor& anchor) {
  const bool is_out = field.distance(p_O).distance >= 0;
  if (is_out && !has_creases(field)) return settle(field, p_O, anchor);
  const std::optional<SurfacePoint> nearest =
      is_out ? field.closest(p_O, field.band()) : nearest_from_inside(field, p_O);
  if (!nearest) return false;
  if (has_creases(field) || !settle(field, nearest->p_O, anchor))
    anchor = on_triangle(field, nearest->p_O, nearest->triangle, p_O);
  return true;
}

bool find_touch(const VoxelField& field, const Vector3d& from_O, const Vector3d& to_O, TouchNormal normal,
                Anchor& anchor) {
  const Vector3d way = to_O - from_O;
  const double length = way.norm();
  if (!std::isfinite(length)) return false;
  if (length > no_motion * field.grid().spacing) {
    const Vector3d direction = way / length;
    // A step that ended on the surface may by rounding have ended in it: the next one sets out a hair before.
    const double hair = no_motion * field.grid().spacing;
    const std::optional<RayHit> hit = field.raycast(from_O - hair * direction, direction, length + hair);
    if (hit && hit->n_O.dot(direction) < 0) {
      anchor = anchor_at(field, hit->p_O, hit->triangle, to_O, normal);
      return true;
    }
  }
  if (field.distance(to_O).distance >= field.grid().spacing) return false;
  const std::optional<SurfacePoint> nearest = nearest_from_inside(field, to_O);
  if (!nearest || nearest->distance >= 0) return false;
  anchor = anchor_at(field, nearest->p_O, nearest->triangle, to_O, normal);
  return true;
}

bool slide(const VoxelField& field, const Slip& slip, Anchor& anchor) {
  const double length = slip.step_O.norm();
  if (!(length > 0) || !std::isfinite(length) || !slip.pull_O.allFinite()) return true;
  Sliding sliding(field, slip, anchor);
  const bool presses = sliding.go();
  anchor = sliding.anchor();
  return presses;
}

bool follow(const VoxelField& field, const Vector3d& p_O, Anchor& anchor) {
  const Vector3d pull = p_O - anchor.C_O;
  const double depth = -pull.dot(anchor.n_O);
  if (!(depth > 0)) return false;
  return slide(field, {.pull_O = p_O, .step_O = pull + depth * anchor.n_O}, anchor);
}

void turn_normal(const VoxelField& field, const Vector3d& pull_O, Anchor& anchor) {
  const FaceGraph& faces = field.faces();
  const Place place = place_of(faces, anchor.face, anchor.C_O, on_feature * field.grid().spacing);
  const Pull pull = split(faces, place, pull_O - anchor.C_O);
  if (pull.depth > 0) anchor.n_O = pull.n;
}

}  // namespace handhold::realtime
