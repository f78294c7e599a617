// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "cases/model/friction.hpp"

namespace handhold {

/// How well the coefficient of a material against skin is known.
enum class Evidence {
  published,   ///< read in the source named
  unverified,  ///< attributed to the source named, but not read there by us
  assumed,     ///< no source for this material: our choice
};

/// A material as an object's surface against skin.
///
/// Sources print ONE coefficient a pair and no static/dynamic split, although Höll et al. 2018 takes both from Zhang &
/// Mak 1999. The split is ours: mu_static is the source's number, mu_dynamic = 0.8 mu_static. All vary by +-30 %
/// between people, with moisture, and fall with the force (Buchholz et al. 1988, Seo et al. 2009).
struct Material {
  std::string_view name{};
  double coefficient{};  ///< what the source prints, dimensionless
  Evidence evidence{};
  std::string_view source{};  ///< where the coefficient is from, what it is
  double density{};           ///< typical handbook value, not from the source [kg/m³]

  [[nodiscard]] Friction friction() const;
};

/// mu_dynamic / mu_static of every material: our choice, see Material.
inline constexpr double dynamic_share = 0.8;

/// The table, in order of name.
[[nodiscard]] const std::vector<Material>& materials();

/// The material of that name; throws InputError listing the names if there is none.
[[nodiscard]] const Material& material(std::string_view name);

}  // namespace handhold
