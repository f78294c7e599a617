// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/element.hpp"

#include <Eigen/LU>

#include "cases/model/defect.hpp"

namespace handhold::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Pulls an anchor that drifted by round-off and integration error back to its surface and cone [1/s]. Fast against a
/// scene, slow against a step.
constexpr double stabilisation = 200;

constexpr double least_divisor = 0.02;

void stick(const Element& element, const Approach& approach, Response& o, const Vector3d& n) {
  o.force = -o.normal_force * n + o.trial;
  o.friction =
      o.trial.norm() -
      DEFECT(reference_breaks_away_at_mu_d, element.friction.mu_static, element.friction.mu_dynamic) * o.normal_force;
  o.dissipation = DEFECT(reference_damper_warms_nothing, element.damping, 0.0) * approach.v.squaredNorm();
}

/// c > 0: the slider yields under the force that the spring and damper pass on to it: c a' = t* − mu_d N t̂.
void damped_slip(const Element& element, const Vector3d& v_t, Response& o, const Vector3d& n) {
  const double c = element.damping, size = o.trial.norm();
  const double mu = DEFECT(reference_damped_slides_at_mu_s, element.friction.mu_dynamic, element.friction.mu_static);
  const double limit = mu * o.normal_force;
  const Vector3d direction = size > 0 ? Vector3d(o.trial / size) : Vector3d::Zero();
  const double speed = (size - limit) / c;
  o.force = -o.normal_force * n + limit * direction;
  o.anchor_rate = speed * direction;
  o.friction = element.friction.mu_dynamic > 0 ? limit - size : -1;
  o.dissipation = c * (o.depth_rate * o.depth_rate + (v_t - o.anchor_rate).squaredNorm()) + limit * speed;
}

/// c = 0, mu_d = 0: the anchor stays below p: differentiate p = C − d n, with n' = K C'.
void frictionless_slip(const Vector3d& v_t, const AnchorSurface& surface, Response& o) {
  const Vector3d& n = surface.n;
  const Matrix3d tangent = Matrix3d::Identity() - n * n.transpose();
  const Matrix3d system = Matrix3d::Identity() - o.depth * tangent * surface.curvature * tangent;
  o.singular = !(system.determinant() > least_divisor);
  if (o.singular) return;
  o.anchor_rate = system.inverse() * v_t + stabilisation * o.lag;
  o.friction = -1;
}

/// c = 0: the anchor moves along the lag so that |e| = mu_d d is kept on a surface of curvature κ along ê:
/// λ = (ê·v + mu_d v·n) / (1 − κ (d + mu_d |e|)), from differentiating |e| and d in O.
void spring_slip(const Element& element, const Approach& approach, const AnchorSurface& surface, Response& o) {
  const Vector3d& n = surface.n;
  const double mu = element.friction.mu_dynamic, length = o.lag.norm();
  const Vector3d direction = length > 0 ? Vector3d(o.lag / length) : Vector3d::Zero();
  o.force = o.normal_force * (mu * direction - n);
  const double kappa = direction.dot(surface.curvature * direction);
  const double divisor = 1 - DEFECT(reference_ignores_curvature, kappa, 0.0) * (o.depth + mu * length);
  o.singular = !(divisor > least_divisor);
  if (o.singular) return;
  const double lambda = (direction.dot(approach.v) + mu * approach.v.dot(n)) / divisor;
  const double speed = lambda + stabilisation * (length - mu * o.depth);
  o.anchor_rate = speed * direction;
  o.friction = o.depth > element.shallow ? -lambda : -1;
  o.dissipation = element.stiffness * length * speed;  // f·v less the spring's rate of energy
}

}  // namespace

Response respond(const Element& element, Mode mode, const Approach& approach, const AnchorSurface& surface) {
  const Vector3d& n = surface.n;
  const double k = element.stiffness, c = element.damping;
  Response o;
  o.depth = -approach.r.dot(n);
  o.lag = approach.r + o.depth * n;
  o.depth_rate = -approach.v.dot(n);
  const Vector3d v_t = approach.v + o.depth_rate * n;
  o.normal_force = k * o.depth + c * o.depth_rate;
  o.trial = k * o.lag + c * v_t;
  o.release = c > 0 ? -o.normal_force : k * (touch_depth / 2 - o.depth);
  if (mode == Mode::stick) {
    stick(element, approach, o, n);
    return o;
  }
  if (c > 0) {
    damped_slip(element, v_t, o, n);
  } else if (element.friction.mu_dynamic > 0) {
    spring_slip(element, approach, surface, o);
  } else {
    o.force = -o.normal_force * n;
    frictionless_slip(v_t, surface, o);
  }
  o.anchor_rate -= stabilisation * surface.phi * n;
  return o;
}

}  // namespace handhold::reference
