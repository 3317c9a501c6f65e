#pragma once

#include "reconstruction/tsdf_volume.hpp"

namespace symscene {

/// The integer at or below a coordinate of a volume. [voxels] Truncation is one instruction,
/// std::floor without SSE 4.1 a call.
inline int floor_of(float coordinate) {
  constexpr int offset = 2 * BlockIndex::reach * TsdfBlock::edge;
  return static_cast<int>(coordinate + static_cast<float>(offset)) - offset;
}

/// Reads a volume's field at points in units of voxels, where voxel k has its centre at k + ½.
/// Remembers the last block: one reader per thread.
class FieldReader {
 public:
  explicit FieldReader(const TsdfVolume& volume) : volume_(volume) {}

  /// The block that holds a voxel; null where there is none.
  const TsdfBlock* block_at(int x, int y, int z) {
    const Eigen::Vector3i block(x >> 3, y >> 3, z >> 3);
    if (block != last_) {
      last_ = block;
      slot_ = volume_.index().find(block);
      cached_ =
          slot_ == BlockIndex::none ? nullptr : &volume_.block(static_cast<std::size_t>(slot_));
    }
    return cached_;
  }

  /// Whether the surface may pass through the last block.
  bool last_is_near_surface() const {
    return cached_ != nullptr && volume_.near_surface(static_cast<std::size_t>(slot_));
  }

  static int place(int x, int y, int z) { return ((z & 7) << 6) | ((y & 7) << 3) | (x & 7); }

  /// Reads the distance of a voxel [units]; false if it was never seen.
  bool distance(int x, int y, int z, float& value) {
    const TsdfBlock* block = block_at(x, y, z);
    if (block == nullptr) return false;
    const std::int16_t distance = block->distance[static_cast<std::size_t>(place(x, y, z))];
    value = static_cast<float>(distance);
    return distance != TsdfBlock::never_seen;
  }

  /// Reads the eight voxels around a point, x fastest, and its position between them in [0, 1)³;
  /// false if one was never seen.
  bool corners(const Eigen::Vector3f& point, float (&values)[8], Eigen::Vector3f& between) {
    const float px = point.x() - 0.5F, py = point.y() - 0.5F, pz = point.z() - 0.5F;
    const int x = floor_of(px), y = floor_of(py), z = floor_of(pz);
    between = {px - static_cast<float>(x), py - static_cast<float>(y), pz - static_cast<float>(z)};
    if ((x & 7) != 7 && (y & 7) != 7 && (z & 7) != 7) return inner_corners(x, y, z, values);
    bool seen = true;
    for (int k = 0; k < 8; ++k) {
      seen = distance(x + (k & 1), y + ((k >> 1) & 1), z + (k >> 2), values[k]) && seen;
    }
    return seen;
  }

 private:
  bool inner_corners(int x, int y, int z, float (&values)[8]) {
    const TsdfBlock* block = block_at(x, y, z);
    if (block == nullptr) return false;
    const auto base = static_cast<std::size_t>(place(x, y, z));
    bool seen = true;
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t i = base + (k & 1) + ((k & 2) << 2) + ((k & 4) << 4);
      values[k] = static_cast<float>(block->distance[i]);
      seen = seen && block->distance[i] != TsdfBlock::never_seen;
    }
    return seen;
  }

  const TsdfVolume& volume_;
  Eigen::Vector3i last_ = Eigen::Vector3i::Constant(1 << 20);
  std::int32_t slot_ = BlockIndex::none;
  const TsdfBlock* cached_ = nullptr;
};

inline float trilinear(const float (&c)[8], const Eigen::Vector3f& t) {
  const float x0 = c[0] + t.x() * (c[1] - c[0]), x1 = c[2] + t.x() * (c[3] - c[2]);
  const float x2 = c[4] + t.x() * (c[5] - c[4]), x3 = c[6] + t.x() * (c[7] - c[6]);
  const float y0 = x0 + t.y() * (x1 - x0), y1 = x2 + t.y() * (x3 - x2);
  return y0 + t.z() * (y1 - y0);
}

/// The gradient of the trilinear interpolation within a cell.
inline Eigen::Vector3f trilinear_gradient(const float (&c)[8], const Eigen::Vector3f& t) {
  const auto mix = [](float a, float b, float at) { return a + at * (b - a); };
  const float x =
      mix(mix(c[1] - c[0], c[3] - c[2], t.y()), mix(c[5] - c[4], c[7] - c[6], t.y()), t.z());
  const float y =
      mix(mix(c[2] - c[0], c[3] - c[1], t.x()), mix(c[6] - c[4], c[7] - c[5], t.x()), t.z());
  const float z =
      mix(mix(c[4] - c[0], c[5] - c[1], t.x()), mix(c[6] - c[2], c[7] - c[3], t.x()), t.y());
  return {x, y, z};
}

}  // namespace symscene
