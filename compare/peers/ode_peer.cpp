// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/ode_peer.hpp"

#include <array>

#include <ode/ode.h>

namespace handhold::compare::peers {
namespace {

constexpr int most_contacts = 8;  // of a pair of shapes

/// ODE's state is global, is set up once, and is never taken down: other peers may still use it.
void initialize() {
  static const int done = dInitODE2(0);
  static_cast<void>(done);
}

Eigen::Vector3d vector_of(const dReal* v) { return {v[0], v[1], v[2]}; }

std::array<dReal, 4> quaternion_of(const Eigen::Quaterniond& R) { return {R.w(), R.x(), R.y(), R.z()}; }

class OdePeer : public Peer {
 public:
  OdePeer(const PeerModel& model, const PeerSetting& setting, double step) : model_(model), step_(step) {
    initialize();
    dRandSetSeed(0);  // the quick stepper shuffles its constraints
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    dHashSpaceSetLevels(space_, -8, 4);  // cells of 4 mm to 16 m
    contacts_ = dJointGroupCreate(0);
    dWorldSetQuickStepNumIterations(world_, setting.iterations > 0 ? setting.iterations : 20);
    soft_ = setting.stiffness > 0;
    const double impulse = step * setting.stiffness + setting.damping;  // [N s/m]; ODE's manual, "ERP and CFM"
    if (soft_) erp_ = step * setting.stiffness / impulse, cfm_ = 1 / impulse;
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) bodies_.push_back(add(i));
  }
  ~OdePeer() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void set_gravity(const Eigen::Vector3d& g) override { dWorldSetGravity(world_, g.x(), g.y(), g.z()); }

  /// By velocity, as its manual has it for kinematic bodies.
  void drive(std::size_t body, const Pose& X_WB) override {
    const BodyState now = state(body);
    const Eigen::Vector3d v = (X_WB.p - now.X_WO.p) / step_;
    const Eigen::AngleAxisd turn(X_WB.R * now.X_WO.R.conjugate());
    const Eigen::Vector3d w = turn.angle() / step_ * turn.axis();
    dBodySetLinearVel(bodies_[body], v.x(), v.y(), v.z());
    dBodySetAngularVel(bodies_[body], w.x(), w.y(), w.z());
  }

  void step() override {
    dSpaceCollide(space_, this, &near);
    dWorldQuickStep(world_, step_);
    dJointGroupEmpty(contacts_);
  }

  [[nodiscard]] BodyState state(std::size_t body) const override {
    dBodyID id = bodies_[body];
    if (!id) return {model_.bodies[body].X_WB, {}};
    const dReal* q = dBodyGetQuaternion(id);
    return {{Eigen::Quaterniond(q[0], q[1], q[2], q[3]), vector_of(dBodyGetPosition(id))},
            {vector_of(dBodyGetAngularVel(id)), vector_of(dBodyGetLinearVel(id))}};
  }

 private:
  dBodyID add(std::size_t index) {
    const PeerBody& body = model_.bodies[index];
    dBodyID id = body.role == Role::fixed ? nullptr : make_body(body);
    dSpaceID space = space_;
    if (body.shapes.size() > 1) {
      space = dSimpleSpaceCreate(space_);
      dSpaceSetSublevel(space, 1);
    }
    for (const PeerShape& shape : body.shapes) {
      const bool box = shape.kind == PeerShape::Kind::box;
      const Eigen::Vector3d size = 2 * shape.half_extents;
      dGeomID geom = box ? dCreateBox(space, size.x(), size.y(), size.z())
                         : dCreateCapsule(space, shape.radius, 2 * shape.half_length);
      dGeomSetData(geom, reinterpret_cast<void*>(index));
      const unsigned free = 1, other = 2;  // category bits
      dGeomSetCategoryBits(geom, body.role == Role::free ? free : other);
      dGeomSetCollideBits(geom, body.role == Role::free ? free | other : free);
      if (id) dGeomSetBody(geom, id);
      place(geom, id ? shape.X_BS : body.X_WB * shape.X_BS, id != nullptr);
    }
    return id;
  }

  static void place(dGeomID geom, const Pose& X, bool as_offset) {
    const std::array<dReal, 4> q = quaternion_of(X.R);
    (as_offset ? dGeomSetOffsetPosition : dGeomSetPosition)(geom, X.p.x(), X.p.y(), X.p.z());
    (as_offset ? dGeomSetOffsetQuaternion : dGeomSetQuaternion)(geom, q.data());
  }

  dBodyID make_body(const PeerBody& body) {
    dBodyID id = dBodyCreate(world_);
    if (body.role == Role::driven) {
      dBodySetKinematic(id);
    } else {
      dMass mass;
      const Eigen::Vector3d& J = body.moments;
      dMassSetParameters(&mass, body.mass, 0, 0, 0, J.x(), J.y(), J.z(), 0, 0, 0);
      dBodySetMass(id, &mass);
    }
    const std::array<dReal, 4> q = quaternion_of(body.X_WB.R);
    dBodySetPosition(id, body.X_WB.p.x(), body.X_WB.p.y(), body.X_WB.p.z());
    dBodySetQuaternion(id, q.data());
    dBodySetLinearVel(id, body.V_WB.v.x(), body.V_WB.v.y(), body.V_WB.v.z());
    dBodySetAngularVel(id, body.V_WB.w.x(), body.V_WB.w.y(), body.V_WB.w.z());
    dBodySetAutoDisableFlag(id, 0);
    return id;
  }

  static void near(void* data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, data, &near);
    static_cast<OdePeer*>(data)->touch(a, b);
  }

  void touch(dGeomID a, dGeomID b) {
    dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (body_a == body_b) return;
    std::array<dContact, most_contacts> contacts;
    const int count = dCollide(a, b, most_contacts, &contacts[0].geom, sizeof(dContact));
    const double mu = count > 0 ? model_.mu(std::size_t(dGeomGetData(a)), std::size_t(dGeomGetData(b))) : 0;
    for (int i = 0; i < count; ++i) {
      dSurfaceParameters& surface = contacts[std::size_t(i)].surface;
      surface = {};
      surface.mode = dContactApprox1 | (soft_ ? dContactSoftERP | dContactSoftCFM : 0);
      surface.mu = mu;
      surface.soft_erp = erp_;
      surface.soft_cfm = cfm_;
      dJointAttach(dJointCreateContact(world_, contacts_, &contacts[std::size_t(i)]), body_a, body_b);
    }
  }

  const PeerModel model_;
  const double step_;
  bool soft_{};
  double erp_{}, cfm_{};
  dWorldID world_{};
  dSpaceID space_{};
  dJointGroupID contacts_{};
  std::vector<dBodyID> bodies_;
};

}  // namespace

std::unique_ptr<Peer> make_ode_peer(const PeerModel& model, const PeerSetting& setting, double step) {
  return std::make_unique<OdePeer>(model, setting, step);
}

}  // namespace handhold::compare::peers
