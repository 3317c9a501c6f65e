#pragma once

#include <vector>

#include "reconstruction/surface_image.hpp"
#include "symscene/reconstruction/measurement_options.hpp"

namespace symscene {

/// Gives depths beside depth edges and on the edges of boxes a surface: there normals are missing,
/// as they need pixels on both sides.
class EdgeSurface {
 public:
  EdgeSurface(const SurfaceImage& surface, const MeasurementOptions& options)
      : surface_(surface),
        ray_x_(surface.camera.column_rays()),
        ray_y_(surface.camera.row_rays()),
        noise_(static_cast<float>(options.noise)),
        max_deviation_(static_cast<float>(options.max_edge_deviation)) {}

  /// The surface of the pixel around (column, row) on whose tangent plane a depth lies best, at
  /// this depth; none if it lies on none of them within its noise, as between two surfaces, or if
  /// its noise hides the shape of an edge.
  SurfacePixel at(float z, const Eigen::Vector3f& ray, std::size_t column, std::size_t row) const;

 private:
  const SurfaceImage& surface_;
  std::vector<float> ray_x_, ray_y_;
  float noise_;          ///< [1/m]
  float max_deviation_;  ///< [m]
};

}  // namespace symscene
