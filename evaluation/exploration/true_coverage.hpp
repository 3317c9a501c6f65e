#pragma once

#include <span>
#include <vector>

#include "simulation/depth_renderer.hpp"
#include "simulation/true_surface.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene {

/// The true surfaces of objects on the table of the clutter benchmark, and how much of them is
/// known. World frame of the benchmark.
class TrueCoverage {
 public:
  explicit TrueCoverage(std::vector<TriangleMesh> objects);

  /// Per object: the share of its surface that is near one of the points.
  std::vector<double> shares(const Points& points) const;
  /// Mean share of the objects whose surface is near a point.
  double observed(const Scene& scene) const;
  /// The same, near a point of the scene or a closed surface of the result.
  double completed(const Scene& scene, const SegmentationResult& result) const;
  /// Masks of the result against the objects whose surface its points are nearest to.
  DetectionCounts masks(const SegmentationResult& result) const;
  /// Places of surface that no point is near to.
  PointIndices uncovered(const Points& points) const;
  /// How many of these places a camera at the pose would see.
  std::size_t count_visible(const PointIndices& places, const CameraIntrinsics& camera,
                            const Eigen::Isometry3d& T_world_camera) const;
  const TrueSurface& surface() const { return surface_; }

 private:
  std::vector<std::uint8_t> near(const Points& points) const;
  double mean_share(const Points& points) const;

  std::vector<TriangleMesh> meshes_;
  TrueSurface surface_;
  DepthRenderer renderer_;
  PointCloud places_;           ///< evenly distributed over surface that can be seen
  std::vector<Index> objects_;  ///< per place
};

}  // namespace symscene
