#pragma once

#include <cstdint>
#include <vector>

#include "symscene/core/camera_model.hpp"
#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// Turns the frames of a calibrated camera into those of a pinhole camera with the same
/// intrinsics: depth is undistorted and corrected, and colours are registered to it. What is needed
/// per pixel is computed once.
class FrameRectifier {
 public:
  /// Throws InputError if the correction is not valid or not for images of the camera's size.
  explicit FrameRectifier(const CameraModel& camera);

  /// The rectified frame. Each pixel takes the nearest measured one, so that no depths are mixed
  /// over edges; where the lens shows nothing it is 0. Colours are those of the colour camera if
  /// the model has one, with its size, and otherwise belong to the pixels of the depth. A point
  /// that the colour camera does not see has the colour of what it sees there, or black outside its
  /// image. Throws InputError if an image is not of its camera's size.
  DepthFrame rectified(DepthFrame frame) const;

  /// An image of labels, undistorted like the depth: `outside` where the lens shows nothing. Throws
  /// InputError if it is not of the camera's size.
  std::vector<Index> rectified_labels(const std::vector<Index>& labels, Index outside) const;

 private:
  std::vector<float> rectified(const std::vector<float>& depth) const;
  void correct_row(Index v, std::vector<float>& factors, float* depth) const;
  Colors undistorted(const Colors& colors) const;
  Colors registered(const Colors& colors, const std::vector<float>& depth) const;

  CameraModel camera_;
  std::vector<std::uint32_t> sources_;  ///< measured pixel per pixel, empty if each is its own
  struct Column {
    std::uint32_t offset;  ///< of the node's first depth in a row of factors
    float beyond;
  };
  std::vector<Column> columns_;
  /// Those of the correction by row, column and range; each axis has its last one twice, so that a
  /// next one always exists.
  std::vector<float> factors_;
};

}  // namespace symscene
