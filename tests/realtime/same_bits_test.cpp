// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/lively_scenes.hpp"
#include "tests/bits/digest.hpp"
#include "tests/realtime/scenes.hpp"

// The same bits again, in two threads at once, and for any order of bodies and phalanges in the scene; for other
// optimisations see tests/bits.

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes
using handhold::testing::Digest;

constexpr double dt = 1.0 / 90;
constexpr int runs = 20;

/// The knocked tower, its fingers with given samples on the side they come with: so that their order can be changed.
Scene tower() {
  Scene scene = catalogue::knocked_tower();
  for (Hand& hand : scene.hands) hand.given.clear();
  for (const int finger : {1, 2, 3, 4})
    scene.hands[0].given.push_back(
        {3 * finger + 2, catalogue::ring({0.008, 0, 0}, Vector3d::UnitX(), Vector3d::UnitY(), 0.003, 8), {}});
  return scene;
}

/// Six fingertips hold a block on which two others lie, and shake it until all slide.
Scene grasp() {
  Scene scene;
  scene.name = "grasp";
  scene.contact = {.stiffness = 500, .damping = 1};
  Body block = touching_block({0.06, 0.06, 0.02}, 0.1, 0.03);
  for (const double z : {0.0, 0.0199, 0.0398}) {
    block.X_WO.p = {0.003 * (z > 0), 0, z};
    scene.bodies.push_back(block);
  }
  const auto shake = [](double t) -> Vector3d {
    const double s = std::max(t, 0.0);
    return {0.02 * s * std::sin(30 * s), 0.01 * s * std::sin(23 * s), 0.015 * s * std::sin(37 * s)};
  };
  std::vector<catalogue::MovingPatch> patches;
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 ? 1 : -1;
    const Vector3d center(0.018 * (i / 2 - 1), side * 0.027, 0);
    patches.push_back({2 + i, catalogue::ring(center, Vector3d::UnitY(), Vector3d::UnitZ(), 0.004, 8), {}, shake});
  }
  scene.hands = {catalogue::hand_of(patches, 1)};
  return scene;
}

struct Kind {
  std::string name{};
  Scene (*make)(){};
  int order{};
};

/// A scene with its bodies and phalanges in another order.
struct Shuffled {
  Scene scene{};
  std::vector<int> original{};  // by body of `scene`: its number in the scene it comes from
};

Shuffled shuffled(const Scene& scene, unsigned seed) {
  Shuffled made{scene, std::vector<int>(scene.bodies.size())};
  std::iota(made.original.begin(), made.original.end(), 0);
  if (seed == 0) return made;
  std::mt19937 random(seed);
  std::shuffle(made.original.begin(), made.original.end(), random);
  for (std::size_t i = 0; i < made.original.size(); ++i)
    made.scene.bodies[i] = scene.bodies[std::size_t(made.original[i])];
  for (Hand& hand : made.scene.hands) std::shuffle(hand.given.begin(), hand.given.end(), random);
  return made;
}

/// A sample's name in the scene whose order has not been changed.
SampleId original_id(SampleId id, const std::vector<int>& original) {
  id.body = std::uint8_t(original[id.body]);
  if (id.belongs_to_body()) id.phalanx = std::uint8_t(original[id.phalanx]);
  return id;
}

/// All bits of what a world shows after a frame, in the original's order.
void put(const World& world, const std::vector<int>& original, Digest& digest) {
  std::vector<const RigidBody*> bodies(original.size());
  for (std::size_t i = 0; i < original.size(); ++i) bodies[std::size_t(original[i])] = &world.bodies()[i];
  for (const RigidBody* body : bodies) {
    digest.put(body->X_WO);
    digest.put(body->v);
    digest.put(body->w);
  }
  std::vector<ContactState> contacts;
  for (std::size_t slot = 0; slot < world.contacts().size(); ++slot)
    if (world.contacts().mode[slot] != Mode::apart) contacts.push_back(world.contact(slot));
  for (ContactState& c : contacts) c.id = original_id(c.id, original);
  std::sort(contacts.begin(), contacts.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  for (const ContactState& c : contacts) digest.put(c);
  std::vector<Event> events = world.events();
  for (Event& e : events) e.id = original_id(e.id, original);
  std::sort(events.begin(), events.end(),
            [](const auto& a, const auto& b) { return std::tie(a.t, a.id) < std::tie(b.t, b.id); });
  for (const Event& e : events) digest.put(e);
  digest.put(world.energy());
  digest.put(world.unconverged());
}

/// A number for every frame.
using Record = std::vector<std::uint64_t>;

Record record(const Scene& scene, int order, unsigned seed = 0) {
  const Shuffled played = shuffled(scene, seed);
  World world = started(played.scene, {.substeps = 2, .order = order}, dt);
  Digest digest;
  Record numbers;
  for (int k = 1; k <= 80; ++k) {
    world.advance(dt, frames(played.scene, k * dt));
    put(world, played.original, digest);
    numbers.push_back(digest.value());
  }
  return numbers;
}

class SameBits : public ::testing::TestWithParam<Kind> {};

TEST_P(SameBits, Again) {
  const Scene scene = GetParam().make();
  const Record first = record(scene, GetParam().order);
  for (int run = 1; run < runs; ++run) ASSERT_EQ(record(scene, GetParam().order), first) << run;
}

TEST_P(SameBits, ForAnyOrderOfBodiesAndPhalanges) {
  const Scene scene = GetParam().make();
  const Record first = record(scene, GetParam().order);
  for (int run = 1; run < runs; ++run) ASSERT_EQ(record(scene, GetParam().order, unsigned(run)), first) << run;
}

TEST_P(SameBits, InTwoThreadsAtOnce) {
  const Scene scene = GetParam().make();  // both threads query the same voxels
  const Record alone = record(scene, GetParam().order);
  for (int round = 0; round < runs / 2; ++round) {
    std::array<Record, 2> records;
    std::array<std::thread, 2> threads;
    for (std::size_t i = 0; i < 2; ++i)
      threads[i] = std::thread([&, i] { records[i] = record(scene, GetParam().order); });
    for (std::thread& thread : threads) thread.join();
    ASSERT_EQ(records[0], alone) << round;
    ASSERT_EQ(records[1], alone) << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits,
                         ::testing::Values(Kind{"Tower", tower, 1}, Kind{"Tower", tower, 2}, Kind{"Grasp", grasp, 1},
                                           Kind{"Grasp", grasp, 2}),
                         [](const auto& made) {
                           return made.param.name + "_order_" + std::to_string(made.param.order);
                         });

/// What is compared is worth it: contacts stick, slide and come and go.
TEST(SameBitsItself, IsAskedOfLivelyScenes) {
  for (const Scene& scene : {tower(), grasp()}) {
    World world = started(scene, {.substeps = 2}, dt);
    std::array<int, 4> events{};
    for (int k = 1; k <= 80; ++k) {
      world.advance(dt, frames(scene, k * dt));
      for (const Event& event : world.events()) ++events[std::size_t(event.kind)];
    }
    for (const int count : events) EXPECT_GT(count, 20) << scene.name;
  }
}

/// A sum in another order does show: the digest is not blind.
TEST(SameBitsItself, ShowAChangeInTheLastPlace) {
  Scene scene = grasp();
  const Record first = record(scene, 1);
  scene.bodies[2].X_WO.p.z() = std::nextafter(scene.bodies[2].X_WO.p.z(), 1);
  EXPECT_NE(record(scene, 1), first);
}

}  // namespace
}  // namespace handhold::realtime
