#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace handhold::realtime {

/// Many 3-vectors, one array a component.
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

 private:
  std::vector<double> x_{}, y_{}, z_{};
};

}  // namespace handhold::realtime
