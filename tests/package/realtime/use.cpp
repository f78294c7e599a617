#include <cstdio>

#include <handhold/cases/model/hand_model.hpp>
#include <handhold/cases/model/input_error.hpp>
#include <handhold/realtime/world.hpp>

// The installed package links, and runs, with Eigen alone.
int main() {
  const handhold::HandModel hand = handhold::anatomical_hand();
  std::printf("a thumb's radius is %g m\n", hand.capsules.front().radius);
  try {
    const handhold::realtime::World world(handhold::Scene{}, {});
    std::puts("a scene without an object was taken");
    return 1;
  } catch (const handhold::InputError& error) {
    std::printf("refused, as it should be: %s\n", error.what());
  }
  return hand.capsules.front().radius > 0 ? 0 : 1;
}
