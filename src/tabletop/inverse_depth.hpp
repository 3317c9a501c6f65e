#pragma once

#include <cstdint>
#include <vector>

#include "symscene/tabletop/view_points.hpp"

namespace symscene {

constexpr std::size_t image_rows_per_block = 16;

/// The inverse depths of an image, in which planes are linear and the noise of structured light and
/// stereo is the same at every distance.
class InverseDepth {
 public:
  /// Depths that are not finite or out of range count as not measured.
  InverseDepth(const DepthFrame& frame, const CameraIntrinsics& camera,
               const ViewPointOptions& options);

  const CameraIntrinsics& camera() const { return camera_; }
  float at(std::size_t pixel) const { return values_[pixel]; }  ///< 0 without a measurement [1/m]

  /// Whether two measured pixels, `gap` pixels apart, may be of one surface.
  bool connected(float a, float b, float gap) const;

  /// The radius of the window in which a plane is fitted at an inverse depth. [px]
  int radius(float inverse) const;

 private:
  CameraIntrinsics camera_;
  std::vector<float> values_;
  float edge_;           ///< step of inverse depth that noise alone does not make [1/m]
  float slant_;          ///< relative step of depth from pixel to pixel of the most slanted surface
  float radius_factor_;  ///< squared radius times inverse depth [px²/m]
};

/// How far a surface reaches from a pixel without passing a depth edge. [px]
struct Arms {
  std::uint8_t left = 0, right = 0, up = 0, down = 0;
};

/// The arms of every pixel, none longer than the radius of its window; holes of up to `max_hole`
/// pixels are stepped over.
std::vector<Arms> arms_of(const InverseDepth& image, int max_hole);

}  // namespace symscene
