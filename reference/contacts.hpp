#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/recording.hpp"
#include "cases/scene/scene.hpp"
#include "reference/element.hpp"
#include "reference/layout.hpp"
#include "reference/spline_surface.hpp"

namespace handhold::reference {

/// Pose and velocity of the body's frame O in W.
struct BodyMotion {
  Eigen::Matrix3d R_WO{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d p_WO{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d w_WO{Eigen::Vector3d::Zero()};  ///< [rad/s]
  Eigen::Vector3d v_WO{Eigen::Vector3d::Zero()};  ///< of O's origin [m/s]
};

/// What changes only at events.
struct Modes {
  std::vector<Mode> mode{};            ///< of every slot
  std::vector<char> exists{};          ///< of every slot: its patch has been seeded or was given
  std::vector<Eigen::Vector3d> p_P{};  ///< of every slot: the sample's point in its phalanx [m]
  std::vector<char> present{};         ///< of every hand
  bool held{false};                    ///< a support holds the body up
};

/// Anchors C in O, one column a slot [m]; those of apart samples mean nothing.
using Anchors = Eigen::Matrix3Xd;

/// One sample at one instant.
struct Sample {
  Eigen::Vector3d p_W{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d v_W{Eigen::Vector3d::Zero()};  ///< [m/s]
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d v_O{Eigen::Vector3d::Zero()};  ///< of p in O (relative to the body) [m/s]
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< at the anchor; zero if apart
  Response response{};                           ///< zero if apart
  double gap{-1};       ///< witness: > 0 when an apart sample touches, or one in contact is released
  double friction{-1};  ///< witness: > 0 when stick breaks away or slip sticks again
};

/// All samples at one instant.
struct Evaluation {
  std::vector<Sample> samples{};   ///< of every slot
  std::vector<double> nearness{};  ///< witness of every pad: > 0 when a patch is due, or to be dropped
  Eigen::Vector3d force_W{Eigen::Vector3d::Zero()};   ///< on the body [N]
  Eigen::Vector3d torque_W{Eigen::Vector3d::Zero()};  ///< about O's origin [N m]
  double hand_power{};                                ///< [W]
  double dissipation{};                               ///< [W]
  int singular_slot{-1};                              ///< where the undamped law has no solution; -1: nowhere
};

/// A change of mode of one sample.
struct Transition {
  int slot{};
  EventKind kind{};
};

/// The contacts of one body with all hands: forces, anchor rates, witnesses, and what happens at events.
///
/// A function of time, motion, modes and anchors only; members are memories of costly results, checked by value.
class Contacts {
 public:
  /// `accuracy`: of the integration, to know what is noise.
  Contacts(const Scene& scene, double accuracy);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] int slots() const { return int(layout_.id.size()); }

  void evaluate(double t, const BodyMotion& body, const Modes& modes, const Anchors& anchors, Evaluation& out);

  /// Modes and anchors at t = 0, from the starts given in the scene.
  void start(const BodyMotion& body, Modes& modes, Anchors& anchors);

  /// Carries out all changes of mode that are due until none is, seeds and drops patches. Adds to `dissipated` what the
  /// springs lose when anchors jump or let go [J]. Throws std::logic_error if the modes do not come to rest.
  std::vector<Transition> settle(double t, const BodyMotion& body, Modes& modes, Anchors& anchors, double& dissipated);

  /// Whether hand `hand` exists just after t.
  [[nodiscard]] bool present_after(int hand, double t) const;

  /// ½ k |p − C|² of the samples in contact [J].
  [[nodiscard]] double elastic_energy(const Modes& modes, const Evaluation& evaluation) const;

  /// Of a slot, for messages: "hand 0 index_distal sample 3".
  [[nodiscard]] std::string describe(int slot) const;

  [[nodiscard]] const SplineSurface& surface() const { return surface_; }

 private:
  struct PhalanxMotion {
    double t{-1};
    Pose X_WP{};
    Twist V_WP{};
  };
  struct SurfaceMemory {
    Eigen::Vector3d anchor{Eigen::Vector3d::Constant(-1e300)};
    AnchorSurface surface{};
  };
  struct NearMemory {  // the distance found at some earlier pose bounds the distance now
    bool known{false};
    Pose X_OP{};
    double distance{};
  };

  [[nodiscard]] const PhalanxMotion& motion_of(std::size_t pad, double t);
  [[nodiscard]] const AnchorSurface& surface_at(std::size_t slot, const Eigen::Vector3d& anchor, bool with_curvature);
  [[nodiscard]] Sample place(std::size_t slot, double t, const BodyMotion& body, const Eigen::Vector3d& p_P);
  void evaluate_sample(std::size_t slot, const BodyMotion& body, Mode mode, const Eigen::Vector3d& anchor, Sample& s);
  [[nodiscard]] double touch_witness(const BodyMotion& body, const Sample& s) const;
  [[nodiscard]] double nearness(std::size_t pad, double t, const BodyMotion& body, const Modes& modes);
  [[nodiscard]] Pose pose_in_body(std::size_t pad, double t, const BodyMotion& body);

  // settle.cpp
  [[nodiscard]] bool settle_pad(std::size_t pad, double t, const BodyMotion& body, Modes& modes);
  void settle_slot(std::size_t slot, double t, const BodyMotion& body, Modes& modes, Anchors& anchors,
                   std::vector<Transition>& changes, double& dissipated);
  void touch(std::size_t slot, const BodyMotion& body, const Sample& s, Mode& mode, Eigen::Vector3d& anchor);
  [[nodiscard]] Eigen::Vector3d with_lag(const Eigen::Vector3d& p_O, const Eigen::Vector3d& anchor,
                                         const Eigen::Vector3d& direction, double ratio, double margin) const;

  const Scene& scene_;
  const Body& body_;
  Element element_;
  Layout layout_;
  SplineSurface surface_;
  double seed_distance_;               // [m]
  double drop_distance_;               // [m]
  std::vector<PhalanxMotion> motion_;  // of every pad
  std::vector<SurfaceMemory> memory_;  // of every slot
  std::vector<NearMemory> near_;       // of every pad
};

}  // namespace handhold::reference
