// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <string>
#include <vector>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/catalogue/scenes/lively_scenes.hpp"
#include "realtime/paper/hand_contact.hpp"
#include "realtime/world.hpp"
#include "tests/bits/digest.hpp"

// Prints a number for all bits of lively runs of the real-time path and of the paper's law. Compiled several times with
// other optimisations (CMakeLists.txt beside this file), it must print the same.

namespace handhold::realtime {
namespace {

using handhold::testing::Digest;

constexpr double dt = 1.0 / 90;
constexpr int frames_a_line = 24;  // the first line that differs tells when the bits part

std::vector<HandFrame> frames(const Scene& scene, double t) {
  std::vector<HandFrame> hands(scene.hands.size());
  for (std::size_t i = 0; i < hands.size(); ++i) {
    hands[i].present = true;
    for (int p = 0; p < phalanx_count; ++p) hands[i].X_WP[std::size_t(p)] = scene.hands[i].motion->pose(p, t);
  }
  return hands;
}

/// Prints what has come together by frame `k`, now and then.
void print(const std::string& name, int k, const Digest& digest) {
  if (k % frames_a_line == 0)
    std::printf("%s to frame %d: %016llx\n", name.c_str(), k, (unsigned long long)(digest.value()));
}

void put(const World& world, Digest& digest) {
  for (const RigidBody& body : world.bodies()) {
    digest.put(body.X_WO);
    digest.put(body.v);
    digest.put(body.w);
  }
  for (std::size_t slot = 0; slot < world.contacts().size(); ++slot)
    if (world.contacts().mode[slot] != Mode::apart) digest.put(world.contact(slot));
  for (const Event& event : world.events()) digest.put(event);
  digest.put(world.energy());
  digest.put(world.unconverged());
}

void play(const std::string& name, const Scene& scene, double duration, const Options& options) {
  World world(world_def_of(scene), options);
  for (const double t : {-2 * dt, -dt}) world.observe(dt, frames(scene, t));
  world.start(dt, frames(scene, 0));
  Digest digest;
  long touching = 0;
  for (int k = 1; k * dt <= duration; ++k) {
    world.advance(dt, frames(scene, k * dt));
    put(world, digest);
    for (const Mode mode : world.contacts().mode) touching += mode != Mode::apart;
    print(name + ", order " + std::to_string(options.order), k, digest);
  }
  std::printf("%s: %ld forces\n", name.c_str(), touching);
}

/// The paper's law on a shaken hand around a box that stays where it is: forces, slopes and every sample.
void play_paper(const std::string& name, const Scene& scene, paper::Normals normals, const paper::Options& options) {
  const Body& body = scene.bodies[0];
  paper::HandContact contact(body.field, normals, Eigen::Vector3d::Zero(), body.friction, options,
                             {scene.hands[0].motion->model()});
  const paper::BodyMotion motion{body.X_WO, {0.1, -0.05, 0.02}, {1, 0.5, -2}};
  Digest digest;
  long touching = 0;
  for (int k = 1; k * dt <= scene.duration; ++k) {
    const paper::Wrench wrench = contact.frame(dt, frames(scene, k * dt), motion);
    digest.put(wrench.force);
    digest.put(wrench.torque);
    const paper::WrenchSlopes slopes = contact.middleware().slopes_at(motion);
    for (int i = 0; i < 36; ++i) digest.put(slopes.by_pose(i)), digest.put(slopes.by_velocity(i));
    for (const paper::PatchState& patch : contact.middleware().patches())
      for (int i = 0; patch.active && i < patch.count; ++i) {
        const paper::SampleState& sample = patch.samples[std::size_t(i)];
        digest.put(int(sample.mode));
        for (const Eigen::Vector3d& v : {sample.anchor.C_O, sample.anchor.n_O, sample.p_P, sample.f_W}) digest.put(v);
        touching += sample.f_W.squaredNorm() > 0;
      }
    print(name, k, digest);
  }
  std::printf("%s: %ld forces\n", name.c_str(), touching);
}

void play_all() {
  for (const std::string& id : catalogue::lively_ids()) {
    const Scene scene = catalogue::lively_scene(id);
    for (const int order : {1, 2}) play(id, scene, scene.duration, {.substeps = 2, .order = order});
  }
  const Scene cup = catalogue::benchmark_scene("S6b").scene;
  for (const int order : {1, 2}) play("S6b", cup, 2, {.substeps = 2, .order = order});
  const Scene box = catalogue::box_in_hand();
  using paper::Normals;
  for (const Normals normals : {Normals::triangle, Normals::smooth, Normals::voxel}) {
    const std::string name = "paper, normals " + std::to_string(int(normals));
    play_paper(name, box, normals, {.damping = 0.5});
    play_paper(name + ", Coulomb", box, normals, paper::coulomb());
  }
}

}  // namespace
}  // namespace handhold::realtime

int main() {
  handhold::realtime::play_all();
  return 0;
}
