// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "tests/reference/independent/surface.hpp"

namespace handhold::independent {

/// k, c and both coefficients of friction of every sample.
struct Law {
  Real k{}, c{}, mu_s{}, mu_d{};
  /// An undamped sample touches this deep and is released half as deep [m]: where its cone has a direction.
  Real touch{1e-13L};
};

/// A sample point in O, and how it moves there.
struct Point {
  Vec3 p{Vec3::Zero()};  ///< [m]
  Vec3 v{Vec3::Zero()};  ///< [m/s]
};

/// What is asked of one sample at one instant.
struct Answer {
  Vec3 force{Vec3::Zero()};  ///< on the object, along the line through p [N]
  Vec3 rate{Vec3::Zero()};   ///< of the sample's three states
  Real due{-1};              ///< > 0: its mode must change
};

/// One sample: its mode, its anchor while it sticks, and the meaning of its three states while it slips.
///
/// Undamped on a face, the state is the angle of the lag, whose length is then mu_d d by construction; otherwise it is
/// the anchor.
class Slider {
 public:
  Slider(const Law& law, std::shared_ptr<const Surface> surface, const SampleId& id);

  /// As a SampleStart asks; `lag` in O.
  void start(const Point& point, const Vec3& lag, bool slipping, Eigen::Ref<Vec3> z);

  [[nodiscard]] Answer answer(const Point& point, const Vec3& z) const;

  /// Carries out one change of mode if one is due.
  [[nodiscard]] std::optional<EventKind> change(const Point& point, Eigen::Ref<Vec3> z);

  /// Takes the drift of a step out of a slipping anchor on a curved surface.
  void clean(const Point& point, Eigen::Ref<Vec3> z) const;

  /// Length by which an error of the states counts [m per unit].
  [[nodiscard]] Real weight(const Point& point) const;

  [[nodiscard]] const SampleId& id() const { return id_; }
  [[nodiscard]] Mode mode() const { return mode_; }

 private:
  [[nodiscard]] bool by_angle() const { return law_.c == 0 && surface_->flat(); }
  [[nodiscard]] Answer sticking(const Point& point) const;
  [[nodiscard]] Answer turning(const Point& point, Real angle) const;
  [[nodiscard]] Answer sliding(const Point& point, const Vec3& anchor) const;
  [[nodiscard]] Answer creeping(const Point& point, const Vec3& anchor) const;
  [[nodiscard]] Real approaching(const Point& point) const;
  void slip_along(const Point& point, const Vec3& direction, const Vec3& near, Eigen::Ref<Vec3> z);
  void touch(const Point& point, Eigen::Ref<Vec3> z);

  Law law_;
  std::shared_ptr<const Surface> surface_;
  SampleId id_;
  Mode mode_{Mode::apart};
  Vec3 anchor_{Vec3::Zero()};  // while it sticks
  Vec3 t1_{Vec3::Zero()}, t2_{Vec3::Zero()};
};

}  // namespace handhold::independent
