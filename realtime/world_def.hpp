// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/model/body.hpp"
#include "cases/model/contact_parameters.hpp"
#include "cases/model/hand_model.hpp"
#include "cases/model/patch.hpp"

namespace handhold {
struct Scene;
}

namespace handhold::realtime {

/// A hand by its shape; where it is comes frame by frame.
struct HandDef {
  HandModel model{anatomical_hand()};
  std::vector<GivenPatch> given{};  ///< empty: patches are seeded where phalanges come near (WorldDef::patch)
};

/// What a World is made of. Poses and vectors in W, any axes that `gravity` fits; SI.
struct WorldDef {
  Eigen::Vector3d gravity{0, 0, -9.81};     ///< [m/s²]
  ContactParameters contact{};              ///< of hands with bodies
  ContactParameters body_contact{2e4, 20};  ///< of bodies with each other, per sample of `Body::samples_O`
  PatchOptions patch{};
  std::vector<Body> bodies{};    ///< 1 to 255; names are not needed
  std::vector<HandDef> hands{};  ///< at most 254
};

/// Throws InputError for what no World can be made of: no body, too many for a SampleId to name, values out of range.
void validate(const WorldDef& def);

/// A scene without what only moves its hands.
[[nodiscard]] WorldDef world_def_of(const Scene& scene);

}  // namespace handhold::realtime
