#pragma once

#include <memory>
#include <vector>

#include "symscene/core/depth_frame.hpp"

namespace symscene {

struct VoxelBlockGridOptions {
  double voxel_size = 0.0031;  ///< [m]
  int block_resolution = 16;   ///< voxels along the edge of a block; Open3D's default is 16
  double truncation = 0.0125;  ///< [m]
  double min_depth = 0.2;      ///< of its views [m]
  double max_depth = 3.0;      ///< [m]
};

/// Open3D's `t::geometry::VoxelBlockGrid` on the processor: distances and weights as floats, no
/// colours. Depth is converted in set_frame(), so that only Open3D's own work is timed.
class VoxelBlockGrid {
 public:
  explicit VoxelBlockGrid(const VoxelBlockGridOptions& options);
  ~VoxelBlockGrid();

  /// Bounds the threads of all grids.
  static void limit_threads(std::size_t threads);

  /// Sets the image for integrate() and cast_view().
  void set_frame(const DepthFrame& frame, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& T_world_camera);

  /// Allocates the blocks that the frame touches and fuses it.
  void integrate();

  /// Casts depths and normals of the blocks that the frame touched.
  void cast_view();

  /// The depths of the last view, 0 without a surface. [m]
  std::vector<float> view_depth() const;

  /// Memory of the blocks in use. [bytes]
  std::size_t bytes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
