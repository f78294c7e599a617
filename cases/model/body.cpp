// SPDX-License-Identifier: Apache-2.0
#include "cases/model/body.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/Eigenvalues>

#include "cases/model/limits.hpp"

namespace handhold {
namespace {

constexpr double unit_tolerance = 1e-6;     // of a quaternion's norm: six printed digits are accepted
constexpr double inertia_tolerance = 1e-9;  // of the trace: rounding of a rotated tensor, far below any real violation
constexpr double least_mass = 1e-6;         // [kg]
constexpr double most_mass = 1e4;           // [kg]
constexpr std::size_t most_samples = std::numeric_limits<std::uint8_t>::max();  // SampleId has one byte

[[noreturn]] void reject(const std::string& what) { throw InputError(what); }

void check_moments(const std::string& who, const Eigen::Matrix3d& J) {
  const double scale = J.diagonal().cwiseAbs().sum();
  if (!J.allFinite()) reject(sentence(who, ": inertia must be finite (check the mesh and its density)"));
  if ((J - J.transpose()).cwiseAbs().maxCoeff() > inertia_tolerance * scale) {
    reject(sentence(who, ": inertia must be symmetric (set Jxy = Jyx, Jxz = Jzx, Jyz = Jzy)"));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(J, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d moments = solver.eigenvalues();  // ascending
  const std::string given = sentence(who, ": principal moments ", moments, " kg m^2");
  if (!(moments.x() > 0)) reject(given + ": must all be > 0 (give the inertia about the centre of mass)");
  if (moments.z() > moments.x() + moments.y() + inertia_tolerance * scale) {
    reject(given + ": the largest exceeds the sum of the others, which no solid has (check signs and units)");
  }
}

void check_inertia(const std::string& who, const Body& body) {
  check_vector(who + ": center of mass", body.inertia.center, "m", most_length);
  if (body.mobility == Mobility::fixed) return;  // its mass never enters
  if (!std::isfinite(body.inertia.mass) || body.inertia.mass <= 0) {
    reject(sentence(who, ": mass ", body.inertia.mass, " kg: must be finite and > 0 (or set the mobility to fixed)"));
  }
  if (body.inertia.mass < least_mass || body.inertia.mass > most_mass) {
    reject(sentence(who, ": mass ", body.inertia.mass, " kg: must be ", least_mass, " to ", most_mass,
                    " kg (check the unit of lengths and density)"));
  }
  if (body.mobility == Mobility::free) check_moments(who, body.inertia.about_center);
}

void check_velocity(const std::string& who, const Body& body) {
  check_vector(who + ": velocity", body.V_WO.v, "m/s", most_speed);
  check_vector(who + ": angular velocity", body.V_WO.w, "rad/s", most_spin);
  const bool turns = !body.V_WO.w.isZero(0);
  const bool moves = turns || !body.V_WO.v.isZero(0);
  if (body.mobility == Mobility::fixed && moves) {
    reject(who + ": a fixed body has no velocity (remove it, or set the mobility to free)");
  }
  if (body.mobility == Mobility::translation && turns) {
    reject(who + ": a body that only translates has no angular velocity (remove it, or set the mobility to free)");
  }
}

}  // namespace

void validate(const Body& body, const std::string& who) {
  if (!body.field) reject(who + ": has no shape (voxelize a mesh or make_box, and set field)");
  try {
    validate(body.friction);
  } catch (const InputError& error) {
    reject(who + ": " + error.what());
  }
  check_vector(who + ": position", body.X_WO.p, "m", most_length);
  if (!(std::abs(body.X_WO.R.norm() - 1) <= unit_tolerance)) {
    reject(sentence(who, ": orientation of norm ", body.X_WO.R.norm(), ": must be a unit quaternion (normalise it)"));
  }
  if (!std::isfinite(body.held_until) || body.held_until < 0) {
    reject(sentence(who, ": held_until ", body.held_until, " s: must be finite and >= 0 (0 lets it go at once)"));
  }
  check_inertia(who, body);
  check_velocity(who, body);
  if (body.samples_O.size() > most_samples) {
    reject(
        sentence(who, ": ", body.samples_O.size(), " surface samples: at most ", most_samples, " (space them wider)"));
  }
  for (const Eigen::Vector3d& p : body.samples_O) check_vector(who + ": surface sample", p, "m", most_length);
}

}  // namespace handhold
