// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// H03. Two bodies in free fall along one line, the striker (b) coming up to the other (a) with closing speed w over a
/// gap. They touch by an undamped spring: L2. Gravity is common, so that x_b − x_a obeys m_r y'' = −K y while y < 0
/// with 1/m_r = 1/m_a + 1/m_b: half a period of contact, then the closing speed is turned round.
struct Strike {
  double mass_a{0.3}, mass_b{0.1};      ///< [kg]
  double speed_a{-0.2}, speed_b{-0.5};  ///< at t = 0, up [m/s]; b is above and falls faster
  double gap{0.0104};                   ///< [m]
  double stiffness{17};                 ///< K [N/m]
  double gravity{9.81};                 ///< downwards [m/s²]
};

[[nodiscard]] double closing_speed(const Strike& s);            ///< w [m/s]
[[nodiscard]] double strike_frequency(const Strike& s);         ///< √(K/m_r) [rad/s]
[[nodiscard]] double strike_time(const Strike& s);              ///< gap / w [s]
[[nodiscard]] double parting_time(const Strike& s);             ///< strike_time + π/ω [s]
[[nodiscard]] double speed_of_a(const Strike& s, double t);     ///< up, after parting [m/s]
[[nodiscard]] double distance_of_a(const Strike& s, double t);  ///< moved up since t = 0, after parting [m]

/// H04. A body dropped from rest over a gap on an undamped spring: L2. In contact m d'' = m g − K d from d = 0 with
/// v = √(2 g gap); it is thrown back with v, and so on for ever.
struct Bounce {
  double mass{0.1};      ///< [kg]
  double gap{0.01};      ///< [m]
  double stiffness{90};  ///< K [N/m]
  double gravity{9.81};  ///< [m/s²]
};

[[nodiscard]] double bounce_frequency(const Bounce& b);  ///< √(K/m) [rad/s]
[[nodiscard]] double landing_speed(const Bounce& b);     ///< [m/s]
[[nodiscard]] double landing_time(const Bounce& b);      ///< the first [s]
[[nodiscard]] double contact_time(const Bounce& b);      ///< 2 (π − atan(v ω/g))/ω [s]
[[nodiscard]] double flight_time(const Bounce& b);       ///< 2 v/g [s]
/// ∫ d'² dt over one contact [m²/s]: what a damper c takes is c times it.
[[nodiscard]] double squared_speed_in_contact(const Bounce& b);

/// H02. A stack of two blocks on a palm that moves with growing acceleration j t, both interfaces undamped, no normal
/// motion: L2. Started with the speeds at which both springs load evenly, lag 1 is (m₁ + m₂) j t/K₁ and lag 2 is
/// m₂ j t/K₂: the accelerations are j t exactly, and the interface with the smaller mu slips first, at mu g/j, as in
/// L1.
struct Stack {
  double mass_lower{0.3}, mass_upper{0.2};            ///< m₁, m₂ [kg]
  double mu_palm{0.8}, mu_pair{0.4};                  ///< static = dynamic
  double stiffness_palm{4000}, stiffness_pair{4000};  ///< K₁, K₂ [N/m]
  double jerk{10};                                    ///< j [m/s³]
  double gravity{9.81};
};

[[nodiscard]] double lower_start_speed(const Stack& s);  ///< −(m₁ + m₂) j/K₁ [m/s]
[[nodiscard]] double upper_start_speed(const Stack& s);  ///< that − m₂ j/K₂ [m/s]
[[nodiscard]] double onset(const Stack& s);              ///< min(mu_palm, mu_pair) g/j [s]
/// Of the upper block against the palm since t = 0, at t > onset, the pair slipping (mu_pair < mu_palm): it has the
/// constant acceleration mu_pair g [m].
[[nodiscard]] double upper_slip(const Stack& s, double t);
/// Of the lower block against the palm, at t > onset, the palm's interface slipping: the centre of mass has the
/// constant acceleration mu_palm g, and the upper spring swings about its load with amplitude m₂ j/(K₂ ω), ω² = K₂
/// (1/m₁ + 1/m₂).
[[nodiscard]] double lower_slip(const Stack& s, double t);

/// H06. A bar's end turns about the bar's middle, `arm` away, from `start` towards a wall's face at distance `wall`.
struct Sweep {
  double arm{0.09375};  ///< [m]
  double wall{};        ///< < arm [m]
  double start{};       ///< angle between the arm and the wall's normal [rad]
  double spin{8};       ///< towards the normal [rad/s]
};
[[nodiscard]] double reach_time(const Sweep& s);  ///< (start − acos(wall/arm))/spin [s]

/// H07, H08. A sample at depth goes round a fixed cylinder or sphere of radius R on a circle of radius ρ < R, undamped,
/// in steady slip: L2. Its anchor trails by the angle φ with sin φ + mu cos φ = mu R/ρ, so that |e| = mu d,
/// d = R − ρ cos φ, e = ρ sin φ.
struct RoundSlide {
  double radius{0.03};     ///< R [m]
  double path_radius{};    ///< ρ [m]
  double mu{0.4};          ///< dynamic
  double stiffness{1000};  ///< of the sample [N/m]
  double speed{3};         ///< angular, about the axis [rad/s]
};
[[nodiscard]] double trailing_angle(const RoundSlide& r);  ///< φ [rad]
[[nodiscard]] double round_depth(const RoundSlide& r);     ///< d [m]
[[nodiscard]] double round_torque(const RoundSlide& r);    ///< about the axis: K e R [N m]

}  // namespace handhold::closed_form
