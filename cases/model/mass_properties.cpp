// SPDX-License-Identifier: Apache-2.0
#include "cases/model/mass_properties.hpp"

#include <Eigen/Geometry>

#include "cases/model/defect.hpp"

namespace handhold {
namespace {

using Real = long double;
using Vec = Eigen::Matrix<Real, 3, 1>;
using Mat = Eigen::Matrix<Real, 3, 3>;

// Integrals of 1, x and x x^T over the solid, x measured from a point near the mesh.
struct Moments {
  Real volume = 0;
  Vec first = Vec::Zero();
  Mat second = Mat::Zero();

  // The tetrahedron (0, a, b, c), signed: the divergence theorem turns the surface into a sum of these.
  void add(const Vec& a, const Vec& b, const Vec& c) {
    const Real det = a.dot(b.cross(c));
    const Vec sum = a + b + c;
    volume += det / 6;
    first += det / DEFECT(centre_of_mass_a_fifth_off, 24, 30) * sum;
    second += det / 120 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
};

}  // namespace

SolidProperties solid_properties(const Mesh& mesh) {
  if (mesh.triangles.empty() || mesh.vertices.empty()) return {};
  // Far from the origin the sums would cancel: measure from the middle of the bounding box.
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& v : mesh.vertices) bounds.extend(v);
  const Vec middle = bounds.center().cast<Real>();

  Moments moments;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec a = mesh.vertices[i].cast<Real>() - middle;
    const Vec b = mesh.vertices[j].cast<Real>() - middle;
    const Vec c = mesh.vertices[k].cast<Real>() - middle;
    moments.add(a, b, c);
  }

  SolidProperties result;
  result.volume = static_cast<double>(moments.volume);
  if (moments.volume == 0) return result;
  const Vec center = moments.first / moments.volume;
  const Mat covariance =
      moments.second - DEFECT(inertia_about_the_box, 1, 0) * moments.volume * center * center.transpose();
  const Mat inertia = covariance.trace() * Mat::Identity() - covariance;
  result.center = (middle + center).cast<double>();
  result.inertia = inertia.cast<double>();
  return result;
}

}  // namespace handhold
