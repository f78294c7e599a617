// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/middleware.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "cases/model/input_error.hpp"
#include "cases/model/rotation.hpp"
#include "realtime/paper/anchor.hpp"

namespace handhold::realtime::paper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Anchors of samples that have lost sight of the surface are looked for no farther than this [m].
constexpr double follow_reach = 0.02;

}  // namespace

Middleware::Middleware(std::shared_ptr<const Surface> surface, const Vector3d& center_O, const Friction& friction,
                       const Options& options, int patches)
    : surface_(std::move(surface)), center_O_(center_O), friction_(friction), options_(options) {
  validate(options);
  if (!surface_) throw InputError("paper middleware without a surface: the object needs a shape (give one)");
  if (patches < 1) throw InputError("paper middleware with " + std::to_string(patches) + " patches: needs at least 1");
  if (!(0 <= friction.mu_dynamic && friction.mu_dynamic <= friction.mu_static && std::isfinite(friction.mu_static)))
    throw InputError("paper middleware: friction must have 0 <= mu_dynamic <= mu_static (correct the coefficients)");
  patches_.resize(std::size_t(patches));
  v_p_.resize(std::size_t(patches));
  for (auto& v : v_p_) v.fill(Vector3d::Zero());
}

void Middleware::seed(int index, const Pose& X_WP, const Pose& X_WO, std::span<const Vector3d> p_P, double reach) {
  PatchState& patch = patches_[std::size_t(index)];
  patch = {};
  patch.active = true;
  const Pose X_OP = X_WO.inverse() * X_WP;
  for (const Vector3d& p : p_P) {
    if (patch.count == max_samples) break;
    const std::optional<Spot> spot = surface_->closest(X_OP * p, reach);
    if (!spot) continue;
    patch.samples[std::size_t(patch.count++)] = {Mode::apart, *spot, *spot, p, Vector3d::Zero()};
  }
  v_p_[std::size_t(index)].fill(Vector3d::Zero());
}

void Middleware::set(int patch, int sample, const Spot& anchor, Mode mode) {
  SampleState& s = patches_[std::size_t(patch)].samples[std::size_t(sample)];
  s.anchor = anchor;
  s.mode = mode;
}

void Middleware::drop(int patch) { patches_[std::size_t(patch)] = {}; }

Vector3d Middleware::point(const PatchState& patch, int i, const Pose& X_WP) const {
  return options_.point == Point::centroid ? X_WP.p : X_WP * patch.samples[std::size_t(i)].p_P;
}

Sample Middleware::sample_of(const PatchState& patch, int i, const BodyMotion& body) const {
  const SampleState& s = patch.samples[std::size_t(i)];
  Sample sample;
  sample.C = body.X_WO * s.anchor.C_O;
  sample.n = body.X_WO.R * s.anchor.n_O;
  sample.p = point(patch, i, patch.X_WP);
  sample.v_C = body.v + body.w.cross(sample.C - body.X_WO * center_O_);
  sample.v_p = v_p_[std::size_t(&patch - patches_.data())][std::size_t(i)];
  return sample;
}

const Wrench& Middleware::frame(double dt, std::span<const Pose> X_WP, const BodyMotion& body) {
  wrench_ = {};
  const Pose X_OW = body.X_WO.inverse();
  const Vector3d center = body.X_WO * center_O_;
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    PatchState& patch = patches_[k];
    if (!patch.active) continue;
    for (int i = 0; i < patch.count && options_.damping > 0; ++i) {
      const Vector3d moved = point(patch, i, X_WP[k]) - point(patch, i, patch.X_WP);
      v_p_[k][std::size_t(i)] = patch.known && dt > 0 ? Vector3d(moved / dt) : Vector3d::Zero();
    }
    patch.X_WP = X_WP[k];
    patch.known = true;
    for (int i = 0; i < patch.count; ++i) {
      step(patch, i, body, X_OW);
      const SampleState& s = patch.samples[std::size_t(i)];
      wrench_.force += s.f_W;
      wrench_.torque += (body.X_WO * s.used.C_O - center).cross(s.f_W);
    }
  }
  return wrench_;
}

void Middleware::step(PatchState& patch, int i, const BodyMotion& body, const Pose& X_OW) {
  SampleState& s = patch.samples[std::size_t(i)];
  Sample sample = sample_of(patch, i, body);
  PrintedForce force = printed_force(sample, options_);
  const Mode mode = classify(force, s.mode == Mode::slip, friction_, options_);
  const Vector3d p_O = X_OW * sample.p;
  if (options_.order == Order::anchor_first && mode == Mode::slip) {
    move_anchor(s, p_O, mode);
    sample = sample_of(patch, i, body);
    force = printed_force(sample, options_);
  }
  s.used = s.anchor;
  s.f_W = force_on_object(force, sample.n, mode, friction_, options_);
  if (options_.order == Order::force_first || mode == Mode::apart) move_anchor(s, p_O, mode);
  s.mode = mode;
}

void Middleware::move_anchor(SampleState& s, const Vector3d& p_O, Mode mode) const {
  if (mode == Mode::slip && options_.anchor_update == AnchorUpdate::ray)
    return cast_anchor(*surface_, p_O, options_, s.anchor);
  if (mode == Mode::slip) return drag_anchor(*surface_, p_O, friction_.mu_dynamic, options_, s.anchor);
  if (mode == Mode::stick || options_.apart_anchor == ApartAnchor::stays) return;
  if (const std::optional<Spot> spot = surface_->closest(p_O, follow_reach)) s.anchor = *spot;
}

Wrench Middleware::wrench_at(const BodyMotion& body) const {
  Wrench wrench;
  const Vector3d center = body.X_WO * center_O_;
  for (const PatchState& patch : patches_) {
    for (int i = 0; i < patch.count && patch.known; ++i) {
      const Sample s = sample_of(patch, i, body);
      const PrintedForce force = printed_force(s, options_);
      const bool slipping = patch.samples[std::size_t(i)].mode == Mode::slip;
      const Vector3d f =
          force_on_object(force, s.n, classify(force, slipping, friction_, options_), friction_, options_);
      wrench.force += f;
      wrench.torque += (s.C - center).cross(f);
    }
  }
  return wrench;
}

// The anchor's material point moves with the body: δC = δx + δθ × r, r = C − c; the normal turns: δn = δθ × n; and the
// pull a = γ (p − C) + c (v_p − v_C) changes by −γ δC − c δv_C, v_C = v + ω × r. The force then changes by
// G_a δa + G_n δn, and the torque r × f by δr × f + r × δf.
WrenchSlopes Middleware::slopes_at(const BodyMotion& body) const {
  WrenchSlopes slopes;
  const Vector3d center = body.X_WO * center_O_;
  for (const PatchState& patch : patches_) {
    for (int i = 0; i < patch.count && patch.known; ++i) {
      const Sample s = sample_of(patch, i, body);
      const PrintedForce force = printed_force(s, options_);
      const Mode mode = classify(force, patch.samples[std::size_t(i)].mode == Mode::slip, friction_, options_);
      if (mode == Mode::apart) continue;
      const Vector3d f = force_on_object(force, s.n, mode, friction_, options_);
      const ForceSlopes g = force_slopes(force, s.n, mode, friction_, options_);
      const Matrix3d r = cross_matrix(s.C - center);
      const Matrix3d turned_pull = options_.stiffness * r + options_.damping * cross_matrix(body.w) * r;
      const Matrix3d by_x = -options_.stiffness * g.by_pull;
      const Matrix3d by_angle = g.by_pull * turned_pull - g.by_normal * cross_matrix(s.n);
      const Matrix3d by_v = -options_.damping * g.by_pull;
      const Matrix3d by_w = options_.damping * g.by_pull * r;
      Matrix6 pose, velocity;
      pose << by_x, by_angle, r * by_x, r * by_angle + cross_matrix(f) * r;
      velocity << by_v, by_w, r * by_v, r * by_w;
      slopes.by_pose += pose;
      slopes.by_velocity += velocity;
    }
  }
  return slopes;
}

}  // namespace handhold::realtime::paper
