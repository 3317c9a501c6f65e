#pragma once

#include <memory>
#include <optional>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/oriented_box.hpp"

namespace symscene {

/// The model is OctoMap's (Hornung et al. 2013): evidence adds up as log-odds that are clamped, so
/// that a few frames change a mind and noise does not. Log-odds are kept in steps of 0.05.
struct OccupancyVolumeOptions {
  double resolution = 0.005;   ///< edge of a voxel, section 2.1.2 [m]
  double max_depth = 3.0;      ///< along the optical axis; space is seen no farther [m]
  double free_margin = 0.006;  ///< how far before the measured depth space counts as free: half a
                               ///< voxel's diagonal and what noise takes [m]
  double hit = 0.85;           ///< log-odds of a frame that measures a point in a voxel
  double miss = -0.4;          ///< log-odds of a frame that looks through a voxel
  double min_log_odds = -2.0;  ///< clamp: odds of 0.12
  double max_log_odds = 3.5;   ///< clamp: odds of 0.97
  double threshold = 0.0;      ///< log-odds from which a voxel counts as occupied

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("resolution", self.resolution, "m", "edge of a voxel");
    visit("max_depth", self.max_depth, "m", "how far along the optical axis space is seen");
    visit("free_margin", self.free_margin, "m", "how far before a surface space counts as free");
    visit("hit", self.hit, "", "log-odds of a point in a voxel, in steps of 0.05");
    visit("miss", self.miss, "", "log-odds of a look through a voxel, in steps of 0.05");
    visit("min_log_odds", self.min_log_odds, "", "log-odds are clamped here");
    visit("max_log_odds", self.max_log_odds, "", "log-odds are clamped here");
    visit("threshold", self.threshold, "", "log-odds from which a voxel is occupied");
  }
  void validate() const;
};

/// What depth frames with known poses tell of space, on OctoMap's grid: voxel k covers [k, k + 1)
/// times the resolution along each axis. In a frame a voxel is
/// - hit if the point that any pixel measures lies in it,
/// - else looked through if its centre lies, by a margin, before what the pixel that it falls on
///   and the eight around it measured (pixels without a measurement say nothing),
/// - else not seen.
/// Space of one value takes no memory voxel by voxel: a volume costs what its surfaces cost. The
/// same bytes for any number of threads.
class OccupancyVolume {
 public:
  explicit OccupancyVolume(const OccupancyVolumeOptions& options = {});
  ~OccupancyVolume();
  OccupancyVolume(OccupancyVolume&&) noexcept;
  OccupancyVolume& operator=(OccupancyVolume&&) noexcept;

  /// Adds a frame. Depths that are not positive or not finite are no measurements. Throws
  /// InputError if the image is not of the camera's size, or the intrinsics or the pose are not
  /// usable numbers. What lies outside OctoMap's 65,536 voxels a side is left out.
  void integrate(const DepthFrame& frame, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& T_world_camera);

  /// What is known of space, or of the voxels whose centre is in `region`.
  OccupancyMap map(const std::optional<OrientedBox>& region = std::nullopt) const;

  /// The same with how sure it is.
  LogOddsMap log_odds(const std::optional<OrientedBox>& region = std::nullopt) const;

  /// What is known of the voxel around a point.
  VoxelState at(const Eigen::Vector3d& point_world) const;

  /// What the voxels take. [bytes]
  std::size_t memory() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
