// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "realtime/phase_clock.hpp"
#include "realtime/solve/island.hpp"
#include "realtime/solve/island_system.hpp"

namespace handhold::realtime {

struct SolverOptions {
  double tolerance{1e-13};  ///< of the momentum balance, relative to the sum of its terms' sizes
};

struct SolverReport {
  int iterations{};  ///< Newton steps
  bool converged{true};
};

/// Solves the momentum balances of an island for the changes δ of its bodies' velocities.
///
/// For given roles, semi-smooth Newton on touching (N >= 0) and on the cones (|f_t| <= μ N) finds δ in a few steps.
/// Friction that grows with pressure can send it in circles; then the limits of friction are frozen, which leaves a
/// convex problem that Newton cannot miss, and found anew from its solution, until Newton gets home from there.
/// At a solution, sticking samples outside the static cone start to slide, samples that pull let go and those on watch
/// come in: never back within a step, so the rounds end.
///
/// A first attempt is eager: it changes roles on the way to a solution, and cuts steps that make things worse. That
/// takes half the time, but what was let in too early may leave no solution. Then a second one starts from the
/// beginning.
class IslandSolver {
 public:
  /// Room for islands of `bodies` bodies in all.
  void reserve(int bodies);
  /// ... that have `slots` samples in all.
  void reserve_slots(std::size_t slots) { first_role_.reserve(slots); }

  void watch(PhaseClock* clock) { clock_ = clock; }  ///< see World::watch

  /// `role` by slot and `moments` by patch, in and out; forces of linear samples go to contacts.f_O, those of others to
  /// their sliders.
  SolverReport solve(Island& island, const Scheme& scheme, std::vector<BodyStep>& bodies, Contacts& contacts,
                     std::vector<StickMoments>& moments, std::vector<Role>& role, const SolverOptions& options);

 private:
  using Changes = std::vector<Vector6>;

  /// All samples of an island, whatever their roles.
  struct Samples {
    const Scheme& scheme;
    Contacts& contacts;
    std::vector<StickMoments>& moments;
    std::vector<Role>& role;
  };

  void collect(Island& island, const std::vector<BodyStep>& bodies, const Samples& samples);
  [[nodiscard]] bool change_roles(Island& island, const std::vector<BodyStep>& bodies, const Samples& samples);
  [[nodiscard]] bool find_balance(Island& island, std::vector<BodyStep>& bodies, const Samples& samples, bool first);
  [[nodiscard]] bool attempt(Island& island, std::vector<BodyStep>& bodies, const Samples& samples);
  void keep_roles(const Island& island, const Samples& samples);
  void begin_again(Island& island, std::vector<BodyStep>& bodies, const Samples& samples);
  [[nodiscard]] bool newton(Island& island, std::vector<BodyStep>& bodies, const Samples* samples, int patience,
                            bool first);
  [[nodiscard]] bool cut_step(double before, Island& island, std::vector<BodyStep>& bodies);
  void descend(Island& island, std::vector<BodyStep>& bodies);
  void lap(Phase phase) {
    if (clock_) clock_->lap(phase);
  }
  void remember_best(const Island& island, const std::vector<BodyStep>& bodies);

  IslandSystem system_{};
  double tolerance_{};
  int iterations_{};
  bool eager_{true};
  std::vector<Role> first_role_{};  // by slot of the island's patches, in a row
  Changes best_{}, frozen_{};       // δ: of the least residual; of the last frozen problem
  double best_squared_{};
  PhaseClock* clock_{};
};

}  // namespace handhold::realtime
