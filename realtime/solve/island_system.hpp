// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "realtime/solve/block_system.hpp"
#include "realtime/solve/island.hpp"

namespace handhold::realtime {

/// What limits the friction of samples that are not linear.
enum class Cones {
  touching,  ///< as `live`, but what has just come in is taken to press, or else, before anything has moved, nothing
             ///< would carry anything
  live,      ///< the pressure, as the law wants it
  frozen,    ///< Slider::cap: then forces are the slope of a convex potential of the velocities
};

/// Momentum balances (see BodyStep) of the bodies of an island as one system r(δ) = 0 in the changes δ of their
/// velocities. What sticks is a spring and a damper, linear in δ, and enters as one sum a patch. One body is a dense
/// 6 x 6 system, several are a BlockSystem.
class IslandSystem {
 public:
  /// Room for islands of `bodies` bodies in all.
  void reserve(int bodies);

  /// Begins with an island; `end` must follow before the next.
  void begin(const Island& island, double reach);
  /// Completes the trials of all sliders.
  void end(Island& island, const std::vector<BodyStep>& bodies);
  /// To be called when patches have been given their samples, or others.
  void regroup(const Island& island);

  /// Evaluates all sliders and the residual at the present δ; true if that is next to nothing against the sizes of its
  /// terms, `tolerance` times their sum, and their rounding.
  bool balance(Island& island, const std::vector<BodyStep>& bodies, double tolerance, Cones cones);
  /// |r|² at the last `balance`, in SI units.
  [[nodiscard]] double squared_residual() const { return squared_; }
  [[nodiscard]] bool is_finite() const { return std::isfinite(squared_); }

  /// One Newton step from the last `balance`: δ += step.
  void correct(const Island& island, std::vector<BodyStep>& bodies);
  /// Takes back `share` of the last step.
  void step_back(const Island& island, std::vector<BodyStep>& bodies, double share) const;
  /// Residual · last step: how steeply a potential falls along it.
  [[nodiscard]] double fall() const;

 private:
  void analyse(const Island& island);
  [[nodiscard]] bool add_slopes(const Island& island, const std::vector<BodyStep>& bodies);
  void add_stiffness(const PatchStep& patch, const Matrix6& S);
  [[nodiscard]] int row(int body) const { return body < 0 ? -1 : row_[std::size_t(body)]; }

  double reach_{};
  std::vector<int> acting_{};  // patches with samples that may have a force
  std::vector<int> row_{};     // of a body in the system, -1: it does not move
  std::vector<Vector6> residual_{}, step_{};
  double squared_{};
  Matrix6 dense_{Matrix6::Zero()};
  BlockSystem blocks_{};
  bool analysed_{false};
};

}  // namespace handhold::realtime
