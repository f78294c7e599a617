#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"

namespace handhold::compare {

struct EngineOptions {
  double frame_rate{90};              ///< frames of the recording, and the real-time path's clock [Hz]
  std::vector<double> frame_times{};  ///< instead of a rate: ascending in (0, duration], the last at its end [s]
  int substeps{4};                    ///< of the real-time path, a frame
  int order{1};                       ///< of the real-time path: 1 implicit Euler, 2 implicit midpoint
  double accuracy{1e-10};             ///< of the reference's integrator
  double max_step{1e-3};              ///< of the reference's integrator [s]
  bool exact_mesh{false};             ///< the reference touches the triangles instead of the spline of the voxel field
};

/// Called now and then with the simulated time [s]; returning false stops the run, which keeps what it has.
using Progress = std::function<bool(double t)>;

/// Anything that turns a scene into a recording. An adapter is a few lines: see compare/engine/engines.cpp.
class Engine {
 public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual std::string name() const = 0;

  /// Throws InputError for a scene that the engine cannot express. A run that fails midway is data: see
  /// Recording::outcome.
  [[nodiscard]] virtual Recording simulate(const Scene& scene, const EngineOptions& options,
                                           const Progress& progress = {}) const = 0;
};

}  // namespace handhold::compare
