#include "voxel_walk.hpp"

#include <algorithm>
#include <limits>

namespace symscene {

VoxelWalk::VoxelWalk(const VoxelFrame& frame, const Eigen::Vector3f& origin,
                     const Eigen::Vector3f& direction)
    : size_(frame.size.array()) {
  constexpr float never = std::numeric_limits<float>::infinity();
  const Eigen::Array3f at = (origin - frame.origin).array() / frame.resolution;
  const Eigen::Array3f along = direction.array() / frame.resolution;
  float enter = 0.0F, leave = never;
  for (int axis = 0; axis < 3; ++axis) {
    const auto size = static_cast<float>(size_[axis]);
    if (along[axis] == 0.0F) {
      if (at[axis] < 0.0F || at[axis] >= size) return;
      continue;
    }
    const float a = -at[axis] / along[axis], b = (size - at[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter < leave)) return;
  const Eigen::Array3f first = at + enter * along;
  stride_ << 1, static_cast<std::ptrdiff_t>(frame.row_length()),
      static_cast<std::ptrdiff_t>(frame.slice_length());
  for (int axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<float>(size_[axis] - 1);
    cell_[axis] = static_cast<int>(std::clamp(first[axis], 0.0F, last));
    step_[axis] = along[axis] > 0.0F ? 1 : -1;
    spacing_[axis] = along[axis] == 0.0F ? never : 1.0F / std::abs(along[axis]);
    const auto face = static_cast<float>(cell_[axis] + (along[axis] > 0.0F ? 1 : 0));
    next_[axis] = along[axis] == 0.0F ? never : (face - at[axis]) / along[axis];
    index_ += static_cast<std::size_t>(cell_[axis] * stride_[axis]);
  }
  entered_ = enter;
  is_inside_ = true;
}

void VoxelWalk::advance() {
  Eigen::Index axis = 0;
  entered_ = next_.minCoeff(&axis);
  cell_[axis] += step_[axis];
  is_inside_ = cell_[axis] >= 0 && cell_[axis] < size_[axis];
  index_ =
      static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index_) + step_[axis] * stride_[axis]);
  next_[axis] += spacing_[axis];
}

}  // namespace symscene
