// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/substeps.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace handhold::compare {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Of the body about its centre of mass, over k: the sum over its samples of [1, -r×; r×, -r× r×].
Matrix6 springs(const Body& body, std::size_t index, const Frame& frame) {
  const Eigen::Vector3d center_W = frame.bodies[index].X_WO * body.inertia.center;
  Matrix6 K = Matrix6::Zero();
  for (const ContactState& c : frame.contacts) {
    if (c.id.body != index || c.id.belongs_to_body() || c.mode == Mode::apart) continue;
    const Eigen::Vector3d r = c.C_W - center_W;
    Eigen::Matrix3d R;
    R << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    K.topLeftCorner<3, 3>() += Eigen::Matrix3d::Identity();
    K.topRightCorner<3, 3>() -= R;
    K.bottomLeftCorner<3, 3>() += R;
    K.bottomRightCorner<3, 3>() -= R * R;
  }
  return K;
}

Matrix6 inertia(const Body& body, const Pose& X_WO) {
  const Eigen::Matrix3d R = X_WO.R.toRotationMatrix();
  Matrix6 M = body.inertia.mass * Matrix6::Identity();
  M.bottomRightCorner<3, 3>() = R * body.inertia.about_center * R.transpose();
  return M;
}

}  // namespace

double fastest_motion(const Scene& scene, const Recording& recording) {
  double largest = 0;
  for (const Frame& frame : recording.frames) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      if (body.mobility != Mobility::free) continue;
      const Matrix6 K = scene.contact.stiffness * springs(body, i, frame);
      if (K.isZero(0) || !K.allFinite()) continue;
      const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6> modes(K, inertia(body, frame.bodies[i].X_WO),
                                                                    Eigen::EigenvaluesOnly);
      largest = std::max(largest, modes.eigenvalues().maxCoeff());
    }
  }
  return std::sqrt(largest);
}

int needed_substeps(double fastest, double frame_rate) {
  const double needed = std::ceil(fastest / (most_phase * frame_rate));
  return int(std::clamp(needed, double(least_substeps), double(most_substeps)));
}

}  // namespace handhold::compare
