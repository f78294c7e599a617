// SPDX-License-Identifier: Apache-2.0
#include "realtime/detection/fan.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

constexpr double rounding = 1e-12;  // of directions
constexpr double flat = 1e-9;       // sine of a turn: less is none

int corner_at(const Face& f, int vertex) {
  for (int i = 0; i < 3; ++i)
    if (f.vertex[std::size_t(i)] == vertex) return i;
  return -1;
}

bool ends_at(int side, int corner) { return side == corner || (side + 1) % 3 == corner; }

/// The side of the face beyond side `side` of `f` that lies along it.
int side_beyond(const Face& f, int side, const Face& beyond) {
  const auto i = std::size_t(side);
  int best = -1;
  double straightest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double turned = (beyond.n.cross(beyond.out[std::size_t(k)]) + f.n.cross(f.out[i])).squaredNorm();
    if (turned < straightest) straightest = turned, best = k;
  }
  return best;
}

/// Gathers the point of a fan that is nearest to a pull, sector by sector.
class NearestInFan {
 public:
  NearestInFan(const FaceGraph& faces, const Vector3d& pull) : faces_(faces), pull_(pull) {}

  /// The sector of face `id` between its sides that hold the place: one side, or the two at `corner`.
  void offer(int id, int side, int corner) {
    const Face& f = faces_[id];
    if (f.n.isZero(0)) return;
    const double height = pull_.dot(f.n);
    const Vector3d w = pull_ - height * f.n;
    const auto bounds = [&](int k) { return corner < 0 ? k == side : ends_at(k, corner); };
    bool leads_in = true;
    for (int k = 0; k < 3; ++k)
      leads_in = leads_in && !(bounds(k) && w.dot(f.out[std::size_t(k)]) > rounding * w.norm());
    if (leads_in) return take(w, std::abs(height), {id, -1, corner});
    for (int k = 0; k < 3; ++k)
      if (bounds(k)) offer_side(id, k, corner);
  }

  [[nodiscard]] const Vector3d& w() const { return w_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] const Place& place() const { return place_; }

 private:
  void offer_side(int id, int k, int corner) {
    const Face& f = faces_[id];
    Vector3d along = f.n.cross(f.out[std::size_t(k)]);
    if (corner >= 0 && corner != k) along = -along;  // away from the corner
    double at = pull_.dot(along);
    if (corner >= 0 && at < 0) at = 0;
    const Vector3d w = at * along;
    take(w, (pull_ - w).norm(), {id, k, corner});
  }

  void take(const Vector3d& w, double distance, const Place& place) {
    if (!(distance < (1 - rounding) * distance_)) return;
    w_ = w;
    distance_ = distance;
    place_ = place;
  }

  const FaceGraph& faces_;
  const Vector3d& pull_;
  Vector3d w_{Vector3d::Zero()};
  double distance_{std::numeric_limits<double>::max()};
  Place place_{};
};

/// Outward at a corner: normals weighted by the faces' angles there.
Vector3d normal_at(const FaceGraph& faces, int vertex) {
  Vector3d sum = Vector3d::Zero();
  for (const int id : faces.around(vertex)) {
    const Face& f = faces[id];
    const auto i = std::size_t(corner_at(f, vertex));
    const Vector3d u = f.corner[(i + 1) % 3] - f.corner[i], v = f.corner[(i + 2) % 3] - f.corner[i];
    sum += std::atan2(u.cross(v).norm(), u.dot(v)) * f.n;
  }
  return sum;
}

/// Which way is out at the nearest point of a fan tells which side of the surface the pull is on (Baerentzen and
/// Aanaes, IEEE TVCG 11, 2005).
Vector3d outward(const FaceGraph& faces, const NearestInFan& nearest) {
  const auto [face, side, corner] = nearest.place();
  const Face& f = faces[face];
  if (corner >= 0 && nearest.w().isZero(0)) return normal_at(faces, f.vertex[std::size_t(corner)]);
  if (side < 0) return f.n;
  const int beyond = f.beyond[std::size_t(side)];
  return beyond < 0 ? f.n : Vector3d(f.n + faces[beyond].n);
}

}  // namespace

Place place_of(const FaceGraph& faces, int face, const Vector3d& p_O, double eps) {
  const Face& f = faces[face];
  Place place{.face = face};
  double nearest = eps;
  for (int i = 0; i < 3; ++i) {
    if ((p_O - f.corner[std::size_t(i)]).squaredNorm() < 4 * eps * eps) return {.face = face, .corner = i};
    const double inside = f.inside(std::size_t(i), p_O);
    if (inside < nearest) nearest = inside, place.side = i;
  }
  return place;
}

bool is_hollow(const FaceGraph& faces, const Place& place) {
  const auto hollow = [&](const Face& f, int side) {
    const int beyond = f.beyond[std::size_t(side)];
    return beyond >= 0 && f.out[std::size_t(side)].dot(faces[beyond].n) < -flat;
  };
  const Face& f = faces[place.face];
  if (place.corner < 0) return place.side >= 0 && hollow(f, place.side);
  const int vertex = f.vertex[std::size_t(place.corner)];
  for (const int id : faces.around(vertex))
    for (int k = 0; k < 3; ++k)
      if (ends_at(k, corner_at(faces[id], vertex)) && hollow(faces[id], k)) return true;
  return false;
}

int face_along(const FaceGraph& faces, const Place& place, const Vector3d& n_O) {
  int best = place.face;
  const auto offer = [&](int face) {
    if (face >= 0 && faces[face].n.dot(n_O) > faces[best].n.dot(n_O)) best = face;
  };
  if (place.corner >= 0)
    for (const int face : faces.around(faces[place.face].vertex[std::size_t(place.corner)])) offer(face);
  else if (place.side >= 0)
    offer(faces[place.face].beyond[std::size_t(place.side)]);
  return best;
}

Pull split(const FaceGraph& faces, const Place& place, const Vector3d& pull) {
  NearestInFan nearest(faces, pull);
  const Face& f = faces[place.face];
  if (place.corner >= 0) {
    const int vertex = f.vertex[std::size_t(place.corner)];
    for (const int id : faces.around(vertex)) nearest.offer(id, -1, corner_at(faces[id], vertex));
  } else {
    nearest.offer(place.face, place.side, -1);
    const int beyond = place.side < 0 ? -1 : f.beyond[std::size_t(place.side)];
    if (beyond >= 0) nearest.offer(beyond, side_beyond(f, place.side, faces[beyond]), -1);
  }
  const Vector3d pressing = pull - nearest.w();
  const bool is_out = pressing.dot(outward(faces, nearest)) >= 0;
  Pull result{nearest.w(), faces[nearest.place().face].n, nearest.distance(), nearest.place()};
  if (nearest.place().side >= 0 && nearest.distance() > 0) result.n = -pressing / nearest.distance();
  if (is_out) result.depth = -nearest.distance();
  return result;
}

}  // namespace handhold::realtime
