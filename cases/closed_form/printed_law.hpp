// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

// L3: the law of Höll et al. 2018 as printed (eq. 1 to 5, one ray a frame). Its truths are exact maps from one frame to
// the next; they say what that law does, never what friction does. docs/paper.md tells them in words.

namespace handhold::closed_form {

/// One contact sample on a flat face, its hand point at constant depth.
struct PrintedFace {
  double gamma{100};  ///< γ of a sample [N/m]
  Friction friction{};
  double depth{0.0025};    ///< d [m], > 0
  double offset{0.001};    ///< ε of the ray's origin [m], > 0
  double frame{1.0 / 90};  ///< dt [s]
};

/// Whether a frame's force is taken before ("O1") or after ("O2") the anchor moves.
enum class FrameOrder { force_first, anchor_first };

/// q = d / (d + ε): a ray from C + ε n to p meets the face at the fraction ε / (d + ε) of its way, so the lag, which is
/// e at its start and 0 at p, is q e there.
[[nodiscard]] double contraction(const PrintedFace& face);

/// One frame of a face along which the hand goes with speed v.
struct PrintedSlide {
  double lag{};    ///< after the frame [m]
  double force{};  ///< tangential [N]
  bool slips{};
};

/// The lag grows by v dt; beyond μ_s d (eq. 4) the frame slips: force μ_d γ e (eq. 5), e -> q e.
[[nodiscard]] PrintedSlide next_slide(const PrintedFace& face, double lag, double v, FrameOrder order);

/// L3-02. The lag before the ray in frame n if frames 0 to n all slip: e_{n+1} = q e_n + v dt has the fixed point
/// e* = v dt / (1 − q) = v dt (d + ε) / ε, and e_n = e* + (e_0 − e*) q^n.
[[nodiscard]] double sliding_lag(const PrintedFace& face, double v, double first_lag, int n);

/// L3-02. μ_d γ e* (O1), or μ_d γ q e* (O2) [N].
[[nodiscard]] double steady_slide_force(const PrintedFace& face, double v, FrameOrder order);

/// L3-02. Steady sliding slips in every frame iff e* > μ_s d: v above v_c = μ_s d ε / (dt (d + ε)) [m/s].
[[nodiscard]] double steady_slide_speed(const PrintedFace& face);

/// L3-03. Mean force over γ d as v / v_c -> 0: sticking frames rise evenly from q μ_s d to μ_s d: μ_s (1 + q) / 2.
[[nodiscard]] double chatter_friction(const PrintedFace& face);

/// L3-03. Bound on |mean − limit| over whole periods, relative to the limit, for v < v_c / q.
///
/// With x = v dt and S = μ_s d, a period from one slip at e_0 to the next at e_1, both in (S, S + x], has the lags
/// q e_0 + x, ..., e_1, evenly spaced, the last with μ_d: n = (e_1 − q e_0) / x >= ((1 − q) S − q x) / x frames of mean
/// force γ [(q e_0 + x + e_1) / 2 − (1 − μ_d) e_1 / n], so
/// −(1 − μ_d) (S + x) x / ((1 − q) S − q x) + x / 2 <= mean / γ − S (1 + q) / 2 <= x (q + 2) / 2.
[[nodiscard]] double chatter_error(const PrintedFace& face, double v);

/// L3-03. Share of slipping frames as r = v / v_c -> 0: r; over whole periods within [r / (1 + r), r / (1 − q r)].
[[nodiscard]] double chatter_share(const PrintedFace& face, double v);

/// L3-04. Sum of the forces of the slipping frames among n, from lag s_0 to lag s_n after the frame, for any v (O1).
///
/// Every frame: s' = s + v dt − (1 − q) e over slipping frames, e the lag before the ray. Summed:
/// Σ e = (n v dt + s_0 − s_n) / (1 − q), and each gives μ_d γ e.
[[nodiscard]] double slip_impulse(const PrintedFace& face, double v, int n, double first_lag, double last_lag);

/// L3-07. All samples pull on one centroid at depth d: a ring of radius a about its foot is a lag a, and slips by
/// itself to a q^k, the first not above μ_s d.
struct PatchCollapse {
  double radius{};  ///< [m]
  int frames{};
};

[[nodiscard]] PatchCollapse patch_collapse(const PrintedFace& face, double radius);

/// L3-07. Torque of `samples` sticking samples with points of their own on a ring of radius a, turned by φ against
/// their anchors: each pulls with γ (p − C) at C, of moment γ a² sin φ [N m].
[[nodiscard]] double stick_torque(double gamma, int samples, double radius, double angle);

/// L3-14. Steady torque of `samples` slipping samples turning by φ = ω dt a frame on radius a.
///
/// In the complex plane p_n = a e^{iφn}, C_{n+1} = (1 − q) p_n + q C_n, so C_n = c e^{iφn}, c = (1 − q) a / (e^{iφ} −
/// q). Each sample's moment is μ_d γ Im(conj(C) p) = μ_d γ a² (1 − q) sin φ / |e^{iφ} − q|².
[[nodiscard]] double spin_torque(const PrintedFace& face, int samples, double radius, double spin);

/// L3-14. Lag before the ray, |p − C| = a |e^{iφ} − 1| / |e^{iφ} − q|; all slip iff it is above μ_s d.
[[nodiscard]] double spin_lag(const PrintedFace& face, double radius, double spin);

/// L3-11. A hand point at depth d along the true normal, inclined by `slope` to the normal n that the law is given.
struct TiltedPress {
  bool sticks{};       ///< tan(slope) <= μ_s
  double normal{};     ///< force along the true normal [N]
  double tangent{};    ///< across it, which nobody pressed for [N]
  double deviation{};  ///< between force and true normal [rad]
};

/// The pull γ d splits into cos along n and sin across; eq. 5 keeps μ_d sin of the latter. Back in the true frame:
/// normal γ d (cos² + μ_d sin²), tangent γ d (1 − μ_d) sin cos.
[[nodiscard]] TiltedPress tilted_press(const PrintedFace& face, double slope);

/// L3-12. Energy that one sample gives per cycle "shear to s at depth d1, press until it sticks, unshear, retract", ε
/// -> 0: taken γ e_1²/2 + μ_d γ (s² − e_1²)/2 with e_1 = μ_s d1, given back γ s²/2: γ (1 − μ_d) (s² − e_1²) / 2 [J].
[[nodiscard]] double cycle_gain(const PrintedFace& face, double shear);

/// L3-13. Angle, seen from the centre of a ball of radius R, between an anchor and the point of the surface closest to
/// p, after one ray; `angle` before, p at depth d. First root of |o + t (p − o)| = R from o = (R + ε)(sin, cos)(angle),
/// p = (0, R − d).
[[nodiscard]] double ball_anchor(double radius, double depth, double offset, double angle);

}  // namespace handhold::closed_form
