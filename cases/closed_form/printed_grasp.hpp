// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cases/closed_form/printed_law.hpp"

// L3, continued: an object under the printed law, moved by a frame-rate integrator (semi-implicit Euler as in PhysX
// unless said otherwise: velocity, then position with the new velocity).

namespace handhold::closed_form {

/// An object of mass m on springs of total stiffness K = n γ, in frames of dt.
struct SpringFrames {
  double mass{0.2};        ///< [kg]
  double stiffness{1600};  ///< K [N/m]
  double frame{1.0 / 90};  ///< dt [s]
};

/// w = K dt² / m: all there is to a spring in frames.
[[nodiscard]] double spring_number(const SpringFrames& springs);

/// L3-01. Rate λ = sqrt(K / m) of d'' = ± λ² d [1/s].
[[nodiscard]] double spring_rate(const SpringFrames& springs);

/// L3-01. Depth at frame n from rest at d_0 with eq. 1's sign on the object, d'' = +λ² d, semi-implicit:
/// d_{n+1} − 2 d_n + d_{n−1} = w d_n with d_{−1} = d_0 gives d_0 cosh((n + ½) θ) / cosh(θ / 2), cosh θ = 1 + w / 2.
[[nodiscard]] double attracted_depth(const SpringFrames& springs, double first_depth, int n);

/// L3-01. The same with the sign put right: cos for cosh, cos θ = 1 − w / 2, while it is positive. Needs w < 4.
[[nodiscard]] double repelled_depth(const SpringFrames& springs, double first_depth, int n);

/// L3-08. Growth of a stuck object's oscillation per frame, sqrt of the determinant of the frame's 2 x 2 map (its
/// eigenvalues are a complex pair as long as the map oscillates). 1 for semi-implicit Euler with w < 4.
///   explicit Euler, or semi-implicit with a pose one frame old: (z − 1)² = −w, |z| = sqrt(1 + w)
///   force held over n semi-implicit sub-steps: x_1 = x + dt v − w (n + 1) / (2 n) x, v_1 = v − w x / dt:
///     det = 1 − w (n + 1) / (2 n) + w = 1 + w (n − 1) / (2 n)
///   force held, motion exact (n -> infinity): det = 1 + w / 2
[[nodiscard]] double explicit_growth(const SpringFrames& springs);
[[nodiscard]] double delayed_growth(const SpringFrames& springs);
[[nodiscard]] double held_growth(const SpringFrames& springs, int substeps);
[[nodiscard]] double exact_hold_growth(const SpringFrames& springs);

/// L3-08. Semi-implicit Euler is stable for m > K dt² / 4 [kg].
[[nodiscard]] double least_stable_mass(double stiffness, double frame);

/// L3-18. Lag at frame n of a stuck object let go unstretched under gravity g: s_{n+1} − 2 s_n + s_{n−1} = g dt² − w
/// s_n with s_0 = 0 before its first force (s_1 = g dt²): (m g / K) [1 − cos((n + ½) θ) / cos(θ / 2)], cos θ = 1 − w
/// / 2.
[[nodiscard]] double released_lag(const SpringFrames& springs, double gravity, int n);

/// L3-18. Its supremum over n: cos(θ/2) = sqrt(1 − w / 4) = sqrt(1 − m_min / m): (m g / K) (1 + 1 / sqrt(1 − m_min /
/// m)).
[[nodiscard]] double largest_released_lag(const SpringFrames& springs, double gravity);

struct MassWindow {
  double least{}, most{};  ///< [kg]
};

/// L3-18. Masses that do not slip at any phase: largest lag <= μ_s d.
///
/// With u = sqrt(1 − m_min / m), m = m_min / (1 − u²), the condition (m g / K)(1 + 1 / u) <= μ_s d reads
/// 1 / (u (1 − u)) <= A = μ_s d K / (m_min g): between the roots u = (1 ± sqrt(1 − 4 / A)) / 2; none if A < 4.
[[nodiscard]] std::optional<MassWindow> release_window(double stiffness, double frame, double gravity,
                                                       double static_lag);

/// L3-10. As dt -> 0: the lag overshoots to 2 m g / K, so the least mass that slips is μ_s d K / (2 g) [kg].
[[nodiscard]] double release_mass(double stiffness, double gravity, double static_lag);

/// An object between fingers that carry it with `samples` samples in all, at rest or sliding down.
struct PrintedPinch {
  PrintedFace face{};
  int samples{16};
  double mass{0.3};      ///< [kg]
  double gravity{9.81};  ///< [m/s²]
  FrameOrder order{FrameOrder::force_first};
};

struct PinchFrame {
  double fall{};   ///< of the object since the start [m]
  double speed{};  ///< downwards [m/s]
  double lag{};    ///< of a sample, positive as it carries [m]
  bool slips{};    ///< in the frame that led here
};

/// One frame at depth `face.depth` (which may change from frame to frame; 0 or less: no contact): force, velocity, ray,
/// position.
[[nodiscard]] PinchFrame next_pinch(const PrintedPinch& pinch, const PinchFrame& before);

/// L3-05. m g = n μ_d γ e* with e* = v dt / (1 − q): v = m g ε / (n μ_d γ dt (d + ε)) (O1); divided by q for O2 [m/s].
[[nodiscard]] double terminal_speed(const PrintedPinch& pinch);

/// L3-06. Holds from rest iff m g <= n γ μ_s d.
[[nodiscard]] double holding_mass(const PrintedPinch& pinch);

/// L3-06. Slides on for ever iff its steady lag m g / (n μ_d γ) (O1) is above μ_s d: m > n γ μ_d μ_s d / g.
[[nodiscard]] double sliding_mass(const PrintedPinch& pinch);

/// L3-16. Fingers open with `rate` [m/s] of depth each from `face.depth`. Onset where m g = n γ μ_s d_s.
[[nodiscard]] double opening_onset(const PrintedPinch& pinch, double rate);

/// L3-16. Fall until d = 0, quasi-steady (terminal speed at every depth), up to O(rate):
/// ∫ v dt = m g ε / (n μ_d γ dt r) ln((d_s + ε) / ε), from dt = −dd / r.
[[nodiscard]] double opening_creep(const PrintedPinch& pinch, double rate);

/// L3-17. A finger with `samples` samples drags a block over a table of kinetic friction `mu_table` (L1).
struct PrintedDrag {
  PrintedFace face{};
  int samples{8};
  double mass{0.2};  ///< of the block [kg]
  double mu_table{0.2};
  double gravity{9.81};  ///< [m/s²]
};

/// L3-17. Speed that the block lags behind: n μ_d γ e* = μ_t (n γ d + m g), e* = v dt / (1 − q) [m/s].
[[nodiscard]] double drag_lag_speed(const PrintedDrag& drag);

/// L3-17. Whether that slides for ever (above v_c); else the finger sticks again.
[[nodiscard]] bool drag_slides(const PrintedDrag& drag);

/// L3-09. The centroid of a capsule of radius r is that far from its skin: a dead zone r, and a delay r / V.
[[nodiscard]] double dead_time(double radius, double speed);

/// L3-09. Ungated, the springs of `samples` samples pull with up to n γ r while the capsule's skin touches [N].
[[nodiscard]] double largest_pull(double gamma, int samples, double radius);

/// L3-09. How deep two capsules pinch to hold m: r + m g / (n γ μ_s), n samples in all [m].
[[nodiscard]] double holding_penetration(const PrintedPinch& pinch, double radius);

}  // namespace handhold::closed_form
