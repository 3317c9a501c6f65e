#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/octree.hpp"
#include "occupancy_brick.hpp"
#include "range_pyramid.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"

namespace symscene {

/// How much of a cube a frame looks through.
enum class Sight : std::uint8_t { none, some, all };

/// The free space that a frame has seen. Cubes are given by the centre of their first voxel in the
/// camera's frame and by their level.
class OccupancyView {
 public:
  OccupancyView(const DepthFrame& frame, const CameraIntrinsics& camera,
                const Eigen::Isometry3d& T_world_camera, const OccupancyVolumeOptions& options);

  /// Bounds on how much of a cube the frame looks through.
  Sight look_at(const Eigen::Vector3f& first_camera, int level) const;

  /// A byte of 1 for every voxel of a block that is looked through.
  void look_through(const Eigen::Vector3f& first_camera, std::uint8_t* looks) const;

  /// The centre of a voxel. [m]
  Eigen::Vector3f center_camera(const OctreeKey& key) const {
    const Eigen::Array3d cell(key[0], key[1], key[2]);
    const Eigen::Vector3d center = (cell - (OccupancyMap::key_of_origin - 0.5)) * resolution_;
    return (T_camera_world_ * center).cast<float>();
  }

  /// The largest depth that the frame looks through. [m]
  float reach() const { return limits_.max(); }

 private:
  /// Offsets of eight corners, or of the voxels of a block, from the first voxel's centre.
  template <std::size_t count>
  struct Offsets {
    alignas(64) std::array<float, count> x, y, z;  ///< x and y times the focal length
  };
  template <std::size_t count>
  void fill_offsets(Offsets<count>& offsets, int spacing) const;

  struct Bounds {
    float low, high;
  };
  struct ImageBounds {
    Bounds u, v;
  };
  /// Bounds of the depths and pixels of the centres of a cube's voxels. Pixels are shifted by half
  /// a pixel, so that truncation rounds.
  static Bounds depths(const Eigen::Vector3f& first, const Offsets<8>& corners);
  ImageBounds project(const Eigen::Vector3f& first, const Offsets<8>& corners) const;

  Eigen::Isometry3d T_camera_world_;
  double resolution_;
  float fx_, fy_, cx_, cy_;
  RangePyramid limits_;  ///< a voxel is looked through if its depth is below its pixel's limit [m]
  Offsets<block_voxels> voxels_;
  std::array<Offsets<8>, brick_level + 1> corners_;
};

}  // namespace symscene
