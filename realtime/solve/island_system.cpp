// SPDX-License-Identifier: Apache-2.0
#include "realtime/solve/island_system.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "realtime/solve/small_solve.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Σ Gᵀ G slope over the linear samples, G = [1, −a×].
Matrix6 stick_slope(const PatchStep& p) {
  const double s = p.stiffness.slope;
  const Matrix3d a = s * cross_matrix(p.sums.arm);
  Matrix6 S;
  S.topLeftCorner<3, 3>() = s * p.sums.count * Matrix3d::Identity();
  S.topRightCorner<3, 3>() = -a;
  S.bottomLeftCorner<3, 3>() = a;
  S.bottomRightCorner<3, 3>() = s * (p.sums.arm_arm.trace() * Matrix3d::Identity() - p.sums.arm_arm);
  return S;
}

/// Adds Gᵀ D G.
void add_slope(const Vector3d& arm, const Matrix3d& D, Matrix6& S) {
  const Matrix3d r = cross_matrix(arm);
  const Matrix3d Dr = D * r;
  S.topLeftCorner<3, 3>() += D;
  S.topRightCorner<3, 3>() -= Dr;
  S.bottomLeftCorner<3, 3>() += r * D;
  S.bottomRightCorner<3, 3>() -= r * Dr;
}

/// Evaluates one element at a change `dv` of relative velocity.
///
/// What sticks may, until it is known to hold, pull no harder than its static cone either: else its force would jump
/// as it lets go, and there might be no solution.
void evaluate(Slider& slider, const Vector3d& dv, const Friction& friction, Cones cones) {
  move_trial(slider.element, slider.at_rest, dv, slider.trial);
  slider.acts = true;
  ElementForce force;
  if (cones == Cones::frozen)
    force = capped_force(slider.element, slider.trial, slider.cap);
  else if (slider.trial.N > 0)
    force = sliding_force(slider.element, slider.trial, slider.limit(friction));
  else if (cones == Cones::touching && slider.entering)
    force = sticking_force(slider.element, slider.trial);
  else
    slider.acts = false;
  slider.grip = force.grip;
  slider.f = force.f;
  slider.tangent = force.tangent;
}

}  // namespace

void PatchStep::relative(const std::vector<BodyStep>& bodies, Vector3d& dv, Vector3d& dw) const {
  const Vector6& d = bodies[std::size_t(target)].change;
  dv = d.head<3>();
  dw = d.tail<3>();
  if (source < 0) return;
  const Vector6& e = bodies[std::size_t(source)].change;
  dv -= e.head<3>() + e.tail<3>().cross(offset);
  dw -= e.tail<3>();
}

void IslandSystem::reserve(int bodies) {
  row_.assign(std::size_t(bodies), -1);
  residual_.reserve(std::size_t(bodies));
  step_.reserve(std::size_t(bodies));
  if (bodies > 1) blocks_.reserve(bodies);
  acting_.reserve(std::size_t(bodies) * std::size_t(bodies));
}

void IslandSystem::begin(const Island& island, double reach) {
  reach_ = reach;
  residual_.resize(island.bodies.size());
  step_.resize(island.bodies.size());
  for (std::size_t i = 0; i < island.bodies.size(); ++i) row_[std::size_t(island.bodies[i])] = int(i);
}

/// Most of what is near in a blow does not touch.
void IslandSystem::regroup(const Island& island) {
  acting_.clear();
  for (std::size_t i = 0; i < island.patches.size(); ++i)
    if (island.patches[i].sums.count > 0 || island.patches[i].slider_count > 0) acting_.push_back(int(i));
  analysed_ = island.bodies.size() < 2;
}

void IslandSystem::end(Island& island, const std::vector<BodyStep>& bodies) {
  for (const int i : acting_) {
    const PatchStep& p = island.patches[std::size_t(i)];
    Vector3d dv, dw;
    p.relative(bodies, dv, dw);
    for (int k = p.first_slider; k < p.first_slider + p.slider_count; ++k) {
      Slider& slider = island.sliders[std::size_t(k)];
      const Trial all = trial(slider.element, dv + dw.cross(slider.arm));
      slider.trial.depth = all.depth;
      slider.trial.lag = all.lag;
      slider.trial.v_t = all.v_t;
    }
  }
  for (const int body : island.bodies) row_[std::size_t(body)] = -1;
}

/// Once after `regroup`, and only if there is anything to solve for.
void IslandSystem::analyse(const Island& island) {
  if (analysed_) return;
  analysed_ = true;
  blocks_.begin(int(island.bodies.size()));
  for (const int i : acting_) {
    const int t = row(island.patches[std::size_t(i)].target), s = row(island.patches[std::size_t(i)].source);
    if (t >= 0 && s >= 0) blocks_.couple(t, s);
  }
  blocks_.analyse();
}

/// Puts a patch's slope against its relative velocity where its bodies' velocities are: T = [1, −offset×; 0, 1] takes
/// the source's to the target's centre.
void IslandSystem::add_stiffness(const PatchStep& p, const Matrix6& S) {
  const int t = row(p.target), s = row(p.source);
  if (residual_.size() > 1) return blocks_.add_contact(t, s, p.offset, reach_ * S);
  if (t >= 0) dense_ += reach_ * S;
  if (s < 0) return;
  Matrix6 T = Matrix6::Identity();
  T.topRightCorner<3, 3>() = -cross_matrix(p.offset);
  dense_ += reach_ * T.transpose() * S * T;
}

bool IslandSystem::balance(Island& island, const std::vector<BodyStep>& bodies, double tolerance, Cones cones) {
  constexpr double rounding = 4e-16;
  double size = 0, noise = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyStep& body = bodies[std::size_t(island.bodies[i])];
    residual_[i] = body.rest;
    if (!body.change.isZero(0)) residual_[i] -= body.mass * body.change;
    size += reach_ * std::sqrt(body.squared_norm(body.external)) + std::sqrt(body.squared_norm(body.momentum));
  }
  for (const int index : acting_) {
    const PatchStep& p = island.patches[std::size_t(index)];
    Vector3d dv, dw;
    p.relative(bodies, dv, dw);
    const double s = p.stiffness.slope;
    const Matrix3d& aa = p.sums.arm_arm;
    Vector3d force = p.sums.force - s * (p.sums.count * dv + dw.cross(p.sums.arm));
    Vector3d torque = p.sums.torque - s * (p.sums.arm.cross(dv) + aa.trace() * dw - aa * dw);
    size += reach_ * force.norm();
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      Slider& slider = island.sliders[std::size_t(i)];
      evaluate(slider, dv + dw.cross(slider.arm), p.friction, cones);
      force += slider.f;
      torque += slider.arm.cross(slider.f);
      size += reach_ * slider.f.norm();
    }
    // What rounding of positions makes of forces, and that of patches which press against each other.
    const double extent = bodies[std::size_t(p.target)].center.norm() + p.offset.norm();
    const double stiff = reach_ * p.stiffness.k * extent, apart = 2 * reach_ * p.sums.size;
    noise += (p.sums.count + p.slider_count) * stiff * stiff + apart * apart;
    if (const int t = row(p.target); t >= 0) {
      residual_[std::size_t(t)].head<3>() += reach_ * force;
      residual_[std::size_t(t)].tail<3>() += reach_ * torque;
    }
    if (const int t = row(p.source); t >= 0) {
      residual_[std::size_t(t)].head<3>() -= reach_ * force;
      residual_[std::size_t(t)].tail<3>() -= reach_ * (torque + p.offset.cross(force));
    }
  }
  squared_ = 0;
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    const BodyStep& body = bodies[std::size_t(island.bodies[i])];
    if (!body.turns) residual_[i].tail<3>().setZero();
    squared_ += body.squared_norm(residual_[i]);
  }
  return std::sqrt(squared_) <= tolerance * size + rounding * std::sqrt(noise);
}

/// The system of a Newton step; true if it is symmetric.
bool IslandSystem::add_slopes(const Island& island, const std::vector<BodyStep>& bodies) {
  analyse(island);
  const bool one = island.bodies.size() == 1;
  const bool symmetric =
      std::none_of(island.sliders.begin(), island.sliders.end(), [](const Slider& s) { return s.grip.mu > 0; });
  if (one)
    dense_ = bodies[std::size_t(island.bodies[0])].mass;
  else
    blocks_.clear(symmetric);
  for (std::size_t i = 0; !one && i < island.bodies.size(); ++i)
    blocks_.block(int(i), int(i)) = bodies[std::size_t(island.bodies[i])].mass;
  for (const int index : acting_) {
    const PatchStep& p = island.patches[std::size_t(index)];
    Matrix6 S = Matrix6::Zero();
    if (p.sums.count > 0) S = stick_slope(p);
    for (int i = p.first_slider; i < p.first_slider + p.slider_count; ++i) {
      const Slider& slider = island.sliders[std::size_t(i)];
      if (slider.acts) add_slope(slider.arm, slope_of(slider.element, slider.trial, slider.grip), S);
    }
    add_stiffness(p, S);
  }
  return symmetric;
}

void IslandSystem::correct(const Island& island, std::vector<BodyStep>& bodies) {
  const bool symmetric = add_slopes(island, bodies);
  step_ = residual_;
  if (island.bodies.size() > 1)
    blocks_.solve(step_);
  else if (symmetric)
    step_[0] = solve_symmetric(dense_, step_[0]);
  else
    step_[0] = dense_.partialPivLu().solve(Vector6(step_[0]));
  for (std::size_t i = 0; i < step_.size(); ++i) {
    BodyStep& body = bodies[std::size_t(island.bodies[i])];
    if (!body.turns) step_[i].tail<3>().setZero();
    body.change += step_[i];
  }
}

void IslandSystem::step_back(const Island& island, std::vector<BodyStep>& bodies, double share) const {
  for (std::size_t i = 0; i < step_.size(); ++i) bodies[std::size_t(island.bodies[i])].change -= share * step_[i];
}

double IslandSystem::fall() const {
  double sum = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) sum += residual_[i].dot(step_[i]);
  return sum;
}

}  // namespace handhold::realtime
