// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <Eigen/Core>

#include "cases/model/input_error.hpp"
#include "cases/model/text.hpp"

namespace handhold {

// Beyond these nothing is a hand with an object, and a simulation would run for ever or drown in rounding.
inline constexpr double most_length = 1e3;   // [m]
inline constexpr double most_speed = 1e3;    // [m/s]
inline constexpr double most_spin = 1e4;     // [rad/s]
inline constexpr double most_gravity = 1e3;  // [m/s²]

/// Throws InputError for a vector that is not finite or longer than `most`; `what` begins its sentence.
inline void check_vector(const std::string& what, const Eigen::Vector3d& v, const char* unit, double most) {
  if (!v.allFinite()) throw InputError(sentence(what, " = ", v, ": must be finite (give three numbers in ", unit, ")"));
  if (v.norm() > most) throw InputError(sentence(what, " = ", v, ": at most ", most, " ", unit, " (check the unit)"));
}

}  // namespace handhold
