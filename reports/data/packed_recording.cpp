// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/packed_recording.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "cases/input/text_encoding.hpp"

namespace handhold::reports {
namespace {

using Json = nlohmann::ordered_json;
using Column = std::vector<double>;

Json quantisation_json(const Quantisation& scale) { return {{"lo", scale.lo}, {"step", scale.step}}; }

/// Seven columns of poses. q and -q are the same rotation: the sign that is nearer to the frame before keeps the
/// columns smooth.
struct PoseColumns {
  std::array<Column, 7> columns{};

  void add(const Pose& X) {
    Eigen::Vector4d q(X.R.w(), X.R.x(), X.R.y(), X.R.z());
    if (!columns[3].empty() &&
        q.dot(Eigen::Vector4d(columns[3].back(), columns[4].back(), columns[5].back(), columns[6].back())) < 0)
      q = -q;
    for (int i = 0; i < 3; ++i) columns[i].push_back(X.p[i]);
    for (int i = 0; i < 4; ++i) columns[3 + i].push_back(q[i]);
  }
};

/// One scale for the positions of all of them.
Quantisation position_quantisation(const std::vector<PoseColumns>& poses) {
  Column all;
  for (const PoseColumns& pose : poses)
    for (int i = 0; i < 3; ++i) all.insert(all.end(), pose.columns[i].begin(), pose.columns[i].end());
  return quantisation_of(all);
}

void add(PackedColumns& into, const std::vector<PoseColumns>& poses, const Quantisation& position) {
  for (const PoseColumns& pose : poses)
    for (int i = 0; i < 7; ++i) into.add(pose.columns[i], i < 3 ? position : unit_quantisation);
}

/// A contact sample over the frames: anchor in the body's frame, force in the world, mode.
struct Track {
  SampleId id{};
  std::array<Column, 6> columns{};
  std::vector<std::uint8_t> mode{};
};

std::vector<SampleId> sample_ids(const Recording& recording) {
  std::vector<SampleId> ids;
  for (const Frame& frame : recording.frames)
    for (const ContactState& contact : frame.contacts) ids.push_back(contact.id);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

using Row = std::array<double, 6>;

Row row_of(const ContactState& contact, const Frame& frame) {
  const Eigen::Vector3d anchor = frame.bodies.at(contact.id.body).X_WO.inverse() * contact.C_W;
  return {anchor.x(), anchor.y(), anchor.z(), contact.f_W.x(), contact.f_W.y(), contact.f_W.z()};
}

const ContactState* contact_of(const SampleId& id, const Frame& frame) {
  const auto found = std::lower_bound(frame.contacts.begin(), frame.contacts.end(), id,
                                      [](const ContactState& c, const SampleId& i) { return c.id < i; });
  return found != frame.contacts.end() && found->id == id ? &*found : nullptr;
}

Track track_of(const SampleId& id, const Recording& recording) {
  Track track{.id = id};
  std::vector<Row> rows;
  for (const Frame& frame : recording.frames) {
    const ContactState* contact = contact_of(id, frame);
    track.mode.push_back(contact ? std::uint8_t(std::uint8_t(contact->mode) + 1) : std::uint8_t{0});
    rows.push_back(contact ? row_of(*contact, frame) : rows.empty() ? Row{} : rows.back());
  }
  const auto first = std::find_if(track.mode.begin(), track.mode.end(), [](std::uint8_t m) { return m != 0; });
  const auto before = std::size_t(first - track.mode.begin());  // frames until the sample first exists
  std::fill_n(rows.begin(), before, rows[before]);
  for (const Row& row : rows)
    for (int i = 0; i < 6; ++i) track.columns[i].push_back(row[i]);
  return track;
}

/// Scales of all tracks: anchors, forces.
std::array<Quantisation, 2> add(PackedColumns& into, const std::vector<Track>& tracks) {
  std::array<Column, 2> all;
  for (const Track& track : tracks)
    for (int i = 0; i < 6; ++i) all[i / 3].insert(all[i / 3].end(), track.columns[i].begin(), track.columns[i].end());
  const std::array<Quantisation, 2> scales{quantisation_of(all[0]), quantisation_of(all[1])};
  for (const Track& track : tracks) {
    for (int i = 0; i < 6; ++i) into.add(track.columns[i], scales[i / 3]);
    into.add_bytes(track.mode);
  }
  return scales;
}

/// The energies, and what does not balance: a small difference of large numbers, taken before they are rounded.
Json add_energies(PackedColumns& into, const Recording& recording) {
  std::array<Column, 6> columns;
  for (const Frame& frame : recording.frames) {
    const Energy& e = frame.energy;
    const std::array<double, 5> book{e.kinetic, e.potential, e.elastic, e.dissipated, e.hand_work};
    for (int i = 0; i < 5; ++i) columns[i].push_back(book[i]);
    const double sum = e.kinetic + e.potential + e.elastic + e.dissipated - e.hand_work;
    columns[5].push_back(columns[5].empty() ? sum : sum - columns[5].front());
  }
  if (!columns[5].empty()) columns[5].front() = 0;
  Json scales = Json::array();
  const bool kept = std::ranges::any_of(
      columns, [](const Column& c) { return std::ranges::any_of(c, [](double v) { return v != 0; }); });
  if (!kept) return scales;
  for (const Column& column : columns) {
    const Quantisation scale = quantisation_of(column);
    into.add(column, scale);
    scales.push_back(quantisation_json(scale));
  }
  return scales;
}

/// CPU time of the advance that led to each frame; null where it was not measured.
Json add_frame_times(PackedColumns& into, const Recording& recording) {
  if (recording.frame_time.empty()) return nullptr;
  Column column;
  for (std::size_t k = 0; k < recording.frames.size(); ++k)
    column.push_back(recording.frame_time[std::min(k > 0 ? k - 1 : 0, recording.frame_time.size() - 1)]);
  const Quantisation scale = quantisation_of(column);
  into.add(column, scale);
  return quantisation_json(scale);
}

/// {n, dt} for frames at one rate, else all of them.
Json times_json(const std::vector<Frame>& frames) {
  const std::size_t n = frames.size();
  const double dt = n > 1 ? (frames.back().t - frames.front().t) / double(n - 1) : 1;
  const bool even =
      std::ranges::all_of(frames, [&, k = 0](const Frame& f) mutable { return std::abs(f.t - dt * k++) < 1e-9; });
  if (even) return {{"n", n}, {"dt", dt}};
  Json list = Json::array();
  for (const Frame& frame : frames) list.push_back(frame.t);
  return {{"list", std::move(list)}};
}

/// Events to 10 us; those of one kind and phalanx at one instant become one with a count.
Json events_json(const std::vector<Event>& events) {
  Json out = Json::array();
  for (const Event& e : events) {
    const double t = std::round(e.t * 1e5) / 1e5;
    Json row{t, to_string(e.kind), e.id.hand, e.id.phalanx, 1};
    if (!out.empty() && std::equal(row.begin(), row.end() - 1, out.back().begin()))
      out.back()[4] = out.back()[4].get<int>() + 1;
    else
      out.push_back(std::move(row));
  }
  return out;
}

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::vector<int> shown_phalanges(const Hand& hand) {
  std::vector<int> shown;
  for (const GivenPatch& patch : hand.given) shown.push_back(patch.phalanx);
  if (shown.empty()) {
    shown.resize(phalanx_count);
    std::iota(shown.begin(), shown.end(), 0);
  }
  return shown;
}

Json patches_json(const Hand& hand) {
  Json out = Json::array();
  for (const GivenPatch& patch : hand.given) {
    Json points = Json::array();
    for (const Eigen::Vector3d& p : patch.p_P) points.push_back(vector_json(p));
    out.push_back({{"phalanx", patch.phalanx}, {"points", std::move(points)}});
  }
  return out;
}

Json add_hand(PackedColumns& into, const Hand& hand, const Recording& recording) {
  const HandModel& model = hand.motion->model();
  const std::vector<int> shown = shown_phalanges(hand);
  std::vector<PoseColumns> poses(shown.size());
  for (const Frame& frame : recording.frames)
    for (std::size_t i = 0; i < shown.size(); ++i) poses[i].add(hand.motion->pose(shown[i], frame.t));
  const Quantisation scale = position_quantisation(poses);
  add(into, poses, scale);
  Json capsules = Json::array(), presence = Json::array();
  for (const Capsule& c : model.capsules) capsules.push_back({c.half_length, c.radius});
  for (const Interval& i : hand.motion->presence()) presence.push_back({i.begin, i.end});
  return {{"shown", shown},
          {"scale", quantisation_json(scale)},
          {"capsules", std::move(capsules)},
          {"palm", vector_json(model.palm_box.half_extents)},
          {"patches", patches_json(hand)},
          {"present", std::move(presence)}};
}

Json bodies_json(const Scene& scene, Blobs& blobs) {
  Json out = Json::array();
  for (const Body& body : scene.bodies)
    out.push_back({{"name", body.name},
                   {"mass", body.inertia.mass},
                   {"held_until", body.held_until},
                   {"mesh", body.field ? Json(pack_mesh(body.field->mesh(), blobs)) : Json(nullptr)}});
  return out;
}

Quantisation add_bodies(PackedColumns& into, const Scene& scene, const Recording& recording) {
  std::vector<PoseColumns> poses(scene.bodies.size());
  for (const Frame& frame : recording.frames)
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].add(frame.bodies.at(i).X_WO);
  const Quantisation scale = position_quantisation(poses);
  add(into, poses, scale);
  return scale;
}

std::string text(const Json& json) { return escape_hidden(json.dump(-1, ' ', false, Json::error_handler_t::replace)); }

}  // namespace

std::string pack_recording(const Scene& scene, const Recording& recording, Blobs& blobs) {
  PackedColumns columns;
  Json header{{"format", "handhold recording"},
              {"version", 1},
              {"engine", recording.engine},
              {"scene", scene.name},
              {"outcome", to_string(recording.outcome)},
              {"note", recording.note},
              {"t", times_json(recording.frames)},
              {"bodies", bodies_json(scene, blobs)},
              {"hands", Json::array()}};
  for (const Hand& hand : scene.hands) header["hands"].push_back(add_hand(columns, hand, recording));
  header["position"] = quantisation_json(add_bodies(columns, scene, recording));
  std::vector<Track> tracks;
  header["contacts"] = Json::array();
  for (const SampleId& id : sample_ids(recording)) {
    tracks.push_back(track_of(id, recording));
    header["contacts"].push_back({id.hand, id.phalanx, id.body, id.sample});
  }
  const auto [anchor, force] = add(columns, tracks);
  header["anchor"] = quantisation_json(anchor);
  header["force"] = quantisation_json(force);
  header["energy"] = add_energies(columns, recording);
  header["cost"] = add_frame_times(columns, recording);
  header["events"] = events_json(recording.events);
  return store("recording", columns.packed(text(header)), blobs);
}

std::string pack_mesh(const Mesh& mesh, Blobs& blobs) {
  PackedColumns columns;
  Json scales = Json::array();
  for (int axis = 0; axis < 3; ++axis) {
    Column values;
    for (const Eigen::Vector3d& v : mesh.vertices) values.push_back(v[axis]);
    const Quantisation scale = quantisation_of(values);
    columns.add(values, scale);
    scales.push_back(quantisation_json(scale));
  }
  std::vector<std::uint16_t> low, high;
  for (const auto& triangle : mesh.triangles)
    for (const int i : triangle) {
      low.push_back(std::uint16_t(i & 0xffff));
      high.push_back(std::uint16_t(i >> 16));
    }
  columns.add(low);
  columns.add(high);
  const Json header{{"format", "handhold mesh"},
                    {"version", 1},
                    {"vertices", mesh.vertices.size()},
                    {"triangles", mesh.triangles.size()},
                    {"scales", std::move(scales)}};
  return store("mesh", columns.packed(text(header)), blobs);
}

}  // namespace handhold::reports
