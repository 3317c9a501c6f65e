#pragma once

#include <span>

#include "symscene/core/options.hpp"
#include "symscene/core/oriented_box.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

struct CloudFusionOptions {
  double voxel_size = 0.003;
  int min_frames = 3;
  double edge_step = 0.015;
  int normal_radius = 3;
  double smoothing = 0.0035;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", above(0.0),
          "spacing of the fused points (3.1 mm in section 2.1.1)");
    visit("min_frames", self.min_frames, "", at_least(1), "frames that must have seen a point");
    visit("edge_step", self.edge_step, "m", above(0.0),
          "depth step between neighbouring pixels from which they count as flying pixels");
    visit("normal_radius", self.normal_radius, "px", at_least(1),
          "half width of the window in which a normal is fitted");
    visit("smoothing", self.smoothing, "m", above(0.0),
          "standard deviation of the smoothing over the surface");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A fused cloud and, per point, the object that most of its measurements show.
struct FusedCloud {
  PointCloud cloud;
  std::vector<Index> objects;  ///< per point, the number of the mesh
};

/// Fuses at most 64 frames with known poses into one oriented cloud of the surfaces inside
/// `region`, in the world frame. Points are averaged per voxel, separately for surfaces that face
/// different ways, and then moved along their normals onto the mean of their neighbourhood, so that
/// the cloud is a single layer like one from a truncated signed distance function. Throws
/// InputError if an option is out of range.
FusedCloud fuse_cloud(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                      const OrientedBox& region, const CloudFusionOptions& options);

}  // namespace symscene
