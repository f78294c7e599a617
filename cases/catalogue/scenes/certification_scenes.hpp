// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/catalogue/claim.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// The hands of these scenes are splines whose knots lie at multiples of 1 / certification_rate [Hz]: between two knots
/// everything but a change of mode is analytic, so an integrator of high order steps from knot to knot.
inline constexpr double certification_rate = 2000;

/// A scene on which an integrator is certified, because its own error is all that is left: contacts far from edges, so
/// that the spline of the voxel field is a plane (or, for one scene, a smooth ball) to round-off; no grazing events.
struct CertificationScene {
  std::string name{};  ///< e.g. "twist16"
  std::string what{};  ///< one sentence
  std::function<Scene()> scene{};
  bool flat{true};              ///< all contacts lie on the faces of a box
  bool eventless{false};        ///< no change of mode: shows the order of an integrator
  bool costly{false};           ///< for the cost of many contacts only
  std::vector<Claim> claims{};  ///< closed forms of L2, where there are any
};

/// pull, pinch-open (closed forms); plate, tilt (lift-off), twist16; twist16-damped, tilt-damped; ball; smooth, slide
/// (event-free); twist128.
[[nodiscard]] const std::vector<CertificationScene>& certification_scenes();

/// The one of that name; throws InputError listing the names.
[[nodiscard]] const CertificationScene& certification_scene(const std::string& name);

}  // namespace handhold::catalogue
