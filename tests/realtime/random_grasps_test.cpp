// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/realtime/audited_twin.hpp"
#include "tests/realtime/random_grasp.hpp"

// Random grasps of one body, every sub-step audited. How many: HANDHOLD_GRASPS; from which seed: HANDHOLD_FIRST_GRASP.
// All 100 000:
//
//   HANDHOLD_GRASPS=100000 ./realtime_test --gtest_filter='RandomGrasps.*'
//
// takes ten minutes on one core (20 000: 103 s of CPU time, measured at -O2).

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes

long from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atol(text) : otherwise;
}

/// Sums and worst cases over all grasps.
struct Survey {
  AuditTally all{};
  long grasps{}, touched{};
  double gain{};  // largest relative_gain
};

/// Kinetic and potential energy beyond the start and what hands gave, relative to what passed through the hands, at
/// least 1 mJ.
double relative_gain(const AuditTally& t) { return t.gain / std::max(t.throughput, 1e-3); }

/// The audit's own measure of what hands gave is right to third order in the turn of a step: 1/12 of 0.25 rad
/// (Options::longest_turn) to the third.
constexpr double tolerated_gain = 1e-3;

void add(const AuditTally& t, Survey& survey) {
  AuditTally& all = survey.all;
  ++survey.grasps;
  survey.touched += t.forces > 0;
  for (long AuditTally::*count : {&AuditTally::steps, &AuditTally::forces, &AuditTally::slides, &AuditTally::backward,
                                  &AuditTally::unconverged, &AuditTally::audited})
    all.*count += t.*count;
  for (double AuditTally::*worst : {&AuditTally::touch, &AuditTally::way_in, &AuditTally::momentum, &AuditTally::cone,
                                    &AuditTally::element, &AuditTally::energy})
    all.*worst = std::max(all.*worst, t.*worst);
  all.terms += t.terms;
  all.excess += t.excess;
  all.throughput += t.throughput;
  survey.gain = std::max(survey.gain, relative_gain(t));
}

std::string describe(long seed, const RandomGrasp& grasp) {
  std::ostringstream text;
  text << "seed " << seed << " (HANDHOLD_FIRST_GRASP=" << seed << " HANDHOLD_GRASPS=1), m "
       << grasp.scene.bodies[0].inertia.mass << " kg, k " << grasp.scene.contact.stiffness << " N/m, c "
       << grasp.scene.contact.damping << " N s/m, h " << grasp.dt / grasp.options.substeps << " s, order "
       << grasp.options.order;
  return text.str();
}

void print(const Survey& s) {
  const AuditTally& t = s.all;
  std::cout << s.grasps << " grasps, " << s.touched << " of them touched; " << t.steps << " sub-steps, " << t.audited
            << " with their energy, " << t.unconverged << " not solved; " << t.forces << " forces, " << t.slides
            << " of them sliding, " << t.backward << " backwards\nlargest share of what is allowed: momentum "
            << t.momentum << ", cone " << t.cone << ", element " << t.element << ", energy " << t.energy << ", touch "
            << t.touch << ", way in " << t.way_in << "\nof " << t.throughput << " J: numerical " << t.terms.numerical
            << ", turning " << t.terms.turning << ", touching " << t.terms.touching << ", appearing "
            << t.terms.appearing << ", curving " << t.terms.curving << ", in steps that gained " << t.excess
            << "; largest gain of a grasp " << s.gain << "\n";
}

/// The first grasps that were found to gain energy (66550, 95229; of the second order 92584, which shook for good) and
/// to slide backwards (68619, 77696), among more than 100 000 of each engine that was.
constexpr std::array<long, 5> once_faulty{66550, 68619, 77696, 92584, 95229};

void play(long seed, const std::vector<GraspObject>& objects, Survey& survey) {
  RandomGrasp grasp(std::uint64_t(seed), objects);
  std::vector<std::vector<HandFrame>> before;
  for (int k = 0; k < 3; ++k) before.push_back(grasp.next_frame());
  AuditedTwin twin(grasp.scene, grasp.options, grasp.dt, before);
  bool same = true;
  for (int k = 1; k <= grasp.frames; ++k) {
    twin.advance(grasp.next_frame());
    same = same && twin.agrees();
  }
  const AuditTally& t = twin.tally();
  add(t, survey);
  EXPECT_TRUE(same) << describe(seed, grasp) << ": the twin of one sub-step a frame went another way";
  EXPECT_EQ(t.fault, "") << describe(seed, grasp);
  EXPECT_EQ(t.unconverged, 0) << describe(seed, grasp);
  EXPECT_EQ(t.backward, 0) << describe(seed, grasp);
  EXPECT_LE(relative_gain(t), tolerated_gain) << describe(seed, grasp);
}

TEST(RandomGrasps, KeepEveryInvariantInEverySubStep) {
  const long count = from_environment("HANDHOLD_GRASPS", 300), first = from_environment("HANDHOLD_FIRST_GRASP", 1);
  const std::vector<GraspObject> objects = grasp_objects();
  Survey survey;
  for (const long seed : once_faulty) play(seed, objects, survey);
  for (long seed = first; seed < first + count; ++seed) play(seed, objects, survey);
  print(survey);
  EXPECT_GT(survey.touched, 0.8 * double(survey.grasps));
}

}  // namespace
}  // namespace handhold::realtime
