// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "cases/model/defect.hpp"
#include "realtime/world.hpp"

// Which samples can touch in a step: patches of phalanges and of pairs of bodies come and go here.

namespace handhold::realtime {
namespace {

constexpr double touching = 3e-5;  // samples this near are looked at, whatever the motion [radii of the smaller body]

Box nowhere() {
  constexpr double far = std::numeric_limits<double>::max();
  return {Eigen::Vector3d::Constant(far), Eigen::Vector3d::Constant(-far)};
}

Box box_about(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& half) {
  return {a.cwiseMin(b) - half, a.cwiseMax(b) + half};
}

}  // namespace

std::vector<Eigen::Vector3d> outward_of(const Body& body) {
  std::vector<Eigen::Vector3d> outward;
  for (const Eigen::Vector3d& p : body.samples_O) {
    const std::optional<SurfacePoint> surface = body.field->closest(p, body.field->band());
    const Eigen::Vector3d away = p - body.inertia.center;
    outward.push_back(surface ? surface->n_O : Eigen::Vector3d(away.normalized()));
  }
  return outward;
}

/// Updates the patches for a step of `h`; 0: as things stand.
void World::detect(double h) {
  ++step_;
  for (const int i : active_patches_) {
    PatchSlot& p = patch(i);
    watched_[std::size_t(i)] = 0;
    if (p.of_body() || p.given || !p.active || contacts_.touches(p)) continue;
    const Pose X_OP = end_pose(p.body, h).inverse() * next_[std::size_t(p.hand)].X_WP[std::size_t(p.phalanx)];
    if (proximity_[std::size_t(i)].leaves(*source(p.body).field, X_OP, 2 * scene_.patch.contact_offset)) drop(p);
  }
  sweep(h);
  for (const int i : candidates_) watch_hand(i, h);
  for (const std::uint32_t pair : body_pairs_) watch_pair(by_rank_[pair >> 16], by_rank_[pair & 0xffff], h);
  for (const int i : active_patches_) {
    const PatchSlot& p = patch(i);
    if (p.active && p.of_body() && !watched_[std::size_t(i)] && !contacts_.touches(p)) give_back(i);
  }
  if (!regroup_) return;
  std::sort(active_patches_.begin(), active_patches_.end());
  active_patches_.erase(std::unique(active_patches_.begin(), active_patches_.end()), active_patches_.end());
  std::erase_if(active_patches_, [&](int i) { return !patch(i).active; });
}

/// Where a body will be if it goes on as it does.
Pose World::end_pose(int body, double h) const {
  const RigidBody& b = bodies_[std::size_t(body)];
  const Eigen::Quaterniond R = b.turns() ? rotation_by(h * b.w) * b.X_WO.R : b.X_WO.R;
  return {R, b.center() + h * b.v - R * b.center_O};
}

/// Finds the patches of phalanges, and the pairs of bodies, that may come near in this step.
void World::sweep(double h) {
  candidates_.clear();
  const int phalanges = int(patches_from_.size());
  const auto offer = [&](int i, int phalanx) {
    if (!next_[std::size_t(phalanx / phalanx_count)].present) return;
    const PatchSlot& p = patch(i);
    if (!p.active && !is_far(p, proximity_[std::size_t(i)].reach(), h)) candidates_.push_back(i);
  };
  if (bodies_.size() == 1) {
    for (int i = 0; i < phalanges; ++i)
      if (patches_from_[std::size_t(i)] >= 0) offer(patches_from_[std::size_t(i)], i);
    return;
  }
  place_boxes(h);
  if (broad_phase_.outgrown()) find_pairs();
  for (const int i : hand_pairs_) offer(i, patch(i).hand * phalanx_count + patch(i).phalanx);
}

/// Boxes that hold what moves during a step: bodies first, phalanges after them. Foresees the bodies' velocities.
void World::place_boxes(double h) {
  const std::size_t bodies = bodies_.size();
  for (std::size_t i = 0; i < bodies; ++i) {
    const RigidBody& body = bodies_[i];
    const BodyStep& s = steps_[i];
    const Eigen::AlignedBox3d bounds = source(int(i)).field->bounds();
    const double turn = h * body.w.norm() * body.radius;
    const Eigen::Vector3d half = s.R.cwiseAbs() * (0.5 * bounds.sizes());
    const Eigen::Vector3d start = body.X_WO.p + s.R * bounds.center();
    const Eigen::Vector3d free_v = body.v + free_change(body, s, {.h = h}), move = h * free_v;
    // Contacts do what they did in the last step: what rests goes on resting.
    foreseen_[i] = free_v + std::max(h / last_h_, 1.0) * pushed_[i];
    broad_phase_.place(i,
                       box_about(start, start + move, half + Eigen::Vector3d::Constant(turn + touching * body.radius)),
                       move.norm() + turn);
  }
  for (std::size_t i = 0; i < patches_from_.size(); ++i) {
    const int first = patches_from_[i];
    const HandFrame& hand = next_[i / phalanx_count];
    if (first < 0 || !hand.present) {
      broad_phase_.place(bodies + i, nowhere(), 0);
      continue;
    }
    const double reach = proximity_[std::size_t(first)].reach() + scene_.patch.contact_offset;
    const Eigen::Vector3d &start = start_pose(patch(first)).p, &end = hand.X_WP[i % phalanx_count].p;
    broad_phase_.place(bodies + i, box_about(start, end, Eigen::Vector3d::Constant(reach)), (end - start).norm());
  }
}

/// Pairs of boxes that may meet before they are looked for again.
void World::find_pairs() {
  const int bodies = int(bodies_.size());
  hand_pairs_.clear();
  body_pairs_.clear();
  broad_phase_.visit([&](int i, int j) {
    if (i >= bodies) return;
    if (j >= bodies) {
      hand_pairs_.push_back(patches_from_[std::size_t(j - bodies)] + i);
      return;
    }
    if (!bodies_[std::size_t(i)].moves() && !bodies_[std::size_t(j)].moves()) return;
    const auto [low, high] = std::minmax(rank_[std::size_t(i)], rank_[std::size_t(j)]);
    body_pairs_.push_back(std::uint32_t(low) << 16 | std::uint32_t(high));
  });
  std::sort(hand_pairs_.begin(), hand_pairs_.end());
  std::sort(body_pairs_.begin(), body_pairs_.end());
}

/// A ball around the phalanx stays clear of the body's bounding box.
bool World::is_far(const PatchSlot& p, double reach, double h) const {
  const BodyStep& s = steps_[std::size_t(p.body)];
  const RigidBody& body = bodies_[std::size_t(p.body)];
  const Eigen::Vector3d& end = next_[std::size_t(p.hand)].X_WP[std::size_t(p.phalanx)].p;
  const Eigen::Vector3d arm = end - s.center - h * body.v;
  const double moved = (end - start_pose(p).p).norm() + h * (body.v.norm() + body.w.norm() * arm.norm());
  const Eigen::Vector3d p_O = s.R.transpose() * arm + body.center_O;
  return source(p.body).field->bounds().exteriorDistance(p_O) > reach + scene_.patch.contact_offset + moved;
}

void World::watch_hand(int i, double h) {
  PatchSlot& p = patch(i);
  const Pose X_OP = bodies_[std::size_t(p.body)].X_WO.inverse() * start_pose(p);
  const Pose Y_OP = end_pose(p.body, h).inverse() * next_[std::size_t(p.hand)].X_WP[std::size_t(p.phalanx)];
  Proximity& proximity = proximity_[std::size_t(i)];
  const VoxelField& field = *source(p.body).field;
  if (const std::optional<Pose> at = proximity.approach(field, X_OP, Y_OP, scene_.patch.contact_offset)) {
    seed(p, *at, proximity.place());
    active_patches_.push_back(i);
  }
}

void World::seed(PatchSlot& p, const Pose& X_OP, const Nearest& nearest) {
  const Patch points = seed_patch(p.phalanx, X_OP, nearest, scene_.patch);
  p.active = true;
  regroup_ = true;
  for (int i = 0; i < p.count; ++i) {
    contacts_.p_P.set(p.slot(i), points.p_P[std::size_t(i)]);
    contacts_.mode[p.slot(i)] = Mode::apart;
    contacts_.f_O.set(p.slot(i), Eigen::Vector3d::Zero());
  }
}

void World::drop(PatchSlot& p) {
  p.active = false;
  regroup_ = true;
  for (int i = 0; i < p.count; ++i) contacts_.mode[p.slot(i)] = Mode::apart;
}

/// A pair of bodies whose boxes meet.
void World::watch_pair(int a, int b, double h) {
  const RigidBody &A = bodies_[std::size_t(a)], &B = bodies_[std::size_t(b)];
  const Eigen::Vector3d &v_A = foreseen_[std::size_t(a)], &v_B = foreseen_[std::size_t(b)];
  // A distance changes by no more than the bodies' points there move against each other; the part of a body's turning
  // that moves a point along the line to its nearest point is that of its own surface, within its radius.
  const double coming = h * ((v_A - v_B).norm() + DEFECT(pair_ignores_spin, A.w.norm(), 0.0) * A.radius +
                             DEFECT(pair_ignores_spin, B.w.norm(), 0.0) * B.radius) +
                        touching * std::min(A.radius, B.radius);
  const double gone = (moved_[std::size_t(a)] - moved_[std::size_t(b)]).norm() + turned_[std::size_t(a)] * A.radius +
                      turned_[std::size_t(b)] * B.radius;
  double clearance = pairs_.clearance(a, b, step_) - gone;
  if (clearance <= coming) {
    clearance = std::numeric_limits<double>::max();
    watch_samples(a, b, coming, clearance);
    watch_samples(b, a, coming, clearance);
    clearance = std::max(clearance, 0.0);
  }
  pairs_.set_clearance(a, b, step_, clearance);
}

/// Marks the free samples of `from` that can reach `target` when both come nearer by `coming`; `clearance` falls to no
/// more than the distance of the nearest free one.
void World::watch_samples(int target, int from, double coming, double& clearance) {
  const std::vector<Eigen::Vector3d>& points = source(from).samples_O;
  if (points.empty()) return;
  const VoxelField& field = *source(target).field;
  const Pose X_TS = bodies_[std::size_t(target)].X_WO.inverse() * bodies_[std::size_t(from)].X_WO;
  const Eigen::Matrix3d R = X_TS.R.toRotationMatrix();
  const double interpolation = 0.5 * field.grid().spacing;  // more than the interpolated distance can be wrong
  int taken = pairs_.patch(target, from);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (taken >= 0) {
      const std::size_t slot = patch(taken).slot(int(i));
      near_[slot] = 0;
      if (contacts_.mode[slot] != Mode::apart) continue;
    }
    const Eigen::Vector3d p = R * points[i] + X_TS.p;
    if (const double outside = field.bounds().exteriorDistance(p); outside > coming) {
      clearance = std::min(clearance, outside);
      continue;
    }
    double distance = field.distance(p).distance - interpolation;
    // Only where that leaves it open is the surface asked: in a blow most of what is near is so by far.
    if (distance <= coming && distance + 2 * interpolation > coming) {
      const double within = coming + 2 * interpolation;
      const std::optional<SurfacePoint> surface = field.closest(p, within);
      if (surface)
        distance = surface->distance;
      else if (distance > 0 || field.distance(p).distance > 0)
        distance = within;
    }
    clearance = std::min(clearance, distance);
    if (distance > coming) continue;
    if (taken < 0) {
      taken = take_pair(target, from);
    }
    near_[patch(taken).slot(int(i))] = 1;
    watched_[std::size_t(taken)] = 1;
  }
}

int World::take_pair(int target, int from) {
  if (pairs_.exhausted()) {
    const std::size_t before = contacts_.patches.size();
    grow_pool(scene_, contacts_);
    pairs_.add_free(contacts_, before);
    resize_for_slots();
  }
  const int taken = pairs_.take(scene_, target, from, contacts_);
  for (int i = 0; i < patch(taken).count; ++i) near_[patch(taken).slot(i)] = 0;
  active_patches_.push_back(taken);
  regroup_ = true;
  return taken;
}

void World::give_back(int taken) {
  pairs_.give_back(taken, contacts_);
  regroup_ = true;
}

int World::root(int body) {
  while (parent_[std::size_t(body)] != body) body = parent_[std::size_t(body)];
  return body;
}

/// Bodies that move and touch are one island, named by its lowest rank; everything in it is sorted by rank.
/// Islands stay the same as long as no patch comes or goes.
void World::find_islands() {
  if (!regroup_) return;
  regroup_ = false;
  for (std::size_t r = 0; r < parent_.size(); ++r) parent_[r] = int(r);
  const auto moves = [&](int body) { return bodies_[std::size_t(body)].moves(); };
  for (const int i : active_patches_) {
    const PatchSlot& p = patch(i);
    if (!p.of_body() || !moves(p.body) || !moves(p.phalanx)) continue;
    const int a = root(rank_[std::size_t(p.body)]), b = root(rank_[std::size_t(p.phalanx)]);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }
  members_.clear();
  for (int r = 0; r < int(parent_.size()); ++r) members_.emplace_back(root(r), r);
  std::sort(members_.begin(), members_.end());
  active_.clear();
  for (const int i : active_patches_) {
    const PatchSlot& p = patch(i);
    const int target = rank_[std::size_t(p.body)];
    const int second = p.of_body() ? rank_[std::size_t(p.phalanx)] : p.phalanx;
    const int at = p.of_body() && !moves(p.body) ? second : target;
    active_.push_back({root(at), std::uint32_t(target) << 16 | std::uint32_t(p.hand) << 8 | std::uint32_t(second), i});
  }
  std::sort(active_.begin(), active_.end(), [](const Active& a, const Active& b) {
    return a.island != b.island ? a.island < b.island : a.key < b.key;
  });
}

}  // namespace handhold::realtime
