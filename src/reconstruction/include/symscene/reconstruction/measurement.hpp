#pragma once

#include <vector>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

struct MeasurementOptions {
  double min_depth = 0.2;    ///< what is nearer is left out [m]
  double max_depth = 3.0;    ///< what is farther is left out, below 6.5 [m]
  double noise = 1.425e-3;   ///< standard deviation of depth over its square [1/m]
  double edge_step = 0.015;  ///< depth between neighbours, at 1 m, that makes an edge [m]
  int tracking_width = 320;  ///< images are halved for tracking while they are wider by half [px]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_depth", self.min_depth, "m", "what is nearer is left out");
    visit("max_depth", self.max_depth, "m", "what is farther is left out, below 6.5");
    visit("noise", self.noise, "1/m", "standard deviation of depth over its square");
    visit("edge_step", self.edge_step, "m", "depth step at 1 m that makes an edge");
    visit("tracking_width", self.tracking_width, "px", "width of the images that are tracked");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;

  /// The standard deviation of a depth (Khoshelham and Elberink 2012, Eq. 10). [m]
  double deviation(double depth) const { return noise * depth * depth; }
};

/// What a pixel of a tracking image shows, in the camera's frame. Without a surface all is zero.
struct SurfacePixel {
  float depth = 0.0F;  ///< [m]
  float nx = 0.0F;     ///< unit normal towards the camera; zero at edges
  float ny = 0.0F;
  float nz = 0.0F;

  bool shows_surface() const { return nz < 0.0F; }
};

/// A depth image as the tracker sees it: smoothed, with normals. A level of a pyramid.
struct SurfaceImage {
  CameraIntrinsics camera;
  std::vector<SurfacePixel> pixels;
};

/// A depth image made ready to be tracked and fused.
struct Measurement {
  static constexpr float depth_unit = 1e-4F;  ///< of packed depths [m]

  CameraIntrinsics camera;

  /// One entry a pixel and an empty one at the end: the depth in units in the
  /// upper 16 bits, 0 for none; then 8 bits for the cosine by which a depth difference becomes a
  /// distance to the surface, in 255ths; then 8 bits for the weight, in 16ths of that of a frontal
  /// view at 1 m.
  std::vector<std::uint32_t> packed;
  const Colors* colors = nullptr;  ///< of the frame, which has to live on; null without

  std::vector<SurfaceImage> pyramid;  ///< finest first, each level half of the one before
  std::size_t measured = 0;           ///< pixels of the finest level with a surface
};

/// The surface that a depth image shows, 0 being no depth: smoothed over 5×5 pixels where they lie
/// within four deviations of each other, with normals from the differences of pixels around.
SurfaceImage find_surface(std::vector<float> depth, const CameraIntrinsics& camera,
                          const MeasurementOptions& options);

/// Smooths a depth image for tracking, estimates normals, and weighs every pixel for fusion by its
/// range and angle (section 2.1.1; Newcombe et al. 2011, section 3.2). Values that are not finite
/// or out of range count as not measured. Throws InputError if the image is not of the camera's
/// size.
Measurement prepare_measurement(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const MeasurementOptions& options);

}  // namespace symscene
