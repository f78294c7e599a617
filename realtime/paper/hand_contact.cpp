// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/hand_contact.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "cases/model/input_error.hpp"

namespace handhold::realtime::paper {
namespace {

/// Farthest point of a shape from its centroid.
double extent(const PhalanxShape& shape) {
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->half_length + capsule->radius;
  return std::get<PalmBox>(shape).half_extents.norm();
}

bool finite(const HandFrame& hand) {
  return std::all_of(hand.X_WP.begin(), hand.X_WP.end(),
                     [](const Pose& X) { return X.p.allFinite() && X.R.coeffs().allFinite(); });
}

}  // namespace

HandContact::HandContact(std::shared_ptr<const VoxelField> field, Normals normals, const Eigen::Vector3d& center_O,
                         const Friction& friction, const Options& options, std::vector<HandModel> hands,
                         const PatchOptions& patch)
    : field_(std::move(field)),
      models_(std::move(hands)),
      patch_(patch),
      middleware_(field_ ? std::make_shared<FieldSurface>(field_, normals) : nullptr, center_O, friction, options,
                  int(models_.size()) * phalanx_count),
      X_WP_(models_.size() * phalanx_count) {
  // The ring that places the anchors lies on the skin in any case; whether the springs end there is Options::point.
  patch_.reference_point = ReferencePoint::skin;
  patch_.contact_offset = options.contact_offset;
  if (patch_.samples < 1 || patch_.samples > max_samples)
    throw InputError("patch of " + std::to_string(patch_.samples) + " samples: needs 1 to " +
                     std::to_string(max_samples) + " (the paper has 8)");
}

const Wrench& HandContact::frame(double dt, std::span<const HandFrame> hands, const BodyMotion& body) {
  for (std::size_t h = 0; h < models_.size(); ++h) {
    const bool here = h < hands.size() && hands[h].present && finite(hands[h]);
    for (int i = 0; i < phalanx_count; ++i) {
      const int patch = patch_of(int(h), i);
      if (!here) {
        if (middleware_.patches()[std::size_t(patch)].active) middleware_.drop(patch);
        continue;
      }
      X_WP_[std::size_t(patch)] = hands[h].X_WP[std::size_t(i)];
      detect(int(h), i, hands[h].X_WP[std::size_t(i)], body.X_WO);
    }
  }
  return middleware_.frame(dt, X_WP_, body);
}

void HandContact::detect(int hand, int phalanx, const Pose& X_WP, const Pose& X_WO) {
  const int index = patch_of(hand, phalanx);
  const PatchState& patch = middleware_.patches()[std::size_t(index)];
  const PhalanxShape shape = models_[std::size_t(hand)].shape(phalanx);
  const Pose X_OP = X_WO.inverse() * X_WP;
  const double offset = patch_.contact_offset, exit = 2 * offset;
  // Nothing of the phalanx can be nearer than this; the interpolated distance is short by less than two voxels.
  const double least = field_->distance(X_OP.p).distance - extent(shape) - 2 * field_->grid().spacing;
  if (least > exit) {
    if (patch.active) middleware_.drop(index);
    return;
  }
  if (patch.active) {
    const auto touches = [](const SampleState& s) { return s.mode != Mode::apart; };
    if (std::any_of(patch.samples.begin(), patch.samples.begin() + patch.count, touches) &&
        middleware_.options().gate == Gate::pushing)
      return;  // pushes, so it is inside: no need to look
    if (nearest(shape, X_OP, *field_).distance > exit) middleware_.drop(index);
    return;
  }
  const Nearest place = nearest(shape, X_OP, *field_);
  if (place.distance > offset) return;
  const Patch points = seed_patch(phalanx, X_OP, place, patch_);
  const std::span<const Eigen::Vector3d> p_P(points.p_P.data(), std::size_t(points.count));
  const double palm_ring = std::max({patch_.finger_radius, patch_.thumb_radius, patch_.palm_radius});
  middleware_.seed(index, X_WP, X_WO, p_P, std::abs(place.distance) + 2 * palm_ring);
}

}  // namespace handhold::realtime::paper
