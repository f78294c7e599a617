// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/model/hand_motion.hpp"
#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::compare {

/// What stands still on the object at a touch: the whole hand, or the fingers that touch (Höll et al. 2018, section
/// 3.4).
enum class DrawnMode { whole, finger };

/// The deepest that any phalanx of a hand was in any body at the end of a frame.
struct Deepest {
  double depth{};   ///< of its skin [m]; 0 if none was inside, and the rest then means nothing
  int phalanx{-1};  ///< which
  double t{};       ///< when [s]
};

/// One hand's figures over a recording.
struct DrawnHand {
  std::vector<Interval> frozen{};  ///< some phalanx stood on a body: from the first frame that has it so to the first
                                   ///< that does not, or the last of all [s]
  Deepest drawn{}, tracked{};
  bool bound_kept{};      ///< to the µm that a phalanx's depth is found to
  double release_step{};  ///< longest way of a drawn phalanx between two frames while it glides back [m]
  double tracked_step{};  ///< the way of the same tracked phalanx between the same two frames [m]
  /// Largest difference between two successive ways of a drawn phalanx, as vectors, while it glides back [m]: what
  /// remains of a long way if the object took the hand along, and all of a way that is a jump.
  double release_jump{};
};

/// The drawn hands beside a recording.
struct DrawnHands {
  Trace trace{};                   ///< the hands of the scene as drawn, one stamp a frame; W, lost where absent
  std::vector<DrawnHand> hands{};  ///< in the order of the scene
  double bound{};                  ///< no drawn phalanx was to be deeper than this [m]
};

/// Throws InputError if the scene has no hand to draw: none at all, or one of prescribed samples that has no shape.
void check_drawable(const Scene& scene);

/// Plays the real-time path's drawn hand (realtime/visual_hand.hpp) on the scene's hands and the recorded bodies, frame
/// by frame, and moves what is deeper than `bound` [m] out of them. A phalanx touches the body it is deepest in, and
/// none if its skin is outside all. Ends before a frame whose bodies are not finite. Throws as check_drawable does.
[[nodiscard]] DrawnHands draw_hands(const Scene& scene, const Recording& recording, DrawnMode mode,
                                    double bound = 0.0005);

}  // namespace handhold::compare
