// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>

#include "realtime/c_support.hpp"
#include "realtime/gamma.hpp"
#include "realtime/paper/hand_contact.hpp"

using handhold::HandFrame;
using handhold::HandModel;
using handhold::InputError;
using handhold::PatchOptions;
using handhold::phalanx_count;
using handhold::VoxelField;
using handhold::c::guarded;
using handhold::c::is_unit;
using handhold::c::model_of;
using handhold::c::pose;
using handhold::c::read_frames;
using handhold::c::require;
using handhold::c::vector;
namespace paper = handhold::realtime::paper;

struct hh_contact {
  std::shared_ptr<const VoxelField> field;
  hh_object object{};
  std::vector<HandModel> models;
  std::unique_ptr<paper::HandContact> contact;
  std::vector<HandFrame> frames;  // of the step, kept so that a step allocates nothing
};

namespace {

using handhold::c::store;

paper::BodyMotion motion(const hh_body& body) {
  require(is_unit(body.pose), "body pose: the quaternion must be a unit one (w, x, y, z)");
  const paper::BodyMotion m{pose(body.pose), vector(body.velocity), vector(body.angular_velocity)};
  require(m.X_WO.p.allFinite() && m.v.allFinite() && m.w.allFinite(), "body: position and velocities must be finite");
  return m;
}

void store(const paper::Wrench& wrench, hh_wrench* out) {
  store(wrench.force, out->force);
  store(wrench.torque, out->torque);
}

template <class Enum>
Enum switched(int value, int count, const char* name) {
  if (value < 0 || value >= count)
    throw InputError(std::string(name) + "=" + std::to_string(value) + ": no such choice (take one of the HH_ names)");
  return static_cast<Enum>(value);
}

paper::Options options_of(const hh_options& o) {
  paper::Options p;
  p.stiffness = o.stiffness;
  p.damping = o.damping;
  p.ray_offset = o.ray_offset;
  p.turned_away = o.turned_away;
  p.contact_offset = o.contact_offset;
  p.sign = switched<paper::Sign>(o.sign, 2, "sign");
  p.point = switched<paper::Point>(o.point, 2, "point");
  p.gate = switched<paper::Gate>(o.gate, 2, "gate");
  p.slip_force = switched<paper::SlipForce>(o.slip_force, 2, "slip_force");
  p.order = switched<paper::Order>(o.order, 2, "order");
  p.slip_state = switched<paper::SlipState>(o.slip_state, 2, "slip_state");
  p.anchor_update = switched<paper::AnchorUpdate>(o.anchor_update, 2, "anchor_update");
  p.apart_anchor = switched<paper::ApartAnchor>(o.apart_anchor, 2, "apart_anchor");
  return p;
}

PatchOptions patch_of(const hh_options& o) {
  PatchOptions p;
  p.samples = o.samples;
  p.finger_radius = o.finger_radius;
  p.thumb_radius = o.thumb_radius;
  p.palm_radius = o.palm_radius;
  for (const double radius : {o.finger_radius, o.thumb_radius, o.palm_radius})
    require(std::isfinite(radius) && radius >= 0, "patch radius: must be finite and not negative");
  return p;
}

std::unique_ptr<paper::HandContact> make(const hh_contact& c, const hh_options& o) {
  const auto normals = switched<paper::Normals>(o.normals, 3, "normals");
  return std::make_unique<paper::HandContact>(c.field, normals, vector(c.object.center_of_mass),
                                              handhold::Friction{c.object.mu_static, c.object.mu_dynamic},
                                              options_of(o), c.models, patch_of(o));
}

void to_c(const paper::Options& p, const PatchOptions& patch, hh_options& o) {
  o = {};
  o.stiffness = p.stiffness;
  o.damping = p.damping;
  o.ray_offset = p.ray_offset;
  o.turned_away = p.turned_away;
  o.contact_offset = p.contact_offset;
  o.sign = int(p.sign);
  o.point = int(p.point);
  o.gate = int(p.gate);
  o.slip_force = int(p.slip_force);
  o.order = int(p.order);
  o.slip_state = int(p.slip_state);
  o.anchor_update = int(p.anchor_update);
  o.apart_anchor = int(p.apart_anchor);
  o.samples = patch.samples;
  o.finger_radius = patch.finger_radius;
  o.thumb_radius = patch.thumb_radius;
  o.palm_radius = patch.palm_radius;
}

}  // namespace

const char* hh_version(void) { return HANDHOLD_VERSION; }

int hh_options_init(int law, hh_options* options, hh_error* error) {
  return guarded(error, [&] {
    require(options, "hh_options_init: options must not be null");
    require(law >= HH_PAPER && law <= HH_COULOMB, "law: no such law (HH_PAPER, HH_PAPER_AS_PRINTED or HH_COULOMB)");
    to_c(law == HH_PAPER ? paper::Options() : law == HH_COULOMB ? paper::coulomb() : paper::as_printed(), {}, *options);
    if (law == HH_COULOMB) options->normals = HH_NORMALS_SMOOTH;
  });
}

int hh_auto_stiffness(double mass, double volume, double mu_static, int samples, double depth, double margin,
                      double* stiffness, hh_error* error) {
  return guarded(error, [&] {
    require(stiffness, "hh_auto_stiffness: stiffness must not be null");
    *stiffness = handhold::realtime::auto_stiffness({mass, volume, mu_static, samples, depth, margin, 9.81});
  });
}

void hh_hand_mean(double scale, hh_hand* hand) {
  if (!hand) return;
  const HandModel model = handhold::anatomical_hand(scale);
  for (std::size_t i = 0; i < 15; ++i) {
    hand->half_length[i] = model.capsules[i].half_length;
    hand->radius[i] = model.capsules[i].radius;
  }
  store(model.palm_box.half_extents, hand->palm);
}

int hh_contact_create(const hh_field* field, const hh_object* object, const hh_hand* hands, int hand_count,
                      const hh_options* options, hh_contact** contact, hh_error* error) {
  return guarded(error, [&] {
    require(contact, "hh_contact_create: contact must not be null");
    *contact = nullptr;
    require(field && object && hands && options,
            "hh_contact_create: field, object, hands and options must not be null");
    require(hand_count >= 1 && hand_count <= 16, "hand_count: must be 1 to 16");
    require(vector(object->center_of_mass).allFinite(), "object: the centre of mass must be finite");
    auto made = std::make_unique<hh_contact>();
    made->field = field->field;
    made->object = *object;
    for (int i = 0; i < hand_count; ++i) made->models.push_back(model_of(hands[i]));
    made->frames.resize(std::size_t(hand_count));
    made->contact = make(*made, *options);
    *contact = made.release();
  });
}

void hh_contact_destroy(hh_contact* contact) { delete contact; }

int hh_contact_set_options(hh_contact* contact, const hh_options* options, hh_error* error) {
  return guarded(error, [&] {
    require(contact && options, "hh_contact_set_options: contact and options must not be null");
    contact->contact = make(*contact, *options);
  });
}

int hh_contact_step(hh_contact* contact, double dt, const hh_hand_frame* hands, const hh_body* body, hh_wrench* wrench,
                    hh_error* error) {
  return guarded(error, [&] {
    require(contact && hands && body && wrench, "hh_contact_step: contact, hands, body and wrench must not be null");
    require(std::isfinite(dt) && dt > 0, "dt: must be above 0 s");
    const paper::BodyMotion m = motion(*body);
    read_frames(hands, contact->frames);
    store(contact->contact->frame(dt, contact->frames, m), wrench);
  });
}

int hh_contact_wrench_at(const hh_contact* contact, const hh_body* body, hh_wrench* wrench, hh_error* error) {
  return guarded(error, [&] {
    require(contact && body && wrench, "hh_contact_wrench_at: contact, body and wrench must not be null");
    store(contact->contact->middleware().wrench_at(motion(*body)), wrench);
  });
}

int hh_contact_slopes(const hh_contact* contact, const hh_body* body, double by_pose[36], double by_velocity[36],
                      hh_error* error) {
  return guarded(error, [&] {
    require(contact && body && by_pose && by_velocity, "hh_contact_slopes: no argument must be null");
    using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
    const paper::WrenchSlopes slopes = contact->contact->middleware().slopes_at(motion(*body));
    Eigen::Map<RowMajor>(by_pose, 6, 6) = slopes.by_pose;
    Eigen::Map<RowMajor>(by_velocity, 6, 6) = slopes.by_velocity;
  });
}

int hh_contact_samples(const hh_contact* contact, hh_sample* samples, int capacity) {
  if (!contact) return -1;
  int count = 0;
  const std::vector<paper::PatchState>& patches = contact->contact->middleware().patches();
  for (std::size_t k = 0; k < patches.size(); ++k) {
    for (int i = 0; i < patches[k].count; ++i, ++count) {
      if (!samples || count >= capacity) continue;
      const paper::SampleState& s = patches[k].samples[std::size_t(i)];
      hh_sample& out = samples[count];
      out.hand = int(k) / phalanx_count;
      out.phalanx = int(k) % phalanx_count;
      out.number = i;
      out.mode = int(s.mode);
      store(s.anchor.C_O, out.anchor);
      store(s.anchor.n_O, out.normal);
      store(s.f_W, out.force);
    }
  }
  return count;
}
