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

#include "cases/hand/grasp_places.hpp"
#include "cases/hand/grip.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "cases/model/patch.hpp"

namespace handhold {
namespace {

constexpr double tick = 0.005;       // of the search for closings [s]: half a frame of the slowest trackers
constexpr double clearance = 0.005;  // a phalanx farther than this has not come near yet [m]: above any contact offset
constexpr double longest_approach = 1;    // [s]
constexpr double longest_search = 3600;   // of presence [s]: memory, and a wrong unit of time shows here
constexpr int surface_points = 1500;      // a few a square centimetre of a mug
constexpr std::size_t most_places = 80;   // tried in full
constexpr double least_distance = 0.015;  // between places that are tried: nearer ones fare alike [m]
constexpr int rolls = 24;                 // about the line from thumb to finger
constexpr double pi = 3.14159265358979323846;

// Weights of the search, as metres of unwanted depth.
constexpr double lever_weight = 0.05;    // a place 1 cm off the centre of volume is as bad as 0.5 mm
constexpr double tilt_weight = 0.001;    // upside down is as bad as 2 mm
constexpr double oblique_weight = 0.01;  // opposition 0.8 is as bad as 2 mm
constexpr double unwanted_weight =
    3;  // of each: beyond the radius, the finger's bone is inside, and which side it touches is chance
constexpr double approach_weight = 0.5;  // of the depth that phalanges pass through on their way

/// What the search knows of the hand: its motion, and its grip over time with every finger.
struct Reach {
  const HandMotion& motion;
  std::vector<std::vector<Grip>> grips;  // one for each finger and interval of presence
  std::vector<int> finger;               // of each
};

struct Candidate {
  GraspPlace place;
  Closing closing;
  double excess{};
  double cost{std::numeric_limits<double>::infinity()};
  Pose X_WO{};
};

Reach look_at(const HandMotion& motion) {
  double present_for = 0;
  for (const Interval& present : motion.presence()) present_for += present.end - present.begin;
  if (!(present_for <= longest_search)) {
    throw InputError(
        fmt::format("trace: the hand is there for {:g} s, at most {:g} s are searched for a grasp (check "
                    "the unit of time, cut the trace, or place the object by hand: --place x,y,z)",
                    present_for, longest_search));
  }
  Reach reach{motion, {}, {}};
  for (const Interval& present : motion.presence()) {
    for (int finger = 1; finger <= 4; ++finger) {
      reach.grips.push_back(sample_grips(motion, finger, present, tick));
      reach.finger.push_back(finger);
    }
  }
  return reach;
}

double widest_grip(const Reach& reach) {
  double widest = 0;
  for (const auto& grips : reach.grips) {
    for (const Grip& grip : grips) widest = std::max(widest, grip.gap);
  }
  return widest;
}

/// The closing on something `thickness` thick that lasts longest; the fingers next to the thumb count for more, since
/// people grasp with them and the outer ones come along.
std::optional<Closing> best_closing(const Reach& reach, double thickness, const PlacementOptions& options) {
  constexpr std::array<double, 5> weight{0, 1, 0.9, 0.6, 0.4};
  std::optional<Closing> best;
  double longest = 0;
  for (std::size_t i = 0; i < reach.grips.size(); ++i) {
    const double closed = thickness - 2 * options.depth;
    for (const Closing& closing : find_closings(reach.grips[i], reach.finger[i], closed, thickness)) {
      const double lasting = closing.end - closing.begin;
      if (lasting < options.least_grip || weight[closing.finger] * lasting <= longest) continue;
      longest = weight[closing.finger] * lasting;
      best = closing;
    }
  }
  return best;
}

double depth_of(int phalanx, const HandMotion& motion, double t, const Pose& X_OW, const VoxelField& field) {
  return -nearest(motion.model().shape(phalanx), X_OW * motion.pose(phalanx, t), field).distance;
}

/// Cost of the pose at one time but for thumb and finger: depth beyond what is wanted, summed over the phalanges.
double unwanted_depth(const Candidate& c, double t, const HandMotion& motion, const VoxelField& field,
                      const PlacementOptions& options) {
  const Pose X_OW = c.X_WO.inverse();
  double sum = 0;
  for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
    const double wanted = phalanx == palm ? options.palm_depth : options.most_depth;
    sum += std::max(0.0, depth_of(phalanx, motion, t, X_OW, field) - wanted);
  }
  return sum;
}

/// Moves the object along the line from thumb to finger until both are as deep in it; returns how far that depth is
/// from the one aimed at, plus what is left of the difference.
double balance(Candidate& c, const Grip& grip, const HandMotion& motion, const VoxelField& field, double aimed) {
  constexpr int steps = 3;  // flat faces need one, curved ones converge quadratically
  double thumb = 0, finger = 0;
  for (int i = 0; i <= steps; ++i) {
    const Pose X_OW = c.X_WO.inverse();
    thumb = depth_of(last_phalanx(0), motion, grip.t, X_OW, field);
    finger = depth_of(last_phalanx(c.closing.finger), motion, grip.t, X_OW, field);
    if (i < steps) c.X_WO.p += (thumb - finger) / 2 * grip.axis_W;
  }
  return std::abs(thumb - aimed) + std::abs(finger - aimed);
}

/// Least rotation that takes unit vector a to b. (Eigen's FromTwoVectors brings an SVD along: 8 s of compile time.)
Eigen::Quaterniond least_turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double cosine = a.dot(b);
  Eigen::Quaterniond q;
  q.w() = 1 + cosine;  // the half-way quaternion, before normalisation
  q.vec() = a.cross(b);
  if (q.w() < 1e-9) {  // opposite: half a turn about any normal
    q.w() = 0;
    q.vec() = a.unitOrthogonal();
  }
  return q.normalized();
}

/// The object turned so that `n_O` points to the thumb, then by `roll` about that line, its place in the middle of the
/// grip.
Pose lay(const GraspPlace& place, const Eigen::Vector3d& n_O, const Grip& grip, double roll) {
  const Eigen::Quaterniond least = least_turn(n_O, -grip.axis_W);
  const Eigen::Quaterniond R = (Eigen::AngleAxisd(roll, grip.axis_W) * least).normalized();
  return {R, grip.middle_W - R * place.center_O};
}

/// What a place costs before its orientation is known.
double place_cost(const GraspPlace& place, double excess, const Eigen::Vector3d& center) {
  return excess + lever_weight * (place.center_O - center).norm() + oblique_weight * (1 - place.opposition);
}

std::vector<Candidate> choose_places(const Reach& reach, const VoxelField& field, const PlacementOptions& options) {
  const Eigen::Vector3d center = solid_properties(field.mesh()).center;
  std::vector<Candidate> all;
  for (const GraspPlace& place : find_grasp_places(field, widest_grip(reach), surface_points)) {
    const std::optional<Closing> closing = best_closing(reach, place.thickness, options);
    if (!closing) continue;
    const double excess = std::max(0.0, (place.thickness - closing->mean_gap) / 2 - options.most_depth);
    all.push_back({place, *closing, excess, place_cost(place, excess, center), {}});
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<Candidate> chosen;
  for (const Candidate& c : all) {
    const auto is_near = [&](const Candidate& other) {
      return (other.place.center_O - c.place.center_O).norm() < least_distance &&
             std::abs(other.place.n_O.dot(c.place.n_O)) > 0.9;
    };
    if (std::none_of(chosen.begin(), chosen.end(), is_near)) chosen.push_back(c);
    if (chosen.size() == most_places) break;
  }
  return chosen;
}

/// Depth of the phalanges on their way in: what passes through the object could touch its far side.
double approach_cost(const Candidate& c, const HandMotion& motion, const VoxelField& field,
                     const PlacementOptions& options) {
  double worst = 0;
  for (const double before : {0.03, 0.06, 0.1, 0.15, 0.2}) {
    worst = std::max(worst, unwanted_depth(c, c.closing.begin - before, motion, field, options));
  }
  return worst;
}

/// The best of 48 orientations of one place; its cost is infinite if none is better than `to_beat`.
Candidate turn(const Candidate& c, double to_beat, const Reach& reach, const VoxelField& field,
               const PlacementOptions& options) {
  const Grip grip = grip_at(reach.motion, c.closing.finger, c.closing.begin);
  Candidate best = c;
  best.cost = to_beat;
  for (int k = 0; k < 2 * rolls; ++k) {
    Candidate turned = c;
    const Eigen::Vector3d n_O = k < rolls ? c.place.n_O : Eigen::Vector3d(-c.place.n_O);
    turned.X_WO = lay(c.place, n_O, grip, 2 * pi * k / rolls);
    turned.cost += tilt_weight * (1 - (turned.X_WO.R * Eigen::Vector3d::UnitZ()).z());
    turned.cost += balance(turned, grip, reach.motion, field, options.depth);
    if (turned.cost >= best.cost) continue;
    turned.cost += unwanted_weight * unwanted_depth(turned, grip.t, reach.motion, field, options);
    if (turned.cost >= best.cost) continue;
    turned.cost += approach_weight * approach_cost(turned, reach.motion, field, options);
    if (turned.cost < best.cost) best = turned;
  }
  if (best.cost >= to_beat) best.cost = std::numeric_limits<double>::infinity();
  return best;
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
double find_start(const Candidate& c, const Reach& reach, const VoxelField& field, double lead, double& depth) {
  const auto& presence = reach.motion.presence();
  const double closure = c.closing.begin;
  const auto holds = [&](const Interval& i) { return i.begin <= closure && closure <= i.end; };
  const double first = std::find_if(presence.begin(), presence.end(), holds)->begin;
  const double earliest = std::max(first, closure - longest_approach);
  double best = closure;
  depth = std::numeric_limits<double>::infinity();
  for (double t = closure; t >= earliest; t -= 2 * tick) {
    const double here = deepest(c, t, reach.motion, field);
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

Placement describe(const Candidate& c, const Reach& reach, const VoxelField& field, const PlacementOptions& options) {
  Placement placement;
  placement.X_WO = c.X_WO;
  placement.closure = c.closing.begin;
  placement.held_until = c.closing.begin + options.hold;
  placement.finger = c.closing.finger;
  placement.thickness = c.place.thickness;
  placement.excess = c.excess;
  placement.touches = find_touches(c, reach.motion, field);
  double depth_at_start{};
  placement.start = find_start(c, reach, field, options.lead, depth_at_start);
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

Placement place_in_hand(const Trace& trace, std::size_t hand, const VoxelField& field,
                        const PlacementOptions& options) {
  validate(options);
  if (hand >= trace.hands.size()) {
    throw InputError(
        fmt::format("trace '{}' has {} hands: no hand {} (0 is the first)", trace.name, trace.hands.size(), hand));
  }
  const TraceSpline motion(trace, hand);
  const Reach reach = look_at(motion);
  Candidate best;
  for (const Candidate& place : choose_places(reach, field, options)) {
    const Candidate turned = turn(place, best.cost, reach, field, options);
    if (turned.cost < best.cost) best = turned;
  }
  if (std::isfinite(best.cost)) {
    const Placement placement = describe(best, reach, field, options);
    if (placement.opposition > 0) return placement;
  }
  throw InputError(fmt::format("trace '{}': hand {} never closes on the object (place it by hand: --place x,y,z)",
                               trace.name, hand));
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
