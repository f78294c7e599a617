// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/law.hpp"

#include <algorithm>

namespace handhold::realtime::paper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double sign_of(const Options& options) { return options.sign == Sign::as_printed ? 1 : -1; }

/// Coulomb's tangent, printed sign: at most μ_d N along the spring's own.
bool limited(const PrintedForce& force, const Friction& friction) {
  return force.tangent.norm() > friction.mu_dynamic * std::max(0.0, force.normal);
}

}  // namespace

PrintedForce printed_force(const Sample& s, const Options& options) {
  PrintedForce force;
  force.f = options.stiffness * (s.C - s.p);  // eq. 1
  if (options.damping > 0) force.f += options.damping * (s.v_C - s.v_p);
  force.normal = force.f.dot(s.n);               // eq. 2
  force.tangent = force.f - force.normal * s.n;  // eq. 3
  force.pushes = force.normal > 0 && (s.C - s.p).dot(s.n) > 0;
  return force;
}

Mode classify(const PrintedForce& force, bool slipping, const Friction& friction, const Options& options) {
  if (options.gate == Gate::pushing && !force.pushes) return Mode::apart;
  const bool remembers = options.slip_state == SlipState::stateful && slipping;
  const double mu = remembers ? friction.mu_dynamic : friction.mu_static;
  const bool inside = force.normal > 0 && force.tangent.norm() <= mu * force.normal;  // eq. 4
  return inside ? Mode::stick : Mode::slip;
}

Vector3d force_on_object(const PrintedForce& force, const Vector3d& n, Mode mode, const Friction& friction,
                         const Options& options) {
  if (mode == Mode::apart) return Vector3d::Zero();
  if (mode == Mode::stick) return sign_of(options) * force.f;
  Vector3d tangent = friction.mu_dynamic * force.tangent;  // eq. 5
  if (options.slip_force == SlipForce::capped) {
    tangent = force.tangent;
    if (limited(force, friction)) tangent *= friction.mu_dynamic * std::max(0.0, force.normal) / force.tangent.norm();
  }
  return sign_of(options) * (force.normal * n + tangent);
}

// With the pull a = −f, so that the force on the object is g(a, n) for the sign `onto_object`:
//   stick   g = a
//   scaled  g = μ a + (1 − μ) (a·n) n
//   capped  g = (a·n) n + μ N t, N = −a·n, t = a_t / |a_t|, a_t = a − (a·n) n
ForceSlopes force_slopes(const PrintedForce& force, const Vector3d& n, Mode mode, const Friction& friction,
                         const Options& options) {
  ForceSlopes slopes;
  if (mode == Mode::apart) return slopes;
  const double mu = friction.mu_dynamic, an = -force.normal;
  const Vector3d a = -force.f;
  const Matrix3d project = n * n.transpose();
  const Matrix3d turn = n * a.transpose() + an * Matrix3d::Identity();  // d((a·n) n) / dn
  const bool scaled = options.slip_force == SlipForce::scaled;
  if (mode == Mode::stick || (!scaled && !limited(force, friction))) {
    slopes.by_pull = Matrix3d::Identity();
  } else if (scaled) {
    slopes.by_pull = mu * Matrix3d::Identity() + (1 - mu) * project;
    slopes.by_normal = (1 - mu) * turn;
  } else {
    const double length = force.tangent.norm(), N = std::max(0.0, force.normal);
    const Vector3d t = -force.tangent / length;
    const Matrix3d across = mu * N / length * (Matrix3d::Identity() - t * t.transpose());
    slopes.by_pull = project + across * (Matrix3d::Identity() - project);
    slopes.by_normal = turn - across * turn;
    if (force.normal > 0) {
      slopes.by_pull -= mu * t * n.transpose();
      slopes.by_normal -= mu * t * a.transpose();
    }
  }
  if (options.sign == Sign::as_printed) {
    slopes.by_pull = -slopes.by_pull;
    slopes.by_normal = -slopes.by_normal;
  }
  return slopes;
}

}  // namespace handhold::realtime::paper
