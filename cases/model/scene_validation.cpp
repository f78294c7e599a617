#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include <Eigen/Eigenvalues>

#include "cases/model/input_error.hpp"
#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "cases/model/text.hpp"

namespace handhold {
namespace {

constexpr double unit_tolerance = 1e-6;     // of a quaternion's norm: six printed digits are accepted
constexpr double inertia_tolerance = 1e-9;  // of the trace: rounding of a rotated tensor, far below any real violation
constexpr std::size_t most_bodies = std::numeric_limits<std::uint8_t>::max();  // SampleId has one byte for each
constexpr std::size_t most_samples = std::numeric_limits<std::uint8_t>::max();
constexpr std::size_t most_hands = SampleId::of_body;

[[noreturn]] void reject(const std::string& what) { throw InputError(what); }

// Beyond these nothing is a hand with an object, and a simulation would run for ever or drown in rounding.
constexpr double most_length = 1e3;          // [m]
constexpr double most_speed = 1e3;           // [m/s]
constexpr double most_spin = 1e4;            // [rad/s]
constexpr double most_gravity = 1e3;         // [m/s²]
constexpr double least_mass = 1e-6;          // [kg]
constexpr double most_mass = 1e4;            // [kg]
constexpr double most_stiffness = 1e9;       // [N/m]
constexpr double most_damping = 1e6;         // [N s/m]
constexpr double most_duration = 24 * 3600;  // [s]

void check_finite(const std::string& what, const Eigen::Vector3d& v, const char* unit, double most) {
  if (!v.allFinite()) reject(sentence(what, " = ", v, ": must be finite (give three numbers in ", unit, ")"));
  if (v.norm() > most) reject(sentence(what, " = ", v, ": at most ", most, " ", unit, " (check the unit)"));
}

void check_moments(const std::string& who, const Eigen::Matrix3d& J) {
  const double scale = J.diagonal().cwiseAbs().sum();
  if (!J.allFinite()) reject(sentence(who, ": inertia must be finite (check the mesh and its density)"));
  if ((J - J.transpose()).cwiseAbs().maxCoeff() > inertia_tolerance * scale) {
    reject(sentence(who, ": inertia must be symmetric (set Jxy = Jyx, Jxz = Jzx, Jyz = Jzy)"));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(J, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d moments = solver.eigenvalues();  // ascending
  const std::string given = sentence(who, ": principal moments ", moments, " kg m^2");
  if (!(moments.x() > 0)) reject(given + ": must all be > 0 (give the inertia about the centre of mass)");
  if (moments.z() > moments.x() + moments.y() + inertia_tolerance * scale) {
    reject(given + ": the largest exceeds the sum of the others, which no solid has (check signs and units)");
  }
}

void check_inertia(const std::string& who, const Body& body) {
  check_finite(who + ": center of mass", body.inertia.center, "m", most_length);
  if (body.mobility == Mobility::fixed) return;  // its mass never enters
  if (!std::isfinite(body.inertia.mass) || body.inertia.mass <= 0) {
    reject(sentence(who, ": mass ", body.inertia.mass, " kg: must be finite and > 0 (or set the mobility to fixed)"));
  }
  if (body.inertia.mass < least_mass || body.inertia.mass > most_mass) {
    reject(sentence(who, ": mass ", body.inertia.mass, " kg: must be ", least_mass, " to ", most_mass,
                    " kg (check the unit of lengths and density)"));
  }
  if (body.mobility == Mobility::free) check_moments(who, body.inertia.about_center);
}

void check_velocity(const std::string& who, const Body& body) {
  check_finite(who + ": velocity", body.V_WO.v, "m/s", most_speed);
  check_finite(who + ": angular velocity", body.V_WO.w, "rad/s", most_spin);
  const bool turns = !body.V_WO.w.isZero(0);
  const bool moves = turns || !body.V_WO.v.isZero(0);
  if (body.mobility == Mobility::fixed && moves) {
    reject(who + ": a fixed body has no velocity (remove it, or set the mobility to free)");
  }
  if (body.mobility == Mobility::translation && turns) {
    reject(who + ": a body that only translates has no angular velocity (remove it, or set the mobility to free)");
  }
  if (body.held_until > 0 && moves) {
    reject(who + ": a held body starts at rest (remove the velocity, or set held_until to 0)");
  }
}

void check_body(const Body& body) {
  if (body.name.empty()) reject("a body without name: every body has one (set its name)");
  const std::string who = sentence("body '", body.name, "'");
  if (!body.field) reject(who + ": has no shape (voxelize a mesh or make_box, and set field)");
  try {
    validate(body.friction);
  } catch (const InputError& error) {
    reject(who + ": " + error.what());
  }
  check_finite(who + ": position", body.X_WO.p, "m", most_length);
  if (!(std::abs(body.X_WO.R.norm() - 1) <= unit_tolerance)) {
    reject(sentence(who, ": orientation of norm ", body.X_WO.R.norm(), ": must be a unit quaternion (normalise it)"));
  }
  if (!std::isfinite(body.held_until) || body.held_until < 0) {
    reject(sentence(who, ": held_until ", body.held_until, " s: must be finite and >= 0 (0 lets it go at once)"));
  }
  check_inertia(who, body);
  check_velocity(who, body);
  if (body.samples_O.size() > most_samples) {
    reject(
        sentence(who, ": ", body.samples_O.size(), " surface samples: at most ", most_samples, " (space them wider)"));
  }
  for (const Eigen::Vector3d& p : body.samples_O) check_finite(who + ": surface sample", p, "m", most_length);
}

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
  for (const Eigen::Vector3d& p : patch.p_P) check_finite(where + ": sample", p, "m", most_length);
  if (!patch.start.empty() && patch.start.size() != count) {
    reject(sentence(where, ": ", patch.start.size(), " starts for ", count, " samples: give none or one a sample") +
           " (start empty is unstretched stick)");
  }
  for (const SampleStart& start : patch.start) check_finite(where + ": lag", start.lag_W, "m", most_length);
}

void check_hand(const Hand& hand, std::size_t index, double duration) {
  const std::string who = sentence("hand ", index);
  if (!hand.motion) reject(who + ": has no motion (give it a trace)");
  const auto overlaps = [&](const Interval& i) { return i.begin <= duration && i.end >= 0; };
  const auto& presence = hand.motion->presence();
  if (std::none_of(presence.begin(), presence.end(), overlaps)) {
    reject(sentence(who, ": is never present in 0 to ", duration, " s (shift the trace, or remove the hand)"));
  }
  std::set<int> seen;
  for (const GivenPatch& patch : hand.given) {
    check_given(who, patch);
    if (!seen.insert(patch.phalanx).second) {
      reject(sentence(who, ": two given patches on ", phalanx_name(patch.phalanx),
                      ": one a phalanx (merge their samples)"));
    }
  }
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

void validate(const Scene& scene) {
  if (!std::isfinite(scene.duration) || scene.duration <= 0) {
    reject(sentence("duration ", scene.duration, " s: must be finite and > 0 (time starts at 0)"));
  }
  if (scene.duration > most_duration) {
    reject(sentence("duration ", scene.duration, " s: at most ", most_duration, " (a day)"));
  }
  check_finite("gravity", scene.gravity, "m/s^2", most_gravity);
  validate(scene.contact);
  validate(scene.body_contact);
  validate(scene.patch);
  if (scene.bodies.empty()) reject(sentence("scene '", scene.name, "': has no body (add at least one)"));
  if (scene.bodies.size() > most_bodies) {
    reject(sentence(scene.bodies.size(), " bodies: at most ", most_bodies, " (split the scene)"));
  }
  if (scene.hands.size() > most_hands) {
    reject(sentence(scene.hands.size(), " hands: at most ", most_hands, " (split the scene)"));
  }
  std::set<std::string> names;
  for (const Body& body : scene.bodies) {
    check_body(body);
    if (!names.insert(body.name).second) {
      reject(sentence("body '", body.name, "': the name is taken (give every body its own)"));
    }
  }
  for (std::size_t i = 0; i < scene.hands.size(); ++i) check_hand(scene.hands[i], i, scene.duration);
}

}  // namespace handhold
