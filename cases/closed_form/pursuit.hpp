// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// Serves G08 and G09 (twisted_ring.hpp, spin_stop.hpp). A sample that slips on a circle. Seen from the object it goes
/// round a centre at distance D, and its anchor follows on a leash of length ρ (the kinetic lag): a curve of pursuit. ψ
/// is the angle from the sample's velocity to the leash, with D/ρ = q; per angle θ turned
///   dψ/dθ = 1 − q sin ψ,
/// so that ψ tends to asin(1/q). The moment of a pull F along the leash about the centre is F D cos ψ. Valid while
/// cos ψ > 0: then the anchor moves forwards.

/// ψ after a turn by `turn` >= 0 from ψ = `start`, 0 <= start < π.
[[nodiscard]] double pursuit_angle(double ratio, double start, double turn);

/// The turn in which ψ grows from `start` to `end`, both below asin(1/q), q > 1.
[[nodiscard]] double pursuit_turn(double ratio, double start, double end);

/// ψ after the mean of cos ψ times the turn, ∫ cos ψ dθ, has reached `work` >= 0: sin ψ = (1 − (1 − q sin start)
/// e^(−q work)) / q.
[[nodiscard]] double pursuit_after_work(double ratio, double start, double work);

}  // namespace handhold::closed_form
