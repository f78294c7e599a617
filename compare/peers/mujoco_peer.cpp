// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/mujoco_peer.hpp"

#include <array>
#include <cstring>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "cases/model/input_error.hpp"

namespace handhold::compare::peers {
namespace {

constexpr double finger_mass = 0.05;    // [kg]
constexpr double finger_moment = 1e-5;  // [kg m²]
constexpr double weld_time = 0.004;     // time constant of the weld [s]
constexpr const char* file = "scene.xml";

std::string text(const Eigen::Vector3d& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }
std::string place(const Pose& X) {
  return fmt::format("pos='{}' quat='{} {} {} {}'", text(X.p), X.R.w(), X.R.x(), X.R.y(), X.R.z());
}

std::string geom(const PeerShape& shape, const PeerBody& body) {
  const bool box = shape.kind == PeerShape::Kind::box;
  const std::string size = box ? text(shape.half_extents) : fmt::format("{} {}", shape.radius, shape.half_length);
  const bool free = body.role == Role::free;  // only pairs with a free body collide
  return fmt::format("<geom type='{}' size='{}' {} contype='{}' conaffinity='{}'{}/>", box ? "box" : "capsule", size,
                     place(shape.X_BS), 1, free ? 1 : 0,
                     body.role == Role::driven ? "" : fmt::format(" friction='{} 0.005 0.0001' priority='1'", body.mu));
}

std::string body_text(std::size_t index, const PeerBody& body) {
  std::string out;
  const bool driven = body.role == Role::driven;
  if (driven) out += fmt::format("<body name='m{}' mocap='true' {}/>", index, place(body.X_WB));
  out += fmt::format("<body name='b{}' {}>", index, place(body.X_WB));
  if (body.role != Role::fixed) {
    const double mass = driven ? finger_mass : body.mass;
    const Eigen::Vector3d moments = driven ? Eigen::Vector3d::Constant(finger_moment) : body.moments;
    out += fmt::format("<freejoint/><inertial pos='0 0 0' mass='{}' diaginertia='{}'/>", mass, text(moments));
  }
  for (const PeerShape& shape : body.shapes) out += geom(shape, body);
  return out + "</body>";
}

std::string model_text(const PeerModel& model, const PeerSetting& setting, double step) {
  const bool large = model.bodies.size() > 40;
  std::string out = fmt::format(
      "<mujoco><compiler inertiafromgeom='false' angle='radian'/>"
      "<size njmax='{}' nconmax='{}' nstack='{}'/>",
      large ? 12000 : 4000, large ? 3000 : 1000, large ? 80000000 : 20000000);
  const bool stock = setting.stiffness <= 0;
  out += fmt::format(
      "<option timestep='{}' gravity='0 0 0' iterations='{}' cone='{}' impratio='{}' noslip_iterations='{}'/>", step,
      setting.iterations > 0 ? setting.iterations : 100, stock ? "pyramidal" : "elliptic",
      stock ? 1 : setting.stiffness, int(setting.damping));
  out += "<worldbody>";
  for (std::size_t i = 0; i < model.bodies.size(); ++i) out += body_text(i, model.bodies[i]);
  out += "</worldbody><equality>";
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (model.bodies[i].role == Role::driven)
      out += fmt::format("<weld body1='m{0}' body2='b{0}' solref='{1} 1' solimp='0.95 0.99 0.001'/>", i, weld_time);
  return out + "</equality></mujoco>";
}

mjModel* compile(const std::string& xml) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), file, int(xml.size())) != 0) throw InputError("MuJoCo: no room for the scene");
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), file)], xml.data(), xml.size());
  std::array<char, 500> error{};
  mjModel* model = mj_loadXML(file, files.get(), error.data(), int(error.size()));
  mj_deleteVFS(files.get());
  if (!model) throw InputError(fmt::format("MuJoCo refuses the scene: {}", error.data()));
  return model;
}

class MujocoPeer : public Peer {
 public:
  MujocoPeer(const PeerModel& model, const PeerSetting& setting, double step)
      : scene_(model), model_(compile(model_text(model, setting, step))), data_(mj_makeData(model_)) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      ids_.push_back(id("b", i));
      mocaps_.push_back(model.bodies[i].role == Role::driven ? model_->body_mocapid[id("m", i)] : -1);
      if (model.bodies[i].role == Role::free) set_velocity(i);
    }
    mj_forward(model_, data_);
  }
  ~MujocoPeer() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void set_gravity(const Eigen::Vector3d& g) override {
    for (int k = 0; k < 3; ++k) model_->opt.gravity[k] = g[k];
    for (std::size_t i = 0; i < ids_.size(); ++i)  // a finger is carried by its hand
      if (mocaps_[i] >= 0)
        for (int k = 0; k < 3; ++k) data_->xfrc_applied[6 * ids_[i] + k] = -finger_mass * g[k];
  }

  void drive(std::size_t body, const Pose& X) override {
    mjtNum* p = data_->mocap_pos + 3 * mocaps_[body];
    mjtNum* q = data_->mocap_quat + 4 * mocaps_[body];
    for (int k = 0; k < 3; ++k) p[k] = X.p[k];
    q[0] = X.R.w(), q[1] = X.R.x(), q[2] = X.R.y(), q[3] = X.R.z();
  }

  void step() override { mj_step(model_, data_); }

  [[nodiscard]] BodyState state(std::size_t body) const override {
    if (scene_.bodies[body].role == Role::fixed) return {scene_.bodies[body].X_WB, {}};
    const int joint = model_->body_jntadr[ids_[body]];
    const mjtNum* q = data_->qpos + model_->jnt_qposadr[joint];
    const mjtNum* v = data_->qvel + model_->jnt_dofadr[joint];
    const Eigen::Quaterniond R = Eigen::Quaterniond(q[3], q[4], q[5], q[6]).normalized();
    return {{R, {q[0], q[1], q[2]}}, {R * Eigen::Vector3d(v[3], v[4], v[5]), {v[0], v[1], v[2]}}};
  }

 private:
  [[nodiscard]] int id(const char* prefix, std::size_t i) const {
    return mj_name2id(model_, mjOBJ_BODY, fmt::format("{}{}", prefix, i).c_str());
  }

  void set_velocity(std::size_t i) {
    const PeerBody& body = scene_.bodies[i];
    const Eigen::Vector3d w_B = body.X_WB.R.conjugate() * body.V_WB.w;  // a free joint turns in the body's own frame
    mjtNum* v = data_->qvel + model_->jnt_dofadr[model_->body_jntadr[ids_[i]]];
    for (int k = 0; k < 3; ++k) v[k] = body.V_WB.v[k], v[3 + k] = w_B[k];
  }

  const PeerModel scene_;
  mjModel* model_{};
  mjData* data_{};
  std::vector<int> ids_, mocaps_;  // of every body of the scene; mocap −1: none
};

}  // namespace

std::unique_ptr<Peer> make_mujoco_peer(const PeerModel& model, const PeerSetting& setting, double step) {
  return std::make_unique<MujocoPeer>(model, setting, step);
}

}  // namespace handhold::compare::peers
