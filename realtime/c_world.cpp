// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "cases/model/text.hpp"
#include "realtime/c_support.hpp"
#include "realtime/world.hpp"

using handhold::Body;
using handhold::HandFrame;
using handhold::InputError;
using handhold::Mobility;
using handhold::Mode;
using handhold::SampleId;
using handhold::sentence;
using handhold::c::guarded;
using handhold::c::is_unit;
using handhold::c::model_of;
using handhold::c::pose;
using handhold::c::read_frames;
using handhold::c::require;
using handhold::c::store;
using handhold::c::vector;
using handhold::realtime::Options;
using handhold::realtime::PatchSlot;
using handhold::realtime::RigidBody;
using handhold::realtime::World;
using handhold::realtime::WorldDef;

struct hh_world {
  World world;
  std::vector<HandFrame> frames;  // of the step, kept so that a step allocates nothing
  bool started{false};
};

namespace {

constexpr int world_cookie = 0x68687701;
constexpr int body_cookie = 0x68686201;
constexpr double longest_frame = 1;  // [s]: what is longer is no frame, but a unit gone wrong

/// The velocity of O's origin, as Body has it, from that of the centre of mass.
handhold::Twist twist_of(const hh_body& start, const Eigen::Vector3d& center_O) {
  const Eigen::Vector3d w = vector(start.angular_velocity);
  return {w, vector(start.velocity) - w.cross(pose(start.pose).R * center_O)};
}

Body body_of(const hh_body_def& d, int index) {
  if (d.cookie != body_cookie)
    throw InputError(sentence("body ", index, ": must begin as hh_body_def_default() (then set its members)"));
  if (!d.field) throw InputError(sentence("body ", index, ": has no field (set field)"));
  if (d.mobility < HH_FREE || d.mobility > HH_FIXED)
    throw InputError(
        sentence("body ", index, ": mobility ", d.mobility, ": no such choice (take one of the HH_ names)"));
  if (!is_unit(d.start.pose))
    throw InputError(sentence("body ", index, ": the quaternion must be a unit one (w, x, y, z)"));
  Body body;
  body.field = d.field->field;
  body.inertia.mass = d.mass;
  body.inertia.center = vector(d.center_of_mass);
  body.inertia.about_center = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(d.inertia);
  body.mobility = Mobility(d.mobility);
  body.friction = {d.mu_static, d.mu_dynamic};
  body.X_WO = pose(d.start.pose);
  body.V_WO = twist_of(d.start, body.inertia.center);
  body.held_until = d.held_until;
  if (d.touches_bodies) body.samples_O = d.field->samples_O;
  if (d.touches_bodies && body.samples_O.empty())
    throw InputError(sentence("body ", index, ": its field has no samples to touch bodies with (voxelize with ",
                              "--sample-spacing, or set touches_bodies to 0)"));
  return body;
}

WorldDef def_of(const hh_world_def& d) {
  WorldDef def;
  def.gravity = vector(d.gravity);
  def.contact = {d.stiffness, d.damping};
  def.body_contact = {d.body_stiffness, d.body_damping};
  def.patch.samples = d.samples;
  def.patch.finger_radius = d.finger_radius;
  def.patch.thumb_radius = d.thumb_radius;
  def.patch.palm_radius = d.palm_radius;
  def.patch.contact_offset = d.contact_offset;
  for (int i = 0; i < d.body_count; ++i) def.bodies.push_back(body_of(d.bodies[i], i));
  for (int i = 0; i < d.hand_count; ++i) def.hands.push_back({model_of(d.hands[i]), {}});
  return def;
}

void check_frame(double dt) {
  if (!(dt > 0 && dt <= longest_frame))
    throw InputError(sentence("dt ", dt, " s: must be above 0 and at most 1 s (give seconds)"));
}

hh_body state_of(const RigidBody& body) {
  hh_body state{};
  const Eigen::Quaterniond& R = body.X_WO.R;
  const double q[4] = {R.w(), R.x(), R.y(), R.z()};
  std::copy_n(q, 4, state.pose.q);
  store(body.X_WO.p, state.pose.p);
  store(body.v, state.velocity);
  store(body.w, state.angular_velocity);
  return state;
}

hh_sample_id name_of(const SampleId& id) {
  const bool of_body = id.belongs_to_body();
  return {of_body ? -1 : id.hand, of_body ? -1 : id.phalanx, of_body ? id.phalanx : -1, id.body, id.sample};
}

hh_touch touch_of(const handhold::ContactState& state) {
  hh_touch touch{};
  touch.id = name_of(state.id);
  touch.mode = int(state.mode);
  touch.depth = state.depth;
  store(state.p_W, touch.point);
  store(state.C_W, touch.anchor);
  store(state.n_W, touch.normal);
  store(state.f_W, touch.force);
  return touch;
}

}  // namespace

hh_world_def hh_world_def_default(void) {
  const WorldDef def;
  const Options options;
  hh_world_def d{};
  d.cookie = world_cookie;
  store(def.gravity, d.gravity);
  d.stiffness = def.contact.stiffness;
  d.damping = def.contact.damping;
  d.body_stiffness = def.body_contact.stiffness;
  d.body_damping = def.body_contact.damping;
  d.samples = def.patch.samples;
  d.finger_radius = def.patch.finger_radius;
  d.thumb_radius = def.patch.thumb_radius;
  d.palm_radius = def.patch.palm_radius;
  d.contact_offset = def.patch.contact_offset;
  d.substeps = options.substeps;
  d.order = options.order;
  d.longest_bridge = options.longest_bridge;
  d.longest_turn = options.longest_turn;
  return d;
}

hh_body_def hh_body_def_default(void) {
  const handhold::Friction friction;
  hh_body_def d{};
  d.cookie = body_cookie;
  d.mu_static = friction.mu_static;
  d.mu_dynamic = friction.mu_dynamic;
  d.start.pose.q[0] = 1;
  return d;
}

int hh_world_create(const hh_world_def* def, hh_world** world, hh_error* error) {
  return guarded(error, [&] {
    require(world, "hh_world_create: world must not be null");
    *world = nullptr;
    require(def, "hh_world_create: def must not be null");
    require(def->cookie == world_cookie, "world: must begin as hh_world_def_default() (then set its members)");
    require(def->bodies || def->body_count <= 0, "world: body_count without bodies (set bodies)");
    require(def->hands || def->hand_count <= 0, "world: hand_count without hands (set hands)");
    Options options;
    options.substeps = def->substeps;
    options.order = def->order;
    options.longest_bridge = def->longest_bridge;
    options.longest_turn = def->longest_turn;
    const WorldDef made = def_of(*def);
    *world = new hh_world{World(made, options), std::vector<HandFrame>(made.hands.size()), false};
  });
}

void hh_world_destroy(hh_world* world) { delete world; }

int hh_world_step(hh_world* world, double dt, const hh_hand_frame* hands, hh_error* error) {
  return guarded(error, [&] {
    require(world && (hands || world->frames.empty()), "hh_world_step: world and hands must not be null");
    check_frame(dt);
    read_frames(hands, world->frames);
    if (world->started) return world->world.advance(dt, world->frames);
    world->world.start(dt, world->frames);
    world->started = true;
  });
}

double hh_world_time(const hh_world* world) { return world ? world->world.time() : 0; }

int hh_world_body(const hh_world* world, int body, hh_body* state, hh_error* error) {
  return guarded(error, [&] {
    require(world && state, "hh_world_body: world and state must not be null");
    const std::vector<RigidBody>& bodies = world->world.bodies();
    if (body < 0 || std::size_t(body) >= bodies.size())
      throw InputError(sentence("body ", body, ": there are ", bodies.size(), " (count from 0)"));
    *state = state_of(bodies[std::size_t(body)]);
  });
}

int hh_world_touches(const hh_world* world, hh_touch* touches, int capacity) {
  if (!world) return -1;
  int count = 0;
  const handhold::realtime::Contacts& contacts = world->world.contacts();
  for (const PatchSlot& patch : contacts.patches) {
    for (int i = 0; patch.active && i < patch.count; ++i) {
      if (contacts.mode[patch.slot(i)] == Mode::apart) continue;
      if (touches && count < capacity) touches[count] = touch_of(world->world.contact(patch.slot(i)));
      ++count;
    }
  }
  return count;
}

int hh_world_events(const hh_world* world, hh_event* events, int capacity) {
  if (!world) return -1;
  int count = 0;
  for (const handhold::Event& event : world->world.events()) {
    if (events && count < capacity) events[count] = {event.t, event.window, int(event.kind), name_of(event.id)};
    ++count;
  }
  return count;
}

int hh_world_energy(const hh_world* world, hh_energy* energy, hh_error* error) {
  return guarded(error, [&] {
    require(world && energy, "hh_world_energy: world and energy must not be null");
    const handhold::Energy e = world->world.energy();
    *energy = {e.kinetic, e.potential, e.elastic, e.dissipated, e.hand_work};
  });
}

long hh_world_unconverged(const hh_world* world) { return world ? world->world.unconverged() : -1; }
