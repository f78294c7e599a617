// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/scene/materials.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "cases/input/nearest_name.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::string_view buchholz = "Buchholz et al. 1988, pinch, static, dry";
constexpr std::string_view zhang_mak = "Zhang & Mak 1999, in vivo, one coefficient";
constexpr std::string_view mean = "no number found: mean of all materials in Zhang & Mak 1999";

}  // namespace

Friction Material::friction() const { return {coefficient, dynamic_share * coefficient}; }

const std::vector<Material>& materials() {
  static const std::vector<Material> table{
      {"aluminium", 0.38, Evidence::published, buchholz, 2700},  // 0.42 in Zhang & Mak (unverified), 0.6 in Seo 2009
      {"cotton", 0.51, Evidence::unverified, zhang_mak, 500},    // density of woven cloth, with its air
      {"glass", 0.46, Evidence::assumed, mean, 2500},            // rises fivefold with moisture: Dzidek et al. 2017
      {"leather", 0.39, Evidence::assumed, "no number found: as suede", 900},
      {"nylon", 0.37, Evidence::published, zhang_mak, 1140},
      {"paper", 0.27, Evidence::published, buchholz, 800},  // moist 0.42
      {"plastic", 0.53, Evidence::assumed, "no number found: as smooth vinyl", 1050},
      {"rubber", 0.9, Evidence::published, "Seo et al. 2009, falls by 46 % from 1 N to 20 N", 1100},
      {"sandpaper", 0.61, Evidence::published, buchholz, 1300},  // 0.96 at 4 N in Savescu et al. 2008
      {"silicone", 0.61, Evidence::published, zhang_mak, 1150},
      {"steel", 0.38, Evidence::assumed, "no number found: as aluminium", 7850},
      {"suede", 0.39, Evidence::published, buchholz, 600},  // moist 0.66
      {"vinyl", 0.53, Evidence::published, "Buchholz et al. 1988, pinch, static, smooth", 1350},
      {"vinyl_textured", 0.50, Evidence::published, "Buchholz et al. 1988, pinch, static, textured", 1350},
      {"wood", 0.46, Evidence::assumed, mean, 700},
  };
  return table;
}

const Material& material(std::string_view name) {
  const std::vector<Material>& table = materials();
  const auto found = std::find_if(table.begin(), table.end(), [&](const Material& m) { return m.name == name; });
  if (found != table.end()) return *found;
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const Material& m : table) names.emplace_back(m.name);
  throw InputError(fmt::format("material '{}': no such material (take one of {})", name, join_names(names)));
}

}  // namespace handhold
