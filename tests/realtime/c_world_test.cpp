// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "cases/model/voxel_file.hpp"
#include "realtime/handhold.h"
#include "tests/realtime/allocations.hpp"
#include "tests/realtime/scenes.hpp"

namespace handhold::realtime {
namespace {

constexpr double dt = 1.0 / 90;

/// A cube of 50 mm that stands on the ground, struck by a fingertip from above and from the side.
WorldDef struck_cube() {
  WorldDef def;
  def.bodies = {testing::touching_block({0.05, 0.05, 0.05}, 0.1, 0.05), testing::ground()};
  for (Body& body : def.bodies) {
    const SolidProperties solid = solid_properties(body.field->mesh());
    body.inertia = {0.1, solid.center, 0.1 / solid.volume * solid.inertia};
  }
  def.bodies[0].X_WO.p = {0.01, 0, 0.025};
  def.bodies[0].V_WO = {{0, 0, 1}, {0.2, 0, 0}};
  def.hands.resize(1);
  return def;
}

HandFrame hand_at(double t) {
  HandFrame hand;
  hand.present = t < 0.5;
  for (Pose& far_away : hand.X_WP) far_away.p.z() = 5;
  hand.X_WP[5].p = {0.1 * t, 0, 0.1 - 0.1 * t};
  return hand;
}

hh_pose in_c(const Pose& X) { return {{X.R.w(), X.R.x(), X.R.y(), X.R.z()}, {X.p.x(), X.p.y(), X.p.z()}}; }

hh_hand_frame in_c(const HandFrame& hand) {
  hh_hand_frame frame{};
  frame.present = hand.present;
  for (int i = 0; i < phalanx_count; ++i) frame.phalanx[i] = in_c(hand.X_WP[std::size_t(i)]);
  return frame;
}

/// The same world as `def`, through the C interface; fields go by their files' bytes.
hh_world* make_in_c(const WorldDef& def) {
  std::vector<hh_body_def> bodies;
  std::vector<hh_field*> fields;
  hh_error error{};
  for (const Body& body : def.bodies) {
    const std::string bytes = pack_voxels(*body.field, body.samples_O);
    EXPECT_EQ(hh_field_from_bytes(bytes.data(), bytes.size(), &fields.emplace_back(), &error), HH_OK) << error.message;
    hh_body_def b = hh_body_def_default();
    b.field = fields.back();
    b.mass = body.inertia.mass;
    EXPECT_EQ(hh_field_solid(b.field, b.mass, b.center_of_mass, b.inertia, &error), HH_OK) << error.message;
    b.mobility = int(body.mobility);
    b.mu_static = body.friction.mu_static;
    b.mu_dynamic = body.friction.mu_dynamic;
    b.start.pose = in_c(body.X_WO);
    const Eigen::Vector3d v = body.V_WO.v + body.V_WO.w.cross(body.X_WO.R * body.inertia.center);
    for (int i = 0; i < 3; ++i) b.start.velocity[i] = v[i], b.start.angular_velocity[i] = body.V_WO.w[i];
    b.touches_bodies = !body.samples_O.empty();
    bodies.push_back(b);
  }
  hh_hand hand;
  hh_hand_mean(1, &hand);
  hh_world_def d = hh_world_def_default();
  d.bodies = bodies.data();
  d.body_count = int(bodies.size());
  d.hands = &hand;
  d.hand_count = 1;
  hh_world* world = nullptr;
  EXPECT_EQ(hh_world_create(&d, &world, &error), HH_OK) << error.message;
  for (hh_field* field : fields) hh_field_destroy(field);
  return world;
}

TEST(CWorld, HasTheBitsOfTheCppWorldAndAllocatesNothing) {
  const WorldDef def = struck_cube();
  World world(def, {});
  hh_world* const in_c_world = make_in_c(def);
  ASSERT_NE(in_c_world, nullptr);
  hh_error error{};
  std::vector<hh_touch> touches(512);
  std::vector<hh_event> events(512);
  int most_touching = 0, all_events = 0;
  for (int k = 0; k < 90; ++k) {
    const std::vector<HandFrame> hands{hand_at(k * dt)};
    if (k == 0) world.start(dt, hands);
    if (k > 0) world.advance(dt, hands);
    const hh_hand_frame frame = in_c(hands[0]);
    const std::size_t before = testing::allocations();
    ASSERT_EQ(hh_world_step(in_c_world, dt, &frame, &error), HH_OK) << error.message;
    hh_body state;
    ASSERT_EQ(hh_world_body(in_c_world, 0, &state, &error), HH_OK);
    const int touching = hh_world_touches(in_c_world, touches.data(), int(touches.size()));
    const int changes = hh_world_events(in_c_world, events.data(), int(events.size()));
    hh_energy energy;
    ASSERT_EQ(hh_world_energy(in_c_world, &energy, &error), HH_OK);
    EXPECT_EQ(testing::allocations(), before) << "frame " << k;

    const RigidBody& body = world.body();
    EXPECT_EQ(Eigen::Vector3d(state.pose.p), body.X_WO.p) << k;
    EXPECT_EQ(Eigen::Vector3d(state.velocity), body.v) << k;
    EXPECT_EQ(Eigen::Vector3d(state.angular_velocity), body.w) << k;
    EXPECT_EQ(energy.dissipated, world.energy().dissipated) << k;
    ASSERT_EQ(std::size_t(changes), world.events().size()) << k;
    for (int i = 0; i < changes; ++i) EXPECT_EQ(events[std::size_t(i)].t, world.events()[std::size_t(i)].t);
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (int i = 0; i < touching; ++i) {
      const hh_touch& touch = touches[std::size_t(i)];
      EXPECT_EQ(touch.id.body == 0, touch.id.hand == 0);  // the finger on the cube, the cube on the ground
      EXPECT_EQ(touch.id.of_body, touch.id.hand < 0 ? 0 : -1);
      force += Eigen::Vector3d(touch.force);
    }
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (std::size_t slot = 0; slot < world.contacts().size(); ++slot)
      if (world.contacts().mode[slot] != Mode::apart) expected += world.contact(slot).f_W;
    EXPECT_EQ(force, expected) << k;
    most_touching = std::max(most_touching, touching);
    all_events += changes;
  }
  EXPECT_GT(most_touching, 4);  // the ground's four corners, and the finger
  EXPECT_GT(all_events, 8);
  hh_world_destroy(in_c_world);
}

TEST(WorldDef, IsCheckedMemberByMember) {
  const auto refused = [](auto change, const std::string& word) {
    WorldDef def = struck_cube();
    change(def);
    try {
      (void)World(def, {});
      ADD_FAILURE() << "taken: " << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find('('), std::string::npos) << error.what();
    }
  };
  refused([](WorldDef& d) { d.bodies.clear(); }, "without bodies");
  refused([](WorldDef& d) { d.bodies.resize(256, d.bodies[0]); }, "256 bodies");
  refused([](WorldDef& d) { d.hands.resize(255); }, "255 hands");
  refused([](WorldDef& d) { d.gravity.x() = NAN; }, "gravity");
  refused([](WorldDef& d) { d.contact.stiffness = 0; }, "stiffness");
  refused([](WorldDef& d) { d.body_contact.damping = -1; }, "damping");
  refused([](WorldDef& d) { d.patch.samples = 0; }, "samples");
  refused([](WorldDef& d) { d.bodies[1].field = nullptr; }, "body");
  refused([](WorldDef& d) { d.bodies[0].name.clear(), d.bodies[0].inertia.mass = 0; }, "body 0: mass");
  refused([](WorldDef& d) { d.hands[0].model.capsules[5].radius = 0; }, "hand 0: index_distal");
  refused([](WorldDef& d) { d.hands[0].model.palm_box.half_extents.y() = -1; }, "hand 0: palm");
  refused([](WorldDef& d) { d.hands[0].given = {{16, {Eigen::Vector3d::Zero()}, {}}}; }, "phalanx 16");
}

}  // namespace
}  // namespace handhold::realtime
