#include "reference/simbody_bodies.hpp"

#include <cstring>
#include <stdexcept>

namespace handhold::reference::simbody {
namespace {

Eigen::Vector3d to_eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

Eigen::Matrix3d to_eigen(const SimTK::Rotation& R) {
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = R.asMat33()(i, j);
  return out;
}

SimTK::Rotation to_simbody(const Eigen::Quaterniond& q) {
  const Eigen::Quaterniond unit = q.normalized();
  return SimTK::Rotation(SimTK::Quaternion(unit.w(), unit.x(), unit.y(), unit.z()));
}

/// About O's origin, as Simbody wants it. What a mobility never uses is replaced by something harmless.
SimTK::MassProperties mass_properties(const Body& body) {
  const SimTK::Vec3 center = simbody::to_simbody(body.inertia.center);
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

void check_library() {
  char built[64] = {};
  SimTK_about_SimTKcommon("debug", int(sizeof built), built);
  const bool library_checks = std::strcmp(built, "debug") == 0;
#ifdef NDEBUG
  const bool we_check = false;
#else
  const bool we_check = true;
#endif
  if (library_checks != we_check)
    throw std::logic_error(
        "Simbody and handhold were built with different NDEBUG: their states differ in memory (see "
        "reference/CMakeLists.txt)");
}

std::string version() {
  int major = 0, minor = 0, build = 0;
  SimTK_version_SimTKcommon(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

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
    m.mobilized.setQToFitTransform(state, SimTK::Transform(to_simbody(body.X_WO.R), simbody::to_simbody(body.X_WO.p)));
  }
  for (const Moving& m : moving_) {
    const Body& body = scene_.bodies[std::size_t(m.body)];
    if (body.held_until > 0) continue;  // at rest
    m.mobilized.setUToFitVelocity(
        state, SimTK::SpatialVec(simbody::to_simbody(body.V_WO.w), simbody::to_simbody(body.V_WO.v)));
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
      SimTK::SpatialVec(simbody::to_simbody(wrench.torque), simbody::to_simbody(wrench.force));
}

}  // namespace handhold::reference::simbody
