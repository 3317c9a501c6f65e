#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "symscene/core/types.hpp"

namespace symscene {

/// A pinhole camera that looks along +z, with +x to the right of the image and +y down. Pixel
/// centres have integer coordinates. There is no default camera: all fields must be given.
struct CameraIntrinsics {
  Index width = 0;                                       ///< [px]
  Index height = 0;                                      ///< [px]
  double fx = std::numeric_limits<double>::quiet_NaN();  ///< [px]
  double fy = std::numeric_limits<double>::quiet_NaN();  ///< [px]
  double cx = std::numeric_limits<double>::quiet_NaN();  ///< [px]
  double cy = std::numeric_limits<double>::quiet_NaN();  ///< [px]

  std::size_t pixels() const { return std::size_t{width} * height; }

  /// Projects a point in front of the camera into the image. [px]
  Eigen::Vector2d project(const Eigen::Vector3d& point_camera) const {
    return {fx * point_camera.x() / point_camera.z() + cx,
            fy * point_camera.y() / point_camera.z() + cy};
  }
  /// The direction of the ray through a pixel, with z = 1: multiplied by the depth it is the point.
  Eigen::Vector3d ray(double u, double v) const { return {(u - cx) / fx, (v - cy) / fy, 1.0}; }

  /// Half the width and height of the image on the plane z = 1.
  Eigen::Vector2d half_size() const {
    return {0.5 * static_cast<double>(width) / fx, 0.5 * static_cast<double>(height) / fy};
  }

  /// x of the rays through each column.
  std::vector<float> column_rays() const {
    std::vector<float> x(width);
    for (Index u = 0; u < width; ++u) x[u] = static_cast<float>(ray(u, 0.0).x());
    return x;
  }
  /// y of the rays through each row.
  std::vector<float> row_rays() const {
    std::vector<float> y(height);
    for (Index v = 0; v < height; ++v) y[v] = static_cast<float>(ray(0.0, v).y());
    return y;
  }
};

}  // namespace symscene
