// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/independent/solver.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

#include "tests/reference/independent/extrapolation.hpp"

namespace handhold::independent {
namespace {

constexpr int body_states = 13;  // x (3), v (3), q as x, y, z, w (4), L (3)
constexpr Real least_step = 1e-16L, root_width = 1e-17L;

struct Pad {
  int hand{}, phalanx{};
  Vec3 origin{Vec3::Zero()}, origin_v{Vec3::Zero()}, spin{Vec3::Zero()};  // memory of one instant
  Mat3 R{Mat3::Identity()};
};

struct Given {
  std::size_t pad{};
  Vec3 p_P{Vec3::Zero()};
};

class Run {
 public:
  Run(const Scene& scene, const SurfaceChoice& surface, const Settings& settings);
  Result run();

 private:
  struct BodyMotion {
    Vec3 x{Vec3::Zero()}, v{Vec3::Zero()}, w{Vec3::Zero()};
    Mat3 R{Mat3::Identity()};
  };

  [[nodiscard]] BodyMotion motion(const State& y) const;
  void place_hands(Real t);
  [[nodiscard]] Point point(std::size_t j, const BodyMotion& body) const;
  void rhs(Real t, const State& y, State& dy);
  [[nodiscard]] Real due(std::size_t j, Real t, const State& y);
  void settle(Real t, State& y, bool record);
  [[nodiscard]] State weights(Real t, const State& y);
  [[nodiscard]] Real first_event(Real t, const State& y, const State& slope, Real h, const State& end);
  [[nodiscard]] Real root(std::size_t j, Real t, const State& y, const State& slope, Real a, Real b, Real at_b);
  [[nodiscard]] Real to_knot(Real t) const;
  void clean(Real t, State& y);

  [[nodiscard]] Vec3 z(const State& y, std::size_t j) const { return y.segment<3>(body_states + 3 * Eigen::Index(j)); }

  const Scene& scene_;
  const Body& body_;
  Settings settings_;
  Mat3 inertia_, inverse_inertia_;
  std::vector<Pad> pads_;
  std::vector<Given> given_;
  std::vector<Slider> sliders_;
  GraggBulirschStoer<std::function<void(Real, const State&, State&)>> integrator_;
  Real hands_at_{-1e9L};
  State start_;
  Result result_;
};

Run::Run(const Scene& scene, const SurfaceChoice& surface, const Settings& settings)
    : scene_(scene),
      body_(scene.bodies.front()),
      settings_(settings),
      inertia_(body_.inertia.about_center.cast<Real>()),
      inverse_inertia_(inertia_.inverse()),
      integrator_(settings.columns, [this](Real t, const State& y, State& dy) { rhs(t, y, dy); }) {
  const bool simple =
      scene.bodies.size() == 1 && body_.mobility == Mobility::free && !(body_.held_until > 0) && !body_.load;
  if (!simple) throw std::runtime_error("one free body without support or load is all this solver knows");
  const Law law{scene.contact.stiffness, scene.contact.damping, body_.friction.mu_static, body_.friction.mu_dynamic};
  std::vector<const SampleStart*> starts;
  for (std::size_t h = 0; h < scene.hands.size(); ++h)
    for (const GivenPatch& patch : scene.hands[h].given) {
      Pad pad;
      pad.hand = int(h);
      pad.phalanx = patch.phalanx;
      pads_.push_back(pad);
      for (std::size_t i = 0; i < patch.p_P.size(); ++i) {
        given_.push_back({pads_.size() - 1, patch.p_P[i].cast<Real>()});
        starts.push_back(patch.start.empty() ? nullptr : &patch.start[i]);
      }
    }
  start_ = State::Zero(body_states + 3 * Eigen::Index(given_.size()));
  const Mat3 R = body_.X_WO.R.cast<Real>().normalized().toRotationMatrix();
  const Vec3 w = body_.V_WO.w.cast<Real>(), arm = R * body_.inertia.center.cast<Real>();
  start_.segment<3>(0) = body_.X_WO.p.cast<Real>() + arm;
  start_.segment<3>(3) = body_.V_WO.v.cast<Real>() + w.cross(arm);
  start_.segment<4>(6) = body_.X_WO.R.cast<Real>().normalized().coeffs();
  start_.segment<3>(10) = R * inertia_ * R.transpose() * w;
  place_hands(0);
  const BodyMotion body = motion(start_);
  for (std::size_t j = 0; j < given_.size(); ++j) {
    const Pad& pad = pads_[given_[j].pad];
    int sample = 0;
    for (std::size_t i = 0; i < j; ++i) sample += given_[i].pad == given_[j].pad;
    const Point x = point(j, body);
    const SampleId id{std::uint8_t(pad.hand), std::uint8_t(pad.phalanx), 0, std::uint8_t(sample)};
    sliders_.emplace_back(law, surface(x.p), id);
    if (starts[j])
      sliders_[j].start(x, R.transpose() * starts[j]->lag_W.cast<Real>(), starts[j]->slipping,
                        start_.segment<3>(body_states + 3 * Eigen::Index(j)));
  }
  settle(0, start_, false);
}

Run::BodyMotion Run::motion(const State& y) const {
  BodyMotion m;
  m.x = y.segment<3>(0);
  m.v = y.segment<3>(3);
  Quat q;
  q.coeffs() = y.segment<4>(6);
  m.R = q.normalized().toRotationMatrix();
  m.w = m.R * (inverse_inertia_ * (m.R.transpose() * y.segment<3>(10)));
  return m;
}

void Run::place_hands(Real t) {
  if (t == hands_at_) return;
  hands_at_ = t;
  for (Pad& pad : pads_) {
    const HandMotion& hand = *scene_.hands[std::size_t(pad.hand)].motion;
    const Pose X = hand.pose(pad.phalanx, double(t));
    const Twist V = hand.twist(pad.phalanx, double(t));
    pad.R = X.R.cast<Real>().normalized().toRotationMatrix();
    pad.origin = X.p.cast<Real>();
    pad.origin_v = V.v.cast<Real>();
    pad.spin = V.w.cast<Real>();
  }
}

Point Run::point(std::size_t j, const BodyMotion& body) const {
  const Pad& pad = pads_[given_[j].pad];
  const Vec3 on_pad = pad.R * given_[j].p_P;
  const Vec3 from_center = pad.origin + on_pad - body.x;
  const Vec3 seen = pad.origin_v + pad.spin.cross(on_pad) - body.v - body.w.cross(from_center);
  return {body.R.transpose() * from_center + body_.inertia.center.cast<Real>(), body.R.transpose() * seen};
}

void Run::rhs(Real t, const State& y, State& dy) {
  ++result_.evaluations;
  dy.resize(y.size());
  place_hands(t);
  const BodyMotion body = motion(y);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();  // in O, about the centre of mass
  for (std::size_t j = 0; j < sliders_.size(); ++j) {
    const Eigen::Index at = body_states + 3 * Eigen::Index(j);
    if (sliders_[j].mode() == Mode::apart) {
      dy.segment<3>(at).setZero();
      continue;
    }
    const Point x = point(j, body);
    const Answer a = sliders_[j].answer(x, z(y, j));
    dy.segment<3>(at) = a.rate;
    force += a.force;
    torque += (x.p - body_.inertia.center.cast<Real>()).cross(a.force);
  }
  dy.segment<3>(0) = body.v;
  dy.segment<3>(3) = body.R * force / Real(body_.inertia.mass) + scene_.gravity.cast<Real>();
  Quat q, w(0, body.w.x(), body.w.y(), body.w.z());
  q.coeffs() = y.segment<4>(6);
  dy.segment<4>(6) = (w * q).coeffs() / 2;
  dy.segment<3>(10) = body.R * torque;
}

Real Run::due(std::size_t j, Real t, const State& y) {
  place_hands(t);
  return sliders_[j].answer(point(j, motion(y)), z(y, j)).due;
}

void Run::settle(Real t, State& y, bool record) {
  place_hands(t);
  const BodyMotion body = motion(y);
  for (std::size_t j = 0; j < sliders_.size(); ++j) {
    const Point x = point(j, body);
    for (int i = 0;; ++i) {
      const auto kind = sliders_[j].change(x, y.segment<3>(body_states + 3 * Eigen::Index(j)));
      if (!kind) break;
      if (i > 8) throw std::runtime_error("a sample's mode does not settle");
      if (record) result_.events.push_back({t, sliders_[j].id(), *kind});
    }
  }
}

void Run::clean(Real t, State& y) {
  y.segment<4>(6).normalize();
  place_hands(t);
  const BodyMotion body = motion(y);
  for (std::size_t j = 0; j < sliders_.size(); ++j)
    sliders_[j].clean(point(j, body), y.segment<3>(body_states + 3 * Eigen::Index(j)));
}

/// What an error of each state counts in metres, radians and their rates.
State Run::weights(Real t, const State& y) {
  State w = State::Ones(y.size());
  w.segment<3>(10).setConstant(0.1L * inverse_inertia_.norm());
  place_hands(t);
  const BodyMotion body = motion(y);
  for (std::size_t j = 0; j < sliders_.size(); ++j)
    w.segment<3>(body_states + 3 * Eigen::Index(j)).setConstant(sliders_[j].weight(point(j, body)));
  return w;
}

Real Run::to_knot(Real t) const {
  const Real spacing = settings_.knot / Real(settings_.steps_per_knot);
  const Real next = (std::floor(t / spacing + 1e-9L) + 1) * spacing;
  return std::min(next, Real(scene_.duration)) - t;
}

/// Where due(j) turns positive in (t + a, t + b], each trial integrated afresh from t: regula falsi kept in bounds, and
/// bisection every third time.
Real Run::root(std::size_t j, Real t, const State& y, const State& slope, Real a, Real b, Real at_b) {
  State trial, error;
  Real at_a = due(j, t, y);
  for (int i = 0; i < 300 && b - a > root_width; ++i) {
    Real m = b - at_b * (b - a) / (at_b - at_a);
    if (i % 3 == 2 || !(m > a && m < b)) m = (a + b) / 2;
    if (!(m > a && m < b)) break;
    integrator_.step(t, y, slope, m, trial, error);
    const Real at_m = due(j, t + m, trial);
    (at_m > 0 ? b : a) = m;
    (at_m > 0 ? at_b : at_a) = at_m;
  }
  return b;
}

/// The step to the first change of mode within h; h + 1 if there is none.
Real Run::first_event(Real t, const State& y, const State& slope, Real h, const State& end) {
  Real best = h + 1;
  State trial = end, error;
  Real reach = h;
  for (std::size_t j = 0; j < sliders_.size(); ++j) {
    const Real at_end = due(j, t + reach, trial);
    if (!(at_end > 0)) continue;
    best = reach = root(j, t, y, slope, 0, reach, at_end);
    integrator_.step(t, y, slope, reach, trial, error);
  }
  return best;
}

Result Run::run() {
  State y = start_, end, error, slope;
  Real t = 0, h = to_knot(0);
  while (t < Real(scene_.duration)) {
    h = std::min(h, to_knot(t));
    rhs(t, y, slope);
    integrator_.step(t, y, slope, h, end, error);
    const Real size = error.cwiseProduct(weights(t, y)).maxCoeff() / settings_.tolerance;
    if (!(size <= 1)) {  // NaN too
      h *= size > 0 ? std::max(Real(0.1L), Real(0.8L) * std::pow(size, Real(-1) / (integrator_.order() - 1))) : 0.1L;
      if (h < least_step) throw std::runtime_error("step too small");
      continue;
    }
    ++result_.steps;
    const Real event = first_event(t, y, slope, h, end);
    if (event <= h) integrator_.step(t, y, slope, event, end, error);
    const bool on_knot = event > h && h == to_knot(t);
    t = on_knot && t + h > Real(scene_.duration) - 1e-15L ? Real(scene_.duration) : t + std::min(event, h);
    y = end;
    if (event <= h) settle(t, y, true);
    clean(t, y);
    const Real growth = Real(0.8L) * std::pow(std::max(size, 1e-9L), Real(-1) / (integrator_.order() - 1));
    h *= std::clamp(growth, Real(0.5L), Real(3));
  }
  const BodyMotion body = motion(y);
  result_.p_WO = body.x - body.R * body_.inertia.center.cast<Real>();
  result_.R_WO.coeffs() = y.segment<4>(6).normalized();
  return result_;
}

}  // namespace

SurfaceChoice nearest_face(const VoxelField& field) {
  return [faces = faces_of(field)](const Vec3& p_O) {
    return *std::max_element(faces.begin(), faces.end(),
                             [&](const auto& a, const auto& b) { return a->at(p_O).phi < b->at(p_O).phi; });
  };
}

Result solve(const Scene& scene, const SurfaceChoice& surface, const Settings& settings) {
  return Run(scene, surface, settings).run();
}

}  // namespace handhold::independent
