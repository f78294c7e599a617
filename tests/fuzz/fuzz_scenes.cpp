// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_scenes [seconds] [seed]: random scenes through the reference. A valid one gives a recording of finite numbers
// whose energy book closes, whatever its outcome; a spoiled one gives an InputError of one line. Prints the seed of the
// first that does not, and exits with 1; `fuzz_scenes 0 SEED` runs that one alone.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "cases/model/input_error.hpp"
#include "reference/reference.hpp"
#include "tests/fuzz/random_scene.hpp"

namespace handhold::reference {
namespace {

constexpr double accuracy = 1e-7;

bool finite(const Recording& recording) {
  for (const Frame& frame : recording.frames) {
    for (const BodyState& b : frame.bodies)
      if (!b.X_WO.p.allFinite() || !b.X_WO.R.coeffs().allFinite() || !b.V_WO.v.allFinite() || !b.V_WO.w.allFinite())
        return false;
    for (const ContactState& c : frame.contacts)
      if (!c.p_W.allFinite() || !c.C_W.allFinite() || !c.n_W.allFinite() || !c.f_W.allFinite()) return false;
  }
  return true;
}

/// Of the energy book, as a part of what it turned over.
double imbalance(const Recording& recording) {
  double turnover = 1e-3;
  for (const Frame& frame : recording.frames) {
    const Energy& e = frame.energy;
    turnover = std::max(turnover, e.kinetic + std::abs(e.potential) + e.elastic + e.dissipated + std::abs(e.hand_work));
  }
  return energy_residual(recording) / turnover;
}

/// What is wrong with this scene's run; empty if nothing.
std::string trial(unsigned seed, std::string& outcome) {
  RandomScene random(seed);
  const RandomScene::Result made = random.make();
  Options options;
  options.accuracy = accuracy;
  options.step_limit = 20'000;
  options.surface = random.flip(0.3) ? SurfaceModel::mesh : SurfaceModel::voxels;
  try {
    const Recording r = simulate(made.scene, options);
    if (!made.spoiled.empty()) return "accepted: " + made.spoiled;
    outcome = r.outcome == Outcome::complete ? "complete" : r.note;
    if (!finite(r)) return "not finite";
    if (r.frames.empty() || (r.outcome != Outcome::complete && r.note.empty())) return "an outcome without a note";
    // Steps of accuracy 1e-7, some thousand of them, in metres and m/s of bodies up to 1e4 N/m stiff.
    if (!(imbalance(r) < 1e-2)) return "energy book off by " + std::to_string(imbalance(r)) + " of its turnover";
  } catch (const InputError& error) {
    outcome = std::string("refused: ") + error.what();
    if (made.spoiled.empty()) return outcome;
    if (outcome.find('\n') != std::string::npos) return "an error of several lines";
  } catch (const std::exception& error) {
    return std::string("threw: ") + error.what() + (made.spoiled.empty() ? "" : " when " + made.spoiled);
  }
  return {};
}

int run(double seconds, unsigned seed) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  int scenes = 0, completed = 0, refused = 0;
  double slowest = 0;
  unsigned slowest_seed = seed;
  do {
    const double before = elapsed();
    std::string outcome;
    const std::string fault = trial(seed, outcome);
    if (!fault.empty()) {
      std::printf("seed %u: %s\n", seed, fault.c_str());
      return 1;
    }
    if (elapsed() - before > slowest) slowest = elapsed() - before, slowest_seed = seed;
    completed += outcome == "complete";
    refused += outcome.rfind("refused", 0) == 0;
    if (seconds == 0) std::printf("seed %u: %s\n", seed, outcome.c_str());
    ++scenes, ++seed;
  } while (elapsed() < seconds);
  std::printf("%d scenes: %d complete, %d refused, %d stalled; the slowest took %.1f s (seed %u)\n", scenes, completed,
              refused, scenes - completed - refused, slowest, slowest_seed);
  return 0;
}

}  // namespace
}  // namespace handhold::reference

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60;
  const unsigned seed = argc > 2 ? unsigned(std::strtoul(argv[2], nullptr, 10)) : 1;
  return handhold::reference::run(seconds, seed);
}
