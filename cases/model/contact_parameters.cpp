// SPDX-License-Identifier: Apache-2.0
#include "cases/model/contact_parameters.hpp"

#include <cmath>
#include <set>

#include "cases/model/hand_model.hpp"
#include "cases/model/limits.hpp"
#include "cases/model/patch.hpp"

namespace handhold {
namespace {

constexpr double most_stiffness = 1e9;  // [N/m]
constexpr double most_damping = 1e6;    // [N s/m]

[[noreturn]] void reject(const std::string& what) { throw InputError(what); }

void check_given(const std::string& who, const GivenPatch& patch) {
  if (patch.phalanx < 0 || patch.phalanx >= phalanx_count) {
    reject(sentence(who, ": given patch on phalanx ", patch.phalanx, ": must be 0 to ", phalanx_count - 1,
                    " (15 is the palm)"));
  }
  const std::string where = sentence(who, ": given patch on ", phalanx_name(patch.phalanx));
  const std::size_t count = patch.p_P.size();
  if (count < 1 || count > std::size_t(max_samples)) {
    reject(sentence(where, ": ", count, " samples: must be 1 to ", max_samples, " (split it over phalanges)"));
  }
  for (const Eigen::Vector3d& p : patch.p_P) check_vector(where + ": sample", p, "m", most_length);
  if (!patch.start.empty() && patch.start.size() != count) {
    reject(sentence(where, ": ", patch.start.size(), " starts for ", count, " samples: give none or one a sample") +
           " (start empty is unstretched stick)");
  }
  for (const SampleStart& start : patch.start) check_vector(where + ": lag", start.lag_W, "m", most_length);
}

}  // namespace

void validate(const ContactParameters& contact) {
  if (!std::isfinite(contact.stiffness) || contact.stiffness <= 0) {
    reject(sentence("contact stiffness ", contact.stiffness, " N/m: must be finite and > 0 (the paper has 100)"));
  }
  if (contact.stiffness > most_stiffness) {
    reject(sentence("contact stiffness ", contact.stiffness, " N/m: at most ", most_stiffness, " (check the unit)"));
  }
  if (contact.damping > most_damping) {
    reject(sentence("contact damping ", contact.damping, " N s/m: at most ", most_damping, " (check the unit)"));
  }
  if (!std::isfinite(contact.damping) || contact.damping < 0) {
    reject(sentence("contact damping ", contact.damping,
                    " N s/m: must be finite and >= 0 (0 is the paper's bare spring)"));
  }
}

void validate(const std::vector<GivenPatch>& given, const std::string& who) {
  std::set<int> seen;
  for (const GivenPatch& patch : given) {
    check_given(who, patch);
    if (!seen.insert(patch.phalanx).second) {
      reject(sentence(who, ": two given patches on ", phalanx_name(patch.phalanx),
                      ": one a phalanx (merge their samples)"));
    }
  }
}

}  // namespace handhold
