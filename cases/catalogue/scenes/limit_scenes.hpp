// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/catalogue/claim.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// A scene with a closed form in L1 (rigid contact), built at any stiffness: what L2 tends to. The normal forces stay
/// as they are, by pressing less deep, and so does the share of critical damping, so that errors fall as 1/K.
struct LimitScene {
  std::string name{}, what{};
  std::function<Scene(double stiffness)> scene{};  ///< of each sample [N/m]
  std::vector<double> stiffness{};                 ///< to start with, each four times the one before
  std::string quantity{}, unit{};
  Measure measure{};
  double truth{};        ///< L1
  std::string source{};  ///< of the truth
};

/// "shaken pinch" (D04) and "pulled grip".
[[nodiscard]] const std::vector<LimitScene>& limit_scenes();

}  // namespace handhold::catalogue
