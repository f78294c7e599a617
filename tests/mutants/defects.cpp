// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mutants/defects.hpp"

namespace handhold::mutants {

const std::vector<Defect>& all_defects() {
  static const std::vector<Defect> defects{
      // Contact of the real-time path
      {"stale_normal", "an anchor that slid keeps its old normal", {"H07", "H08"}, ""},
      {"anchor_kept_through_slide",
       "an anchor stays behind while its sample slides, and pulls it back",
       {"C03", "C01"},
       ""},
      {"first_touch_at_mu_d", "a first touch slips although it is inside the static cone", {"H09"}, ""},
      {"breaks_away_at_mu_d", "sticking ends at the dynamic coefficient", {"C04", "C01"}, ""},
      {"damper_pushes_before_touch",
       "a damper pushes before the surface is reached",
       {"D13", "H09", "H10"},
       "SlidingBlock*"},
      {"pair_friction_of_one", "two bodies have the friction of the touched one", {"H01"}, ""},
      {"pair_ignores_spin", "bodies that spin towards each other are not looked at", {"H06"}, ""},
      {"own_fall_unforeseen", "a corner's prediction ignores its own body's fall", {"H05"}, ""},
      {"slip_warms_nothing", "the work of friction is lost", {"C03", "G03"}, "Bodies.*"},
      {"damper_warms_nothing", "a damper's work is lost while it slides", {"C06", "C03"}, "Bodies.*"},
      {"lost_spring_keeps_its_energy", "what lets go takes its spring's energy along", {"D02", "G05"}, "Bodies.*"},
      // Bodies of the real-time path
      {"support_turns_freely", "a support does not brake turning", {"H10"}, ""},
      {"oil_warms_nothing", "the work of a support is lost", {"H10"}, "Bodies.*"},
      {"load_gives_nothing", "the work of a load is lost", {"C04", "C05"}, "Bodies.*"},
      {"weighs_a_thousandth_more", "gravity is a thousandth too strong", {"A01", "C01"}, ""},
      {"free_spin_drifts", "a free spin gains energy", {"A01"}, "Bodies.AFreeBody*"},
      {"damping_of_one_sample", "automatic damping is wrong by the root of the samples", {}, "Gamma.TheDamping*"},
      {"thrown_by_its_origin", "a baseline throws a body with the velocity of its origin", {}, "Baselines.AThrown*"},
      // Reference
      {"reference_first_touch_at_mu_d", "a first touch slips although it is inside the static cone", {"H09"}, ""},
      {"reference_breaks_away_at_mu_d", "sticking ends at the dynamic coefficient", {"C04", "C01"}, ""},
      {"reference_damped_slides_at_mu_s", "damped sliding has the static coefficient", {"C06", "C03"}, "DampedSlip*"},
      {"reference_ignores_curvature",
       "an anchor that slides takes its surface for flat",
       {"H07", "H08"},
       "SpringSlip*"},
      {"reference_damper_warms_nothing", "a damper's work is lost while it sticks", {"C06", "C04"}, "Stick.*"},
      {"reference_pair_friction_of_one", "two bodies have the friction of the touched one", {"H01"}, ""},
      {"reference_support_turns_freely", "a support does not brake turning", {"H10"}, ""},
      {"release_is_no_break", "the end of a support is stepped over", {"H10", "D01"}, "Breaks*"},
      {"wedge_or", "a hollow edge pushes outside its arc", {}, "Wedge*"},
      // Rigid bodies
      {"incipient_slip_unaligned", "a slip that begins is not turned against its own friction", {}, "IncipientSlip*"},
      {"blow_without_friction", "a blow has no friction", {"L1-B02"}, ""},
      {"blow_sticks_at_mu_d", "a blow slips although it is inside the static cone", {"L1-B02"}, ""},
      {"half_of_coriolis", "a turning surface has half of Coriolis's force", {"L1-C11", "L1-C12"}, "ContactPoint*"},
      {"ball_touches_at_its_centre", "a ball's friction has no arm", {"L1-E01", "L1-E02"}, ""},
      {"ball_rolls_on_a_plane",
       "a ball's point of contact does not move with the bend of the surface",
       {"L1-E05", "L1-E06", "L1-E07"},
       "ContactPoint*"},
      // Truth
      {"swapped_top", "cn for dn where the spin is about the small axis", {}, "AsymmetricTop*"},
      {"incline_holds_at_mu_d", "an incline holds up to the dynamic coefficient", {"L1-C01", "C01"}, ""},
      {"incline_slides_at_mu_s", "what slides down an incline has the static coefficient", {"L1-C01", "C01"}, ""},
      {"opening_pinch_third", "the fall out of an opening pinch has a half for a third", {"D02", "L1-D02"}, ""},
      {"pinch_forgets_the_lift", "a lift lightens what is pinched", {"L1-D01", "D01"}, "Pinch.*"},
      {"flight_up_only", "a bounce lasts half as long", {"H04"}, ""},
      {"stack_slips_below", "a stack slips at the palm whichever friction is smaller", {"H02"}, ""},
      {"plastic_strike", "the struck block takes half the kick", {"H03"}, ""},
      // Input
      {"webxr_tips_swapped", "the tips of thumb and index finger are swapped", {}, "RealRecording*"},
      {"leap_in_centimetres", "a LeapJS recording is read in centimetres", {}, "LeapReader.ReadsARawFrame"},
      {"centre_of_mass_a_fifth_off", "a mesh's centre of mass is a fifth off", {}, "MassProperties*"},
      {"inertia_about_the_box", "a mesh's inertia is about the middle of its box", {}, "MassProperties*"},
      // Judge
      {"unwrapped_by_pi", "a turn of more than a quarter a frame is lost", {}, "Measures.Unwrap*"},
      {"held_100_mm_too_far", "what slid 100 mm counts as held", {}, "Measures.Holds*"},
      {"first_event_always", "the second touch is looked for and the first is taken", {"H04", "C05"}, ""},
      {"nan_passes", "a number that is none passes", {}, "Gate.*"},
      {"vacuous_unseen", "no gate is ever vacuous", {}, "Gate.*"},
      {"relative_judged_absolute", "a relative error is judged as an absolute one", {"H04", "H05"}, "Judge.*"},
      {"limit_of_the_frame", "limits follow the frame, not the sub-step", {}, "Judge.*"},
      {"studies_skipped", "order studies are never run", {}, "Suite.Studies*"},
      {"suite_drops_the_last", "the last case is not shown", {}, "Suite.Runs*"},
      {"printed_cases_dropped", "the cases of the printed law are not in the catalogue", {}, "Ratchet*"},
      {"controlled_limit_times_1e4",
       "the limit of engines that control their error is 10^4 times too wide",
       {},
       "Ratchet*"},
      {"event_limit_plus_5", "an event may be five sub-steps late", {}, "Ratchet*"},
      {"euler_limit_times_10", "Euler's bias may be ten times as large", {}, "Ratchet*"},
      // Verdict and reports
      {"one_failure_passes", "one failed gate reads \"Passed\"", {}, "OneFailure*"},
      {"nothing_passes", "a suite that judged nothing passes", {}, "Suite.GradesAForeign*"},
      {"vacuous_unsaid", "the last line is silent about vacuous gates", {}, "Verdict.*"},
      {"not_asked_uncounted", "what was not asked is not counted", {}, "ResultsJson.*"},
      {"junit_counts_no_failure", "JUnit says failures=\"0\"", {}, "Junit.*"},
      {"junit_counts_no_skip", "JUnit says skipped=\"0\"", {}, "Junit.*"},
  };
  return defects;
}

}  // namespace handhold::mutants
