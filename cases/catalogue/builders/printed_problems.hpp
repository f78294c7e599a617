// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/case.hpp"
#include "cases/closed_form/printed_grasp.hpp"
#include "cases/closed_form/printed_law.hpp"

// Level L3: scenes and claims that the cases of the printed law share.

namespace handhold::catalogue {

/// What an L3 case is played on: exact planes, or the triangles of a real voxel field whose faces lie at powers of two.
enum class Ground { planes, voxels };

/// Half the thickness of what is pinched, and the height of the voxel field's face that looks up [m].
inline constexpr double half_slab = 1.0 / 32;

/// z of the face that looks up: 0 or half_slab [m].
[[nodiscard]] double top_of(Ground ground);

/// γ, ε and the order of a closed form as options of the law.
[[nodiscard]] printed::Options law_of(const closed_form::PrintedFace& face,
                                      closed_form::FrameOrder order = closed_form::FrameOrder::force_first);

using Scalar = std::function<double(double t)>;

/// One sample on a face that looks up (endless, or 2 m long along x), at x(t) and at the face's depth below it; the
/// body is fixed.
[[nodiscard]] PrintedProblem on_a_face(Ground ground, const closed_form::PrintedFace& face, const Scalar& x,
                                       int frames);

/// The same with eight samples on a ring of `radius` about the phalanx's centroid, turned about z by `angle`(t).
[[nodiscard]] PrintedProblem ring_on_a_face(Ground ground, const closed_form::PrintedFace& face, double radius,
                                            const Scalar& angle, int frames);

/// How the samples of a pinch start: with a lag that carries, and sliding or not.
struct PinchStart {
  double lag{};  ///< [m]
  bool slipping{false};
};

/// A body that can only translate between two fingers, each a ring of half the samples pressed in along x; gravity
/// along −z. On voxels the body is 2 m long.
[[nodiscard]] PrintedProblem in_a_pinch(Ground ground, const closed_form::PrintedPinch& pinch, const PinchStart& start,
                                        int frames);

/// Lets the fingers of a pinch be `depth`(t) in instead [m].
void press(PrintedProblem& pinch, const Scalar& depth);

/// Coefficients under which nothing slips.
inline constexpr Friction sticky{100, 100};

/// A run on planes and, as a variant, on voxels.
[[nodiscard]] std::vector<Run> on_both(const std::function<Run(Ground)>& run);

/// u = 2^-53: the largest relative error of one operation.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Every case of level L3 asserts exact maps from frame to frame, so that only rounding parts law and truth: places up
/// to `places` [m] are rounded four times a frame (phalanx, ray, anchor, their difference), which is compared with a
/// length `of` [m] that forces are made of; `gathered` frames' worth of it adds up. Relative.
[[nodiscard]] Limit rounding_limit(double places, double of, double gathered, const std::string& why);

/// Places up to `reach` [m] along a face, or where a ray meets the triangles of a voxel field: their corners, 1 m away.
[[nodiscard]] double places_on(Ground ground, double reach);

/// What a ray leaves: errors shrink by q a frame, so 1/(1 − q) frames' worth of them adds up.
[[nodiscard]] Limit ray_limit(Ground ground, const closed_form::PrintedFace& face, double reach, double lag);

/// A number of the discrete law, with the same limit for any engine that plays it.
[[nodiscard]] Claim printed_claim(const std::string& quantity, double truth, const std::string& source,
                                  const Measure& measure, const Limit& limit);

/// Yes (1) or no (0), or how many.
[[nodiscard]] Claim printed_count(const std::string& quantity, double truth, const std::string& source,
                                  const Measure& measure);

/// Body and truth of level L3, with its families' usual words left to fill in.
[[nodiscard]] Case printed_case(const std::string& id, const std::string& title);

}  // namespace handhold::catalogue
