// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/placement_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cases/hand/grip_strength.hpp"
#include "cases/hand/phalanx_depth.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

constexpr double tick = 0.005;            // of the search for closings [s]: half a frame of the slowest trackers
constexpr double longest_search = 3600;   // of presence [s]: memory, and a wrong unit of time shows here
constexpr int surface_points = 1500;      // a few a square centimetre of a mug
constexpr std::size_t most_places = 80;   // whose orientations are looked at
constexpr double least_distance = 0.015;  // between places that are tried: nearer ones fare alike [m]
constexpr double least_turn_apart = 0.6;  // between orientations of one place [rad]: so do these
constexpr int rolls = 12;                 // about the line from thumb to finger
constexpr std::array offsets{0.0, 0.008, 0.016};  // of the place from there towards the palm [m]: how deep in the hand
constexpr int closings_each = 2;                  // of a place: the longest

// What is unwanted, as metres of unwanted depth.
constexpr double excess_weight = 0.5;    // a thick object is taken deeply on both sides alike, which holds it
constexpr double lever_weight = 0.15;    // a place 1 cm off the centre of volume is as bad as 1.5 mm
constexpr double enclosed_cost = 0.015;  // the wall of a cup, with a finger inside it
constexpr double narrow_cost = 0.03;     // the rim of a cup, the edge of a card
constexpr double tilt_weight = 0.001;    // upside down is as bad as 2 mm
constexpr double oblique_weight = 0.01;  // opposition 0.8 is as bad as 2 mm
constexpr double astray_weight = 0.02;   // a finger round an edge, on a face at right angles, is as bad as 2 cm
constexpr double weak_weight = 0.006;    // a grip without margin is as bad as 12 mm ...
constexpr double enough_margin = 2;      // ... and one with this margin is not improved by more
constexpr double unwanted_weight =
    3;  // beyond the radius the finger's bone is inside, and which side it touches is chance
constexpr double approach_weight = 0.5;  // of the depth that phalanges pass through on their way

constexpr std::array before_closure{0.03, 0.06, 0.1, 0.15, 0.2};  // [s]
constexpr std::array shares_of_grasp{0.1, 0.3, 0.5, 0.7, 0.9};

using HandPoses = std::array<Pose, phalanx_count>;

HandPoses poses_at(const HandMotion& motion, double t) {
  HandPoses X_WP;
  for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) X_WP[phalanx] = motion.pose(phalanx, t);
  return X_WP;
}

/// The palm's acceleration by central differences over `tick` [m/s²].
Eigen::Vector3d acceleration(const HandMotion& motion, double t) {
  const double h = 4 * tick;  // 20 ms: over two frames of a tracker, so that its noise is not taken for motion
  return (motion.pose(palm, t - h).p - 2 * motion.pose(palm, t).p + motion.pose(palm, t + h).p) / (h * h);
}

/// What the search knows of the hand: its grip over time with every finger.
struct Reach {
  std::vector<std::vector<Grip>> grips{};  // one for each finger and interval of presence
  std::vector<int> finger{};               // of each
  double widest{}, narrowest{infinity};
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
  Reach reach;
  for (const Interval& present : motion.presence()) {
    for (int finger = 1; finger <= 4; ++finger) {
      reach.grips.push_back(sample_grips(motion, finger, present, tick));
      reach.finger.push_back(finger);
      for (const Grip& grip : reach.grips.back()) {
        reach.widest = std::max(reach.widest, grip.gap);
        reach.narrowest = std::min(reach.narrowest, grip.gap);
      }
    }
  }
  return reach;
}

/// The closings on something `thickness` thick that last longest, `depth` deep a side; the fingers next to the thumb
/// count for more, since people grasp with them and the outer ones come along.
std::vector<Closing> longest_closings(const Reach& reach, double thickness, double depth, double least_grip) {
  constexpr std::array<double, 5> weight{0, 1, 0.9, 0.6, 0.4};
  std::vector<Closing> found;
  for (std::size_t i = 0; i < reach.grips.size(); ++i)
    for (const Closing& closing : find_closings(reach.grips[i], reach.finger[i], thickness - 2 * depth, thickness))
      if (closing.end - closing.begin >= least_grip) found.push_back(closing);
  std::stable_sort(found.begin(), found.end(), [&](const Closing& a, const Closing& b) {
    return weight[a.finger] * (a.end - a.begin) > weight[b.finger] * (b.end - b.begin);
  });
  if (found.size() > closings_each) found.resize(closings_each);
  return found;
}

/// Half the depth as long as the hand does not close so far on something so thin, five times at most.
std::vector<Closing> closings_on(const Reach& reach, double thickness, const PlacementOptions& options, double& depth) {
  for (depth = options.depth; depth > options.depth / 20; depth /= 2) {
    std::vector<Closing> found = longest_closings(reach, thickness, depth, options.least_grip);
    if (!found.empty()) return found;
  }
  return {};
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
/// grip, or moved from there.
Pose lay(const GraspPlace& place, const Eigen::Vector3d& n_O, const Grip& grip, double roll,
         const Eigen::Vector3d& offset_W) {
  const Eigen::Quaterniond least = least_turn(n_O, -grip.axis_W);
  const Eigen::Quaterniond R = (Eigen::AngleAxisd(roll, grip.axis_W) * least).normalized();
  return {R, grip.middle_W + offset_W - R * place.center_O};
}

/// Everything of one closing that all orientations share.
class ClosingView {
 public:
  ClosingView(const HandMotion& motion, const Closing& closing, const VoxelField& field,
              const Eigen::Vector3d& center_O, const PlacementOptions& options)
      : model_(motion.model()),
        field_(field),
        options_(options),
        center_O_(center_O),
        grip_(grip_at(motion, closing.finger, closing.begin)),
        at_closure_(poses_at(motion, closing.begin)) {
    for (const double before : before_closure) approach_.push_back(poses_at(motion, closing.begin - before));
    for (const double share : shares_of_grasp) {
      const double t = closing.begin + share * (closing.end - closing.begin);
      grasp_.push_back(poses_at(motion, t));
      asked_.push_back(Eigen::Vector3d(0, 0, -standard_gravity) - acceleration(motion, t));
    }
  }

  [[nodiscard]] const Grip& grip() const { return grip_; }

  /// From between the tips to the palm, across the line that joins them, unit.
  [[nodiscard]] Eigen::Vector3d inward() const {
    const Eigen::Vector3d way = at_closure_[palm].p - grip_.middle_W;
    return (way - way.dot(grip_.axis_W) * grip_.axis_W).normalized();
  }

  /// Largest specific load of a few times, in units of g.
  [[nodiscard]] double load() const {
    double largest = 0;
    for (const Eigen::Vector3d& asked : asked_) largest = std::max(largest, asked.norm() / standard_gravity);
    return largest;
  }

  /// Moves the object along the line from thumb to finger until both are as deep in it; returns what that leaves to
  /// wish for: depth other than the one aimed at, and normals other than the place's, `n_O` at the thumb.
  double balance(PlacementCandidate& c, const Eigen::Vector3d& n_O) const {
    constexpr int steps = 3;  // flat faces need one, curved ones converge quadratically
    PhalanxDepth thumb, finger;
    for (int i = 0; i <= steps; ++i) {
      const Pose X_OW = c.X_WO.inverse();
      thumb = look(last_phalanx(0), X_OW, at_closure_);
      finger = look(last_phalanx(c.closing.finger), X_OW, at_closure_);
      if (i < steps) c.X_WO.p += (thumb.depth - finger.depth) / 2 * grip_.axis_W;
    }
    return std::abs(thumb.depth - c.depth) + std::abs(finger.depth - c.depth) +
           astray_weight * (1 - thumb.n_O.dot(n_O) + std::abs(c.place.opposition + thumb.n_O.dot(finger.n_O)));
  }

  /// Depth beyond what is wanted, summed over the phalanges, as the closing begins.
  [[nodiscard]] double unwanted(const Pose& X_WO) const { return unwanted(X_WO, at_closure_); }

  /// The same on the way in, the worst: what passes through the object could touch its far side.
  [[nodiscard]] double unwanted_before(const Pose& X_WO) const {
    double worst = 0;
    for (const HandPoses& X_WP : approach_) worst = std::max(worst, unwanted(X_WO, X_WP));
    return worst;
  }

  /// Of the grip that carries the object along with the palm, the least of a few times.
  [[nodiscard]] double margin(const Pose& X_WO) const {
    const Pose X_palmO = at_closure_[palm].inverse() * X_WO;
    double least = infinity;
    for (std::size_t i = 0; i < grasp_.size(); ++i)
      least = std::min(least, margin(grasp_[i][palm] * X_palmO, grasp_[i], asked_[i]));
    return least;
  }

 private:
  static constexpr double standard_gravity = 9.81;  // [m/s²]
  static constexpr double weights_carried = 3;      // by the springs at the working depth, as GraspDemand::margin asks
  static constexpr double working_depth = 0.003;    // [m]

  [[nodiscard]] PhalanxDepth look(int phalanx, const Pose& X_OW, const HandPoses& X_WP) const {
    return phalanx_depth(model_.shape(phalanx), X_OW * X_WP[phalanx], field_);
  }

  [[nodiscard]] double unwanted(const Pose& X_WO, const HandPoses& X_WP) const {
    const Pose X_OW = X_WO.inverse();
    double sum = 0;
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
      const double wanted = phalanx == palm ? options_.palm_depth : options_.most_depth;
      sum += std::max(0.0, look(phalanx, X_OW, X_WP).depth - wanted);
    }
    return sum;
  }

  /// For an object of 1 kg: springs that suit the mass make the margin independent of it.
  [[nodiscard]] double margin(const Pose& X_WO, const HandPoses& X_WP, const Eigen::Vector3d& asked) const {
    const Pose X_OW = X_WO.inverse();
    std::vector<GripPad> pads;
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
      const PhalanxDepth at = look(phalanx, X_OW, X_WP);
      if (at.depth > 0) pads.push_back({X_WO * at.skin_O, X_WO.R * at.n_O, at.depth, phalanx == palm ? 0.02 : 0.003});
    }
    if (pads.empty()) return 0;
    const double stiffness =
        weights_carried * standard_gravity / (options_.mu_static * double(pads.size()) * working_depth);
    return grip_margin(pads, {asked, X_WO * center_O_, stiffness, options_.mu_static});
  }

  const HandModel model_;
  const VoxelField& field_;
  const PlacementOptions& options_;
  const Eigen::Vector3d center_O_;
  const Grip grip_;
  const HandPoses at_closure_;
  std::vector<HandPoses> approach_{}, grasp_{};
  std::vector<Eigen::Vector3d> asked_{};  // specific load: gravity less the palm's acceleration [m/s²]
};

bool alike(const PlacementCandidate& a, const PlacementCandidate& b) {
  return (a.place.center_O - b.place.center_O).norm() < least_distance &&
         std::abs(a.place.n_O.dot(b.place.n_O)) > 0.9 && a.closing.begin == b.closing.begin &&
         a.X_WO.R.angularDistance(b.X_WO.R) < least_turn_apart;
}

/// Ascending in cost, each unlike those before it, `count` at most.
std::vector<PlacementCandidate> unlike(std::vector<PlacementCandidate> all, std::size_t count) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  std::vector<PlacementCandidate> chosen;
  for (const PlacementCandidate& c : all) {
    if (chosen.size() == count) break;
    const auto is_alike = [&](const PlacementCandidate& other) { return alike(c, other); };
    if (std::none_of(chosen.begin(), chosen.end(), is_alike)) chosen.push_back(c);
  }
  return chosen;
}

/// Places with the closings that take them, and what they cost before an orientation is known.
std::vector<PlacementCandidate> choose_places(const Reach& reach, const std::vector<GraspPlace>& places,
                                              const Eigen::Vector3d& center_O, const PlacementOptions& options) {
  std::vector<PlacementCandidate> all;
  for (const GraspPlace& place : places) {
    double depth{};
    for (const Closing& closing : closings_on(reach, place.thickness, options, depth)) {
      PlacementCandidate c{place, closing, depth};
      c.excess = std::max(0.0, (place.thickness - closing.mean_gap) / 2 - options.most_depth);
      c.cost = excess_weight * c.excess + lever_weight * (place.center_O - center_O).norm() +
               oblique_weight * (1 - place.opposition) + (place.enclosed ? enclosed_cost : 0) +
               (place.narrow ? narrow_cost : 0);
      all.push_back(c);
    }
  }
  return unlike(std::move(all), most_places);
}

/// Both sides to the thumb and every roll of one place, at one offset.
void turn(const PlacementCandidate& place, double offset, const ClosingView& view,
          std::vector<PlacementCandidate>& all) {
  for (int k = 0; k < 2 * rolls; ++k) {
    PlacementCandidate c = place;
    const Eigen::Vector3d n_O = k < rolls ? c.place.n_O : Eigen::Vector3d(-c.place.n_O);
    c.X_WO = lay(c.place, n_O, view.grip(), 2 * pi * k / rolls, offset * view.inward());
    c.cost += tilt_weight * (1 - (c.X_WO.R * Eigen::Vector3d::UnitZ()).z()) + view.balance(c, n_O);
    c.cost += unwanted_weight * view.unwanted(c.X_WO) + approach_weight * view.unwanted_before(c.X_WO);
    c.margin = view.margin(c.X_WO);
    c.load = view.load();
    c.cost += weak_weight * std::max(0.0, enough_margin - c.margin);
    all.push_back(c);
  }
}

/// The best of every offset, as many of each: what squeezes the object towards the palm looks bad to statics and can
/// hold best.
std::vector<PlacementCandidate> best_of(const std::array<std::vector<PlacementCandidate>, offsets.size()>& by_offset,
                                        std::size_t count) {
  std::vector<PlacementCandidate> best;
  for (const std::vector<PlacementCandidate>& all : by_offset)
    for (PlacementCandidate& c : unlike(all, (count + offsets.size() - 1) / offsets.size()))
      best.push_back(std::move(c));
  std::stable_sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  if (best.size() > count) best.resize(count);
  return best;
}

}  // namespace

PlacementSearch search_placements(const HandMotion& motion, const VoxelField& field, const PlacementOptions& options,
                                  std::size_t count) {
  const Reach reach = look_at(motion);
  const Eigen::Vector3d center_O = solid_properties(field.mesh()).center;
  const std::vector<GraspPlace> places = find_grasp_places(field, reach.widest, surface_points);
  std::array<std::vector<PlacementCandidate>, offsets.size()> by_offset;
  for (const PlacementCandidate& place : choose_places(reach, places, center_O, options)) {
    const ClosingView view(motion, place.closing, field, center_O, options);
    for (std::size_t i = 0; i < offsets.size(); ++i) turn(place, offsets[i], view, by_offset[i]);
  }
  PlacementSearch search{.narrowest = reach.narrowest};
  for (const auto& all : by_offset) search.poses += long(all.size());
  for (const GraspPlace& place : places)
    if (search.thinnest == 0 || place.thickness < search.thinnest) search.thinnest = place.thickness;
  search.best = best_of(by_offset, count);
  return search;
}

}  // namespace handhold
