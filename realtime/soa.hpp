// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace handhold::realtime {

/// Many 3-vectors, one array a component: loops over them read memory in order and fill vector registers.
class Vector3Array {
 public:
  void resize(std::size_t size) {
    x_.resize(size);
    y_.resize(size);
    z_.resize(size);
  }
  [[nodiscard]] Eigen::Vector3d operator[](std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  void set(std::size_t i, const Eigen::Vector3d& v) {
    x_[i] = v.x();
    y_[i] = v.y();
    z_[i] = v.z();
  }

  [[nodiscard]] const double* x() const { return x_.data(); }
  [[nodiscard]] const double* y() const { return y_.data(); }
  [[nodiscard]] const double* z() const { return z_.data(); }
  [[nodiscard]] double* x() { return x_.data(); }
  [[nodiscard]] double* y() { return y_.data(); }
  [[nodiscard]] double* z() { return z_.data(); }

 private:
  std::vector<double> x_{}, y_{}, z_{};
};

}  // namespace handhold::realtime
