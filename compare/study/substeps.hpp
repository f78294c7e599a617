// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::compare {

/// The largest ω h that a default may have: ω the fastest motion of an object on the springs that touch it, h the
/// sub-step. Implicit Euler adds the damping ratio ω h / 2 to every motion: with this it adds at most half of what the
/// element of a grip has by itself (auto_damping_ratio, 0.36).
inline constexpr double most_phase = 0.36;

inline constexpr int least_substeps = 4, most_substeps = 64;  // a default beyond is asked for by hand

/// Largest angular frequency of any free body on the springs of the samples that touch it, all sticking, at any frame
/// [rad/s]: the square root of the largest eigenvalue of M^-1 K, six by six about the centre of mass. 0 without touch.
/// The recording must hold contacts.
[[nodiscard]] double fastest_motion(const Scene& scene, const Recording& recording);

/// Sub-steps a frame with which `fastest` [rad/s] turns by at most `most_phase` a sub-step: 4 to 64.
[[nodiscard]] int needed_substeps(double fastest, double frame_rate);

}  // namespace handhold::compare
