// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/independent/slider.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::independent {
namespace {

Vec3 tangential(const Vec3& v, const Vec3& n) { return v - n * n.dot(v); }

/// Depth and lag of p seen from an anchor.
struct Stretch {
  Local at{};
  Real d{}, d_rate{};
  Vec3 e{Vec3::Zero()}, v_t{Vec3::Zero()};
};

Stretch stretch(const Surface& surface, const Point& x, const Vec3& anchor) {
  Stretch s;
  s.at = surface.at(anchor);
  s.d = -s.at.n.dot(x.p - anchor);
  s.e = x.p - anchor + s.d * s.at.n;
  s.d_rate = -s.at.n.dot(x.v);
  s.v_t = tangential(x.v, s.at.n);
  return s;
}

/// The anchor on the surface from which p is seen with the lag `ratio` d along `direction`, searched from `near`.
Vec3 anchor_for(const Surface& surface, const Vec3& p, Real ratio, const Vec3& direction, const Vec3& near) {
  Vec3 a = near;
  for (int i = 0; i < 100; ++i) {
    const Local at = surface.at(a);
    const Real d = -at.n.dot(p - a);
    const Vec3 along = ratio == 0 ? Vec3(Vec3::Zero()) : tangential(direction, at.n).normalized();
    const Vec3 step = p + d * at.n - ratio * d * along - a - at.phi * at.n;
    a += step;
    if (step.norm() < 1e-19L) break;
  }
  return a;
}

}  // namespace

Slider::Slider(const Law& law, std::shared_ptr<const Surface> surface, const SampleId& id)
    : law_(law), surface_(std::move(surface)), id_(id) {
  if (!surface_->flat()) return;
  const Vec3 n = surface_->at(Vec3::Zero()).n;
  t1_ = n.unitOrthogonal();
  t2_ = n.cross(t1_);
}

/// Apart: > 0 when p is inside and pressing.
Real Slider::approaching(const Point& x) const {
  const Local at = surface_->at(x.p);
  if (law_.c == 0) return -at.phi - law_.touch;
  if (at.phi >= 0) return -at.phi;
  const Stretch s = stretch(*surface_, x, anchor_for(*surface_, x.p, 0, Vec3::Zero(), x.p));
  return std::min(-at.phi, s.d + law_.c / law_.k * s.d_rate);
}

Answer Slider::sticking(const Point& x) const {
  const Stretch s = stretch(*surface_, x, anchor_);
  const Real N = law_.k * s.d + law_.c * s.d_rate;
  const Vec3 t = law_.k * s.e + law_.c * s.v_t;
  const Real letting_go = law_.c > 0 ? -N : law_.k * (law_.touch / 2 - s.d);
  return {t - N * s.at.n, Vec3::Zero(), std::max(letting_go, t.norm() - law_.mu_s * N)};
}

/// c = 0 on a face: e = ρ (cos θ, sin θ) with ρ = μ_d d; the anchor moves along −e only, so that all of v across e
/// turns it: ρ θ' = v·ê⊥.
Answer Slider::turning(const Point& x, Real angle) const {
  const Local at = surface_->at(x.p);
  const Real d = -at.phi, d_rate = -at.n.dot(x.v), rho = law_.mu_d * d;
  const Real c = std::cos(angle), s = std::sin(angle);
  const Vec3 along = c * t1_ + s * t2_, across = c * t2_ - s * t1_;
  const Real anchor_speed = along.dot(x.v) - law_.mu_d * d_rate;
  return {law_.k * d * (law_.mu_d * along - at.n), Vec3(across.dot(x.v) / rho, 0, 0),
          std::max(law_.k * (law_.touch / 2 - d), -anchor_speed)};
}

/// c = 0 on a curved surface: the anchor moves at s ê such that |e| = μ_d d stays. With n' = s K ê,
/// d' = −v·n − s e·Kê and ê·e' = ê·v − s + s d ê·Kê, so s (1 − ê·Kê (d + μ_d ρ)) = ê·v + μ_d v·n.
Answer Slider::sliding(const Point& x, const Vec3& anchor) const {
  const Stretch s = stretch(*surface_, x, anchor);
  const Real rho = s.e.norm();
  const Vec3 along = s.e / rho;
  const Real kappa = along.dot(s.at.shape * along);
  const Real speed = (along.dot(x.v) + law_.mu_d * s.at.n.dot(x.v)) / (1 - kappa * (s.d + law_.mu_d * rho));
  return {law_.k * s.d * (law_.mu_d * along - s.at.n), speed * along,
          std::max(law_.k * (law_.touch / 2 - s.d), -speed)};
}

/// c > 0: what the spring and damper pull more than the slider holds moves the anchor: c a' = t* − μ_d N t*/|t*|.
Answer Slider::creeping(const Point& x, const Vec3& anchor) const {
  const Stretch s = stretch(*surface_, x, anchor);
  const Real N = law_.k * s.d + law_.c * s.d_rate;
  const Vec3 t = law_.k * s.e + law_.c * s.v_t;
  const Real pull = t.norm(), grip = law_.mu_d * N;
  const Vec3 along = t / pull;
  return {grip * along - N * s.at.n, (pull - grip) / law_.c * along, std::max(-N, grip - pull)};
}

Answer Slider::answer(const Point& x, const Vec3& z) const {
  if (mode_ == Mode::apart) return {Vec3::Zero(), Vec3::Zero(), approaching(x)};
  if (mode_ == Mode::stick) return sticking(x);
  if (law_.c > 0) return creeping(x, z);
  return by_angle() ? turning(x, z[0]) : sliding(x, z);
}

void Slider::slip_along(const Point& x, const Vec3& direction, const Vec3& near, Eigen::Ref<Vec3> z) {
  mode_ = Mode::slip;
  if (by_angle())
    z = Vec3(std::atan2(t2_.dot(direction), t1_.dot(direction)), 0, 0);
  else
    z = anchor_for(*surface_, x.p, law_.mu_d, direction, near);
}

void Slider::start(const Point& x, const Vec3& lag, bool slipping, Eigen::Ref<Vec3> z) {
  z.setZero();
  if (!(surface_->at(x.p).phi < 0)) return;
  anchor_ = anchor_for(*surface_, Vec3(x.p - lag), 0, Vec3::Zero(), Vec3(x.p - lag));
  const Vec3 n = surface_->at(anchor_).n;
  mode_ = Mode::stick;
  if (!slipping) return;
  mode_ = Mode::slip;
  z = anchor_;
  if (law_.c == 0) slip_along(x, tangential(lag, n).norm() > 0 ? lag : tangential(x.v, n), anchor_, z);
}

/// Starts with no lag; slips at once if it moves sideways faster than its cone widens.
void Slider::touch(const Point& x, Eigen::Ref<Vec3> z) {
  anchor_ = anchor_for(*surface_, x.p, 0, Vec3::Zero(), x.p);
  mode_ = Mode::stick;
  const Stretch s = stretch(*surface_, x, anchor_);
  if (law_.c > 0 && sticking(x).due > 0) {
    mode_ = Mode::slip;
    z = anchor_;
  }
  if (law_.c == 0 && s.v_t.norm() > law_.mu_s * s.d_rate) slip_along(x, s.v_t, anchor_, z);
}

std::optional<EventKind> Slider::change(const Point& x, Eigen::Ref<Vec3> z) {
  if (!(answer(x, z).due > 0)) return {};
  if (mode_ == Mode::apart) {
    touch(x, z);
    return EventKind::touch;
  }
  const Vec3 anchor = mode_ == Mode::stick ? anchor_ : Vec3(z);
  const bool angle = mode_ == Mode::slip && by_angle();
  const Stretch s = angle ? Stretch{} : stretch(*surface_, x, anchor);
  const Real d = angle ? -surface_->at(x.p).phi : s.d;
  const bool let_go = law_.c > 0 ? law_.k * s.d + law_.c * s.d_rate < 0 : d < law_.touch / 2;
  if (let_go) {
    mode_ = Mode::apart;
    z.setZero();
    return EventKind::release;
  }
  if (mode_ == Mode::stick) {
    if (law_.c == 0) {
      slip_along(x, s.e, anchor_, z);
    } else {
      mode_ = Mode::slip;
      z = anchor_;
    }
    return EventKind::breakaway;
  }
  if (law_.c > 0) {
    anchor_ = z;
  } else {
    const Vec3 along = angle ? Vec3(std::cos(z[0]) * t1_ + std::sin(z[0]) * t2_) : s.e;
    anchor_ = anchor_for(*surface_, x.p, law_.mu_d, along, angle ? x.p : anchor);
  }
  mode_ = Mode::stick;
  z.setZero();
  return EventKind::restick;
}

void Slider::clean(const Point& x, Eigen::Ref<Vec3> z) const {
  if (mode_ != Mode::slip || surface_->flat()) return;
  if (law_.c == 0) {
    z = anchor_for(*surface_, x.p, law_.mu_d, stretch(*surface_, x, z).e, z);
    return;
  }
  const Local at = surface_->at(z);
  z -= at.phi * at.n;
}

Real Slider::weight(const Point& x) const {
  if (mode_ != Mode::slip || !by_angle()) return 1;
  // Near lift-off the lag has no length to speak of, but its direction still says whether it slips: 1e-8 rad of 1e-14
  // m.
  return std::max(-law_.mu_d * surface_->at(x.p).phi, Real(1e-6L));
}

}  // namespace handhold::independent
