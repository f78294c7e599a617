// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/input/trace/trace_reader.hpp"
#include "cases/model/scene.hpp"

namespace handhold::reports {

/// What a user asks to simulate: exactly one of a scene file, a case, or a trace with an object.
struct SceneRequest {
  std::string scene_file{};
  std::string case_name{};  ///< "C01", or "C01/slides" for one of its runs
  std::string trace_file{}, object{};
  TraceReadOptions reading{};  ///< of the trace
  double scale{1};             ///< of the object's file
  std::string place{
      "auto"};  ///< "auto": into the hand's first grasp; or a pose at t = 0, "x,y,z" or "x,y,z,qw,qx,qy,qz" [m]
  std::optional<double>
      held_until{};  ///< a support keeps the object until then [s of the scene]; default: placement's, else 0
  int hand{0};       ///< of the trace
  std::string material{"wood"};                              ///< of the object
  std::optional<double> mass{};                              ///< [kg]
  std::optional<double> density{};                           ///< [kg/m³]
  std::optional<double> stiffness{}, damping{}, duration{};  ///< in place of the scene's own; of a trace's object,
                                                             ///< stiffness and damping suit the grip (auto_contact)
  bool auto_stiffness{false};     ///< asked for in words: an error where nothing is placed in a hand
  std::optional<int> substeps{};  ///< of the real-time path; none: as many as the grip needs
  std::size_t tries{24};          ///< placements that are played, with place "auto"
};

struct NamedScene {
  std::string name{};
  Scene scene{};
  std::string remarks{};              ///< repairs and warnings of meshes and traces, and what was placed where; lines
  std::optional<int> substeps{};      ///< that the grip needs (compare/study/substeps.hpp), of a placing by trial
  std::optional<double> grasp_end{};  ///< of a recorded grasp, of the object placed in it [s]
};

/// The scenes asked for: one, or one a run of a case. Throws InputError.
[[nodiscard]] std::vector<NamedScene> load_scenes(const SceneRequest& request);

/// The request's object with its mass and friction, nowhere yet. Throws InputError.
[[nodiscard]] Body load_body(const SceneRequest& request);

/// What the scene holds, for the terminal.
[[nodiscard]] std::string scene_text(const NamedScene& named);

}  // namespace handhold::reports
