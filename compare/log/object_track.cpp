// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/log/object_track.hpp"

#include <limits>

#include "cases/hand/phalanx_depth.hpp"
#include "cases/hand/trace_spline.hpp"

namespace handhold::compare {
namespace {

/// Lost tracking is not bridged: what an application does then is what is looked at.
constexpr TraceSplineOptions unbridged{.longest_bridge = 0.035};  // two frames of a 60 Hz tracker

Nearness nearness(const Pose& X_WO, const VoxelField& field, const LoggedHands& hands, double t) {
  Nearness nearest{.depth = -std::numeric_limits<double>::infinity()};
  for (std::size_t h = 0; h < hands.size(); ++h) {
    if (!hands[h]->present(t)) continue;
    Nearness here{.depth = -std::numeric_limits<double>::infinity(), .hand = int(h)};
    for (int phalanx = 0; phalanx < phalanx_count; ++phalanx) {
      const Pose X_OP = X_WO.inverse() * hands[h]->pose(phalanx, t);
      const double depth = phalanx_depth(hands[h]->model().shape(phalanx), X_OP, field).depth;
      if (depth > here.depth) here.depth = depth, here.phalanx = phalanx;
      if (depth > -touch_distance) here.touching |= 1u << unsigned(phalanx);
    }
    if (here.depth > nearest.depth) nearest = here;
  }
  return nearest;
}

ObjectTrack track_of(const ObjectLog& log, std::size_t object, const LoggedSolid& solid, const LoggedHands& hands) {
  ObjectTrack track{.name = solid.name};
  const std::vector<std::optional<Pose>>& poses = log.objects[object].X_WO;
  for (std::size_t i = 0; i < log.t.size(); ++i) {
    if (!poses[i]) continue;
    track.t.push_back(log.t[i]);
    track.X_WO.push_back(*poses[i]);
    track.center.push_back(*poses[i] * solid.solid.center);
    track.near.push_back(nearness(*poses[i], *solid.field, hands, log.t[i]));
  }
  return track;
}

}  // namespace

LoggedHands hands_of(const ObjectLog& log) {
  LoggedHands hands;
  if (!log.trace) return hands;
  for (std::size_t i = 0; i < log.trace->hands.size(); ++i)
    hands.push_back(std::make_shared<TraceSpline>(*log.trace, i, unbridged));
  return hands;
}

std::vector<ObjectTrack> tracks_of(const ObjectLog& log, const std::vector<LoggedSolid>& solids) {
  const LoggedHands hands = hands_of(log);
  std::vector<ObjectTrack> tracks;
  for (std::size_t i = 0; i < solids.size(); ++i) tracks.push_back(track_of(log, i, solids[i], hands));
  return tracks;
}

}  // namespace handhold::compare
