// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "cases/model/voxel_field.hpp"
#include "tests/reference/independent/real.hpp"

namespace handhold::independent {

/// A surface near a point X of O: signed distance to first order, normal, and how the normal turns along the surface.
struct Local {
  Real phi{};
  Vec3 n{Vec3::Zero()};
  Mat3 shape{Mat3::Zero()};  ///< dn = shape dX for tangential dX [1/m]
};

class Surface {
 public:
  virtual ~Surface() = default;
  [[nodiscard]] virtual Local at(const Vec3& X) const = 0;
  [[nodiscard]] virtual bool flat() const { return false; }
};

/// The plane n·X = offset: a face of a box, analytic.
class Face : public Surface {
 public:
  Face(const Vec3& n, Real offset) : n_(n), offset_(offset) {}
  [[nodiscard]] Local at(const Vec3& X) const override { return {n_.dot(X) - offset_, n_, Mat3::Zero()}; }
  [[nodiscard]] bool flat() const override { return true; }

 private:
  Vec3 n_;
  Real offset_;
};

/// The exact sphere about O's origin: to tell how far the voxels are from it.
class Ball : public Surface {
 public:
  explicit Ball(Real radius) : radius_(radius) {}
  [[nodiscard]] Local at(const Vec3& X) const override;

 private:
  Real radius_;
};

/// The zero set of the cubic B-spline through the field's numbers, by a recursive prefilter (Unser 1999) with mirrored
/// ends; the ends are felt 0.27 times less a node.
class VoxelSpline : public Surface {
 public:
  explicit VoxelSpline(const VoxelField& field);
  [[nodiscard]] Local at(const Vec3& X) const override;

 private:
  [[nodiscard]] Real coefficient(int i, int j, int k) const { return c_[grid_.index(i, j, k)]; }

  Grid grid_;
  std::vector<Real> c_;
};

/// The six faces of the box around a field's mesh.
[[nodiscard]] std::vector<std::shared_ptr<const Surface>> faces_of(const VoxelField& field);

}  // namespace handhold::independent
