// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/dart_peer.hpp"

#include <tuple>
#include <unordered_map>

#include <dart/collision/CollisionFilter.hpp>
#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/ode/OdeCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/CapsuleShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/ShapeNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

namespace handhold::compare::peers {
namespace {

namespace dd = dart::dynamics;

constexpr std::size_t most_contacts = 10000;

Eigen::Isometry3d isometry(const Pose& X) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = X.R.toRotationMatrix();
  T.translation() = X.p;
  return T;
}

/// Keeps pairs without a free body apart.
struct RoleFilter : dart::collision::CollisionFilter {
  std::unordered_map<const dd::BodyNode*, Role> role;

  bool ignoresCollision(const dart::collision::CollisionObject* a,
                        const dart::collision::CollisionObject* b) const override {
    const dd::BodyNode* body_a = a->getShapeFrame()->asShapeNode()->getBodyNodePtr().get();
    const dd::BodyNode* body_b = b->getShapeFrame()->asShapeNode()->getBodyNodePtr().get();
    return body_a == body_b || !PeerModel::collide(role.at(body_a), role.at(body_b));
  }
};

class DartPeer : public Peer {
 public:
  DartPeer(const PeerModel& model, const PeerSetting& setting, double step)
      : model_(model), step_(step), world_(dart::simulation::World::create()) {
    using dart::constraint::ContactConstraint;
    const bool stock = setting.stiffness <= 0;
    ContactConstraint::setErrorReductionParameter(stock ? 0.01 : setting.stiffness);
    ContactConstraint::setMaxErrorReductionVelocity(stock ? 1e-3 : 1);
    ContactConstraint::setConstraintForceMixing(stock ? 1e-5 : setting.damping);
    world_->setTimeStep(step);
    auto* solver = world_->getConstraintSolver();
    solver->setCollisionDetector(dart::collision::OdeCollisionDetector::create());
    const auto filter = std::make_shared<RoleFilter>();
    for (const PeerBody& body : model_.bodies) {
      add(body);
      filter->role[nodes_.back()] = body.role;
    }
    solver->getCollisionOption().collisionFilter = filter;
    solver->getCollisionOption().maxNumContacts = most_contacts;
  }

  void set_gravity(const Eigen::Vector3d& g) override { world_->setGravity(g); }

  void drive(std::size_t body, const Pose& X_WB) override {
    const Eigen::Isometry3d T = nodes_[body]->getTransform();
    const Eigen::AngleAxisd turn(X_WB.R * Eigen::Quaterniond(T.linear()).conjugate());
    const Eigen::Vector3d w = turn.angle() / step_ * turn.axis(), v = (X_WB.p - T.translation()) / step_;
    dart::dynamics::FreeJoint* joint = joints_[body];
    Eigen::Matrix<double, 6, 1> command;
    command << T.linear().transpose() * w, T.linear().transpose() * v;
    joint->setCommands(command);
  }

  void step() override { world_->step(); }

  [[nodiscard]] BodyState state(std::size_t body) const override {
    const dd::BodyNode* node = nodes_[body];
    const Eigen::Isometry3d T = node->getTransform();
    return {{Eigen::Quaterniond(T.linear()).normalized(), T.translation()},
            {node->getAngularVelocity(), node->getLinearVelocity()}};
  }

 private:
  void add(const PeerBody& body) {
    const dd::SkeletonPtr skeleton = dd::Skeleton::create(body.name);
    dd::FreeJoint* joint = nullptr;
    dd::BodyNode* node = nullptr;
    if (body.role == Role::fixed) {
      const auto made = skeleton->createJointAndBodyNodePair<dd::WeldJoint>();
      made.first->setTransformFromParentBodyNode(isometry(body.X_WB));
      node = made.second;
    } else {
      std::tie(joint, node) = skeleton->createJointAndBodyNodePair<dd::FreeJoint>();
    }
    for (const PeerShape& shape : body.shapes) add_shape(*node, shape, body);
    const bool free = body.role == Role::free;
    const Eigen::Vector3d J = free ? body.moments : Eigen::Vector3d::Constant(1e-3);
    node->setInertia(dd::Inertia(free ? body.mass : 1, 0, 0, 0, J.x(), J.y(), J.z(), 0, 0, 0));
    if (joint) start(*joint, *node, body);
    skeleton->disableSelfCollisionCheck();
    world_->addSkeleton(skeleton);
    nodes_.push_back(node);
    joints_.push_back(joint);
  }

  static void start(dd::FreeJoint& joint, dd::BodyNode& node, const PeerBody& body) {
    joint.setTransform(isometry(body.X_WB));
    Eigen::Matrix<double, 6, 1> velocity;
    velocity << body.X_WB.R.conjugate() * body.V_WB.w, body.X_WB.R.conjugate() * body.V_WB.v;
    joint.setVelocities(velocity);
    if (body.role != Role::driven) return;
    joint.setActuatorType(dd::Joint::VELOCITY);
    node.setGravityMode(false);
  }

  /// DART takes the smaller coefficient of two: hands are given one that is never the smaller.
  static void add_shape(dd::BodyNode& node, const PeerShape& shape, const PeerBody& body) {
    dd::ShapePtr made;
    if (shape.kind == PeerShape::Kind::box)
      made = std::make_shared<dd::BoxShape>(2 * shape.half_extents);
    else
      made = std::make_shared<dd::CapsuleShape>(shape.radius, 2 * shape.half_length);
    auto* shape_node = node.createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(made);
    shape_node->setRelativeTransform(isometry(shape.X_BS));
    shape_node->getDynamicsAspect()->setFrictionCoeff(body.role == Role::driven ? 1e3 : body.mu);
    shape_node->getDynamicsAspect()->setRestitutionCoeff(0);
  }

  const PeerModel model_;
  const double step_;
  dart::simulation::WorldPtr world_;
  std::vector<dd::BodyNode*> nodes_;
  std::vector<dd::FreeJoint*> joints_;  // null: fixed
};

}  // namespace

std::unique_ptr<Peer> make_dart_peer(const PeerModel& model, const PeerSetting& setting, double step) {
  return std::make_unique<DartPeer>(model, setting, step);
}

}  // namespace handhold::compare::peers
