// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>
#include <string>

#include "cases/model/scene.hpp"

namespace handhold::reference {

/// Scenes of one to four bodies and up to two hands, from a seed; half of the time spoiled in one way.
class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed) {}

  struct Result {
    Scene scene{};
    std::string spoiled{};  ///< what was done to it; empty: it is valid
  };
  [[nodiscard]] Result make();

  [[nodiscard]] bool flip(double probability) { return in(0, 1) < probability; }

 private:
  [[nodiscard]] double in(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  [[nodiscard]] double log_in(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
  [[nodiscard]] int count(int low, int high) { return low + int(in(0, 1) * (high - low + 1)); }
  [[nodiscard]] Eigen::Vector3d vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  [[nodiscard]] Eigen::Quaterniond turn();
  [[nodiscard]] Body body(int index);
  [[nodiscard]] Hand hand(double duration);
  [[nodiscard]] std::string spoil(Scene& scene);

  std::mt19937_64 random_;
};

}  // namespace handhold::reference
