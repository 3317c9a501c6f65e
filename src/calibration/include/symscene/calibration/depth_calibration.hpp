#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "symscene/core/camera_model.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// The grid of the correction and how it is fitted.
struct DepthCorrectionOptions {
  int columns = 20;
  int rows = 15;
  int ranges = 8;
  int samples = 4;
  double smoothness = 0.3;
  double min_samples = 2.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("columns", self.columns, "", between(1, 100),
          "factors across the image, from the first to the last pixel");
    visit("rows", self.rows, "", between(1, 100), "factors down the image");
    visit("ranges", self.ranges, "", between(1, 50),
          "depths, evenly spaced over those that were measured");
    visit("samples", self.samples, "", between(1, 16),
          "samples per factor along each axis of the image: robust means over the pixels around "
          "them");
    visit("smoothness", self.smoothness, "", above(0.0),
          "weight of the curvature of the factors over the image and over range, relative to that "
          "of the samples of a factor");
    visit("min_samples", self.min_samples, "", above(0.0),
          "least weight of samples from which a factor counts as measured");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// How the wall is found in an image and its plane fitted.
struct WallFitOptions {
  double tolerance = 0.05;
  double min_share = 0.3;
  int draws = 200;
  int min_views = 3;
  double min_spread = 1.3;
  int rounds = 12;
  std::uint64_t seed = 1;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tolerance", self.tolerance, "", above_up_to(0.0, 0.5),
          "largest difference from the plane, over the depth, in the first search; it must exceed "
          "the error of the camera");
    visit("min_share", self.min_share, "", between(0.0, 1.0),
          "least share of the measured image that shows the wall");
    visit("draws", self.draws, "", between(1, 100000), "planes that are tried per image");
    visit("min_views", self.min_views, "", at_least(1), "least number of images with a wall");
    visit("min_spread", self.min_spread, "", at_least(1.0),
          "least distance of the farthest wall over that of the nearest");
    visit("rounds", self.rounds, "", between(1, 1000),
          "alternations between the planes and the correction at most");
    visit("seed", self.seed, "", any_value(), "seed of the search");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What the calibration found out about an image.
struct DepthViewReport {
  std::size_t number = 0;  ///< in the order in which images were added, from 0
  bool used = false;
  std::string reason;         ///< why it was not used
  double distance = 0.0;      ///< median depth [m]
  double share = 0.0;         ///< of the measured image that agrees with the reference
  double error_before = 0.0;  ///< root mean square difference from the reference, over depth
  double error_after = 0.0;   ///< the same with the correction
};

struct DepthCalibration {
  DepthCorrection correction;
  std::vector<DepthViewReport> views;
  bool is_absolute = false;   ///< whether true distances were known, see WallCalibrator
  double error_before = 0.0;  ///< as of a view, over all
  double error_after = 0.0;
  std::vector<std::string> warnings;
};

/// Corrects depth by images of a flat wall or board. What is not on the plane is left out.
///
/// The plane of a wall alone is not known. Errors that turn planes into planes cannot be seen then:
/// a factor that is the same everywhere, and to first order one that varies linearly over the
/// image. Only the warp is corrected: what makes a plane uneven. With the pose of a board on the
/// wall, from images of its corners, the plane is known, and the correction makes depth true.
class WallCalibrator {
 public:
  /// `camera` is that of the undistorted images. Throws InputError if an option is out of range.
  explicit WallCalibrator(const CameraIntrinsics& camera, const DepthCorrectionOptions& grid = {},
                          const WallFitOptions& fit = {});
  ~WallCalibrator();
  WallCalibrator(WallCalibrator&&) noexcept;

  /// Adds an undistorted depth image and, if it is known, the true plane in the camera's frame.
  /// Throws InputError if the image is not of the camera's size.
  void add(const std::vector<float>& depth, const std::optional<Plane>& plane = std::nullopt);

  /// Throws InputError if too few images show a wall or all show it at one distance.
  DepthCalibration calibrate() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
