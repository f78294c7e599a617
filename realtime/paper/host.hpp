#pragma once

#include <span>
#include <vector>

#include "realtime/paper/middleware.hpp"

namespace handhold::realtime::paper {

/// A rigid body for the host: just what free motion needs.
struct HostBody {
  double mass{1};                                          ///< [kg]
  Eigen::Matrix3d inertia_O{Eigen::Matrix3d::Identity()};  ///< about the centre of mass [kg m²]
  Eigen::Vector3d center_O{Eigen::Vector3d::Zero()};       ///< centre of mass in O [m]
  bool turns{true};                                        ///< false: translation only
  BodyMotion motion{};                                     ///< v is the centre of mass's
};

/// How position and velocity follow from the force.
enum class Integrator {
  semi_implicit,   ///< velocity, then position with the new velocity: PhysX (section 3.5 runs on PhysX 3)
  explicit_euler,  ///< position with the old velocity
  exact_hold,      ///< exact for a force held over the step: x += h v + a h²/2
};

/// How the middleware is coupled to the engine's step.
struct HostOptions {
  Integrator integrator{Integrator::semi_implicit};
  int substeps{1};         ///< of a frame
  bool hold_force{false};  ///< the frame's wrench is kept over its sub-steps; else computed anew, anchors kept
  bool old_pose{false};    ///< the middleware sees the body as it was one frame ago (a pipelined engine)
};

void validate(const HostOptions& options);

/// The least of a physics engine: one rigid body, gravity, explicit forces. It stands for the engine behind the
/// middleware in tests of the discrete law; it collides with nothing.
class Host {
 public:
  Host(Middleware middleware, const HostBody& body, const Eigen::Vector3d& gravity, const HostOptions& options = {});

  /// One frame of `dt` [s] with the phalanges at `X_WP` (one pose a patch) and `applied` beside gravity.
  void advance(double dt, std::span<const Pose> X_WP, const Wrench& applied = {});

  [[nodiscard]] const HostBody& body() const { return body_; }
  [[nodiscard]] HostBody& body() { return body_; }
  [[nodiscard]] const Middleware& middleware() const { return middleware_; }
  [[nodiscard]] Middleware& middleware() { return middleware_; }
  [[nodiscard]] double time() const { return t_; }

 private:
  Middleware middleware_;
  HostBody body_;
  Eigen::Vector3d gravity_;
  HostOptions options_;
  BodyMotion old_;
  double t_{};
};

}  // namespace handhold::realtime::paper
