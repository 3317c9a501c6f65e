#include "padded_field.hpp"

namespace symscene {

/// Copies the voxels of the neighbour on a side, −1, 0 or 1 along each axis; null for none.
void PaddedField::copy(const TsdfBlock* source, std::uint16_t needed_weight,
                       const Eigen::Vector3i& side) {
  constexpr int edge = TsdfBlock::edge;
  const auto begin = [](int s) { return s < 0 ? -margin : s * edge; };
  const auto end = [](int s) { return s < 0 ? 0 : s == 0 ? edge : edge + 2; };
  for (int k = begin(side.z()); k < end(side.z()); ++k) {
    for (int j = begin(side.y()); j < end(side.y()); ++j) {
      for (int i = begin(side.x()); i < end(side.x()); ++i) {
        const auto to = static_cast<std::size_t>(at(i, j, k));
        const auto from = static_cast<std::size_t>(((k & 7) << 6) | ((j & 7) << 3) | (i & 7));
        distance[to] = source ? static_cast<float>(source->distance[from]) : 0.0F;
        weight[to] = source ? source->weight[from] : std::uint16_t{0};
        seen[to] = weight[to] >= needed_weight ? 1 : 0;
      }
    }
  }
}

void PaddedField::read(const TsdfVolume& volume, const Eigen::Vector3i& block,
                       std::span<const std::uint16_t> needed_weights) {
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const Eigen::Vector3i side(x, y, z);
        const std::int32_t slot = volume.index().find(block + side);
        if (slot == BlockIndex::none) {
          copy(nullptr, 1, side);
        } else {
          const auto at = static_cast<std::size_t>(slot);
          copy(&volume.block(at), needed_weights[at], side);
        }
      }
    }
  }
}

Eigen::Vector3f PaddedField::gradient(int index) const {
  Eigen::Vector3f gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const auto here = static_cast<std::size_t>(index);
    const auto low = static_cast<std::size_t>(index - PaddedField::stride[axis]);
    const auto high = static_cast<std::size_t>(index + PaddedField::stride[axis]);
    const bool has_low = weight[low] != 0, has_high = weight[high] != 0;
    const float from = has_low ? distance[low] : distance[here];
    const float to = has_high ? distance[high] : distance[here];
    gradient[axis] = (to - from) / (has_low && has_high ? 2.0F : 1.0F);
  }
  return gradient;
}

}  // namespace symscene
