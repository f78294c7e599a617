// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cases/model/pose.hpp"

namespace handhold {

/// Mode of a contact sample.
enum class Mode : std::uint8_t { apart, stick, slip };

[[nodiscard]] std::string_view to_string(Mode mode);

enum class EventKind : std::uint8_t { touch, breakaway, restick, release };

[[nodiscard]] std::string_view to_string(EventKind kind);

/// What a change of mode is called; the two must differ.
[[nodiscard]] constexpr EventKind change_of(Mode from, Mode to) {
  if (from == Mode::apart) return EventKind::touch;
  if (to == Mode::apart) return EventKind::release;
  return to == Mode::slip ? EventKind::breakaway : EventKind::restick;
}

/// Names one sample: its hand, phalanx, body and its number in the patch. A sample that belongs to another body's
/// surface has `hand` = `of_body` and that body's index as `phalanx`.
struct SampleId {
  std::uint8_t hand{}, phalanx{}, body{}, sample{};

  static constexpr std::uint8_t of_body = 255;
  [[nodiscard]] bool belongs_to_body() const { return hand == of_body; }

  [[nodiscard]] friend bool operator==(const SampleId& a, const SampleId& b) { return key(a) == key(b); }
  [[nodiscard]] friend bool operator<(const SampleId& a, const SampleId& b) { return key(a) < key(b); }

  [[nodiscard]] static std::uint32_t key(const SampleId& id) {
    return std::uint32_t(id.hand) << 24 | std::uint32_t(id.phalanx) << 16 | std::uint32_t(id.body) << 8 | id.sample;
  }
};

struct BodyState {
  Pose X_WO{};
  Twist V_WO{};  ///< v: velocity of O's origin
};

/// State of one contact sample whose patch exists.
struct ContactState {
  SampleId id{};
  Mode mode{Mode::apart};
  double depth{};                                ///< d = −(p − C)·n [m]
  Eigen::Vector3d p_W{Eigen::Vector3d::Zero()};  ///< sample point on the phalanx, or on the other body
  Eigen::Vector3d C_W{Eigen::Vector3d::Zero()};  ///< anchor on the object
  Eigen::Vector3d n_W{Eigen::Vector3d::Zero()};  ///< outward normal at the anchor
  Eigen::Vector3d f_W{Eigen::Vector3d::Zero()};  ///< on the object, on a line through p [N]
};

/// Energy ledger, [J].
struct Energy {
  double kinetic{}, potential{}, elastic{};
  double dissipated{};  ///< by friction and damping since t = 0
  double hand_work{};   ///< done by hands, applied loads, and a support that carries the weight, since t = 0
};

/// kinetic + potential + elastic + dissipated − hand_work [J]: keeps its value at the start; a change is an engine's
/// error.
[[nodiscard]] constexpr double energy_sum(const Energy& e) {
  return e.kinetic + e.potential + e.elastic + e.dissipated - e.hand_work;
}

struct Frame {
  double t{};  ///< [s]
  std::vector<BodyState> bodies{};
  std::vector<ContactState> contacts{};  ///< ascending in id
  Energy energy{};
};

/// A change of mode, located to within `window` (the true instant lies in [t − window, t]).
///
/// touch: apart before, closed after; release: the contrary. breakaway: it slips after; restick: it slipped before and
/// sticks after. A contact that lands and slides on has touch and breakaway at one instant; a slip that stops and goes
/// on the other way at once has restick and breakaway at one instant (a method with fixed steps may report one alone).
/// What is given at t = 0 is no event, with one exception: a rigid support (L1) that slips from the beginning breaks
/// away at t = 0.
struct Event {
  double t{};       ///< [s]
  double window{};  ///< [s]; of a method with fixed steps: one of them
  EventKind kind{};
  SampleId id{};
  BodyState body{};  ///< of the sample's body at `t`
};

/// Where the contact law has no unique continuation (docs/contact-law.md), and which one the engine took.
struct Ambiguity {
  double t{};  ///< [s]
  SampleId id{};
  std::string what{};  ///< "touches on a convex edge: ..."
};

/// How a run ended. Anything but `complete` comes with a sentence in `Recording::note`.
enum class Outcome : std::uint8_t { complete, interrupted, diverged, stalled };

[[nodiscard]] std::string_view to_string(Outcome outcome);

/// What an engine hands back.
struct Recording {
  std::string engine{};
  std::string scene{};
  Outcome outcome{Outcome::complete};
  std::string note{};
  std::map<std::string, std::string> provenance{};  ///< options, versions, compiler
  std::vector<std::string> body_names{};
  std::vector<Frame> frames{};           ///< the first at t = 0
  std::vector<Event> events{};           ///< ascending in time
  std::vector<Ambiguity> ambiguities{};  ///< ascending in time
  std::vector<double> frame_time{};      ///< CPU time of each advance between frames [s]; empty when not measured
};

/// The greatest change of the frames' energy_sum since the first frame [J]; NaN if one of them is.
[[nodiscard]] double energy_residual(const Recording& recording);

}  // namespace handhold
