#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/camera_model.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// A checkerboard: the corners where four squares meet, not those at its border.
struct Board {
  int columns = 0;  ///< corners along a row
  int rows = 0;
  double square = 0.0;  ///< edge of a square [m]

  std::size_t corners() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  /// Position of a corner in the frame of the board, whose plane is z = 0. [m]
  Eigen::Vector3d corner(std::size_t i) const {
    const auto across = static_cast<std::size_t>(columns);
    return {square * static_cast<double>(i % across), square * static_cast<double>(i / across),
            0.0};
  }
  /// Throws InputError unless it has at least 3×3 corners and squares of a size above 0.
  void validate() const;
};

/// Corners of a board in an image.
struct BoardImage {
  static constexpr std::size_t least_corners = 6;  ///< of a part of a board

  std::string name;
  std::vector<Eigen::Vector2d> corners;  ///< [px]
  /// Which corners of the board they are; empty: all of them, row by row.
  std::vector<std::size_t> numbers = {};

  /// The number on the board of the i-th corner.
  std::size_t number(std::size_t i) const { return numbers.empty() ? i : numbers[i]; }
};

/// Whether this build can find boards and calibrate (OpenCV is optional).
bool has_board_calibration();

/// The corners of a board in a grey image, to a fraction of a pixel; none if it is not in view.
/// Throws InputError if the number of pixels is not that of the size or this build cannot.
std::optional<std::vector<Eigen::Vector2d>> find_board(std::span<const std::uint8_t> grey,
                                                       Index width, Index height,
                                                       const Board& board);

/// The number of corners of the board that an image shows, if another one than `board` is found.
std::optional<Board> find_other_board(std::span<const std::uint8_t> grey, Index width, Index height,
                                      const Board& board);

struct IntrinsicCalibrationOptions {
  int min_views = 4;
  double max_error_ratio = 3.0;
  bool fits_k3 = false;
  double min_tilt = radians(10.0);

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_views", self.min_views, "", at_least(3), "least number of images with the board");
    visit("max_error_ratio", self.max_error_ratio, "", above(1.0),
          "reprojection error of an image, over the median of all, above which it is left out");
    visit("fits_k3", self.fits_k3, "", any_value(),
          "fit the radial distortion of r^6, which wide lenses need and which few images confuse "
          "with k2");
    visit("min_tilt", self.min_tilt, "rad", between(0.0, 1.5),
          "angle between board and image that some image must exceed: with boards parallel to the "
          "image, focal length and distance cannot be told apart (Zhang 2000, section 3.4)");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What the calibration found out about an image.
struct BoardViewReport {
  std::string name;
  bool used = false;
  std::string reason;  ///< why it was not used
  double error = 0.0;  ///< root mean square reprojection error [px]
  Eigen::Isometry3d T_camera_board = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector2d> residuals;  ///< per corner: measured less reprojected [px]
};

struct IntrinsicCalibration {
  CameraModel camera;                  ///< without depth correction and colour camera
  std::vector<BoardViewReport> views;  ///< one per image
  double error = 0.0;                  ///< root mean square over all corners that were used [px]
  double focal_deviation = 0.0;        ///< standard deviation of fx [px]
  double center_deviation = 0.0;       ///< the greater one of cx and cy [px]
  double coverage = 0.0;  ///< share of the cells of an 8×6 grid over the image that hold a corner
  std::vector<std::string> warnings;
};

/// Intrinsics and lens distortion from images of a board (Zhang 2000, by OpenCV). Images that fit
/// much worse than the others are left out and named. Images may show parts of the board. The size
/// of the squares only scales the distances of the board: intrinsics do not depend on it. Throws
/// InputError if there are too few images, the board is always parallel to the image (focal length
/// and distance cannot be told apart then), or this build cannot.
IntrinsicCalibration calibrate_intrinsics(std::span<const BoardImage> images, Index width,
                                          Index height, const Board& board,
                                          const IntrinsicCalibrationOptions& options = {});

/// The pose of a board in the frame of a camera, from its corners. None if they do not fit.
/// Throws InputError if the corners are not of the board or this build cannot.
std::optional<Eigen::Isometry3d> board_pose(const BoardImage& image, const CameraModel& camera,
                                            const Board& board);

/// The pose of a colour camera in the frame of a depth camera.
struct ColorPose {
  Eigen::Isometry3d T_depth_color = Eigen::Isometry3d::Identity();
  double error = 0.0;  ///< root mean square reprojection error over both images [px]
  std::size_t pairs = 0;
  CameraModel depth;  ///< both cameras, refined by the pairs
  CameraModel color;
};

/// From pairs of images that show a board at the same time, taken by two calibrated cameras (by
/// OpenCV's stereo calibration). Intrinsics are refined with the pose: a shift of one image is
/// nearly a turn of its camera, so that errors of the centres would become errors of the pose.
/// Pairs that share fewer than BoardImage::least_corners corners are left out. Throws InputError if
/// the lists differ in length, there are fewer than three pairs, or this build cannot.
ColorPose calibrate_color_pose(std::span<const BoardImage> depth_images,
                               std::span<const BoardImage> color_images, const CameraModel& depth,
                               const CameraModel& color, const Board& board);

}  // namespace symscene
