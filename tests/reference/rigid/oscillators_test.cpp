#include "cases/closed_form/oscillators.hpp"

#include <cmath>
#include <numbers>

#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid::testing {
namespace {

namespace exact = closed_form;
using std::numbers::pi;

RigidProblem on_spring(double mass, double stiffness, const Friction& friction, double x, double duration) {
  RigidProblem p = block(mass, friction, duration);
  p.X_WB.p.x() = x;
  p.springs = {{stiffness, {0, 0, 0}, {0, 0, 0}, {}}};
  return p;
}

double c05_harmonic_force(const Options& options) {
  Worst worst;
  for (const exact::HarmonicForce& h :
       {exact::HarmonicForce{0.2, 1.4, 10, g, {0.5, 0.4}}, exact::HarmonicForce{0.2, 1.4, 10, g, {0.5, 0.5}},
        exact::HarmonicForce{0.1, 0.6, 40, g, {0.6, 0.45}}}) {
    const double half = pi / h.frequency;
    RigidProblem p = block(h.mass, h.friction, 2 * half + exact::stop_time(h) + 0.01 * half);
    p.load = [=](double t, const BodyState&) { return Load{h.force * std::sin(h.frequency * t) * x_axis, {0, 0, 0}}; };
    const Trajectory t = run(p, options);
    worst.require(t.events.size() == 6);
    if (t.events.size() != 6) continue;
    for (int k = 0; k < 3; ++k) {  // three half cycles, to and fro
      const Event &onset = t.events[2 * std::size_t(k)], &stop = t.events[2 * std::size_t(k) + 1];
      worst.add(onset.t, exact::slip_onset(h) + k * half);
      worst.add(stop.t, exact::stop_time(h) + k * half);
      const double way = stop.after.X_WO.p.x() - onset.after.X_WO.p.x();
      worst.add(way, (k == 1 ? -1 : 1) * exact::slip(h));
    }
    worst.add_energy(t, 0.1);
  }
  return worst.value();
}

double c06_friction_oscillator(const Options& options) {
  Worst worst;
  for (const exact::FrictionOscillator& o : {exact::FrictionOscillator{0.2, 50, 0.1, g, {0.5, 0.4}},
                                             exact::FrictionOscillator{0.2, 50, 0.173, g, {0.4, 0.4}}}) {
    const int n = exact::half_swings(o);
    const Trajectory t = run(on_spring(o.mass, o.stiffness, o.friction, o.start, 0.3 + exact::stop_time(o)), options);
    worst.require(int(t.events.size()) == n);
    if (int(t.events.size()) != n) continue;
    for (int j = 1; j <= n; ++j) {
      const Event& e = t.events[std::size_t(j - 1)];
      worst.add(e.t, exact::stop_time(o) * j / n);
      worst.add(e.after.X_WO.p.x(), exact::turning_point(o, j), o.start);
      worst.require(e.to == (j == n ? Mode::stick : Mode::slip));
    }
    worst.add(t.frames.back().body.X_WO.p.x(), exact::turning_point(o, n), o.start);
    worst.add_energy(t, 0.25);
  }
  return worst.value();
}

/// Five cycles from a start on the orbit. The orbit attracts, so errors do not add up.
double c07_den_hartog(const Options& options) {
  Worst worst;
  for (const exact::DenHartog& d :
       {exact::DenHartog{0.2, 50, 1, 10, 0.2, g}, exact::DenHartog{0.2, 50, 1, 25, 0.1, g}}) {
    const double half = pi / d.frequency, X = exact::amplitude(d);
    RigidProblem p = on_spring(d.mass, d.stiffness, {d.mu, d.mu}, X, 10 * half + 0.3 * half);
    p.load = [=](double t, const BodyState&) {
      return Load{d.force * std::cos(d.frequency * t + exact::phase(d)) * x_axis, {0, 0, 0}};
    };
    const Trajectory t = run(p, options);
    worst.require(t.events.size() == 10);
    for (std::size_t k = 0; k < t.events.size(); ++k) {
      worst.add(t.events[k].t, double(k + 1) * half);
      worst.add(t.events[k].after.X_WO.p.x(), k % 2 == 0 ? -X : X);
      worst.require(t.events[k].to == Mode::slip);
    }
    for (const Frame& f : t.frames) worst.add(f.body.X_WO.p.x(), exact::position(d, f.t), X);
    worst.add_energy(t, exact::dissipation(d));
  }
  return worst.value();
}

double belt(const exact::BeltOscillator& b, const Options& options) {
  Worst worst;
  const double period = exact::stick_time(b) + exact::slip_time(b);
  RigidProblem p = on_spring(b.mass, b.stiffness, b.friction, exact::restick_position(b), 3.2 * period);
  p.V_WB.v = b.speed * x_axis;
  p.supports[0].motion = steady(b.speed * x_axis);
  const Trajectory t = run(p, options);
  worst.require(t.events.size() == 6);
  if (t.events.size() != 6) return worst.value();
  for (int k = 0; k < 3; ++k) {
    worst.add(t.events[2 * std::size_t(k)].t, k * period + exact::stick_time(b));
    worst.add(t.events[2 * std::size_t(k) + 1].t, (k + 1) * period);
  }
  const double swing = exact::greatest_position(b) - exact::least_position(b);
  for (const Frame& f : t.frames)
    if (f.t < period) worst.add(f.body.X_WO.p.x(), exact::position(b, f.t), swing);
  worst.add_energy(t, 0.01);
  return worst.value();
}

double c08_belt(const Options& options) { return belt({0.2, 50, 0.05, g, {0.6, 0.4}}, options); }
double c08_small_belt(const Options& options) { return belt({0.05, 800, 0.01, g, {0.5, 0.3}}, options); }

double c09_palm(const Options& options) {
  Worst worst;
  for (const exact::OscillatingPalm& palm :
       {exact::OscillatingPalm{0.05, 20, 0.4, g}, exact::OscillatingPalm{0.02, 50, 0.5, g}}) {
    const double half = pi / palm.frequency, v = exact::peak_speed(palm);
    RigidProblem p = block(0.2, {palm.mu, palm.mu}, 6.3 * half);
    p.supports[0].motion = sine(x_axis, palm.amplitude, palm.frequency, exact::switching_phase(palm));
    p.V_WB.v = v * x_axis;
    const Trajectory t = run(p, options);
    worst.require(t.events.size() == 6);
    for (std::size_t k = 0; k < t.events.size(); ++k) {
      worst.add(t.events[k].t, double(k + 1) * half);
      worst.add(t.events[k].after.V_WO.v.x(), k % 2 == 0 ? -v : v);
      worst.require(t.events[k].to == Mode::slip);
    }
    worst.add_energy(t, 0.1);
  }
  return worst.value();
}

/// Below the limit it goes with the palm, to the bit of its velocity error.
double c09_palm_sticking(const Options& options) {
  const exact::OscillatingPalm palm{0.05, 9, 0.6, g};
  RigidProblem p = block(0.2, {palm.mu, palm.mu}, 1);
  p.supports[0].motion = sine(x_axis, palm.amplitude, palm.frequency);
  p.V_WB.v = exact::peak_speed(palm) * x_axis;
  const Trajectory t = run(p, options);
  Worst worst;
  worst.require(exact::sticks(palm) && t.events.empty());
  for (const Frame& f : t.frames) worst.add(f.body.X_WO.p.x(), 0.05 * std::sin(9 * f.t), 0.05);
  return worst.value();
}

class OfOscillators : public ClosedForm {};

TEST_P(OfOscillators, AgreeWithTheirClosedForms) { check(); }

INSTANTIATE_TEST_SUITE_P(L1, OfOscillators,
                         at_all_accuracies({{"C05_harmonic_force", c05_harmonic_force},
                                            {"C06_friction_oscillator", c06_friction_oscillator},
                                            {"C07_den_hartog", c07_den_hartog},
                                            {"C08_belt", c08_belt},
                                            {"C08_small_belt", c08_small_belt, 100},  // swings by 0.3 mm
                                            {"C09_palm", c09_palm},
                                            {"C09_palm_sticking", c09_palm_sticking}}),
                         case_name);

}  // namespace
}  // namespace handhold::reference::rigid::testing
