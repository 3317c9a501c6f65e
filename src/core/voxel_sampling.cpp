#include "core/voxel_sampling.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr int bits_per_axis = 21;
constexpr double max_voxels_per_axis = 1 << (bits_per_axis - 1);

struct KeyedPoint {
  std::uint64_t key;
  Index index;
  bool operator<(const KeyedPoint& other) const {
    return key < other.key || (key == other.key && index < other.index);
  }
};

Box box_of(const Points& points, const PointIndices& indices) {
  Box box;
  for (const Index i : indices) {
    box.min = box.min.cwiseMin(points.row(i).transpose());
    box.max = box.max.cwiseMax(points.row(i).transpose());
  }
  return box;
}

/// The finite points with the key of their voxel, sorted by key.
std::vector<KeyedPoint> sort_into_voxels(const Points& points, double voxel_size) {
  const PointIndices finite = finite_points(points);
  if (finite.empty()) return {};
  const Box box = box_of(points, finite);
  const Eigen::Array3d low = (box.min.cast<double>().array() / voxel_size).floor();
  const Eigen::Array3d extent = (box.max.cast<double>().array() / voxel_size).floor() - low;
  if (!(extent.maxCoeff() < max_voxels_per_axis)) {
    throw InputError(
        "point cloud",
        fmt::format("at most 2^20 voxels of {:.3g} m along an axis (are the units metres?)",
                    voxel_size),
        fmt::format("an extent of {:.4g} m", extent.maxCoeff() * voxel_size));
  }
  std::vector<KeyedPoint> keyed;
  keyed.reserve(finite.size());
  for (const Index i : finite) {
    const Eigen::Array3d voxel =
        (points.row(i).transpose().cast<double>().array() / voxel_size).floor() - low;
    const auto key = [&](int axis) {
      return static_cast<std::uint64_t>(voxel[axis]) << (bits_per_axis * axis);
    };
    keyed.push_back({key(0) | key(1) | key(2), i});
  }
  std::sort(keyed.begin(), keyed.end());
  return keyed;
}

/// Sums over the points of a voxel.
class VoxelMean {
 public:
  void add(const PointCloud& cloud, Index i) {
    ++count_;
    position_ += cloud.position(i).cast<double>();
    if (cloud.has_normals() && cloud.normals.row(i).allFinite())
      normal_ += cloud.normal(i).cast<double>().normalized();
    if (cloud.has_colors()) color_ += cloud.colors.row(i).transpose().cast<double>();
  }

  void write(PointCloud& cloud, Eigen::Index row) const {
    const auto count = static_cast<double>(count_);
    cloud.positions.row(row) = (position_ / count).cast<float>().transpose();
    if (cloud.has_normals()) cloud.normals.row(row) = mean_normal().cast<float>().transpose();
    if (cloud.has_colors()) {
      cloud.colors.row(row) =
          (color_ / count).array().round().cast<std::uint8_t>().matrix().transpose();
    }
  }

 private:
  /// Zero where the normals of the two faces of a thin wall cancel out.
  Eigen::Vector3d mean_normal() const {
    const bool cancel_out = normal_.norm() < 0.1 * static_cast<double>(count_);
    return cancel_out ? Eigen::Vector3d::Zero() : normal_.normalized();
  }

  std::size_t count_ = 0;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d color_ = Eigen::Vector3d::Zero();
};

}  // namespace

PointCloud voxel_downsample(const PointCloud& cloud, double voxel_size) {
  require_option(voxel_size > 0.0, "voxel_size", "a length above 0 m", voxel_size);
  const std::vector<KeyedPoint> keyed = sort_into_voxels(cloud.positions, voxel_size);
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i == 0 || keyed[i].key != keyed[i - 1].key) begins.push_back(i);
  }
  begins.push_back(keyed.size());

  const auto voxels = static_cast<Eigen::Index>(begins.size() - 1);
  PointCloud sampled;
  sampled.positions.resize(voxels, 3);
  sampled.normals.resize(cloud.has_normals() ? voxels : 0, 3);
  sampled.colors.resize(cloud.has_colors() ? voxels : 0, 3);
  for (Eigen::Index row = 0; row < voxels; ++row) {
    VoxelMean mean;
    const auto voxel = static_cast<std::size_t>(row);
    for (std::size_t i = begins[voxel]; i < begins[voxel + 1]; ++i) mean.add(cloud, keyed[i].index);
    mean.write(sampled, row);
  }
  return sampled;
}

}  // namespace symscene
