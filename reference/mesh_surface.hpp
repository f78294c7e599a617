// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "reference/polyhedron.hpp"
#include "reference/surface.hpp"

namespace handhold::reference {

/// The exact triangles.
///
/// An anchor stays on the face it touched. In slip it moves in the face's plane; when it runs over the border, that is
/// an event of its own, and it is where faces meet: `way` says on which of them, along which hollow edge, or whether
/// not at all it goes on (docs/contact-law.md). What is in stick does not look at borders.
class MeshSurface : public Surface {
 public:
  explicit MeshSurface(std::shared_ptr<const VoxelField> field);

  [[nodiscard]] double value(const Eigen::Vector3d& p_O) const override;
  [[nodiscard]] Foot foot(const Eigen::Vector3d& p_O) const override;
  [[nodiscard]] Foot foot_on_sheet(const Eigen::Vector3d& p_O, const Place& anchor) const override;
  [[nodiscard]] AnchorSurface at(const Eigen::Vector3d& anchor_O, const Foothold& hold,
                                 bool with_curvature) const override;
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& p_O, const Foothold& hold) const override;
  [[nodiscard]] double overrun(const Eigen::Vector3d& anchor_O, const Foothold& hold) const override;
  [[nodiscard]] Place border(const Place& anchor) const override;
  [[nodiscard]] Way way(const Eigen::Vector3d& f_O, const Foothold& hold) const override {
    return solid_.way(f_O, hold);
  }
  [[nodiscard]] Way along_edge(const Eigen::Vector3d& f_O, const Foothold& hold) const override {
    return solid_.along_edge(f_O, hold);
  }
  [[nodiscard]] std::optional<Place> slide(const Eigen::Vector3d& p_O, const Place& anchor, double mu) const override;
  [[nodiscard]] Foothold convex_crease(const Foot& foot, double reach) const override;
  [[nodiscard]] bool between_sheets(const Eigen::Vector3d& p_O, const Foot& foot, double reach) const override;
  [[nodiscard]] double band() const override { return field_->band(); }

 private:
  [[nodiscard]] Foot foot_at(const Eigen::Vector3d& p_O, const Place& at) const;
  [[nodiscard]] Place search_beyond(const Eigen::Vector3d& anchor_O, int face, int side) const;

  std::shared_ptr<const VoxelField> field_;
  Polyhedron solid_;
  double diagonal_{};  // of everything [m]
};

}  // namespace handhold::reference
