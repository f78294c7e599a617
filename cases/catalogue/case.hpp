#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// Where a true number comes from. A recording of our own output is `regression` and never truth.
enum class Pedigree { exact, discrete_exact, converged, published, regression };

[[nodiscard]] std::string_view to_string(Pedigree pedigree);

/// What is measured on a recording; from the poses of body 0, the hand's motion and the events alone, so that it can be
/// asked of any engine (forces and energy only of those that record contacts and the energy book). "Relative" means: of
/// the body's centre of mass against the case's phalanx, both counted from t = 0.
struct Measure {
  enum class Kind {
    event_time,            ///< time of the `occurrence`-th first event of kind `event` of any sample [s]
    displacement,          ///< relative displacement along `axis` at the instant [m]
    speed,                 ///< relative speed along `axis` at the instant [m/s]
    time_at_displacement,  ///< first time at which the relative displacement along `axis` reaches `level` [s]
    rotation,              ///< angle turned about `axis` since t = 0, unwrapped, at the instant [rad]
    held,                  ///< 1 if the largest |relative displacement along `axis`| stays below `level` [m], else 0
    no_event,              ///< 1 if no event of kind `event` happens, else 0
    event_count,           ///< how many events of kind `event` there are
    force,                 ///< on body 0 along `axis` by the chosen samples, on the frame `at` [N]
    torque,                ///< the same's torque about the axis through `point` [N m]
    dissipated,            ///< energy lost to friction and dampers since t = 0, on the frame `at` [J]
  };
  Kind kind{Kind::displacement};
  EventKind event{EventKind::touch};
  int occurrence{1};
  Eigen::Vector3d axis{Eigen::Vector3d::UnitX()};  ///< unit, in W
  std::optional<double> at{};                      ///< the instant [s]; nothing: the instant of the event
  double level{};
  int phalanx{-1}, sample{-1};                     ///< of `force` and `torque`: -1 stands for all
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};  ///< in W [m]
};

/// How far a measured value may lie from the truth, and why.
struct Limit {
  double value{};  ///< in the quantity's unit, or a fraction of the truth
  double
      per_substep{};  ///< times the sub-step h of a stepped engine [unit/s]: a first-order bound scales with its step
  bool relative{false};
  std::string reason{};  ///< why this much: a formula, not a wish
  double resolution{};   ///< smallest error that means anything, in the limit's unit; what is below it is luck
};

/// The limit for an engine that steps by `substep` [s]; 0 for one that controls its error.
[[nodiscard]] inline double limit_for(const Limit& limit, double substep) {
  return limit.value + limit.per_substep * substep;
}

/// One true number of a case.
struct Expectation {
  std::string quantity{};  ///< e.g. "slip onset"
  std::string unit{};
  double truth{};
  Pedigree pedigree{Pedigree::exact};
  std::string source{};  ///< formula and level, e.g. "L2 = L1: t_s = (N0 - m g / (2 mu_s)) / r"
  Measure measure{};
  Limit reference{};
  Limit realtime{};
  bool converges{false};  ///< the real-time error of this quantity falls with the sub-step: measure its order
};

/// Something to plot against time, with its truth.
struct Curve {
  std::string label{};  ///< e.g. "slip [m]"
  Measure measure{};    ///< displacement or rotation; `at` is ignored
  std::function<double(double t)> truth{};
};

/// One simulation of a case.
struct Run {
  std::string name{};              ///< e.g. "slides", "0.98 of the threshold"
  std::function<Scene()> scene{};  ///< built on demand: voxelizing takes a moment
  std::vector<Expectation> expectations{};
  std::optional<Curve> curve{};
  std::string not_realtime{};  ///< why the real-time engine is not asked for this run; empty: it is
};

/// One analytic benchmark of the catalogue.
struct Case {
  std::string id{};  ///< e.g. "D02"
  std::string title{};
  std::string level{};      ///< "L1", "L2": which model the truth is of
  std::string statement{};  ///< the scene in words
  std::string formula{};    ///< the closed form, as text
  std::string note{};       ///< how the level of the truth and of the engines are reconciled (stiffness, ...)
  std::vector<Run> runs{};
};

/// All cases, ascending in id.
[[nodiscard]] const std::vector<Case>& all_cases();

}  // namespace handhold::catalogue
