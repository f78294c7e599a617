// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/grasp_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

std::string hold_text(const compare::GraspSummary& s) {
  switch (s.hold) {
    case compare::Hold::held:
      return fmt::format("held to the end, {} by the hand alone, drifted {}", readable(s.carried, "s"),
                         readable(s.drift, "m"));
    case compare::Hold::slipped:
      return fmt::format("in the hand to the end, but slipped: drifted {}", readable(s.drift, "m"));
    case compare::Hold::dropped:
      return s.dropped_at ? fmt::format("carried by the hand alone for {}, dropped: last contact ends at t = {} s",
                                        readable(s.carried, "s"), number(*s.dropped_at, 4))
                          : "dropped";
    case compare::Hold::never_touched:
      return "the hand never touched the object";
  }
  return "";
}

std::string frames_text(const compare::FrameTimes& f) {
  return fmt::format("p50 {}, p90 {}, p99 {}, p99.9 {}, max {} CPU time, {} frames", readable(f.p50, "s"),
                     readable(f.p90, "s"), readable(f.p99, "s"), readable(f.p999, "s"), readable(f.max, "s"), f.frames);
}

std::string frozen_text(const compare::DrawnHand& hand, double end) {
  if (hand.frozen.empty()) return "never: it followed the tracked hand throughout";
  std::string stretches;
  double total = 0;
  for (const Interval& i : hand.frozen) {
    stretches += fmt::format("{}{} to {} s", stretches.empty() ? "" : ", ", number(i.begin, 4), number(i.end, 4));
    total += i.end - i.begin;
  }
  return fmt::format("{} s of {} s: {}", number(total, 4), number(end, 4), stretches);
}

std::string deepest_text(const compare::Deepest& deepest) {
  if (deepest.phalanx < 0) return "never inside";
  return fmt::format("{} ({} at t = {} s)", readable(deepest.depth, "m"), phalanx_name(deepest.phalanx),
                     number(deepest.t, 4));
}

std::string drawn_hand_text(const compare::DrawnHand& hand, double end, double bound) {
  std::string out = summary_line("frozen", frozen_text(hand, end));
  out += summary_line("deepest phalanx", "drawn " + deepest_text(hand.drawn));
  out += summary_line("", "tracked " + deepest_text(hand.tracked));
  out += summary_line("bound", fmt::format("{}: {}", readable(bound, "m"), hand.bound_kept ? "kept" : "NOT KEPT"));
  if (hand.release_step <= 0) return out + summary_line("release", "none");
  out += summary_line("release", fmt::format("at most {} a frame, where the tracked phalanx went {}",
                                             readable(hand.release_step, "m"), readable(hand.tracked_step, "m")));
  return out + summary_line("", fmt::format("largest jump {}: the change of that way from one frame to the next",
                                            readable(hand.release_jump, "m")));
}

/// Where the law has no unique continuation.
std::string undecided_text(const Recording& recording) {
  const Ambiguity& first = recording.ambiguities.front();
  const std::string who = first.id.belongs_to_body()
                              ? "body '" + recording.body_names[first.id.phalanx] + "'"
                              : fmt::format("hand {} {}", int(first.id.hand), phalanx_name(first.id.phalanx));
  return fmt::format("{} times by the law, first at t = {} s: {} sample {} {}", recording.ambiguities.size(),
                     number(first.t, 4), who, int(first.id.sample), first.what);
}

}  // namespace

std::string grasp_text(const compare::GraspSummary& s, const Recording& recording, double seconds) {
  const double end = recording.frames.empty() ? 0 : recording.frames.back().t;
  std::string out = recording.engine + "\n";
  out += summary_line("run", fmt::format("{}: {} frames, {} s simulated in {}", to_string(recording.outcome),
                                         recording.frames.size(), number(end, 4), readable(seconds, "s")));
  if (!recording.note.empty()) out += summary_line("", recording.note);
  out += summary_line("object", hold_text(s));
  out += summary_line("samples",
                      fmt::format("{} touches, {} slips begun, {} ended, {} releases; at most {} phalanges at once",
                                  s.touches, s.breakaways, s.resticks, s.releases, s.phalanges_in_contact));
  out += summary_line("longest slip", readable(s.slip_distance, "m") + " of one anchor on the object");
  out += summary_line("deepest sample", readable(s.max_depth, "m"));
  out += summary_line("energy", readable(s.energy_unexplained, "J") + " unexplained at most");
  const auto substeps = recording.provenance.find("sub-steps a frame");
  if (substeps != recording.provenance.end()) out += summary_line("sub-steps", substeps->second + " a frame");
  if (s.frame.frames > 0) out += summary_line("frame", frames_text(s.frame));
  const auto surface = recording.provenance.find("surface");
  if (surface != recording.provenance.end()) out += summary_line("surface", surface->second);
  if (!recording.ambiguities.empty()) out += summary_line("undecided", undecided_text(recording));
  const auto unconverged = recording.provenance.find("unconverged_substeps");
  if (unconverged != recording.provenance.end())
    out += summary_line("warning", unconverged->second + " sub-steps did not converge");
  return out;
}

std::string horizon_text(const compare::Horizon& h) {
  const std::string aside = readable(compare::horizon_shift, "m"), fork = readable(compare::horizon_fork, "m");
  return summary_line("horizon",
                      h.forks ? fmt::format("this answer means something until t = {} s: started {} aside it is more "
                                            "than {} elsewhere after that",
                                            number(h.t, 4), aside, fork)
                              : fmt::format("this answer means something to the end: started {} aside it is never more "
                                            "than {} elsewhere",
                                            aside, readable(h.apart, "m")));
}

std::string difference_text(const compare::Difference& d, double until) {
  std::string out = fmt::format("reference and real time, until t = {} s\n", number(until, 4));
  out += summary_line("apart", fmt::format("at most {} and {} degrees, {} rms", readable(d.max_translation, "m"),
                                           number(d.max_rotation * 180 / M_PI, 3), readable(d.rms_translation, "m")));
  out += summary_line("same mode", std::isnan(d.mode_agreement)
                                       ? "no sample stands in both"
                                       : fmt::format("{:.1f} % of samples and frames", 100 * d.mode_agreement));
  return out + summary_line("more than 1 mm", std::isnan(d.first_divergence)
                                                  ? "never"
                                                  : fmt::format("from t = {} s", number(d.first_divergence, 4)));
}

std::string drawn_hands_text(const compare::DrawnHands& drawn) {
  std::string out;
  const double end = drawn.trace.t.empty() ? 0 : drawn.trace.t.back();
  for (std::size_t h = 0; h < drawn.hands.size(); ++h) {
    out += fmt::format("drawn hand, {}\n", to_string(drawn.trace.hands[h].side));
    out += drawn_hand_text(drawn.hands[h], end, drawn.bound);
  }
  return out;
}

}  // namespace handhold::reports
