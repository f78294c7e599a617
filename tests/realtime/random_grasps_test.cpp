#include <cstdlib>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/realtime/audited_twin.hpp"
#include "tests/realtime/random_grasp.hpp"

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes

long count_from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atol(text) : otherwise;
}

struct Sum {
  long grasps{}, touched{}, steps{}, forces{}, slides{}, unknown{}, unconverged{}, audited{};
  double momentum{}, cone{}, element{}, energy{}, backward{}, growth{}, gain{}, unbalanced{};
  EnergyTerms terms{};
  double throughput{};
};

void add(const AuditTally& t, Sum& sum) {
  ++sum.grasps;
  sum.touched += t.forces > 0;
  sum.steps += t.steps;
  sum.forces += t.forces;
  sum.slides += t.slides;
  sum.unknown += t.unknown;
  sum.unconverged += t.unconverged;
  sum.audited += t.audited;
  sum.momentum = std::max(sum.momentum, t.momentum);
  sum.cone = std::max(sum.cone, t.cone);
  sum.element = std::max(sum.element, t.element);
  sum.energy = std::max(sum.energy, t.energy);
  sum.unbalanced = std::max(sum.unbalanced, t.unbalanced);
  sum.backward = std::max(sum.backward, t.backward);
  if (t.throughput > 0) sum.growth = std::max(sum.growth, t.growth / (t.throughput + t.terms.appearing));
  if (t.throughput > 0) sum.gain = std::max(sum.gain, t.gain / t.throughput);
  sum.throughput += t.throughput;
  sum.terms.numerical += t.terms.numerical;
  sum.terms.turning += t.terms.turning;
  sum.terms.touching += t.terms.touching;
  sum.terms.appearing += t.terms.appearing;
  sum.terms.blocked += t.terms.blocked;
}

TEST(RandomGrasps, KeepEveryInvariantInEverySubStep) {
  const long count = count_from_environment("HANDHOLD_GRASPS", 200);
  const long first = count_from_environment("HANDHOLD_FIRST_GRASP", 1);
  const std::vector<GraspObject> objects = grasp_objects();
  Sum sum;
  int faults = 0;
  for (long seed = first; seed < first + count; ++seed) {
    RandomGrasp grasp(std::uint64_t(seed), objects);
    std::vector<std::vector<HandFrame>> before;
    for (int k = 0; k < 3; ++k) before.push_back(grasp.next_frame());
    if (grasp.order != 1) continue;
    grasp.options.solver.max_iterations = int(count_from_environment("HANDHOLD_ITERATIONS", grasp.options.solver.max_iterations));
    AuditedTwin twin(grasp.scene, grasp.options, grasp.dt, before);
    bool same = true;
    for (int k = 1; k <= grasp.frames; ++k) {
      twin.advance(grasp.next_frame());
      same = same && twin.agrees();
    }
    const AuditTally& t = twin.tally();
    if (!t.fault.empty() || !same)
      std::cout << "seed " << seed << " same " << same << " m " << grasp.scene.bodies[0].inertia.mass << " k "
                << grasp.scene.contact.stiffness << " c " << grasp.scene.contact.damping << " h "
                << grasp.dt / grasp.options.substeps << " " << t.fault << "\n";
    faults += !t.fault.empty() || !same;
    if (std::getenv("HANDHOLD_VERBOSE") && (t.gain > 0.001 * t.throughput || t.unconverged > 0))
      std::cout << "unconverged " << t.unconverged << " gain seed " << seed << " " << t.gain << " growth " << t.growth << " of " << t.throughput << " turning "
                << t.terms.turning << " touching " << t.terms.touching << " appearing " << t.terms.appearing << " blocked " << t.terms.blocked
                << " numerical " << t.terms.numerical << " h " << grasp.dt / grasp.options.substeps << " k "
                << grasp.scene.contact.stiffness << " c " << grasp.scene.contact.damping << " m "
                << grasp.scene.bodies[0].inertia.mass << "\n";
    add(t, sum);
  }
  std::cout << sum.grasps << " grasps (" << sum.touched << " touched), " << sum.steps << " steps, " << sum.forces
            << " forces, " << sum.slides << " sliding, " << sum.unknown << " unknown, " << sum.unconverged
            << " unconverged, " << sum.audited << " audited\nshare of the allowed: momentum " << sum.momentum
            << ", cone " << sum.cone << ", element " << sum.element << ", energy " << sum.energy << ", backward "
            << sum.backward << "\nenergy: numerical " << sum.terms.numerical << ", turning " << sum.terms.turning
            << ", touching " << sum.terms.touching << ", appearing " << sum.terms.appearing << ", blocked " << sum.terms.blocked << " of " << sum.throughput
            << ", growth " << sum.growth << ", gain " << sum.gain << ", unbalanced " << sum.unbalanced << "\n";
  EXPECT_EQ(faults, 0);
}

}  // namespace
}  // namespace handhold::realtime
