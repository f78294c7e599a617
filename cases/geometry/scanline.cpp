// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/scanline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/geometry/cgal_orientation.hpp"

namespace handhold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
// Forward error bounds of the determinants below, relative to their permanents (Shewchuk 1997, theorems for "A"
// filters).
constexpr double bound_2d = (3 + 16 * unit_roundoff) * unit_roundoff;
constexpr double bound_3d = (7 + 56 * unit_roundoff) * unit_roundoff;
constexpr double underflow = 1e-280;  // below this products lose digits that the relative bounds count on

int sign(double x) { return (x > 0) - (x < 0); }

Vector2d yz(const Vector3d& p) { return {p.y(), p.z()}; }
Vector2d zx(const Vector3d& p) { return {p.z(), p.x()}; }
Vector2d xy(const Vector3d& p) { return {p.x(), p.y()}; }

int orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double det = left - right;
  if (std::abs(det) > bound_2d * (std::abs(left) + std::abs(right)) + underflow) return sign(det);
  return exact_orientation(a, b, c);
}

// Side of p, moved by (e, e²), of the directed line a → b. Zero only if a = b.
int perturbed_side(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  if (const int side = orientation(a, b, p)) return side;
  if (a.y() != b.y()) return sign(a.y() - b.y());  // derivative along e
  return sign(b.x() - a.x());                      // along e²
}

int orientation(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  const Vector3d u = a - d, v = b - d, w = c - d;
  const double vw = v.x() * w.y(), wv = w.x() * v.y();
  const double wu = w.x() * u.y(), uw = u.x() * w.y();
  const double uv = u.x() * v.y(), vu = v.x() * u.y();
  const double det = u.z() * (vw - wv) + v.z() * (wu - uw) + w.z() * (uv - vu);
  const double permanent = (std::abs(vw) + std::abs(wv)) * std::abs(u.z()) +
                           (std::abs(wu) + std::abs(uw)) * std::abs(v.z()) +
                           (std::abs(uv) + std::abs(vu)) * std::abs(w.z());
  if (std::abs(det) > bound_3d * permanent + underflow) return -sign(det);
  return exact_orientation(a, b, c, d);
}

// Side of p, moved by (e³, e, e²), of the plane (a, b, c) whose normal has an x component of sign `nx`, not 0.
int perturbed_side(const Vector3d& a, const Vector3d& b, const Vector3d& c, int nx, const Vector3d& p) {
  if (const int side = orientation(a, b, c, p)) return side;
  if (const int ny = orientation(zx(a), zx(b), zx(c))) return ny;
  if (const int nz = orientation(xy(a), xy(b), xy(c))) return nz;
  return nx;
}

// Nodes first..last of one axis of the grid that lie between two coordinates, with a little to spare.
struct Range {
  int first, last;
};

Range nodes_between(const Grid& grid, int axis, double low, double high, double spare) {
  const double top = grid.size[axis] - 1;
  const double first = std::ceil((low - grid.origin[axis]) / grid.spacing - spare);
  const double last = std::floor((high - grid.origin[axis]) / grid.spacing + spare);
  return {static_cast<int>(std::clamp(first, 0.0, top + 1)), static_cast<int>(std::clamp(last, -1.0, top))};
}

class Rasteriser {
 public:
  Rasteriser(const Mesh& mesh, const Grid& grid) : mesh_(mesh), grid_(grid), winding_(grid.count(), 0) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < grid.size[axis]; ++i) nodes_[axis].push_back(grid.node(i, i, i)[axis]);
    }
  }

  std::vector<std::uint64_t> run() {
    for (const auto& [a, b, c] : mesh_.triangles) add(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
    return sum_rows();
  }

 private:
  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const auto [low_z, high_z] = std::minmax({a.z(), b.z(), c.z()});
    const Range layers = nodes_between(grid_, 2, low_z, high_z, 1e-6);
    if (layers.first > layers.last) return;
    const auto [low_y, high_y] = std::minmax({a.y(), b.y(), c.y()});
    const Range rows = nodes_between(grid_, 1, low_y, high_y, 1e-6);
    if (rows.first > rows.last) return;
    const int nx = orientation(yz(a), yz(b), yz(c));
    if (nx == 0) return;  // seen edge-on: no row pierces it
    for (int k = layers.first; k <= layers.last; ++k) {
      const Range span = row_span(a, b, c, nodes_[2][k]);
      for (int j = std::max(rows.first, span.first); j <= std::min(rows.last, span.last); ++j)
        add_row(a, b, c, nx, j, k);
    }
  }

  // Rows whose y lies within the triangle's slice at z. Only a saving: `add_row` decides.
  Range row_span(const Vector3d& a, const Vector3d& b, const Vector3d& c, double z) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto clip = [&](const Vector3d& p, const Vector3d& q) {
      if (std::min(p.z(), q.z()) > z || std::max(p.z(), q.z()) < z) return;
      const bool level = p.z() == q.z();
      const double s = level ? 0 : (z - p.z()) / (q.z() - p.z());
      const double y = p.y() + s * (q.y() - p.y());
      low = std::min({low, y, level ? q.y() : y});
      high = std::max({high, y, level ? q.y() : y});
    };
    clip(a, b);
    clip(b, c);
    clip(c, a);
    if (low > high) return {1, 0};
    return nodes_between(grid_, 1, low, high, 1e-3);
  }

  void add_row(const Vector3d& a, const Vector3d& b, const Vector3d& c, int nx, int j, int k) {
    const Vector2d row(nodes_[1][j], nodes_[2][k]);
    if (perturbed_side(yz(a), yz(b), row) != nx) return;
    if (perturbed_side(yz(b), yz(c), row) != nx) return;
    if (perturbed_side(yz(c), yz(a), row) != nx) return;
    const int i = first_beyond(a, b, c, nx, row);
    // Along +x one leaves the solid through a face whose normal points along +x.
    if (i < grid_.size.x()) winding_[grid_.index(i, j, k)] -= static_cast<std::int16_t>(nx);
  }

  // First node of the row on the far side of the plane: a guess in floating point, walked to where the exact sides
  // change.
  int first_beyond(const Vector3d& a, const Vector3d& b, const Vector3d& c, int nx, const Vector2d& row) const {
    const auto beyond = [&](int i) {
      return perturbed_side(a, b, c, nx, Vector3d(nodes_[0][i], row.x(), row.y())) == nx;
    };
    const Vector3d n = (b - a).cross(c - a);
    const double x = a.x() - (n.y() * (row.x() - a.y()) + n.z() * (row.y() - a.z())) / n.x();
    const double guess = std::ceil((x - grid_.origin.x()) / grid_.spacing);
    const int count = grid_.size.x();
    int i = std::isfinite(guess) ? static_cast<int>(std::clamp(guess, 0.0, double(count))) : 0;
    while (i > 0 && beyond(i - 1)) --i;
    while (i < count && !beyond(i)) ++i;
    return i;
  }

  std::vector<std::uint64_t> sum_rows() const {
    std::vector<std::uint64_t> occupied((winding_.size() + 63) / 64, 0);
    const std::size_t row_length = grid_.size.x();
    for (std::size_t row = 0; row < winding_.size(); row += row_length) {
      int winding = 0;
      for (std::size_t node = row; node < row + row_length; ++node) {
        winding += winding_[node];
        if (winding > 0) occupied[node >> 6] |= std::uint64_t(1) << (node & 63);
      }
    }
    return occupied;
  }

  const Mesh& mesh_;
  const Grid& grid_;
  std::array<std::vector<double>, 3> nodes_;
  std::vector<std::int16_t> winding_;
};

}  // namespace

std::vector<std::uint64_t> rasterise(const Mesh& mesh, const Grid& grid) { return Rasteriser(mesh, grid).run(); }

}  // namespace handhold
