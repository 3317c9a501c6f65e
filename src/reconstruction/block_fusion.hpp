#pragma once

#include <memory>

#include "reconstruction/tsdf_volume.hpp"

namespace symscene {

/// Fuses one measurement into blocks of a volume. Its projection of a block's voxels is the same
/// for all blocks up to a translation.
class BlockFusion {
 public:
  /// Depths and pixels of a block's voxels. One per task.
  struct Pixels {
    alignas(64) float depth[TsdfBlock::voxels];  ///< of the voxels [m]
    alignas(64) int pixel[TsdfBlock::voxels];
    alignas(64) int packed[TsdfBlock::voxels];  ///< of Measurement::packed
  };

  /// The measurement must outlive it.
  BlockFusion(const Measurement& measurement, const Eigen::Matrix3d& R_camera_world,
              const TsdfOptions& options, double noise, float distance_unit);
  ~BlockFusion();

  /// Averages the measured distances into a block whose corner is at `corner_camera` [m]. Returns
  /// the smallest distance of a seen voxel to the surface. [units]
  int fuse(const Eigen::Vector3f& corner_camera, Pixels& pixels, TsdfBlock& block) const;

  /// Averages colours into the voxels that lie within two voxels of the measured surface, after
  /// fuse() has filled `pixels`.
  void color(const Pixels& pixels, const Colors& colors, ColorBlock& block) const;

 private:
  struct Kernel;
  std::unique_ptr<const Kernel> kernel_;
  float color_reach_;     ///< [m]
  int max_color_weight_;  ///< [frames]
};

}  // namespace symscene
