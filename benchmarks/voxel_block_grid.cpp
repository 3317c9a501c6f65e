#include "voxel_block_grid.hpp"

#include <cstdlib>
#include <string>

#include <omp.h>
#include <open3d/t/geometry/VoxelBlockGrid.h>
#include <open3d/utility/Logging.h>

namespace symscene {
namespace {

namespace core = open3d::core;
namespace geometry = open3d::t::geometry;

constexpr std::int64_t many_voxels = 1 << 25;  // capacity that avoids rehashing
constexpr float meters = 1.0F;                 // depth scale of the image
constexpr float any_weight = 0.5F;             // less than the weight of one frame
constexpr int range_down_factor = 8;           // Open3D's default

core::Device processor() { return core::Device("CPU:0"); }

core::Tensor intrinsic_tensor(const CameraIntrinsics& camera) {
  return {std::vector<double>{camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1},
          {3, 3},
          core::Float64,
          processor()};
}

core::Tensor pose_tensor(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = pose.matrix();
  return {std::vector<double>(rows.data(), rows.data() + rows.size()),
          {4, 4},
          core::Float64,
          processor()};
}

}  // namespace

struct VoxelBlockGrid::Implementation {
  explicit Implementation(const VoxelBlockGridOptions& grid_options)
      : options(grid_options),
        truncation_voxels(static_cast<float>(options.truncation / options.voxel_size)),
        max_depth(static_cast<float>(options.max_depth)),
        grid({"tsdf", "weight"}, {core::Float32, core::Float32}, {{1}, {1}},
             static_cast<float>(options.voxel_size), options.block_resolution,
             many_voxels / block_voxels(), processor()) {}

  std::int64_t block_voxels() const {
    const std::int64_t edge = options.block_resolution;
    return edge * edge * edge;
  }

  VoxelBlockGridOptions options;
  float truncation_voxels;
  float max_depth;
  geometry::VoxelBlockGrid grid;
  geometry::Image depth;
  core::Tensor intrinsic;
  core::Tensor T_camera_world;
  core::Tensor blocks;
  core::Tensor view_depth;
  int width = 0;
  int height = 0;
};

VoxelBlockGrid::VoxelBlockGrid(const VoxelBlockGridOptions& options)
    : implementation_(std::make_unique<Implementation>(options)) {
  // The ray caster warns whenever it enlarges a buffer.
  open3d::utility::SetVerbosityLevel(open3d::utility::VerbosityLevel::Error);
}

VoxelBlockGrid::~VoxelBlockGrid() = default;

void VoxelBlockGrid::limit_threads(std::size_t threads) {
  // Open3D takes the number of cores unless this is set.
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread reads the environment meanwhile
  setenv("OMP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  omp_set_num_threads(static_cast<int>(threads));
}

void VoxelBlockGrid::set_frame(const DepthFrame& frame, const CameraIntrinsics& camera,
                               const Eigen::Isometry3d& T_world_camera) {
  Implementation& self = *implementation_;
  self.width = static_cast<int>(camera.width);
  self.height = static_cast<int>(camera.height);
  self.depth = geometry::Image(
      core::Tensor(frame.depth, {self.height, self.width, 1}, core::Float32, processor()));
  self.intrinsic = intrinsic_tensor(camera);
  self.T_camera_world = pose_tensor(T_world_camera.inverse());
}

void VoxelBlockGrid::integrate() {
  Implementation& self = *implementation_;
  self.blocks = self.grid.GetUniqueBlockCoordinates(self.depth, self.intrinsic, self.T_camera_world,
                                                    meters, self.max_depth, self.truncation_voxels);
  self.grid.Integrate(self.blocks, self.depth, self.intrinsic, self.T_camera_world, meters,
                      self.max_depth, self.truncation_voxels);
}

void VoxelBlockGrid::cast_view() {
  Implementation& self = *implementation_;
  const auto min_depth = static_cast<float>(self.options.min_depth);
  geometry::TensorMap view =
      self.grid.RayCast(self.blocks, self.intrinsic, self.T_camera_world, self.width, self.height,
                        {"depth", "normal"}, meters, min_depth, self.max_depth, any_weight,
                        self.truncation_voxels, range_down_factor);
  self.view_depth = view["depth"];
}

std::vector<float> VoxelBlockGrid::view_depth() const {
  return implementation_->view_depth.ToFlatVector<float>();
}

std::size_t VoxelBlockGrid::bytes() const {
  const std::int64_t blocks = implementation_->grid.GetHashMap().Size();
  return static_cast<std::size_t>(blocks * implementation_->block_voxels()) * 2 * sizeof(float);
}

}  // namespace symscene
