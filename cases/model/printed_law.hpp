// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace handhold::printed {

// What the print of Höll et al. 2018 leaves open or gets wrong, one switch each, with the passage and our reading.
// docs/paper.md tells what every choice does to a grasp.

/// Eq. 1 prints f = γ (C − p), which points out of the object when p is inside; section 3.3 applies it "to the object".
/// Figs. 2 and 4 and the text ("transfers the tangential motion of the hand onto the object") need the opposite.
enum class Sign {
  as_printed,   ///< f acts on the object: it is pulled towards the hand
  onto_object,  ///< f acts on the hand, −f on the object; the cone test of eq. 4 still takes the printed f
};

/// "p_j is the 3D centroid of the hand phalanx" (section 3.3): one index j, while the samples have the index i; but
/// "multiple contact points sampled on the surfaces of the hand and of the object" (section 3.2).
enum class Point {
  centroid,    ///< all samples of a patch pull on the phalanx's centroid
  per_sample,  ///< each on its own point of the phalanx
};

/// Eq. 4 calls f·n <= 0 "outside the cone", eq. 5 scales its tangent, and "the normal component of the contact force is
/// applied directly to the object" (section 3.3): also where it pulls.
enum class Gate {
  none,     ///< as printed: a contact whose p is outside pulls until its patch is dropped
  pushing,  ///< no force unless p is below the surface and f·n > 0
};

/// Eq. 5 outside the cone: "μ_dyn · f_t".
enum class SlipForce {
  scaled,  ///< as printed: μ_dyn times the spring's tangent, without any limit
  capped,  ///< Coulomb: μ_dyn N along the spring's tangent
};

/// When in a frame the anchor moves; section 3.5 does not say.
enum class Order {
  force_first,   ///< "O1": force from the anchor as it is, then the ray
  anchor_first,  ///< "O2": cone test, ray, then the force (in the mode just found) from the new anchor
};

/// Eq. 4 has no memory: a contact that slides is tested against μ_st in every frame.
enum class SlipState {
  memoryless,
  stateful,  ///< a contact that slipped in the last frame sticks again at |f_t| <= μ_dyn N
};

/// How a slipping anchor moves.
enum class AnchorUpdate {
  ray,   ///< section 3.5, Fig. 3: ray from C + ε n towards p, once a frame
  cone,  ///< none of the paper's: along the surface until the lag is Coulomb's μ_dyn d (the limit for every frame rate)
};

/// What a contact's anchor does while a gate holds its force back; the paper has no gate. Without one it never is
/// apart.
enum class ApartAnchor {
  stays,    ///< where it was made or last slipped to: a finger that comes down elsewhere has a lag at once
  follows,  ///< at the surface point closest to p, so that there is no lag at touch
};

/// The paper's law, once a frame. The defaults are what the authors must have run: the print with the sign put right
/// and pulling forbidden. Plain data.
struct Options {
  double stiffness{100};         ///< γ per sample [N/m], > 0 (section 3.3: "γ = 100", no unit)
  double damping{0};             ///< dashpot beside each spring [N s/m], >= 0; the paper has none
  double ray_offset{0.001};      ///< ε, "a small offset in normal direction" (section 3.5) [m], > 0
  double turned_away{1e-9};      ///< Fig. 3, R4 and R5: a hit with n_new·n_old at most this is occluded; −1 to 1
  double contact_offset{0.002};  ///< "Default Contact Offset" (section 3.5) [m], >= 0
  Sign sign{Sign::onto_object};
  Point point{Point::per_sample};
  Gate gate{Gate::pushing};
  SlipForce slip_force{SlipForce::scaled};
  Order order{Order::force_first};
  SlipState slip_state{SlipState::memoryless};
  AnchorUpdate anchor_update{AnchorUpdate::ray};
  ApartAnchor apart_anchor{ApartAnchor::follows};
};

/// Throws InputError for the first number out of its range.
void validate(const Options& options);

/// Eq. 1 to 5 to the letter: printed sign, one centroid a phalanx, no gate.
[[nodiscard]] Options as_printed();

/// The convergent element of docs/contact-law.md, evaluated explicitly once a frame: own points, gated, capped, with a
/// slip flag and the anchor at Coulomb's lag.
[[nodiscard]] Options coulomb();

}  // namespace handhold::printed
