#pragma once

namespace handhold {

/// Coulomb coefficients of a pair of surfaces, dimensionless.
struct Friction {
  double mu_static{0.5};
  double mu_dynamic{0.4};
};

/// Throws InputError unless 0 <= mu_dynamic <= mu_static < infinity.
void validate(const Friction& friction);

}  // namespace handhold
