// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "cases/model/body.hpp"
#include "cases/model/friction.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/printed_law.hpp"
#include "cases/model/scene.hpp"

namespace handhold::printed {

/// Which surface and which normal of a voxel field the law sees.
enum class Normals {
  triangle,  ///< the mesh's triangles and their normals ("surface normal vector of the object mesh", eq. 2)
  smooth,    ///< the mesh's triangles, normal of the smoothed distance field
  voxel,     ///< the faces of the occupied voxels (section 3.5: "we approximate the concave objects with small voxels")
};

/// The half space z <= height [m]: exact.
struct Plane {
  double height{0};
};

/// |x| <= half_width [m], endless along y and z: what two fingers pinch. Exact.
struct Slab {
  double half_width{};
};

/// About the origin of O: exact. Radius in [m].
struct Ball {
  double radius{};
};

/// The surface of a real voxel field.
struct Voxels {
  std::shared_ptr<const VoxelField> field{};
  Normals normals{Normals::triangle};
};

using Shape = std::variant<Plane, Slab, Ball, Voxels>;  ///< of the object, in O

/// How position and velocity follow from the force.
enum class Integrator {
  semi_implicit,   ///< velocity, then position with the new velocity: PhysX (section 3.5 runs on PhysX 3)
  explicit_euler,  ///< position with the old velocity
  exact_hold,      ///< exact for a force held over the step: x += h v + a h²/2
};

/// How the law is coupled to the step of the engine behind it, the host.
struct HostOptions {
  Integrator integrator{Integrator::semi_implicit};
  int substeps{1};         ///< of a frame
  bool hold_force{false};  ///< the frame's wrench is kept over its sub-steps; else computed anew, anchors kept
  bool old_pose{false};    ///< the law sees the body as it was one frame ago (a pipelined engine)
};

/// Throws InputError for less than one sub-step.
void validate(const HostOptions& options);

/// A phalanx P that moves as told, with its contact samples.
struct Phalanx {
  std::vector<Eigen::Vector3d> p_P{};    ///< at most max_samples, in P [m]; P's origin is the phalanx's centroid
  std::vector<SampleStart> start{};      ///< empty (unstretched), or one a sample
  std::function<Pose(double t)> pose{};  ///< X_WP, asked at the frames
};

/// How far from the surface a sample may be at the start: its anchor is the closest point within that [m].
inline constexpr double seed_reach = 0.02;

}  // namespace handhold::printed

namespace handhold {

/// Level L3: one rigid body in front of the law of Höll et al. 2018, frame by frame. In the frame that begins at
/// t_k = k `frame`, the law is given hand and body at t_k; its wrench then moves the body to t_{k+1}.
struct PrintedProblem {
  printed::Options law{};
  printed::HostOptions host{};
  printed::Shape shape{};
  Friction friction{};
  Inertia inertia{1};  ///< not asked of a fixed body; its tensor of a free one only
  Mobility mobility{Mobility::free};
  Pose X_WO{};                           ///< at t = 0
  Twist V_WO{};                          ///< at t = 0
  Eigen::Vector3d gravity{0, 0, -9.81};  ///< [m/s²]
  std::vector<printed::Phalanx> phalanges{};
  std::function<Load(double t)> load{};  ///< besides gravity, constant over a frame; empty: none
  double frame{1.0 / 90};                ///< dt [s]
  int frames{1};                         ///< how many, >= 1
};

/// Throws InputError naming the first thing that cannot be simulated.
void validate(const PrintedProblem& problem);

}  // namespace handhold
