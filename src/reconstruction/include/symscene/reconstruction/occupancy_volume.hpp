#pragma once

#include <memory>
#include <optional>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/oriented_box.hpp"

namespace symscene {

/// The model of OctoMap (Hornung et al. 2013): evidence adds up as clamped log-odds, in steps of
/// 0.05. The clamp lets a few frames change a voxel's state; one noisy frame does not.
struct OccupancyVolumeOptions {
  double resolution = 0.005;
  double max_depth = 6.0;
  double free_margin = 0.006;
  double hit = 0.85;
  double miss = -0.4;
  double min_log_odds = -2.0;
  double max_log_odds = 3.5;
  double threshold = 0.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    constexpr double half_step = 0.025, most = 6.35;  // of log-odds in 8 bits
    visit("resolution", self.resolution, "m", between(1e-4, 1.0),
          "edge of a voxel (section 2.1.2)");
    visit("max_depth", self.max_depth, "m", above_up_to(0.0, 4000.0),
          "depth along the optical axis up to which space is seen");
    visit("free_margin", self.free_margin, "m", between(0.0, 4000.0),
          "distance in front of a measured depth from which space counts as free: half a voxel's "
          "diagonal and the noise");
    visit("hit", self.hit, "", between(half_step, most),
          "log-odds of a point in a voxel, in steps of 0.05");
    visit("miss", self.miss, "", between(-most, -half_step),
          "log-odds of a ray through a voxel, in steps of 0.05");
    visit("min_log_odds", self.min_log_odds, "", Range{-most, 0.0, false, true},
          "lower clamp of the log-odds");
    visit("max_log_odds", self.max_log_odds, "", above_up_to(0.0, most),
          "upper clamp of the log-odds");
    visit("threshold", self.threshold, "", between(-most, most),
          "log-odds from which a voxel counts as occupied");
  }
  /// Throws InputError if a value is out of its range, max_depth is more than 4000 voxels,
  /// free_margin is not below max_depth, or threshold is outside the clamps.
  void validate() const;
};

/// Free and occupied space from depth frames with known poses, on OctoMap's grid: voxel k covers
/// [k, k + 1) times the resolution along each axis. In a frame a voxel is
/// - hit if a measured point lies in it,
/// - else looked through if its centre lies, by a margin, in front of the depths measured in the
///   pixel onto which it projects and in the eight around it (pixels without a measurement are
///   ignored),
/// - else not seen.
/// Uniform space is stored without voxels, so that memory grows with the surfaces. The same bytes
/// for any number of threads.
class OccupancyVolume {
 public:
  explicit OccupancyVolume(const OccupancyVolumeOptions& options = {});
  ~OccupancyVolume();
  OccupancyVolume(OccupancyVolume&&) noexcept;
  OccupancyVolume& operator=(OccupancyVolume&&) noexcept;

  /// Adds a frame. Depths that are not positive and finite are ignored. Points outside
  /// OctoMap's 65,536 voxels per side are ignored. Throws InputError if the image is not of the
  /// camera's size, the intrinsics are not finite and positive, or the pose is not rigid.
  void integrate(const DepthFrame& frame, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& T_world_camera);

  /// The states of all voxels, or of those whose centre is in `region`.
  OccupancyMap map(const std::optional<OrientedBox>& region = std::nullopt) const;

  /// Their log-odds.
  LogOddsMap log_odds(const std::optional<OrientedBox>& region = std::nullopt) const;

  /// The state of the voxel around a point.
  VoxelState at(const Eigen::Vector3d& point_world) const;

  /// Memory of the voxels. [bytes]
  std::size_t memory() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
