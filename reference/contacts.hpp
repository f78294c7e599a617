// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/model/scene.hpp"
#include "reference/contact_data.hpp"
#include "reference/element.hpp"
#include "reference/layout.hpp"
#include "reference/surface.hpp"

namespace handhold::reference {

/// The contacts of all bodies with all hands and with each other: forces, anchor rates, witnesses, and what happens at
/// events.
///
/// A function of time, motions, modes and anchors only; members are memories of costly results, checked by value. What
/// is far costs a look at its pad's bounds, and no more than once a step: evaluate() sees samples in contact, watch()
/// the others. All sums run in the order of slots.
class Contacts {
 public:
  /// `accuracy`: of the integration, to know what is noise.
  Contacts(const Scene& scene, double accuracy, SurfaceModel model);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] int slots() const { return int(layout_.id.size()); }
  [[nodiscard]] const Surface& surface(int body) const { return *surfaces_[std::size_t(body)]; }
  [[nodiscard]] const Element& element(int slot) const {
    return elements_[std::size_t(layout_.pad_of[std::size_t(slot)])];
  }

  /// Forces, and the witnesses of samples in contact. Does not allocate after the first call.
  void evaluate(double t, const Motions& motions, const Modes& modes, const AnchorsView& anchors, Evaluation& out);

  /// The other witnesses, of apart samples and of patches.
  void watch(double t, const Motions& motions, const Modes& modes, const AnchorsView& anchors, Evaluation& out);

  /// Modes without hands, patches and contacts.
  void clear(Modes& modes) const;

  /// Modes and anchors at t = 0, from the starts given in the scene.
  void start(const Motions& motions, Modes& modes, Anchors& anchors);

  /// What settle works on.
  struct Settling {
    double t;
    const Motions& motions;
    Modes& modes;
    Anchors& anchors;
    std::vector<Transition> changes{};
    std::vector<Undecided> undecided{};
    double dissipated{};  ///< what the springs lose when anchors jump or let go [J]
  };

  /// Carries out all changes that are due until none is, seeds and drops patches. Throws CannotAdvance if the modes do
  /// not come to rest.
  void settle(Settling& now);

  /// Whether hand `hand` exists just after t.
  [[nodiscard]] bool present_after(int hand, double t) const;

  /// Position and velocity of a sample; mode and witnesses are left at "apart".
  [[nodiscard]] Sample place(std::size_t slot, double t, const Motions& motions, const Eigen::Vector3d& p_P);

  /// ½ k |p − C|² of the samples in contact, and of those that keep a sheet [J].
  [[nodiscard]] double elastic_energy(const Modes& modes, const Evaluation& evaluation) const;

  /// Of a slot, for messages: "hand 0 index_distal sample 3 on body 'cube'".
  [[nodiscard]] std::string describe(int slot) const;

 private:
  struct PhalanxMotion {
    double t{-1};
    Pose X_WP{};
    Motion motion{};
  };
  struct SurfaceMemory {
    Eigen::Vector3d anchor{Eigen::Vector3d::Constant(-1e300)};
    Foothold hold{};
    AnchorSurface surface{};
  };
  struct NearMemory {  // the distance found at some earlier pose bounds the distance now
    bool known{false};
    Pose X_OP{};
    double distance{};
  };

  [[nodiscard]] const PhalanxMotion& phalanx(const Pad& pad, double t);
  [[nodiscard]] const Motion& carrier(const Pad& pad, double t, const Motions& motions);
  [[nodiscard]] const AnchorSurface& surface_at(std::size_t slot, const Eigen::Vector3d& anchor, const Foothold& hold,
                                                bool with_curvature);
  void respond_at(std::size_t slot, Mode mode, const Eigen::Vector3d& anchor, const Foothold& hold, Sample& s);
  void relax(std::size_t slot, const Place& anchor, Sample& s) const;
  void add_to(const Pad& pad, const Motions& motions, Sample& s, Evaluation& out) const;
  [[nodiscard]] bool live(const Pad& pad, const Modes& modes) const;

  // watch.cpp
  [[nodiscard]] double touch_witness(std::size_t slot, const Sample& s) const;
  [[nodiscard]] double kept_witness(std::size_t slot, const Sample& s, const Place& anchor) const;
  [[nodiscard]] double pressing(std::size_t slot, const Sample& s, const Foot& foot) const;
  [[nodiscard]] double far(const Pad& pad, double t, const Motions& motions);
  [[nodiscard]] double nearness(std::size_t pad, double t, const Motions& motions, const Modes& modes);
  [[nodiscard]] Pose pose_in_body(const Pad& pad, double t, const Motions& motions);

  // settle.cpp
  struct Slot;  // one sample while it is being settled
  [[nodiscard]] bool settle_pad(std::size_t pad, Settling& now);
  void settle_samples(std::size_t pad, Settling& now);
  void settle_slot(std::size_t slot, Settling& now);
  [[nodiscard]] bool change(Slot& x, Settling& now);
  void look(Slot& x);
  void touch(Slot& x, Settling& now);
  void decide(const Slot& x, Foot& foot, Settling& now) const;
  void release(Slot& x);
  void break_away(Slot& x);
  void stick_again(Slot& x);
  void go_over(Slot& x, Settling& now);
  void take_way(Slot& x, const Way& way);
  void say_undecided(const Slot& x, const Way& way, const Eigen::Vector3d& w, Settling& now) const;
  void slip_to_cone(Slot& x, const Eigen::Vector3d& direction);
  [[nodiscard]] Eigen::Vector3d with_lag(std::size_t slot, const Eigen::Vector3d& p_O, const Eigen::Vector3d& anchor,
                                         const Foothold& hold, const Eigen::Vector3d& direction, double ratio,
                                         double margin) const;

  const Scene& scene_;
  Layout layout_;
  std::vector<std::shared_ptr<const Surface>> surfaces_;  // of every body
  std::vector<Element> elements_;                         // of every pad
  std::vector<double> drop_distance_;                     // of every body [m]
  double seed_distance_;                                  // [m]
  double event_window_;                                   // [s]
  std::vector<PhalanxMotion> phalanges_;                  // phalanx_count of every hand
  std::vector<SurfaceMemory> memory_;                     // of every slot
  std::vector<NearMemory> near_;                          // of every pad
};

}  // namespace handhold::reference
