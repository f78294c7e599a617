#include <algorithm>
#include <cmath>

#include "cases/closed_form/curved_slide.hpp"
#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid::testing {
namespace {

namespace exact = closed_form;

double dome(const RigidSurface& surface, const Options& options) {
  Worst worst;
  for (const exact::Dome& d : {exact::Dome{0.1, 0.3, 0.35, 0, g}, exact::Dome{0.1, 0.5, 0.1, 0.7, g}}) {
    RigidProblem p = block(0.2, {d.mu, d.mu}, exact::lift_off_time(d) + 0.05);
    p.supports[0].surface = surface;
    p.X_WB.p = d.radius * Eigen::Vector3d(std::sin(d.start_angle), 0, std::cos(d.start_angle));
    p.V_WB.v = d.start_speed * Eigen::Vector3d(std::cos(d.start_angle), 0, -std::sin(d.start_angle));
    const Trajectory t = run(p, options);
    worst.require(t.events.size() == 1 && t.events[0].to == Mode::apart);
    if (t.events.empty()) continue;
    const BodyState& off = t.events[0].after;
    worst.add(t.events[0].t, exact::lift_off_time(d));
    worst.add(std::atan2(off.X_WO.p.x(), off.X_WO.p.z()), exact::lift_off_angle(d));
    worst.add(off.V_WO.v.norm(), exact::lift_off_speed(d));
    worst.add_energy(t, 0.1);
  }
  return worst.value();
}

double c14_dome(const Options& options) { return dome(make_sphere({0, 0, 0}, 0.1), options); }
double c14_log(const Options& options) { return dome(make_cylinder({0, 0, 0}, y_axis, 0.1), options); }

double bowl(const RigidSurface& surface, const exact::Bowl& b, const Options& options) {
  Worst worst;
  const std::vector<double> angles = exact::turning_angles(b), times = exact::turning_times(b);
  RigidProblem p = block(0.2, b.friction, times.back() + 0.1);
  p.supports[0].surface = surface;
  p.X_WB.p = b.radius * Eigen::Vector3d(std::sin(b.start_angle), 0, -std::cos(b.start_angle));
  const Trajectory t = run(p, options);
  worst.require(t.events.size() + 1 == angles.size());
  for (std::size_t i = 1; i < angles.size() && i <= t.events.size(); ++i) {
    const Eigen::Vector3d& at = t.events[i - 1].after.X_WO.p;
    worst.add(t.events[i - 1].t, times[i]);
    worst.add(std::atan2(at.x(), -at.z()), angles[i], std::abs(b.start_angle));
  }
  worst.require(t.frames.back().supports[0].mode == Mode::stick);
  worst.add_energy(t, 0.1);
  return worst.value();
}

double c15_gutter(const Options& options) {
  return std::max(bowl(make_cylinder({0, 0, 0}, y_axis, 0.08, true), {0.08, 1.2, g, {0.25, 0.2}}, options),
                  bowl(make_cylinder({0, 0, 0}, y_axis, 0.08, true), {0.08, 1.4, g, {0.1, 0.1}}, options));
}
double c15_bowl(const Options& options) {
  return bowl(make_sphere({0, 0, 0}, 0.08, true), {0.08, 1.2, g, {0.25, 0.2}}, options);
}

double c16_wall(const Options& options) {
  const exact::WallSlide w{};
  RigidProblem p = block(0.2, {w.mu_floor, w.mu_floor}, exact::stop_time(w) + 0.1);
  RigidSupport wall;
  wall.surface = make_cylinder({0, 0, 0}, z_axis, w.radius, true);
  wall.friction = {w.mu_wall, w.mu_wall};
  p.supports.push_back(wall);
  p.X_WB.p = w.radius * x_axis;
  p.V_WB.v = w.speed * y_axis;
  const Trajectory t = run(p, options);
  Worst worst;
  for (const Frame& f : t.frames)
    worst.add(std::atan2(f.body.X_WO.p.y(), f.body.X_WO.p.x()), exact::angle_at(w, f.t), exact::swept_angle(w));
  // The floor stops it. The wall, whose force goes to zero at the same moment, may leave a little before, by noise.
  const auto stop = std::find_if(t.events.begin(), t.events.end(), [](const Event& e) { return e.support == 0; });
  worst.require(stop != t.events.end() && t.frames.back().supports[0].mode == Mode::stick);
  if (stop != t.events.end()) worst.add(stop->t, exact::stop_time(w));
  worst.add_energy(t, 0.2);
  return worst.value();
}

class OfCurved : public ClosedForm {};

TEST_P(OfCurved, AgreeWithTheirClosedForms) { check(); }

INSTANTIATE_TEST_SUITE_P(L1, OfCurved,
                         at_all_accuracies({{"C14_dome", c14_dome},
                                            {"C14_log", c14_log},
                                            {"C15_gutter", c15_gutter},
                                            {"C15_bowl", c15_bowl},
                                            {"C16_wall", c16_wall}}),
                         case_name);

}  // namespace
}  // namespace handhold::reference::rigid::testing
