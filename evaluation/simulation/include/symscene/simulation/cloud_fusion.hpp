#pragma once

#include <span>

#include "symscene/core/options.hpp"
#include "symscene/core/oriented_box.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

struct CloudFusionOptions {
  double voxel_size = 0.003;  ///< spacing of the fused points, 3.1 mm in section 2.1.1 [m]
  int min_frames = 3;         ///< frames that must have seen a point
  double edge_step = 0.015;   ///< depth between neighbours from which pixels count as flying [m]
  int normal_radius = 3;      ///< half width of the window that a normal is fitted to [px]
  double smoothing = 0.0035;  ///< standard deviation of the smoothing over the surface [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", "spacing of the fused points");
    visit("min_frames", self.min_frames, "", "frames that must have seen a point");
    visit("edge_step", self.edge_step, "m", "depth step from which pixels count as flying");
    visit("normal_radius", self.normal_radius, "px", "half width of a normal's window");
    visit("smoothing", self.smoothing, "m", "standard deviation of smoothing over the surface");
  }
  void validate() const;
};

/// A fused cloud and, for each point, the object that most of its measurements show.
struct FusedCloud {
  PointCloud cloud;
  std::vector<Index> objects;
};

/// Joins at most 64 frames with known poses into one oriented cloud of what is inside `region`.
/// Points are averaged in voxels, apart for surfaces that face apart, and then moved along their
/// normals onto the mean of their neighbourhood, so that the cloud is one layer thin as one from a
/// truncated signed distance function is.
FusedCloud fuse_cloud(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                      const OrientedBox& region, const CloudFusionOptions& options);

}  // namespace symscene
