// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/catalogue/scenes/benchmark_scenes.hpp"

namespace handhold::catalogue {

// One function a benchmark scene or a family of them; see docs/benchmarks.md.

[[nodiscard]] BenchmarkScene pinch_benchmark();                    // S1
[[nodiscard]] BenchmarkScene cup_benchmark(bool by_its_wall);      // S6b, S6a
[[nodiscard]] BenchmarkScene incline_benchmark(double degrees);    // S3
[[nodiscard]] BenchmarkScene stopping_benchmark(double degrees);   // S3
[[nodiscard]] BenchmarkScene axe_benchmark();                      // S4a
[[nodiscard]] BenchmarkScene jenga_benchmark();                    // S4b
[[nodiscard]] BenchmarkScene swing_benchmark(bool with_friction);  // S5b, S5a

/// A body at rest, one box with the corners ±half, centred at its origin; it has no samples yet.
[[nodiscard]] Body benchmark_block(const std::string& name, const Eigen::Vector3d& half, double voxel_size, double mass,
                                   const Friction& friction);

}  // namespace handhold::catalogue
