// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/measure/grasp.hpp"
#include "compare/study/placing_trial.hpp"

namespace handhold::compare {

/// One recorded hand with one object.
struct GraspPair {
  std::string recording{};
  std::shared_ptr<const Trace> trace{};
  std::size_t hand{};
  Body body{};  ///< its name is the shape's
};

/// What one engine made of a pair.
struct EngineGrasp {
  std::string engine{};
  Outcome outcome{};
  GraspTrial trial{};
  std::optional<double> dropped_at{};  ///< contact was lost for good [s of the scene]
  double frame_cost{};                 ///< CPU time of a frame, median [s]
};

struct GraspRow {
  std::string recording{}, object{};
  double mass{}, mu{};
  std::optional<Placing> placing{};  ///< none: the hand never closes on the object
  std::string refused{};             ///< why, then
  double placing_seconds{};          ///< CPU time of all threads that the process ran, so of this row alone with one
  std::vector<EngineGrasp> engines{};
  std::optional<double> horizon{};     ///< until when the first engine's answer means something [s of the scene]
  std::optional<double> difference{};  ///< of the first two engines' translation, until the horizon or the end [m]
};

struct GraspTableOptions {
  std::vector<std::string> engines{"reference", "realtime"};  ///< the first two are compared
  std::function<std::unique_ptr<Engine>(const std::string&)> make_engine{};
  std::function<ContactParameters(const Body&, const Placement&)> contact_of{};
  /// Until when an engine's answer means something [s]; empty: nobody asks.
  std::function<double(const Scene&, const Engine&, const EngineOptions&, const Recording&)> horizon{};
  EngineOptions engine{};
  std::size_t tried{24};
};

/// Places the object by trial with the real-time path and plays it with every engine to the end of the grasp.
[[nodiscard]] GraspRow play_grasp(const GraspPair& pair, const GraspTableOptions& options);

}  // namespace handhold::compare
