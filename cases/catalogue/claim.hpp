// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "cases/model/recording.hpp"

namespace handhold::catalogue {

/// Where a true number comes from. A recording of our own output is `regression` and never truth.
enum class Pedigree { exact, discrete_exact, converged, published, regression };

[[nodiscard]] std::string_view to_string(Pedigree pedigree);

/// What is measured on a recording; from the poses of a body, the hand's motion and the events alone, so that it can be
/// asked of any engine (forces and energy only of those that record contacts and the energy ledger). "Relative" means:
/// of the body's centre of mass against the phalanx of the first hand's first given patch, or a rigid problem's first
/// support, both counted from t = 0; against the world if there is none.
struct Measure {
  enum class Kind {
    event_time,            ///< time of the `occurrence`-th first event of kind `event` of the chosen samples [s]
    displacement,          ///< relative displacement along `axis` at the instant [m]
    speed,                 ///< relative speed along `axis` at the instant [m/s]
    time_at_displacement,  ///< first time at which the relative displacement along `axis` reaches `level` [s]
    spin,                  ///< angular velocity about `axis` at the instant [rad/s]
    rotation,              ///< angle turned about `axis` since t = 0, unwrapped, at the instant [rad]
    held,                  ///< 1 if the largest |relative displacement along `axis`| stays below `level` [m], else 0
    no_event,              ///< 1 if no event of kind `event` happens, else 0
    event_count,           ///< how many events of kind `event` there are
    force,                 ///< on the body along `axis` by the chosen samples, on the frame `at` [N]
    torque,                ///< the same's torque about the axis through `point` [N m]
    dissipated,            ///< energy lost to friction and dampers since t = 0, on the frame `at` [J]
    force_sum,             ///< of `force` over the frames from `from` to `at`, of samples in `mode` only if given [N]
    mode_count,            ///< samples in `mode`, summed over the frames from `from` to `at`
    lag,                   ///< p − C along `axis`, mean of the chosen samples, on the frame `at` [m]
    work,                  ///< that the chosen samples gave their phalanges from `from` to `at`, on an object at rest;
                           ///< trapezoidal rule over the frames [J]
    growth,                ///< of an oscillation per frame, between the frames `from` and `at`; see frames_measure.hpp
    energy_residual,       ///< the greatest change of the energy ledger's sum over all frames [J]
    mode,                  ///< of the chosen sample on the frame `at`: 0 apart, 1 sticks, 2 slips
  };
  Kind kind{Kind::displacement};
  EventKind event{EventKind::touch};
  int occurrence{1};
  Eigen::Vector3d axis{Eigen::Vector3d::UnitX()};  ///< unit, in W
  std::optional<double> at{};                      ///< the instant [s]; nothing: the instant of the event
  double level{};
  int body{0};  ///< what is measured, and what the samples of events and forces touch
  int phalanx{-1},
      sample{-1};  ///< of what is read off contacts: -1 stands for all; a rigid problem's support is its `phalanx`
  int owner{-1};   ///< >= 0: only samples of that body's own surface
  bool from_last{false};  ///< bodies, hands, patches, samples and supports are counted from the last one on
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};  ///< in W [m]
  std::optional<double> from{};                    ///< where a sum over frames begins [s]; nothing: at `at`
  std::optional<Mode> mode{};
};

/// How far a measured value may lie from the truth, and why: how it follows from what a method errs by,
///
///   value + per_step h + per_delay d + α^recoveries (per_accuracy a + per_noise n + per_rounding r).
///
/// It is derived from the problem for a whole class of methods; which class an engine belongs to, and its h, d, α, a, n
/// and r, are its error model (compare/judge/error_model.hpp).
struct Limit {
  double value{};         ///< in the quantity's unit, or a fraction of the truth
  double per_accuracy{};  ///< times the accuracy a of a method that controls its error
  double per_noise{};     ///< times what is cleared away of the state at an event
  double per_rounding{};  ///< times what a state of size 1 is rounded by in a second of steps [unit s]
  double per_step{};      ///< times the step h of a method of first order [unit/s]
  double per_delay{};     ///< times the time d by which an event is found late [unit/s]
  int recoveries{0};      ///< of a force that follows the state: 1 through the speed of sliding, 2 through the gap
  bool relative{false};
  std::string reason{};  ///< why this much: a formula, not a wish
};

/// One true number of a case. It names no engine.
struct Claim {
  std::string quantity{};  ///< e.g. "slip onset"
  std::string unit{};
  double truth{};
  Pedigree pedigree{Pedigree::exact};
  std::string source{};  ///< formula and level, e.g. "L2 = L1: t_s = (N0 - m g / (2 mu_s)) / r"
  Measure measure{};
  Limit controlled{};     ///< of a method that controls its error to an accuracy
  Limit stepped{};        ///< of a fully implicit method of first order in its step
  bool converges{false};  ///< a stepped method's error in this quantity falls with its step: measure the order
  double scale{};         ///< what a share of the truth is a share of, where the truth is small or zero; 0: |truth|
};

}  // namespace handhold::catalogue
