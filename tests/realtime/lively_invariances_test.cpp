// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/catalogue/scenes/lively_scenes.hpp"
#include "tests/realtime/world_twin.hpp"

// What nature does not care about, asked of scenes that are chaotic: symmetry, similarity, friction that is not used
// (step_audit.hpp asks the other invariants). Chaos makes millimetres of a rounding within a tenth of a second, so
// there are two ways. Changes that only touch exponents or the order of the scene's list have to give the same digits
// in every frame. For all others every frame is played twice from one state, as it is and changed: chaos has no time
// then, and a rounding of the state itself shows what one frame makes of it.

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes

constexpr double dt = 1.0 / 90;

/// What a frame leaves to the solver: it balances the momenta of an island (of all bodies, at 10 m/s) to 1e-13, and to
/// what rounding makes of positions a metre from the origin, 4e-16 h k √n with n = 100 samples; and where that takes
/// the lightest body in the two sub-steps of a frame [m].
double solver_error(const Scene& scene) {
  double momentum = 0, lightest = std::numeric_limits<double>::infinity(), k = scene.contact.stiffness;
  for (const Body& body : scene.bodies) {
    if (!body.samples_O.empty()) k = std::max(k, scene.body_contact.stiffness);
    if (body.mobility == Mobility::fixed) continue;
    momentum += 10 * body.inertia.mass;
    lightest = std::min(lightest, body.inertia.mass);
  }
  return 2 * dt / lightest * (1e-13 * momentum + 4e-16 * dt / 2 * k * 10);
}

struct Lively {
  std::string name{};
  std::function<Scene()> make{};
  double duration{};  // [s]
  double sticks{};    // until then there are frames in which nothing slides [s]
};

const std::vector<Lively>& all_lively() {
  static const std::vector<Lively> all{
      {"BoxInHand", catalogue::box_in_hand, 2, 2},
      {"HandToHand", catalogue::hand_to_hand, 2.4, 2.4},
      {"KnockedTower", catalogue::knocked_tower, 1.6, 1.6},
      {"AxeSmash", [] { return catalogue::benchmark_scene("S4a").scene; }, 1.6, 1.21},
      {"Jenga", [] { return catalogue::benchmark_scene("S4b").scene; }, 1, 1},
  };
  return all;
}

/// Four frames of the hands, the last one at `t`: all that HandPath remembers.
std::vector<std::vector<HandFrame>> history(const ChangedScene& scene, double t, double frame) {
  std::vector<std::vector<HandFrame>> hands;
  for (int ago = 3; ago >= 0; --ago) hands.push_back(scene.frames(t - ago * frame));
  return hands;
}

/// A changed scene that is played in frames of `dt` of the unchanged one.
class Played {
 public:
  Played(const Scene& scene, const Change& change, const Options& options)
      : scene_(scene, change), frame_(dt * change.time()), world_(world_def_of(scene_.scene()), options) {
    const auto hands = history(scene_, 0, frame_);
    for (std::size_t i = 0; i < 3; ++i) world_.observe(frame_, hands[i]);
    world_.start(frame_, hands[3]);
  }

  void advance() { world_.advance(frame_, scene_.frames(++at_ * frame_)); }
  [[nodiscard]] World& world() { return world_; }
  [[nodiscard]] const ChangedScene& scene() const { return scene_; }
  [[nodiscard]] double time() const { return at_ * frame_; }

 private:
  ChangedScene scene_;
  double frame_;
  World world_;
  int at_{};
};

/// How far a world is from where a change has another one. Velocities count by what they make in a frame, turns by
/// where they take a body's farthest point, all in lengths of the unchanged scene [m].
double apart(const World& world, const Change& change, const World& changed) {
  double most = 0;
  for (std::size_t i = 0; i < world.bodies().size(); ++i) {
    const RigidBody &a = world.bodies()[i], &b = changed.bodies()[i];
    const Pose X = change.pose(a.X_WO, changed.time());
    const double L = change.length, T = change.time();
    most = std::max(most, (X.p - b.X_WO.p).norm() / L);
    most = std::max(most, a.radius * (X.R.toRotationMatrix() - b.X_WO.R.toRotationMatrix()).norm());
    if (!a.moves()) continue;
    most = std::max(most, dt * T / L * (change.velocity(a.v) - b.v).norm());
    most = std::max(most, dt * a.radius * (change.axial(a.w) / T - b.w).norm() * T);
  }
  return most;
}

/// A support's oil has a time of its own, which no similarity knows (support_time); instead of it something carries the
/// weight, and lets go bit by bit.
Scene without_support(Scene scene) {
  for (Body& body : scene.bodies) {
    if (body.held_until <= 0) continue;
    const Vector3d carried = -body.inertia.mass * scene.gravity;
    body.load = [carried, until = body.held_until](double t) -> Load {
      return {std::clamp(2 - 2 * t / until, 0.0, 1.0) * carried, Vector3d::Zero()};
    };
    body.held_until = 0;
  }
  return scene;
}

/// The coefficient of friction that the samples in contact need to stick as they do; infinity if one slides.
double friction_needed(const World& world) {
  const Contacts& contacts = world.contacts();
  double needed = 0;
  for (std::size_t slot = 0; slot < contacts.size(); ++slot) {
    if (contacts.mode[slot] == Mode::slip) return std::numeric_limits<double>::infinity();
    if (contacts.mode[slot] == Mode::apart) continue;
    const Vector3d f = contacts.f_O[slot], n = contacts.n_O[slot];
    needed = std::max(needed, (f - f.dot(n) * n).norm() / -f.dot(n));
  }
  return needed;
}

/// Of all places and times at once: what rounding makes of a state, of lengths and speeds of about 1.
class Noise {
 public:
  explicit Noise(unsigned seed) : random_(seed) {}
  Vector3d operator()() { return {spread_(random_), spread_(random_), spread_(random_)}; }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> spread_{-2.2e-16, 2.2e-16};
};

/// Where and how a scene stands that is moved.
const Pose elsewhere{Eigen::Quaterniond(Eigen::AngleAxisd(2, Vector3d(2, -1, 3).normalized())), {0.25, -0.5, 0.75}};

class LivelyInvariance : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] const Lively& lively() const { return all_lively()[std::size_t(GetParam())]; }
  [[nodiscard]] int frame_count() const { return int(std::lround(lively().duration / dt)); }

  const Scene scene_ = lively().make();
};

/// Froude: lengths by a quarter and a sixteenth, times by their roots, masses by powers of two: all numbers keep their
/// digits, unless one with a dimension hides somewhere. Those known are a support's time, and what a phalanx sees
/// exactly (nearest_reach, 10 mm): no larger scene, whose patches would be looked for farther away than that. Cubes of
/// a tenth of a millimetre, a 256th, would feel others.
TEST_P(LivelyInvariance, OfSizeAndWeightToTheLastBit) {
  const Scene scene = without_support(scene_);
  for (const int order : {1, 2}) {
    if (order == 2 && lively().name == "AxeSmash") continue;  // holds, too, and takes as long as all others together
    const Change change{.length = order == 1 ? 0.25 : 0.0625, .mass = order == 1 ? 8.0 : 0.5};
    Played plain(scene, {}, {.substeps = 2, .order = order}), changed(scene, change, {.substeps = 2, .order = order});
    for (int k = 1; k <= frame_count(); ++k) {
      plain.advance();
      changed.advance();
      ASSERT_EQ(apart(plain.world(), change, changed.world()), 0) << k;
      ASSERT_EQ(plain.world().contacts().mode, changed.world().contacts().mode) << k;
    }
    const double energy = change.mass * change.length;
    EXPECT_EQ(plain.world().energy().dissipated * energy, changed.world().energy().dissipated);
    EXPECT_EQ(plain.world().energy().hand_work * energy, changed.world().energy().hand_work);
  }
}

TEST_P(LivelyInvariance, OfTheOrderOfBodiesToTheLastBit) {
  std::vector<int> original(scene_.bodies.size());
  std::iota(original.begin(), original.end(), 0);
  std::mt19937 random(7);
  std::shuffle(original.begin(), original.end(), random);
  Scene shuffled = scene_;
  for (std::size_t i = 0; i < original.size(); ++i) shuffled.bodies[i] = scene_.bodies[std::size_t(original[i])];
  Played plain(scene_, {}, {.substeps = 2}), changed(shuffled, {}, {.substeps = 2});
  for (int k = 1; k <= frame_count(); ++k) {
    plain.advance();
    changed.advance();
    for (std::size_t i = 0; i < original.size(); ++i) {
      const RigidBody &a = plain.world().bodies()[std::size_t(original[i])], &b = changed.world().bodies()[i];
      ASSERT_EQ(a.X_WO.p, b.X_WO.p) << k;
      ASSERT_EQ(a.X_WO.R.coeffs(), b.X_WO.R.coeffs()) << k;
      ASSERT_EQ(a.v, b.v) << k;
      ASSERT_EQ(a.w, b.w) << k;
    }
  }
}

/// Elsewhere, looking another way, in a mirror, passing by. What stands still in the world (the ground, a support while
/// it holds) does not pass by.
TEST_P(LivelyInvariance, OfPlaceDirectionMirrorImageAndVelocityInEveryFrame) {
  struct Twin {
    Change change{};
    ChangedScene scene;
  };
  std::vector<Twin> twins;
  double stands_until = 0;
  for (const Body& body : scene_.bodies)
    stands_until = std::max(stands_until, body.mobility == Mobility::fixed ? lively().duration : body.held_until);
  for (const Change& change :
       {Change{.mirrored = true, .X = elsewhere}, Change{.mirrored = true, .X = elsewhere, .boost = {0.5, -0.25, 1}}})
    twins.push_back({change, {scene_, change}});
  if (stands_until >= lively().duration) twins.pop_back();

  Noise noise(3);
  Played plain(scene_, {}, {.substeps = 2});
  double worst = 0, largest = 0;
  for (int k = 1; k <= frame_count(); ++k) {
    std::vector<World> changed, disturbed(2, plain.world());
    for (const Twin& twin : twins)
      changed.push_back(WorldTwin::of(plain.world(), twin.scene, dt, history(twin.scene, plain.time(), dt)));
    for (World& world : disturbed) WorldTwin::disturb(world, noise);
    const double begin = plain.time();
    plain.advance();
    double of_rounding = 0;
    for (World& world : disturbed) {
      world.advance(dt, plain.scene().frames(plain.time()));
      of_rounding = std::max(of_rounding, apart(plain.world(), {}, world));
    }
    for (std::size_t i = 0; i < twins.size(); ++i) {
      changed[i].advance(dt, twins[i].scene.frames(plain.time()));
      if (!twins[i].change.boost.isZero() && begin <= stands_until) continue;
      const double off = apart(plain.world(), twins[i].change, changed[i]);
      const double allowed = solver_error(scene_) + 30 * of_rounding;
      EXPECT_LT(off, allowed) << "frame " << k << ", change " << i;
      worst = std::max(worst, off / allowed);
      largest = std::max(largest, off);
    }
  }
  std::cout << lively().name << ": at most " << largest << " m apart after a frame, " << worst << " of the allowed\n";
}

/// From the very start on, and with hands and phalanges numbered the other way round, as long as a run whose start was
/// disturbed by a rounding stays within a micrometre.
TEST_P(LivelyInvariance, FromTheStartUntilChaosSetsIn) {
  const std::vector<Change> changes{{.mirrored = true, .X = elsewhere}, {.renumbered = true}};
  Noise noise(4);
  Played plain(scene_, {}, {.substeps = 2});
  std::vector<Played> changed, disturbed(2, plain);
  for (const Change& change : changes) changed.emplace_back(scene_, change, Options{.substeps = 2});
  for (Played& run : disturbed) WorldTwin::disturb(run.world(), noise);
  // Disturbed once, against rounding otherwise in some ten thousand operations of each of a hundred steps: √1e6.
  constexpr double roundings = 1000;
  double of_rounding = 0, largest = 0;
  int k = 0;
  while (k < frame_count()) {
    plain.advance();
    for (Played& run : disturbed) {
      run.advance();
      of_rounding = std::max(of_rounding, apart(plain.world(), {}, run.world()));
    }
    if (of_rounding > 1e-6) break;
    ++k;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      changed[i].advance();
      const double off = apart(plain.world(), changes[i], changed[i].world());
      EXPECT_LT(off, k * solver_error(scene_) + roundings * of_rounding) << "frame " << k << ", change " << i;
      largest = std::max(largest, off);
    }
  }
  std::cout << lively().name << ": at most " << largest << " m apart in " << k << " frames, a rounding made "
            << of_rounding << "\n";
  EXPECT_GT(k, 80);
}

/// In every frame in which nothing slides, from one state: what sticks with less friction than there is does not care
/// how much more there is: to the last bit where all that touches stuck before. What may touch or let go feels its cone
/// on the way to a solution, which ends within the solver's tolerance, unless there are several: so it was found once,
/// where the tower falls with a friction of 2.
TEST_P(LivelyInvariance, OfFrictionThatIsNotUsedInEveryFrame) {
  constexpr double less = 3;
  Scene rough = scene_, rougher = scene_;
  for (Body& body : rough.bodies) body.friction = {less, less};
  for (Body& body : rougher.bodies) body.friction = {6, 5};
  const ChangedScene other(rougher, {});
  Played plain(rough, {}, {.substeps = 1});
  int same = 0, in_doubt = 0, several = 0;
  for (int k = 1; k <= int(std::lround(lively().sticks / dt)); ++k) {
    World twin = WorldTwin::of(plain.world(), other, dt, history(other, plain.time(), dt));
    const bool slid = friction_needed(plain.world()) > less;
    plain.advance();
    twin.advance(dt, other.frames(plain.time()));
    if (slid || friction_needed(twin) > less) continue;
    const double off = apart(plain.world(), {}, twin);
    if (!WorldTwin::any(plain.world(), Role::free)) {
      EXPECT_EQ(off, 0) << k;
      ++same;
    } else {
      ++in_doubt;
      several += !(off < solver_error(scene_));
    }
  }
  std::cout << lively().name << ": " << same << " frames to the last bit, " << in_doubt
            << " in which a sample may touch or let go (" << several << " with another solution), of " << frame_count()
            << "\n";
  EXPECT_GT(same + in_doubt, 30);  // enough to mean something: what sticks beside an edge soon needs more
  EXPECT_LE(several, lively().name == "KnockedTower" ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, LivelyInvariance, ::testing::Range(0, 5),
                         [](const auto& made) { return all_lively()[std::size_t(made.param)].name; });

}  // namespace
}  // namespace handhold::realtime
