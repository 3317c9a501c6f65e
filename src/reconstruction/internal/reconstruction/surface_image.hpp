#pragma once

#include <vector>

#include "symscene/core/camera.hpp"
#include "symscene/reconstruction/measurement_options.hpp"

namespace symscene {

/// The surface in one pixel, in the camera's frame. All zero without a surface.
struct SurfacePixel {
  float depth = 0.0F;  ///< [m]
  float nx = 0.0F;     ///< unit normal towards the camera; zero at depth edges
  float ny = 0.0F;
  float nz = 0.0F;

  bool shows_surface() const { return nz < 0.0F; }
};

/// A smoothed depth image with normals.
struct SurfaceImage {
  CameraIntrinsics camera;
  std::vector<SurfacePixel> pixels;
};

/// Bridges holes of one pixel in a depth image (0 where nothing was measured), smooths it over 5×5
/// pixels whose depths lie within
/// `smoothing_sigmas` deviations of each other, and estimates normals from the differences of
/// neighbouring pixels.
SurfaceImage find_surface(std::vector<float> depth, const CameraIntrinsics& camera,
                          const MeasurementOptions& options);

}  // namespace symscene
