// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace handhold::realtime {

/// What a step does, in this order.
enum class Phase : std::uint8_t {
  hands,      ///< the hands' paths, and where all phalanges are at the end of the sub-step
  bodies,     ///< where bodies would go
  detection,  ///< who may touch whom
  islands,    ///< which bodies move together
  patches,    ///< how patches move, and what their samples may do
  sums,       ///< what sticking samples are for the solve
  solve,      ///< Newton's steps
  check,      ///< every sticking sample at the solution
  finish,     ///< bodies move, anchors slide, energy is booked
};

inline constexpr std::array<std::string_view, 9> phase_names{"hands", "bodies", "detection", "islands", "patches",
                                                             "sums",  "solve",  "check",     "finish"};

/// Tells where the time of World::advance goes (World::watch). A reading of the clock, some 20 ns, is in every lap.
class PhaseClock {
 public:
  using Seconds = std::array<double, phase_names.size()>;

  /// To be called just before `advance`.
  void begin() {
    seconds_.fill(0);
    laps_.fill(0);
    last_ = Clock::now();
  }
  /// Everything since the last lap was `phase`.
  void lap(Phase phase) {
    const Clock::time_point now = Clock::now();
    seconds_[std::size_t(phase)] += std::chrono::duration<double>(now - last_).count();
    ++laps_[std::size_t(phase)];
    last_ = now;
  }
  [[nodiscard]] const Seconds& seconds() const { return seconds_; }  ///< since `begin` [s]
  [[nodiscard]] int laps(Phase phase) const { return laps_[std::size_t(phase)]; }

 private:
  using Clock = std::chrono::steady_clock;
  Seconds seconds_{};
  Clock::time_point last_{};
  std::array<int, phase_names.size()> laps_{};
};

}  // namespace handhold::realtime
