#pragma once

#include <array>
#include <span>

#include "reconstruction/tsdf_volume.hpp"

namespace symscene {

/// The field of a block with a margin of the voxels around it: one before it and two behind.
struct PaddedField {
  static constexpr int margin = 1;
  static constexpr int padded = TsdfBlock::edge + 2 * margin + 1;
  static constexpr int stride[3] = {1, padded, padded* padded};

  std::array<float, padded * padded * padded> distance;  ///< [units]
  std::array<std::uint16_t, padded * padded * padded> weight;

  /// The index of a voxel, relative to the block's first.
  static int at(int x, int y, int z) {
    return ((z + margin) * padded + y + margin) * padded + x + margin;
  }

  std::array<std::uint8_t, padded * padded * padded> seen;  ///< whether the weight suffices

  /// Reads a block, with the weights that voxels of each slot need. Where the volume has no block
  /// distances and weights are 0.
  void read(const TsdfVolume& volume, const Eigen::Vector3i& block,
            std::span<const std::uint16_t> needed_weights);

  /// The gradient at a voxel, one-sided at the border of the seen space. [units/voxel]
  Eigen::Vector3f gradient(int index) const;

 private:
  void copy(const TsdfBlock* source, std::uint16_t needed_weight, const Eigen::Vector3i& side);
};

}  // namespace symscene
