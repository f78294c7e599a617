// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/block_field.hpp"

#include <algorithm>
#include <deque>
#include <mutex>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::catalogue {
namespace {

constexpr std::size_t kept = 8;  // some 20 MB each

struct Entry {
  Eigen::Vector3d size{};
  double voxel_size{};
  std::once_flag once{};
  std::shared_ptr<const VoxelField> field{};
};

class Recent {
 public:
  std::shared_ptr<Entry> find(const Eigen::Vector3d& size, double voxel_size) {
    const std::lock_guard lock(mutex_);
    const auto same = [&](const auto& entry) { return entry->size == size && entry->voxel_size == voxel_size; };
    if (const auto found = std::find_if(entries_.begin(), entries_.end(), same); found != entries_.end()) return *found;
    if (entries_.size() == kept) entries_.pop_front();
    entries_.push_back(std::make_shared<Entry>());
    entries_.back()->size = size;
    entries_.back()->voxel_size = voxel_size;
    return entries_.back();
  }

 private:
  std::mutex mutex_{};
  std::deque<std::shared_ptr<Entry>> entries_{};
};

}  // namespace

std::shared_ptr<const VoxelField> block_field(const Eigen::Vector3d& size, double voxel_size) {
  static Recent recent;
  const std::shared_ptr<Entry> entry = recent.find(size, voxel_size);
  std::call_once(entry->once, [&] { entry->field = voxelize(make_box(size), {.voxel_size = voxel_size}); });
  return entry->field;
}

}  // namespace handhold::catalogue
