// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/placement.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "cases/hand/placement_search.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/patch.hpp"

namespace handhold {
namespace {

constexpr double tick = 0.01;        // of the search for a start [s]
constexpr double clearance = 0.005;  // a phalanx farther than this has not come near yet [m]: above any contact offset
constexpr double longest_approach = 1;  // [s]

using Candidate = PlacementCandidate;

double depth_of(int phalanx, const HandMotion& motion, double t, const Pose& X_OW, const VoxelField& field) {
  return -nearest(motion.model().shape(phalanx), X_OW * motion.pose(phalanx, t), field).distance;
}

/// The search balances thumb and finger on the interpolated field; this does it to the last micrometre.
void balance(Candidate& c, const HandMotion& motion, const VoxelField& field) {
  const Grip grip = grip_at(motion, c.closing.finger, c.closing.begin);
  constexpr int most_steps = 20;  // oblique faces need them
  for (int i = 0; i < most_steps; ++i) {
    const Pose X_OW = c.X_WO.inverse();
    const double thumb = depth_of(last_phalanx(0), motion, grip.t, X_OW, field);
    const double finger = depth_of(last_phalanx(c.closing.finger), motion, grip.t, X_OW, field);
    c.X_WO.p += (thumb - finger) / 2 * grip.axis_W;
    if (std::abs(thumb - finger) < 1e-6) return;
  }
}

/// Depth of the deepest phalanx, < 0 if all are outside.
double deepest(const Candidate& c, double t, const HandMotion& motion, const VoxelField& field) {
  const Pose X_OW = c.X_WO.inverse();
  double depth = -std::numeric_limits<double>::infinity();
  for (int p = 0; p < phalanx_count; ++p) depth = std::max(depth, depth_of(p, motion, t, X_OW, field));
  return depth;
}

/// The last time before closure at which every phalanx is clear of the object; if there is none, when they are least
/// deep.
double find_start(const Candidate& c, const HandMotion& motion, const VoxelField& field, double lead, double& depth) {
  const auto& presence = motion.presence();
  const double closure = c.closing.begin;
  const auto holds = [&](const Interval& i) { return i.begin <= closure && closure <= i.end; };
  const double first = std::find_if(presence.begin(), presence.end(), holds)->begin;
  const double earliest = std::max(first, closure - longest_approach);
  double best = closure;
  depth = std::numeric_limits<double>::infinity();
  for (double t = closure; t >= earliest; t -= tick) {
    const double here = deepest(c, t, motion, field);
    if (here <= -clearance) {
      depth = here;
      return std::max(first, t - lead);
    }
    if (here < depth) depth = here, best = t;
  }
  return best;
}

std::vector<Touch> find_touches(const Candidate& c, const HandMotion& motion, const VoxelField& field) {
  std::vector<Touch> touches;
  const Pose X_OW = c.X_WO.inverse();
  for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
    const Nearest place = nearest(motion.model().shape(phalanx), X_OW * motion.pose(phalanx, c.closing.begin), field);
    if (place.distance < 0) touches.push_back({phalanx, -place.distance, c.X_WO.R * place.n_O});
  }
  return touches;
}

const Touch* find_touch(const Placement& placement, int phalanx) {
  for (const Touch& touch : placement.touches) {
    if (touch.phalanx == phalanx) return &touch;
  }
  return nullptr;
}

std::string notes(const Placement& placement, const PlacementOptions& options, double depth_at_start) {
  std::string note;
  const auto add = [&](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  if (depth_at_start > 0) add(fmt::format("the hand starts {:.1f} mm inside the object", 1e3 * depth_at_start));
  for (const Touch& touch : placement.touches) {
    const double most = touch.phalanx == palm ? options.palm_depth : options.most_depth;
    if (touch.depth > most) add(fmt::format("{} is {:.1f} mm deep", phalanx_name(touch.phalanx), 1e3 * touch.depth));
  }
  if (placement.excess > 0)
    add(fmt::format("the hand closes {:.1f} mm a side too far for the object", 1e3 * placement.excess));
  return note;
}

Placement describe(Candidate c, const HandMotion& motion, const VoxelField& field, const PlacementOptions& options) {
  balance(c, motion, field);
  Placement placement;
  placement.X_WO = c.X_WO;
  placement.closure = c.closing.begin;
  placement.held_until = c.closing.begin + options.hold;
  placement.until = c.closing.end;
  placement.finger = c.closing.finger;
  placement.thickness = c.place.thickness;
  placement.excess = c.excess;
  placement.margin = c.margin;
  placement.load = c.load;
  placement.cost = c.cost;
  placement.touches = find_touches(c, motion, field);
  double depth_at_start{};
  placement.start = find_start(c, motion, field, options.lead, depth_at_start);
  const Touch* thumb = find_touch(placement, last_phalanx(0));
  const Touch* finger = find_touch(placement, last_phalanx(c.closing.finger));
  if (thumb && finger) placement.opposition = -thumb->n_W.dot(finger->n_W);
  placement.note = notes(placement, options, depth_at_start);
  return placement;
}

}  // namespace

void validate(const PlacementOptions& options) {
  for (const double value :
       {options.depth, options.most_depth, options.palm_depth, options.hold, options.least_grip, options.lead}) {
    if (std::isfinite(value) && value >= 0) continue;
    throw InputError(fmt::format("placement option {}: must be finite and >= 0 (correct it)", value));
  }
  if (!(options.mu_static > 0))
    throw InputError(
        fmt::format("placement mu_static {}: must be > 0 (nothing holds without friction)", options.mu_static));
  if (options.depth > 0 && options.depth <= options.most_depth) return;
  throw InputError(fmt::format("placement depth {} m: must be > 0 and <= most_depth = {} m (correct it)", options.depth,
                               options.most_depth));
}

std::string Placement::report() const {
  std::string text = fmt::format("closes at {:.2f} s on {:.1f} mm:", closure, 1e3 * thickness);
  for (const Touch& touch : touches)
    text += fmt::format(" {} {:.1f} mm,", phalanx_name(touch.phalanx), 1e3 * touch.depth);
  text.back() = ';';
  text += fmt::format(" opposition {:.2f}", opposition);
  return note.empty() ? text : text + "; " + note;
}

Placements placements_in_hand(const Trace& trace, std::size_t hand, const VoxelField& field, std::size_t count,
                              const PlacementOptions& options) {
  validate(options);
  if (hand >= trace.hands.size()) {
    throw InputError(
        fmt::format("trace '{}' has {} hands: no hand {} (0 is the first)", trace.name, trace.hands.size(), hand));
  }
  const TraceSpline motion(trace, hand);
  const PlacementSearch search = search_placements(motion, field, options, count);
  Placements out{.poses = search.poses};
  for (const PlacementCandidate& c : search.best) {
    const Placement placement = describe(c, motion, field, options);
    if (placement.opposition > 0) out.ranked.push_back(placement);
  }
  if (!out.ranked.empty()) return out;
  const std::string thin =
      search.thinnest > 0
          ? fmt::format("the object is {:.1f} mm or more thick between opposite places", 1e3 * search.thinnest)
          : "the object has no opposite places within its reach";
  throw InputError(
      fmt::format("trace '{}': hand {} never closes on the object: thumb and finger come within {:.1f} mm "
                  "of each other, {} (place it by hand: --place x,y,z)",
                  trace.name, hand, 1e3 * search.narrowest, thin));
}

Placement place_in_hand(const Trace& trace, std::size_t hand, const VoxelField& field,
                        const PlacementOptions& options) {
  return placements_in_hand(trace, hand, field, 1, options).ranked.front();
}

Pose parse_placement(std::string_view text) {
  std::vector<double> v;
  const std::string given(text.substr(0, 80));
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("place '{}': {} (write x,y,z or x,y,z,qw,qx,qy,qz)", given, why));
  };
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    std::string_view field = text.substr(0, comma);
    while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
    while (!field.empty() && field.back() == ' ') field.remove_suffix(1);
    double value{};
    const auto [end, failed] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (failed != std::errc() || end != field.data() + field.size()) refuse("must be numbers with commas between");
    if (!std::isfinite(value)) refuse("must be finite");
    v.push_back(value);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  if (v.size() != 3 && v.size() != 7) refuse(fmt::format("must be 3 or 7 numbers, not {}", v.size()));
  Pose pose;
  pose.p = {v[0], v[1], v[2]};
  if (v.size() == 3) return pose;
  pose.R = Eigen::Quaterniond(v[3], v[4], v[5], v[6]);
  if (!(std::abs(pose.R.norm() - 1) <= 1e-3))
    refuse(fmt::format("the quaternion has norm {}, must be 1", pose.R.norm()));
  pose.R.normalize();
  return pose;
}

}  // namespace handhold
