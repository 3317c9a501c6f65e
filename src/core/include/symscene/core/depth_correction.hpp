#pragma once

#include <cstdint>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// Factors that correct the depth of a camera by pixel and range: Teichman, Miller and Thrun,
/// "Unsupervised intrinsic calibration of depth sensors via SLAM", RSS 2013. They are given at the
/// nodes of a grid, evenly spaced from the first to the last pixel of the undistorted image, for
/// evenly spaced depths, and are linear between them. At other depths they are constant.
struct DepthCorrection {
  static constexpr std::size_t max_cells = 40000;

  Index width = 0;           ///< of the image [px]
  Index height = 0;          ///< of the image [px]
  Index columns = 0;         ///< nodes across the image
  Index rows = 0;            ///< nodes down the image
  Index ranges = 0;          ///< number of depths
  double first_range = 0.0;  ///< least depth [m]
  double range_step = 0.0;   ///< distance of neighbouring depths [m]
  /// True over measured depth, range by range, in each row by row.
  std::vector<float> factors;
  /// Per factor: 1 if measurements gave it, 0 if it comes from its neighbours.
  std::vector<std::uint8_t> measured;

  std::size_t cells() const { return std::size_t{columns} * rows * ranges; }
  std::size_t cell(Index range, Index row, Index column) const {
    return (std::size_t{range} * rows + row) * columns + column;
  }
  double range(Index i) const { return first_range + i * range_step; }

  /// The factor at a pixel and a measured depth. [px, m]
  double factor(double u, double v, double depth) const;

  /// Throws InputError if sizes are zero or do not agree, there are more than `max_cells`, or a
  /// factor is not within 0.5 to 2.
  void validate() const;
};

/// A position on an axis of evenly spaced nodes: between `node` and the next, or at the last one.
struct AxisPlace {
  Index node = 0;
  double beyond = 0.0;  ///< share of the way to the next node, in [0, 1]
};

/// Where `value`, in units of the spacing from the first node, lies among `count` nodes. Ends hold.
AxisPlace place_on_axis(double value, Index count);

/// The same of a pixel among nodes from the first to the last of `size` pixels.
AxisPlace place_in_image(double pixel, Index size, Index nodes);

}  // namespace symscene
