// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <Eigen/Core>

#include "cases/closed_form/slider_oscillator.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// How the samples of a scene share the springs of a closed_form::SliderOscillator.
struct SliderLayout {
  int samples{8};         ///< of the sliding contact: on the palm, or of both fingers together
  double finger_depth{};  ///< of the two fingers that make the tether, when the tether is slack [m]
};

/// A block that only translates, on a level palm which moves along x as the oscillator's base; x of the oscillator is
/// W's x. The tether is two fingers that press on the block's ends with one sample each, deep enough never to let go:
/// along their normal they are a linear spring, so that tether = 2 stiffness / samples (and damping alike), and
/// tether_end must rest at 0. Gravity leans: it gives the normal force (constant) and the constant part of the force.
[[nodiscard]] Scene palm_scene(const std::string& name, const closed_form::SliderOscillator& oscillator,
                               const SliderLayout& layout, double duration);

/// A cube between thumb and index (eight samples each, along y), which move together up and down as the oscillator's
/// base and press with half its normal force each; x of the oscillator is W's z. The normal force must be linear in t.
[[nodiscard]] Scene pinch_scene(const std::string& name, const closed_form::SliderOscillator& oscillator,
                                double duration);

/// Sets x, v and stretch to the forced motion in stick, without transient; the anchor lies where base and mass have the
/// same coordinate.
void start_in_forced_stick(closed_form::SliderOscillator& oscillator);

}  // namespace handhold::catalogue
