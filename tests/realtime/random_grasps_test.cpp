#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/realtime/audited_twin.hpp"
#include "tests/realtime/random_grasp.hpp"

// Random grasps of one body, every sub-step audited. How many: HANDHOLD_GRASPS; from which seed: HANDHOLD_FIRST_GRASP;
// with HANDHOLD_VERBOSE those are named that had a sub-step without a solution. All 100 000:
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
  long gained{};  // grasps, all solved, with a body that got 1 % more than what passed through the hands
  double gain{};  // of a grasp, relative to what passed through its hands, at least 1 mJ
};

void add(const AuditTally& t, Survey& survey) {
  AuditTally& all = survey.all;
  ++survey.grasps;
  survey.touched += t.forces > 0;
  for (long AuditTally::*count : {&AuditTally::steps, &AuditTally::forces, &AuditTally::slides, &AuditTally::backward,
                                  &AuditTally::unconverged, &AuditTally::audited})
    all.*count += t.*count;
  for (double AuditTally::*worst :
       {&AuditTally::touch, &AuditTally::momentum, &AuditTally::cone, &AuditTally::element, &AuditTally::energy})
    all.*worst = std::max(all.*worst, t.*worst);
  all.terms += t.terms;
  all.excess += t.excess;
  all.throughput += t.throughput;
  survey.gained += t.unconverged == 0 && t.gain > 0.01 * std::max(t.throughput, 1e-3);
  if (t.unconverged == 0 && t.audited > 0) survey.gain = std::max(survey.gain, t.gain / std::max(t.throughput, 1e-3));
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
            << t.touch << "\nof " << t.throughput << " J: numerical " << t.terms.numerical << ", turning "
            << t.terms.turning << ", touching " << t.terms.touching << ", appearing " << t.terms.appearing
            << ", curving " << t.terms.curving << ", in steps that gained " << t.excess << "; largest gain of a grasp "
            << s.gain << "\n";
}

TEST(RandomGrasps, KeepEveryInvariantInEverySubStep) {
  const long count = from_environment("HANDHOLD_GRASPS", 300), first = from_environment("HANDHOLD_FIRST_GRASP", 1);
  const std::vector<GraspObject> objects = grasp_objects();
  Survey survey;
  for (long seed = first; seed < first + count; ++seed) {
    RandomGrasp grasp(std::uint64_t(seed), objects);
    std::vector<std::vector<HandFrame>> before;
    for (int k = 0; k < 3; ++k) before.push_back(grasp.next_frame());
    AuditedTwin twin(grasp.scene, grasp.options, grasp.dt, before);
    bool same = true;
    for (int k = 1; k <= grasp.frames; ++k) {
      twin.advance(grasp.next_frame());
      same = same && twin.agrees();
    }
    EXPECT_TRUE(same) << describe(seed, grasp) << ": the twin of one sub-step a frame went another way";
    EXPECT_EQ(twin.tally().fault, "") << describe(seed, grasp);
    add(twin.tally(), survey);
    if (twin.tally().gain > 1e-6 * std::max(twin.tally().throughput, 1e-3) && std::getenv("HANDHOLD_VERBOSE"))
      std::cout << twin.tally().gain << " J gained of " << twin.tally().throughput << ": " << describe(seed, grasp)
                << "\n";
    if (twin.tally().backward > 0 && std::getenv("HANDHOLD_VERBOSE"))
      std::cout << twin.tally().backward << " slides backwards: " << describe(seed, grasp) << "\n";
    if (twin.tally().unconverged > 0 && std::getenv("HANDHOLD_VERBOSE"))
      std::cout << twin.tally().unconverged << " sub-steps not solved: " << describe(seed, grasp) << "\n";
  }
  print(survey);
  EXPECT_GT(survey.touched, 0.8 * double(survey.grasps));
  // Kinetic and potential energy beyond the start and what hands gave, where every sub-step was solved: the audit
  // bounds it by the identity of EnergyTerms; that this is next to nothing is measured: 3e-13 at most in 6000 grasps.
  EXPECT_EQ(survey.gained, 0);
  EXPECT_EQ(survey.all.unconverged, 0);
  EXPECT_EQ(survey.all.backward, 0);
}

}  // namespace
}  // namespace handhold::realtime
