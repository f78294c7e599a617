// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/simbody_bodies.hpp"

namespace handhold::reference::simbody {
namespace {

/// About O's origin, as Simbody wants it. What a mobility never uses is replaced by something harmless.
SimTK::MassProperties mass_properties(const Body& body) {
  const SimTK::Vec3 center = to_simbody(body.inertia.center);
  const Eigen::Matrix3d& J = body.inertia.about_center;
  const bool rotates = body.mobility == Mobility::free;
  const SimTK::Inertia central = rotates ? SimTK::Inertia(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2))
                                         : SimTK::Inertia(body.inertia.mass);
  return {body.inertia.mass, center, central.shiftFromMassCenter(center, body.inertia.mass)};
}

SimTK::MobilizedBody mobilize(SimTK::SimbodyMatterSubsystem& matter, const Body& body) {
  const SimTK::Body::Rigid solid(mass_properties(body));
  if (body.mobility == Mobility::free)
    return SimTK::MobilizedBody::Free(matter.Ground(), SimTK::Transform(), solid, SimTK::Transform());
  // Outboard frame turned back, so that the coordinates are W's.
  const SimTK::Transform turned(~to_simbody(body.X_WO.R));
  return SimTK::MobilizedBody::Translation(matter.Ground(), SimTK::Transform(), solid, turned);
}

}  // namespace

Bodies::Bodies(const Scene& scene, SimTK::SimbodyMatterSubsystem& matter) : scene_(scene) {
  for (int i = 0; i < int(scene.bodies.size()); ++i) {
    const Body& body = scene.bodies[std::size_t(i)];
    at_start_.push_back({body.X_WO.R.normalized().toRotationMatrix(), body.X_WO.p, {0, 0, 0}, {0, 0, 0}});
    index_.push_back(body.mobility == Mobility::fixed ? -1 : int(moving_.size()));
    if (body.mobility != Mobility::fixed) moving_.push_back({i, mobilize(matter, body)});
  }
}

void Bodies::set_start(SimTK::State& state) const {
  for (const Moving& m : moving_) {
    const Body& body = scene_.bodies[std::size_t(m.body)];
    m.mobilized.setQToFitTransform(state, SimTK::Transform(to_simbody(body.X_WO.R), to_simbody(body.X_WO.p)));
  }
  for (const Moving& m : moving_) {
    const Body& body = scene_.bodies[std::size_t(m.body)];
    m.mobilized.setUToFitVelocity(state, SimTK::SpatialVec(to_simbody(body.V_WO.w), to_simbody(body.V_WO.v)));
  }
}

void Bodies::read_motions(const SimTK::State& state, Motions& out) const {
  if (out.size() != at_start_.size()) out = at_start_;
  for (const Moving& m : moving_) {
    const SimTK::Transform& X = m.mobilized.getBodyTransform(state);
    const SimTK::SpatialVec& V = m.mobilized.getBodyVelocity(state);
    out[std::size_t(m.body)] = {to_eigen(X.R()), to_eigen(X.p()), to_eigen(V[0]), to_eigen(V[1])};
  }
}

void Bodies::apply(int body, const Wrench& wrench, SimTK::Vector_<SimTK::SpatialVec>& body_forces) const {
  const int i = index_[std::size_t(body)];
  if (i < 0) return;
  body_forces[moving_[std::size_t(i)].mobilized.getMobilizedBodyIndex()] +=
      SimTK::SpatialVec(to_simbody(wrench.torque), to_simbody(wrench.force));
}

}  // namespace handhold::reference::simbody
