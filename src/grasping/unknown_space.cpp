#include "unknown_space.hpp"

#include <algorithm>
#include <limits>

namespace symscene {
namespace {

constexpr int coarseness = 2;  // voxels of the grid per coarse one, along each axis
constexpr std::int16_t nobody = -1;

/// The voxels of a ball, and their squared distances from its centre [voxels²].
struct BallVoxel {
  Eigen::Vector3i offset;
  std::uint16_t squared;
};

std::vector<BallVoxel> ball(int radius) {
  std::vector<BallVoxel> voxels;
  for (int z = -radius; z <= radius; ++z) {
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        const int squared = x * x + y * y + z * z;
        if (squared <= radius * radius)
          voxels.push_back({{x, y, z}, static_cast<std::uint16_t>(squared)});
      }
    }
  }
  return voxels;
}

}  // namespace

UnknownSpace::UnknownSpace(const OccupancyGrid& grid, const std::vector<SurfaceSamples>& objects,
                           const SurfaceSamples& others, float reach)
    : grid_(grid), coarse_size_((grid.frame.size.array() + coarseness - 1) / coarseness) {
  const std::size_t voxels = static_cast<std::size_t>(coarse_size_.x()) *
                             static_cast<std::size_t>(coarse_size_.y()) *
                             static_cast<std::size_t>(coarse_size_.z());
  owner_.assign(voxels, nobody);
  std::vector<std::uint16_t> nearest(voxels, std::numeric_limits<std::uint16_t>::max());
  for (std::size_t i = 0; i < objects.size(); ++i)
    claim(objects[i], static_cast<int>(i), reach, nearest);
  claim(others, nobody, reach, nearest);
}

void UnknownSpace::claim(const SurfaceSamples& samples, int owner, float reach,
                         std::vector<std::uint16_t>& nearest) {
  const float edge = grid_.frame.resolution * coarseness;
  const std::vector<BallVoxel> around = ball(static_cast<int>(reach / edge));
  std::vector<std::size_t> centres;
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3i coarse = coarse_of(samples.positions.row(i).transpose());
    if ((coarse.array() >= 0).all() && (coarse.array() < coarse_size_.array()).all())
      centres.push_back(coarse_index(coarse));
  }
  std::sort(centres.begin(), centres.end());
  centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
  const auto row = static_cast<std::size_t>(coarse_size_.x());
  const auto slice = row * static_cast<std::size_t>(coarse_size_.y());
  for (const std::size_t centre : centres) {
    const Eigen::Vector3i at(static_cast<int>(centre % row), static_cast<int>(centre % slice / row),
                             static_cast<int>(centre / slice));
    for (const BallVoxel& voxel : around) {
      const Eigen::Vector3i coarse = at + voxel.offset;
      if ((coarse.array() < 0).any() || (coarse.array() >= coarse_size_.array()).any()) continue;
      const std::size_t index = coarse_index(coarse);
      if (voxel.squared >= nearest[index]) continue;
      nearest[index] = voxel.squared;
      owner_[index] = static_cast<std::int16_t>(owner);
    }
  }
}

std::optional<std::size_t> UnknownSpace::voxel_of(const Eigen::Vector3f& point) const {
  const Eigen::Array3f voxel = (point - grid_.frame.origin).array() / grid_.frame.resolution;
  if (!((voxel >= 0.0F).all() && (voxel < grid_.frame.size.array().cast<float>()).all()))
    return std::nullopt;
  const Eigen::Array3i at = voxel.cast<int>();
  return static_cast<std::size_t>(at.z()) * grid_.frame.slice_length() +
         static_cast<std::size_t>(at.y()) * grid_.frame.row_length() +
         static_cast<std::size_t>(at.x());
}

Eigen::Vector3i UnknownSpace::coarse_of(const Eigen::Vector3f& point) const {
  const float edge = grid_.frame.resolution * coarseness;
  return ((point - grid_.frame.origin) / edge).array().floor().cast<int>();
}

std::size_t UnknownSpace::coarse_index(const Eigen::Vector3i& coarse) const {
  return (static_cast<std::size_t>(coarse.z()) * static_cast<std::size_t>(coarse_size_.y()) +
          static_cast<std::size_t>(coarse.y())) *
             static_cast<std::size_t>(coarse_size_.x()) +
         static_cast<std::size_t>(coarse.x());
}

int UnknownSpace::owner_at(const Eigen::Vector3f& point) const {
  return owner_[coarse_index(coarse_of(point))];
}

bool UnknownSpace::is_outside(const SurfaceSamples& samples) const {
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    if (samples.observed[static_cast<std::size_t>(i)] == 0) continue;
    const Eigen::Vector3f point = samples.positions.row(i).transpose();
    const Eigen::Vector3f normal = samples.normals.row(i).transpose();
    for (const float offset : {0.0F, 1.5F}) {
      const auto voxel = voxel_of(point + offset * grid_.frame.resolution * normal);
      if (voxel && grid_.states[*voxel] != VoxelState::never_seen) return false;
    }
  }
  return true;
}

}  // namespace symscene
