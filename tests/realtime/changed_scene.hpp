#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "cases/hand/trace_spline.hpp"
#include "cases/hand/trace_builder.hpp"
#include "tests/realtime/scenes.hpp"

// Any scene, seen from elsewhere, in a mirror, passing by, or of another size and weight. Nothing is voxelized anew: a
// changed field has the numbers of the old one, so that what an engine does with it may be compared to the last bit.

namespace handhold::realtime::testing {

/// How a scene is changed, in this order: size and weight, mirror image, place and direction, passing by. The defaults
/// change nothing. Gravity keeps its size, so that times go with √length and forces with masses (Froude).
struct Change {
  double length{1}, mass{1};         ///< lengths and masses by these factors
  bool mirrored{false};              ///< y to −y, of the world and of every body's and phalanx's own frame
  Pose X{};                          ///< it stands and looks elsewhere
  Vector3d boost{Vector3d::Zero()};  ///< it passes by [m/s]
  /// Hands, and bones of fingers but the thumb's, are numbered the other way round: sums run in another order.
  bool renumbered{false};

  [[nodiscard]] int phalanx(int i) const { return renumbered && i >= 3 && i < palm ? palm + 2 - i : i; }
  [[nodiscard]] double time() const { return std::sqrt(length); }

  /// A vector of a body's own frame, without its size.
  [[nodiscard]] Vector3d own(const Vector3d& v) const { return mirrored ? Vector3d(v.x(), -v.y(), v.z()) : v; }
  /// A vector of W, without its size: polar as a force, or axial as a torque.
  [[nodiscard]] Vector3d polar(const Vector3d& v) const { return X.R * own(v); }
  [[nodiscard]] Vector3d axial(const Vector3d& v) const { return X.R * (mirrored ? Vector3d(-own(v)) : v); }
  /// A velocity of a point.
  [[nodiscard]] Vector3d velocity(const Vector3d& v) const { return polar(v) * (length / time()) + boost; }
  /// Where a pose of the old scene is at time `t` of the changed one.
  [[nodiscard]] Pose pose(const Pose& Y, double t) const {
    const Eigen::Quaterniond& q = Y.R;
    const Pose own_pose{mirrored ? Eigen::Quaterniond(q.w(), -q.x(), q.y(), -q.z()) : q, own(length * Y.p)};
    if (X.R.coeffs() == Eigen::Quaterniond::Identity().coeffs()) return {own_pose.R, own_pose.p + X.p + t * boost};
    return {X.R * own_pose.R, X.R * own_pose.p + X.p + t * boost};
  }
};

/// A grid's entries with j running the other way.
template <class Entry>
std::vector<Entry> mirrored(const std::vector<Entry>& entries, const Eigen::Vector3i& size) {
  std::vector<Entry> made;
  made.reserve(entries.size());
  for (int k = 0; k < size.z(); ++k)
    for (int j = size.y() - 1; j >= 0; --j) {
      const auto row = entries.begin() + std::ptrdiff_t(k * size.y() + j) * size.x();
      made.insert(made.end(), row, row + size.x());
    }
  return made;
}

inline void mirror(VoxelField::Data& data) {
  const Grid grid = data.grid;
  data.grid.origin.y() = -(grid.origin.y() + grid.spacing * (grid.size.y() - 1));
  data.distance = mirrored(data.distance, grid.size);
  std::vector<std::uint8_t> inside;
  for (std::size_t i = 0; i < grid.count(); ++i) inside.push_back(data.occupied[i >> 6] >> (i & 63) & 1);
  inside = mirrored(inside, grid.size);
  std::fill(data.occupied.begin(), data.occupied.end(), 0);
  for (std::size_t i = 0; i < inside.size(); ++i) data.occupied[i >> 6] |= std::uint64_t(inside[i]) << (i & 63);
  for (Vector3d& v : data.mesh.vertices) v.y() = -v.y();
  for (auto& triangle : data.mesh.triangles) std::swap(triangle[1], triangle[2]);  // outward stays outward
  data.cell_origin.y() = -(data.cell_origin.y() + data.cell_size * data.cell_count.y());
  std::vector<std::uint32_t> cells(data.cell_start.size() - 1), start{0}, triangles;
  std::iota(cells.begin(), cells.end(), 0);
  for (const std::uint32_t cell : mirrored(cells, data.cell_count)) {
    const auto all = data.cell_triangles.begin();
    triangles.insert(triangles.end(), all + data.cell_start[cell], all + data.cell_start[cell + 1]);
    start.push_back(std::uint32_t(triangles.size()));
  }
  data.cell_start = start;
  data.cell_triangles = triangles;
}

inline std::shared_ptr<const VoxelField> changed(const VoxelField& field, const Change& change) {
  VoxelField::Data data = field.data();
  const double L = change.length;
  for (Vector3d& v : data.mesh.vertices) v *= L;
  for (float& d : data.distance) d *= float(L);
  data.grid.origin *= L;
  data.cell_origin *= L;
  for (double* length : {&data.grid.spacing, &data.band, &data.cell_size}) *length *= L;
  if (change.mirrored) mirror(data);
  return std::make_shared<const VoxelField>(std::move(data));
}

inline Body changed(Body body, const Change& change) {
  const double L = change.length, M = change.mass, T = change.time();
  body.inertia.mass *= M;
  body.inertia.center = change.own(L * body.inertia.center);
  body.inertia.about_center *= M * L * L;
  if (change.mirrored) {
    const Vector3d flip(1, -1, 1);
    body.inertia.about_center = (flip.asDiagonal() * body.inertia.about_center * flip.asDiagonal()).eval();
  }
  body.X_WO = change.pose(body.X_WO, 0);
  body.V_WO = {change.axial(body.V_WO.w) / T, change.velocity(body.V_WO.v)};
  body.held_until *= T;
  for (Vector3d& p : body.samples_O) p = change.own(L * p);
  if (body.load)
    body.load = [load = body.load, change, L, M, T](double t) -> Load {
      const Load old = load(t / T);
      return {M * change.polar(old.force_W), M * L * change.axial(old.torque_W)};
    };
  return body;
}

/// A hand's shapes and given samples; its motion is up to `frames`.
inline Hand changed(const Hand& hand, const Change& change) {
  const double L = change.length;
  const HandModel& old = hand.motion->model();
  HandModel model = old;
  for (int i = 0; i < palm; ++i) {
    const Capsule& capsule = old.capsules[std::size_t(i)];
    model.capsules[std::size_t(change.phalanx(i))] = {L * capsule.half_length, L * capsule.radius};
  }
  model.palm_box.half_extents *= L;
  const PoseFunction still = [](double) { return std::array<Pose, phalanx_count>{}; };
  Hand made = hand;
  made.motion = std::make_shared<TraceSpline>(sample_trace("still", hand.motion->side(), model, still, 0, 1, 2), 0);
  for (GivenPatch& given : made.given) {
    given.phalanx = change.phalanx(given.phalanx);
    for (Vector3d& p : given.p_P) p = change.own(L * p);
    for (SampleStart& start : given.start) start.lag_W = change.polar(L * start.lag_W);
  }
  return made;
}

/// A scene, changed, and with it the hands' frames.
class ChangedScene {
 public:
  ChangedScene(const Scene& scene, const Change& change) : old_(scene), change_(change), scene_(scene) {
    const double L = change.length, M = change.mass, T = change.time();
    scene_.duration *= T;
    scene_.gravity = change.polar(scene.gravity);
    for (ContactParameters* contact : {&scene_.contact, &scene_.body_contact}) {
      contact->stiffness *= M / L;
      contact->damping *= M / T;
    }
    PatchOptions& patch = scene_.patch;
    for (double* length : {&patch.finger_radius, &patch.thumb_radius, &patch.palm_radius, &patch.contact_offset})
      *length *= L;
    std::map<const VoxelField*, std::shared_ptr<const VoxelField>> fields;  // bodies of one shape share them
    for (Body& body : scene_.bodies) {
      std::shared_ptr<const VoxelField>& field = fields[body.field.get()];
      if (!field) field = changed(*body.field, change);
      body.field = field;
      body = changed(body, change);
    }
    for (Hand& hand : scene_.hands) hand = changed(hand, change);
    if (change.renumbered) std::reverse(scene_.hands.begin(), scene_.hands.end());
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Change& change() const { return change_; }
  /// Of the hands at time `t` of the changed scene.
  [[nodiscard]] std::vector<HandFrame> frames(double t) const {
    std::vector<HandFrame> hands = testing::frames(old_, t / change_.time());
    for (HandFrame& hand : hands) {
      const HandFrame old = hand;
      for (int i = 0; i < phalanx_count; ++i)
        hand.X_WP[std::size_t(change_.phalanx(i))] = change_.pose(old.X_WP[std::size_t(i)], t);
    }
    if (change_.renumbered) std::reverse(hands.begin(), hands.end());
    return hands;
  }

 private:
  Scene old_;
  Change change_;
  Scene scene_;
};

}  // namespace handhold::realtime::testing
