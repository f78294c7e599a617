#include "cases/catalogue/case.hpp"

#include <cmath>

#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {

std::string_view to_string(Pedigree pedigree) {
  switch (pedigree) {
    case Pedigree::exact:
      return "exact";
    case Pedigree::discrete_exact:
      return "discrete-exact";
    case Pedigree::converged:
      return "converged";
    case Pedigree::published:
      return "published";
    case Pedigree::regression:
      return "regression";
  }
  return "?";
}

Limit reference_limit() { return reference_limit(1, ""); }

Limit reference_limit(double magnified, const std::string& why) {
  return {.value = 1e-9 * magnified,
          .relative = true,
          .reason = "ten times the integrator's accuracy of 1e-10" + (why.empty() ? why : "; " + why),
          .resolution = 1e-10};
}

Limit exact_limit() { return {.value = 0, .reason = "yes or no: nothing to tolerate"}; }

Limit event_limit(double substeps, const std::string& why) {
  return {.per_substep = substeps + 0.01,
          .reason = "a change of mode shows at the end of its sub-step, + 1 % for rounding at its edge" +
                    (why.empty() ? why : "; " + why),
          .resolution = 1e-3};
}

Limit euler_bias_limit(double change) {
  return {
      .per_substep = 0.51 * std::abs(change),
      .reason = "semi-implicit Euler is off by half a sub-step times the change of speed (R03), + 2 % for the onset"};
}

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases{incline_case(),       stopping_case(),  pinch_case(),
                                       pinch_opening_case(), palm_lift_case(), spin_down_case()};
  return cases;
}

}  // namespace handhold::catalogue
