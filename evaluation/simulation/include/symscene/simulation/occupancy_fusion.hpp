#pragma once

#include <span>

#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/options.hpp"
#include "symscene/simulation/cloud_fusion.hpp"

namespace symscene {

struct OccupancyFusionOptions {
  double resolution = 0.005;   ///< edge of a voxel, section 2.1.2 [m]
  double free_margin = 0.006;  ///< how far before the measured depth space counts as free: half a
                               ///< voxel's diagonal and what noise takes [m]
  int min_free_frames = 2;     ///< frames that must have looked through a free voxel
  int min_hit_frames = 2;      ///< frames that must have measured a point in an occupied voxel

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("resolution", self.resolution, "m", "edge of a voxel");
    visit("free_margin", self.free_margin, "m", "how far before a surface space counts as free");
    visit("min_free_frames", self.min_free_frames, "", "frames that look through a free voxel");
    visit("min_hit_frames", self.min_hit_frames, "", "frames that see an occupied voxel");
  }
  void validate() const;
};

/// What frames with known poses tell of the space in `region`: voxels are projected into every
/// frame and are free if enough frames look through them, occupied if enough measure a point in
/// them, else never seen. On OctoMap's grid: voxel k covers [k, k + 1) times the resolution.
OccupancyMap fuse_occupancy(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                            const OrientedBox& region, const OccupancyFusionOptions& options);

}  // namespace symscene
