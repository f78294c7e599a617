#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "cases/scene/friction.hpp"
#include "realtime/block_system.hpp"
#include "realtime/body_step.hpp"
#include "realtime/element.hpp"
#include "realtime/patch_kernel.hpp"
#include "realtime/phase_clock.hpp"

namespace handhold::realtime {

/// A sample whose force is not linear in the velocities: what it is given, and what comes out.
struct Slider {
  std::size_t slot{};
  ElementStep element{};
  Eigen::Vector3d arm{Eigen::Vector3d::Zero()};      ///< p − centre of mass of its body, in W [m]
  bool sliding{false};                               ///< in: see Role; out: slides
  bool entering{false};                              ///< in: was apart
  bool presses{false};                               ///< out: has a force
  Trial trial{};                                     ///< out: at the solution
  Eigen::Vector3d f{Eigen::Vector3d::Zero()};        ///< out: force on the object [N]
  Eigen::Vector3d tangent{Eigen::Vector3d::Zero()};  ///< out: its tangential part [N]
  Eigen::Matrix3d slope{Eigen::Matrix3d::Zero()};    ///< out: −df/dv [N s/m]
};

/// All patches between two bodies in one step; hands are one body here.
struct PatchStep {
  int target{}, source{-1};           ///< bodies; source -1: hands
  int first_patch{}, patch_count{0};  ///< in Island::slots
  Stiffness stiffness{};
  Friction friction{};
  Eigen::Vector3d offset{Eigen::Vector3d::Zero()};  ///< from the source's centre of mass to the target's
  StickSums sums{};
  int first_slider{}, slider_count{};
  StickResult stuck{};  ///< out: of the linear samples
  bool watches{false};  ///< has samples on watch

  /// Adds a change of the bodies' velocities up to that of p against the target: dv + dw × arm.
  void relative(const std::vector<BodyStep>& bodies, Eigen::Vector3d& dv, Eigen::Vector3d& dw) const;
};

struct SolverOptions {
  int max_iterations{60};
  double tolerance{1e-13};  ///< of the momentum balance, relative to the sum of its terms' sizes
};

struct SolverReport {
  int iterations{};
  bool converged{true};
};

/// Bodies that are coupled through contacts with each other, with all their patches. Without such contacts, one body.
struct Island {
  std::vector<int> bodies{};  ///< those that move
  std::vector<PatchStep> patches{};
  std::vector<SlotStep> slots{};  ///< those of each PatchStep in a row
  std::vector<Slider> sliders{};
};

/// Solves the momentum balances (see BodyStep) of an island for the changes δ of its bodies' velocities.
///
/// What sticks is a spring and a damper, linear in δ, and enters as one sum a pair of bodies. What slides, may let go
/// or has just come in is iterated: semi-smooth Newton on touching (N >= 0) and sliding (|f_t| <= μ_d N). At a
/// solution, sticking samples outside the static cone start to slide, never back within a step, so the loop ends. One
/// body is a dense 6 x 6 system, several are a BlockSystem.
class IslandSolver {
 public:
  /// Room for islands of `bodies` bodies in all.
  void reserve(int bodies);
  void watch(PhaseClock* clock) { clock_ = clock; }  ///< see World::watch

  /// `role` by slot and `moments` by patch, in and out; forces of linear samples go to contacts.f_O, those of others to
  /// their sliders.
  SolverReport solve(Island& island, const Scheme& scheme, std::vector<BodyStep>& bodies, Contacts& contacts,
                     std::vector<StickMoments>& moments, std::vector<Role>& role, const SolverOptions& options);

 private:
  void collect(Island& island, const Scheme& scheme, const std::vector<BodyStep>& bodies, const Contacts& contacts,
               std::vector<StickMoments>& moments, const std::vector<Role>& role) const;
  void begin(const Island& island);
  [[nodiscard]] bool is_balanced(Island& island, double reach, const std::vector<BodyStep>& bodies, double tolerance,
                                 bool touching);
  void analyse(const Island& island);
  [[nodiscard]] bool add_slopes(const Island& island, double reach, const std::vector<BodyStep>& bodies, bool exact);
  void remember(const Island& island, const std::vector<BodyStep>& bodies);
  void add_stiffness(const PatchStep& patch, double reach, const Matrix6& S);
  void correct(const Island& island, std::vector<BodyStep>& bodies, bool symmetric);
  void step_back(const Island& island, std::vector<BodyStep>& bodies, double share) const;
  [[nodiscard]] int row(int body) const { return body < 0 ? -1 : row_[std::size_t(body)]; }

  std::vector<int> row_{};  // of a body in the system, -1: it does not move
  std::vector<Vector6> residual_{}, correction_{}, best_{};
  double best_squared_{};
  double squared_{};  // norm of the residual
  Matrix6 dense_{Matrix6::Zero()};
  BlockSystem blocks_{};
  bool analysed_{false};
  PhaseClock* clock_{};
};

}  // namespace handhold::realtime
