// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/spline_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double least_band = 12;  // [voxels]

/// Weights of the four cubic B-splines that reach a point at fraction u of its cell, and their derivatives by u.
struct Weights {
  std::array<double, 4> w, dw, ddw;
};

Weights weights(double u) {
  const double s = 1 - u, u2 = u * u, u3 = u2 * u;
  return {{s * s * s / 6, (3 * u3 - 6 * u2 + 4) / 6, (-3 * u3 + 3 * u2 + 3 * u + 1) / 6, u3 / 6},
          {-s * s / 2, (3 * u2 - 4 * u) / 2, (-3 * u2 + 2 * u + 1) / 2, u2 / 2},
          {s, 3 * u - 2, 1 - 3 * u, u}};
}

/// Turns samples into spline coefficients along one axis of the padded array, for `width` neighbouring lines at once.
///
/// Natural ends (s'' = 0) give c_0 = f_0 and c_{-1} = 2 c_0 − c_1; between them c_{i-1} + 4 c_i + c_{i+1} = 6 f_i,
/// solved by Thomas' elimination, which is stable (diagonally dominant).
void prefilter(double* line, std::ptrdiff_t stride, int count, std::ptrdiff_t width) {
  const auto at = [&](int i) { return line + i * stride; };  // i = 0 is the first node, −1 its ghost
  std::vector<double> pivot(std::size_t(count), 0.0);
  for (int i = 1; i + 1 < count; ++i) {
    pivot[std::size_t(i)] = 1 / (4 - pivot[std::size_t(i - 1)]);
    const double scale = pivot[std::size_t(i)];
    for (std::ptrdiff_t x = 0; x < width; ++x) at(i)[x] = (6 * at(i)[x] - at(i - 1)[x]) * scale;
  }
  for (int i = count - 2; i >= 1; --i) {
    const double factor = pivot[std::size_t(i)];
    for (std::ptrdiff_t x = 0; x < width; ++x) at(i)[x] -= factor * at(i + 1)[x];
  }
  for (std::ptrdiff_t x = 0; x < width; ++x) {
    at(-1)[x] = 2 * at(0)[x] - at(1)[x];
    at(count)[x] = 2 * at(count - 1)[x] - at(count - 2)[x];
  }
}

}  // namespace

SplineSurface::SplineSurface(std::shared_ptr<const VoxelField> field) : field_(std::move(field)) {
  const Grid& grid = field_->grid();
  if (grid.size.minCoeff() < 4)
    throw InputError(fmt::format("voxel field of {} x {} x {} nodes: the spline needs 4 a side (use smaller voxels)",
                                 grid.size.x(), grid.size.y(), grid.size.z()));
  if (field_->band() < least_band * grid.spacing * (1 - 1e-9))
    throw InputError(
        fmt::format("voxel field with a band of {:.3g} voxels: the spline needs {} (voxelize with a wider band)",
                    field_->band() / grid.spacing, least_band));
  size_ = grid.size + Eigen::Vector3i::Constant(2);
  const std::ptrdiff_t row = size_.x(), slab = row * size_.y();
  coefficients_.assign(std::size_t(slab) * std::size_t(size_.z()), 0.0);
  const std::vector<float>& distance = field_->data().distance;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j) {
      double* line = &coefficients_[std::size_t((k + 1) * slab + (j + 1) * row + 1)];
      std::copy_n(&distance[grid.index(0, j, k)], grid.size.x(), line);
      prefilter(line, 1, grid.size.x(), 1);
    }
  for (int k = 0; k < grid.size.z(); ++k)
    prefilter(&coefficients_[std::size_t((k + 1) * slab + row)], row, grid.size.y(), row);
  prefilter(&coefficients_[std::size_t(slab)], slab, grid.size.z(), slab);
}

bool SplineSurface::on_grid(const Vector3d& node) const {
  return (node.array() >= 0).all() && (node.array() <= (size_.array() - 3).cast<double>()).all();
}

template <int Derivatives>
SurfaceSample SplineSurface::sample(const Vector3d& p_O) const {
  const Grid& grid = field_->grid();
  const Vector3d node = (p_O - grid.origin) / grid.spacing;
  if (!on_grid(node)) {  // NaN too
    const DistanceSample far = field_->distance(p_O);
    return {std::max(far.distance, 0.0), far.gradient, Matrix3d::Zero()};
  }
  const Eigen::Vector3i cell = node.array().floor().cast<int>().min(size_.array() - 4);
  const Weights x = weights(node.x() - cell.x()), y = weights(node.y() - cell.y()), z = weights(node.z() - cell.z());
  const std::ptrdiff_t row = size_.x(), slab = row * size_.y();
  const double* base = &coefficients_[std::size_t(cell.z() * slab + cell.y() * row + cell.x())];
  // Sums over x, then over y, then over z; every derivative shares those of the lower axes.
  double f = 0, fx = 0, fy = 0, fz = 0, fxx = 0, fyy = 0, fzz = 0, fxy = 0, fxz = 0, fyz = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    double g = 0, gx = 0, gy = 0, gxx = 0, gxy = 0, gyy = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      const double* c = base + std::ptrdiff_t(k) * slab + std::ptrdiff_t(j) * row;
      const double s = c[0] * x.w[0] + c[1] * x.w[1] + c[2] * x.w[2] + c[3] * x.w[3];
      g += s * y.w[j];
      if constexpr (Derivatives >= 1) {
        const double sx = c[0] * x.dw[0] + c[1] * x.dw[1] + c[2] * x.dw[2] + c[3] * x.dw[3];
        gx += sx * y.w[j];
        gy += s * y.dw[j];
        if constexpr (Derivatives >= 2) {
          gxx += (c[0] * x.ddw[0] + c[1] * x.ddw[1] + c[2] * x.ddw[2] + c[3] * x.ddw[3]) * y.w[j];
          gxy += sx * y.dw[j];
          gyy += s * y.ddw[j];
        }
      }
    }
    f += g * z.w[k];
    if constexpr (Derivatives >= 1) {
      fx += gx * z.w[k];
      fy += gy * z.w[k];
      fz += g * z.dw[k];
    }
    if constexpr (Derivatives >= 2) {
      fxx += gxx * z.w[k];
      fxy += gxy * z.w[k];
      fyy += gyy * z.w[k];
      fxz += gx * z.dw[k];
      fyz += gy * z.dw[k];
      fzz += g * z.ddw[k];
    }
  }
  SurfaceSample out;
  out.value = f;
  if constexpr (Derivatives >= 1) out.gradient = Vector3d(fx, fy, fz) / grid.spacing;
  if constexpr (Derivatives >= 2) {
    out.hessian << fxx, fxy, fxz, fxy, fyy, fyz, fxz, fyz, fzz;
    out.hessian /= grid.spacing * grid.spacing;
  }
  return out;
}

double SplineSurface::value(const Vector3d& p_O) const { return sample<0>(p_O).value; }
SurfaceSample SplineSurface::gradient(const Vector3d& p_O) const { return sample<1>(p_O); }
SurfaceSample SplineSurface::evaluate(const Vector3d& p_O) const { return sample<2>(p_O); }

Vector3d SplineSurface::project(const Vector3d& p_O) const {
  Vector3d p = p_O;
  for (int i = 0; i < 20; ++i) {
    const SurfaceSample s = gradient(p);
    const double slope = s.gradient.squaredNorm();
    if (!(slope > 0)) break;
    const Vector3d step = (s.value / slope) * s.gradient;
    p -= step;
    if (step.squaredNorm() < 1e-36) break;  // 1e-18 m: below the round-off of coordinates
  }
  return p;
}

AnchorSurface SplineSurface::at(const Vector3d& anchor_O, const Foothold&, bool with_curvature) const {
  const SurfaceSample s = with_curvature ? evaluate(anchor_O) : gradient(anchor_O);
  const double slope = s.gradient.norm();
  return {s.value / slope, s.gradient / slope, s.hessian / slope};
}

/// Deep in the solid the spline is flat (clamped) or kinked (medial axis): start from the exact mesh there.
Vector3d SplineSurface::nearby_surface_point(const Vector3d& p_O) const {
  if (std::abs(value(p_O)) < 0.5 * field_->grid().spacing) return p_O;
  const double everywhere = field_->band() + 2 * field_->grid().spacing * size_.cast<double>().norm();
  const std::optional<SurfacePoint> closest = field_->closest(p_O, everywhere);
  return closest ? closest->p_O : p_O;
}

Foot SplineSurface::foot(const Vector3d& p_O) const { return foot_from(p_O, nearby_surface_point(p_O)); }

Foot SplineSurface::foot_from(const Vector3d& p_O, const Vector3d& start_O) const {
  Foot foot;
  foot.p_O = project(start_O);
  for (int i = 0; i < 60; ++i) {  // contracts by depth × curvature
    foot.n_O = gradient(foot.p_O).gradient.normalized();
    const Vector3d r = p_O - foot.p_O;
    foot.depth = -r.dot(foot.n_O);
    const Vector3d lag = r + foot.depth * foot.n_O;
    if (lag.squaredNorm() < 1e-32) break;
    foot.p_O = project(foot.p_O + lag);
  }
  return foot;
}

}  // namespace handhold::reference
