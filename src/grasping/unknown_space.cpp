#include "unknown_space.hpp"

#include <algorithm>
#include <limits>

#include "core/parallel.hpp"

namespace symscene {

UnknownSpace::UnknownSpace(const OccupancyGrid& grid, const std::vector<SurfaceSamples>& objects,
                           const SurfaceSamples& others, float reach)
    : grid_(grid) {
  std::vector<Voxels> claims(objects.size() + 1);  // those of `others` last
  parallel_for_each(claims.size(), [&](std::size_t i) {
    claims[i] = coarse_voxels(i < objects.size() ? objects[i] : others);
  });
  const int radius = static_cast<int>(reach / (grid.frame.resolution * coarseness));
  if (!bound(claims, radius)) return;
  NearestOwner nearest(coarse_size_, static_cast<int>(claims.size()));
  for (std::size_t i = 0; i < claims.size(); ++i) {
    for (const Eigen::Array3i& voxel : claims[i])
      nearest.claim(voxel - coarse_low_, static_cast<int>(i));
  }
  nearest_ = nearest.nearest(radius);
}

UnknownSpace::Voxels UnknownSpace::coarse_voxels(const SurfaceSamples& samples) const {
  const float edge = grid_.frame.resolution * coarseness;
  const Eigen::Array3i size = (grid_.frame.size.array() + coarseness - 1) / coarseness;
  Voxels voxels;
  voxels.reserve(static_cast<std::size_t>(samples.size()));
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3f offset = samples.positions.row(i).transpose() - grid_.frame.origin;
    const Eigen::Array3i coarse = (offset / edge).array().floor().cast<int>();
    if ((coarse >= 0).all() && (coarse < size).all()) voxels.push_back(coarse);
  }
  return voxels;
}

bool UnknownSpace::bound(const std::vector<Voxels>& claims, int radius) {
  Eigen::Array3i low = Eigen::Array3i::Constant(std::numeric_limits<int>::max());
  Eigen::Array3i high = Eigen::Array3i::Constant(-1);
  for (const Voxels& voxels : claims) {
    for (const Eigen::Array3i& voxel : voxels) {
      low = low.min(voxel);
      high = high.max(voxel);
    }
  }
  if ((high < 0).any()) return false;
  const Eigen::Array3i last = (grid_.frame.size.array() - 1) / coarseness;
  coarse_low_ = (low - radius).max(0);
  coarse_size_ = (high + radius).min(last) - coarse_low_ + 1;
  return true;
}

std::optional<Eigen::Array3i> UnknownSpace::voxel_of(const Eigen::Vector3f& point) const {
  const Eigen::Array3f voxel = (point - grid_.frame.origin).array() / grid_.frame.resolution;
  if (!((voxel >= 0.0F).all() && (voxel < grid_.frame.size.array().cast<float>()).all()))
    return std::nullopt;
  return voxel.cast<int>();
}

VoxelState UnknownSpace::state_at(const Eigen::Array3i& voxel) const {
  return grid_.states[static_cast<std::size_t>(voxel.z()) * grid_.frame.slice_length() +
                      static_cast<std::size_t>(voxel.y()) * grid_.frame.row_length() +
                      static_cast<std::size_t>(voxel.x())];
}

int UnknownSpace::owner_at(const Eigen::Array3i& voxel) const {
  const Eigen::Array3i at = voxel / coarseness - coarse_low_;
  if ((at < 0).any() || (at >= coarse_size_).any()) return NearestOwner::nobody;
  const std::size_t row =
      static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(coarse_size_.y()) +
      static_cast<std::size_t>(at.y());
  return nearest_[row * static_cast<std::size_t>(coarse_size_.x()) +
                  static_cast<std::size_t>(at.x())]
      .owner;
}

bool UnknownSpace::is_outside(const SurfaceSamples& samples) const {
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    if (samples.observed[static_cast<std::size_t>(i)] == 0) continue;
    const Eigen::Vector3f point = samples.positions.row(i).transpose();
    const Eigen::Vector3f normal = samples.normals.row(i).transpose();
    for (const float offset : {0.0F, 1.5F}) {
      const auto voxel = voxel_of(point + offset * grid_.frame.resolution * normal);
      if (voxel && state_at(*voxel) != VoxelState::never_seen) return false;
    }
  }
  return true;
}

}  // namespace symscene
