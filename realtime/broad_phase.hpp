#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace handhold::realtime {

/// Axis-aligned box in W.
struct Box {
  Eigen::Vector3d low{Eigen::Vector3d::Zero()}, high{Eigen::Vector3d::Zero()};

  [[nodiscard]] bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Pairs of boxes that meet, by sort and sweep along x. The order is kept from step to step, where little changes, so
/// that sorting by insertion takes linear time.
class BroadPhase {
 public:
  void resize(std::size_t boxes) {
    boxes_.resize(boxes);
    order_.resize(boxes);
    for (std::size_t i = 0; i < boxes; ++i) order_[i] = int(i);
  }
  [[nodiscard]] Box& box(std::size_t i) { return boxes_[i]; }

  /// Calls visit(i, j) with i < j for every pair that meets, in no order that means anything.
  template <class Visit>
  void visit(Visit&& visit) {
    sort();
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const Box& box = boxes_[std::size_t(order_[at])];
      for (std::size_t next = at + 1; next < order_.size(); ++next) {
        const Box& other = boxes_[std::size_t(order_[next])];
        if (other.low.x() > box.high.x()) break;
        if (box.meets(other)) visit(std::min(order_[at], order_[next]), std::max(order_[at], order_[next]));
      }
    }
  }

 private:
  void sort() {
    const auto before = [&](int i, int j) { return boxes_[std::size_t(i)].low.x() < boxes_[std::size_t(j)].low.x(); };
    for (std::size_t i = 1; i < order_.size(); ++i) {
      const int box = order_[i];
      std::size_t at = i;
      for (; at > 0 && before(box, order_[at - 1]); --at) order_[at] = order_[at - 1];
      order_[at] = box;
    }
  }

  std::vector<Box> boxes_{};
  std::vector<int> order_{};
};

}  // namespace handhold::realtime
