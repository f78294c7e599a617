// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/hand/placement.hpp"
#include "compare/engine/engine.hpp"

namespace handhold::compare {

/// What an object does in a recorded grasp, from the support's end to the end of the grasp.
struct GraspTrial {
  bool held{};          ///< in touch to the end of the grasp, and its grip point stays within `most_drift`
  double carried{};     ///< by the hand alone [s]
  double asked{};       ///< from the support's end to the end of the grasp [s]
  double drift{};       ///< farthest that what was between thumb and finger went from there, while carried [m]
  double turned{};      ///< largest turn in the palm's frame, while carried [rad]
  double unevenness{};  ///< spread of the pressing samples' depth over its mean, mean over the frames carried
  double weight{};      ///< [N]
  double strength{};  ///< what the grip could carry against gravity at its pressure, least over the frames carried [N]
  double fastest{};   ///< motion of the object on its grip (substeps.hpp) [rad/s]
  int substeps{};     ///< a frame, with which it was played
  double load{};      ///< largest |m (a - g)| of the palm's motion while asked to carry [N]
  long steps{};       ///< of the engine, in all
};

/// Farther than this the object has left the grip, even if a finger still touches it [m]: a finger's breadth.
inline constexpr double most_drift = 0.02;

/// Judges a recording of a scene with one body in one hand that grasps by thumb and `finger` until `until` [s of the
/// scene].
[[nodiscard]] GraspTrial judge_grasp(const Scene& scene, const Recording& recording, int finger, double until);

/// An object that wants a place in a recorded hand.
struct PlacingRequest {
  const Trace* trace{};
  std::size_t hand{};
  Body body{};                  ///< all but where it is and until when it is held up
  ContactParameters contact{};  ///< unless `contact_of` says better
  std::function<ContactParameters(const Placement&)> contact_of{};  ///< what suits a grip; empty: `contact`
  EngineOptions engine{};
  bool choose_substeps{true};  ///< as many sub-steps as the grip needs (substeps.hpp), at least those of `engine`
  std::size_t tried{24};       ///< the best so many of the ranked placements are played, >= 1
  PlacementOptions placement{};
};

struct TriedPlacement {
  Placement placement{};
  ContactParameters contact{};
  GraspTrial trial{};
};

/// What would hold where nothing does, each found by playing it: doubled or halved until it holds, six times at most.
struct Remedy {
  std::optional<double> stiffness{};  ///< of a sample [N/m]
  std::optional<double> mass{};       ///< [kg]
};

struct Placing {
  std::vector<TriedPlacement> tried{};  ///< the winner first
  long poses{};                         ///< looked at
  long steps{};                         ///< played, all trials together
  std::optional<Remedy> remedy{};       ///< where the winner does not hold
};

/// The scene of a placement: t = 0 is Placement::start of the trace; it ends with the hand's presence.
[[nodiscard]] Scene scene_of(const PlacingRequest& request, const Placement& placement,
                             const ContactParameters& contact);

/// Tries the best placements that geometry and statics offer with `engine`, on all cores, for the length of the
/// recorded grasp. The winner holds to its end, or else holds longest; among those that hold the one that costs least:
/// all that is unwanted of its pose, as metres, and how far it drifts and turns in the hand. The same for any number
/// of cores. Throws InputError if the hand never closes on the object.
[[nodiscard]] Placing place_by_trial(const PlacingRequest& request, const Engine& engine);

}  // namespace handhold::compare
