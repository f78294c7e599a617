#pragma once

namespace handhold::closed_form {

/// D04. An object pinched by two fingers that move up and down together as A sin(ωt). L1, one coefficient of friction;
/// g < 2 μ N / m. It slides down while the hand accelerates up, in one phase a period.
struct RigidShake {
  double mass{0.2};          ///< [kg]
  double normal_force{2.6};  ///< N of each finger [N]
  double mu{0.5};
  double amplitude{0.01};  ///< A [m]
  double frequency{25};    ///< ω [rad/s]
  double gravity{9.81};    ///< [m/s²]
};

/// t1 = (π + asin((c − g) / (A ω²))) / ω with c = 2 μ N / m [s]; NaN if it holds.
[[nodiscard]] double onset_time(const RigidShake& shake);

/// t2: u(t) = (c − g)(t − t1) − A ω (cos ωt − cos ωt1) = 0 again [s].
[[nodiscard]] double stop_time(const RigidShake& shake);

/// How far it has come down in the hand after one period: A (sin ωt2 − sin ωt1) − A ω cos(ωt1)(t2 − t1)
/// − ½ (c − g)(t2 − t1)² [m].
[[nodiscard]] double slip_per_period(const RigidShake& shake);

}  // namespace handhold::closed_form
