// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace handhold::realtime {

/// Axis-aligned box in W.
struct Box {
  Eigen::Vector3d low{Eigen::Vector3d::Zero()}, high{Eigen::Vector3d::Zero()};

  [[nodiscard]] bool contains(const Box& other) const {
    return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
  }
  [[nodiscard]] bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Pairs of boxes that meet, by sort and sweep along the axis along which they are spread the most. Every box is given
/// some room, and pairs are those of rooms: they stand until a box leaves its room, so that what rests costs a
/// comparison a step.
class BroadPhase {
 public:
  void resize(std::size_t boxes) {
    boxes_.resize(boxes);
    rooms_.resize(boxes);
    spare_.resize(boxes);
    order_.resize(boxes);
    for (std::size_t i = 0; i < boxes; ++i) order_[i] = int(i);
    outgrown_ = true;
  }

  /// Puts box i, of what moves by `motion` a step [m].
  void place(std::size_t i, const Box& box, double motion) {
    boxes_[i] = box;
    spare_[i] = least_spare * std::max((box.high - box.low).minCoeff(), 0.0) + 2 * motion;
    outgrown_ = outgrown_ || !rooms_[i].contains(box);
  }
  /// Pairs have to be looked for again.
  [[nodiscard]] bool outgrown() const { return outgrown_; }

  /// Gives every box a room and calls visit(i, j) with i < j for every pair of them that meets, in no order that means
  /// anything.
  template <class Visit>
  void visit(Visit&& visit) {
    outgrown_ = false;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      rooms_[i] = {boxes_[i].low.array() - spare_[i], boxes_[i].high.array() + spare_[i]};
    const int axis = longest_spread();
    sort(axis);
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const Box& room = rooms_[std::size_t(order_[at])];
      for (std::size_t next = at + 1; next < order_.size(); ++next) {
        const Box& other = rooms_[std::size_t(order_[next])];
        if (other.low[axis] > room.high[axis]) break;
        if (room.meets(other)) visit(std::min(order_[at], order_[next]), std::max(order_[at], order_[next]));
      }
    }
  }

 private:
  static constexpr double least_spare = 5e-4;  // of a box's shortest side: blocks of a tower stand no nearer

  /// Variance of the middles. Its rounding depends on the order of boxes, but the pairs are the same for every axis.
  [[nodiscard]] int longest_spread() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
    double count = 0;
    for (const Box& room : rooms_) {
      if (!room.meets(room)) continue;  // it is nowhere
      const Eigen::Vector3d middle = 0.5 * (room.low + room.high);
      sum += middle;
      squares += middle.cwiseAbs2();
      ++count;
    }
    int axis = 0;
    (count * squares - sum.cwiseAbs2()).maxCoeff(&axis);
    return axis;
  }

  /// By insertion: where little changes from time to time, this takes linear time.
  void sort(int axis) {
    const auto before = [&](int i, int j) {
      return rooms_[std::size_t(i)].low[axis] < rooms_[std::size_t(j)].low[axis];
    };
    for (std::size_t i = 1; i < order_.size(); ++i) {
      const int box = order_[i];
      std::size_t at = i;
      for (; at > 0 && before(box, order_[at - 1]); --at) order_[at] = order_[at - 1];
      order_[at] = box;
    }
  }

  std::vector<Box> boxes_{}, rooms_{};
  std::vector<double> spare_{};  // around a box in its room, on every side
  std::vector<int> order_{};
  bool outgrown_{true};
};

}  // namespace handhold::realtime
