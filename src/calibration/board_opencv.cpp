// Calibration by the corners of boards, with OpenCV.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/median.hpp"
#include "symscene/calibration/intrinsic_calibration.hpp"
#include "symscene/core/error.hpp"
#include "without_opencv.hpp"

#ifdef SYMSCENE_HAS_OPENCV
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/opencv_memory.hpp"
#include "opencv_images.hpp"
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_OPENCV

bool has_board_calibration() { return false; }

IntrinsicCalibration calibrate_intrinsics(std::span<const BoardImage>, Index, Index, const Board&,
                                          const IntrinsicCalibrationOptions&) {
  throw_no_opencv();
}
std::optional<Eigen::Isometry3d> board_pose(const BoardImage&, const CameraModel&, const Board&) {
  throw_no_opencv();
}
ColorPose calibrate_color_pose(std::span<const BoardImage>, std::span<const BoardImage>,
                               const CameraModel&, const CameraModel&, const Board&) {
  throw_no_opencv();
}

#else

namespace {

using BoardPoints = std::vector<cv::Point3f>;

/// On the board, the corners that an image shows.
BoardPoints board_points(const BoardImage& image, const Board& board) {
  BoardPoints points;
  for (std::size_t i = 0; i < image.corners.size(); ++i) {
    const Eigen::Vector3f p = board.corner(image.number(i)).cast<float>();
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

ImagePoints points_of(const std::vector<Eigen::Vector2d>& corners) {
  ImagePoints points;
  for (const Eigen::Vector2d& p : corners)
    points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  return points;
}

cv::Mat matrix_of(const CameraIntrinsics& camera) {
  return (cv::Mat_<double>(3, 3) << camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0,
          1.0);
}

cv::Mat coefficients_of(const LensDistortion& lens) {
  return (cv::Mat_<double>(1, 5) << lens.k1, lens.k2, lens.p1, lens.p2, lens.k3);
}

Eigen::Isometry3d pose_of(const cv::Mat& rotation, const cv::Mat& translation) {
  cv::Mat R = rotation;
  if (rotation.total() == 3) cv::Rodrigues(rotation, R);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose.linear()(i, j) = R.at<double>(i, j);
    pose.translation()[i] = translation.at<double>(i);
  }
  return pose;
}

void require_corners(const BoardImage& image, const Board& board) {
  const std::size_t count = image.corners.size();
  if (image.numbers.empty()) {
    if (count != board.corners())
      throw InputError(image.name, fmt::format("{} corners", board.corners()),
                       fmt::format("{}", count));
    return;
  }
  const bool are_on_board =
      std::all_of(image.numbers.begin(), image.numbers.end(),
                  [&](std::size_t number) { return number < board.corners(); });
  if (image.numbers.size() != count || count < BoardImage::least_corners || !are_on_board)
    throw InputError(image.name,
                     fmt::format("at least {} corners, each with a number below {}",
                                 BoardImage::least_corners, board.corners()),
                     fmt::format("{} corners and {} numbers", count, image.numbers.size()));
}

void require_count(std::size_t count, int least) {
  if (count < static_cast<std::size_t>(least))
    throw InputError("images of the board",
                     fmt::format("at least {} (record it at different places of the image, near "
                                 "and far, and turned up to 45 degrees to all sides)",
                                 least),
                     fmt::format("{}", count));
}

void require_images(std::span<const BoardImage> images, int least, const Board& board) {
  for (const BoardImage& image : images) require_corners(image, board);
  require_count(images.size(), least);
}

/// The corners that both images of a pair show, in one order.
std::pair<BoardImage, BoardImage> shared_corners(const BoardImage& a, const BoardImage& b) {
  std::map<std::size_t, std::size_t> places;  // in b, by number
  for (std::size_t i = 0; i < b.corners.size(); ++i) places.emplace(b.number(i), i);
  std::pair<BoardImage, BoardImage> shared;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    const auto at = places.find(a.number(i));
    if (at == places.end()) continue;
    shared.first.corners.push_back(a.corners[i]);
    shared.first.numbers.push_back(a.number(i));
    shared.second.corners.push_back(b.corners[at->second]);
    shared.second.numbers.push_back(a.number(i));
  }
  return shared;
}

/// The outcome of one call of OpenCV.
struct Solution {
  cv::Mat matrix, coefficients, deviations, errors;
  std::vector<cv::Mat> rotations, translations;
};

Solution solve(const std::vector<BoardPoints>& points, const std::vector<ImagePoints>& images,
               cv::Size size, bool fits_k3) {
  Solution solution;
  cv::Mat extrinsic_deviations;
  const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-10);
  cv::calibrateCamera(points, images, size, solution.matrix, solution.coefficients,
                      solution.rotations, solution.translations, solution.deviations,
                      extrinsic_deviations, solution.errors, fits_k3 ? 0 : cv::CALIB_FIX_K3, until);
  return solution;
}

CameraModel model_of(const cv::Mat& K, const cv::Mat& coefficients, Index width, Index height) {
  const auto d = [&](int i) { return coefficients.at<double>(i); };
  CameraModel camera;
  camera.intrinsics = {width,
                       height,
                       K.at<double>(0, 0),
                       K.at<double>(1, 1),
                       K.at<double>(0, 2),
                       K.at<double>(1, 2)};
  camera.distortion = {d(0), d(1), d(2), d(3), d(4)};
  return camera;
}

/// Corners as measured less where the calibrated camera shows them.
std::vector<Eigen::Vector2d> residuals_of(const BoardImage& image, const CameraModel& camera,
                                          const Eigen::Isometry3d& T_camera_board,
                                          const Board& board) {
  std::vector<Eigen::Vector2d> residuals;
  for (std::size_t i = 0; i < image.corners.size(); ++i) {
    const Eigen::Vector3d point = T_camera_board * board.corner(image.number(i));
    const Eigen::Vector2d shown = camera.distortion.distorted(point.hnormalized());
    const CameraIntrinsics& K = camera.intrinsics;
    residuals.push_back(image.corners[i] -
                        Eigen::Vector2d(K.fx * shown.x() + K.cx, K.fy * shown.y() + K.cy));
  }
  return residuals;
}

double root_mean_square_of(const std::vector<Eigen::Vector2d>& residuals) {
  double sum = 0.0;
  for (const Eigen::Vector2d& r : residuals) sum += r.squaredNorm();
  return residuals.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(residuals.size()));
}

/// Whether the image with the greatest error was left out.
bool leave_out_worst(std::vector<std::size_t>& used, const Solution& solution, double ratio,
                     std::vector<BoardViewReport>& views) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < used.size(); ++k)
    errors.push_back(solution.errors.at<double>(static_cast<int>(k)));
  const auto worst = std::max_element(errors.begin(), errors.end());
  const auto at = static_cast<std::size_t>(worst - errors.begin());
  const double greatest = *worst;
  const double middle = *median(std::move(errors));
  if (greatest <= ratio * middle) return false;
  views[used[at]].reason = fmt::format(
      "its reprojection error of {:.2f} px is {:.1f} times the "
      "median of the images",
      greatest, greatest / middle);
  views[used[at]].error = greatest;
  used.erase(used.begin() + static_cast<std::ptrdiff_t>(at));
  return true;
}

double coverage_of(std::span<const BoardImage> images, const std::vector<std::size_t>& used,
                   Index width, Index height) {
  constexpr int columns = 8, rows = 6;
  std::vector<bool> holds(columns * rows);
  for (const std::size_t i : used) {
    for (const Eigen::Vector2d& p : images[i].corners) {
      const int x = std::clamp(static_cast<int>((p.x() + 0.5) * columns / width), 0, columns - 1);
      const int y = std::clamp(static_cast<int>((p.y() + 0.5) * rows / height), 0, rows - 1);
      holds[static_cast<std::size_t>(y * columns + x)] = true;
    }
  }
  return static_cast<double>(std::count(holds.begin(), holds.end(), true)) / (columns * rows);
}

/// Throws InputError if no board is turned against the image by at least `min_tilt`.
void require_tilt(const IntrinsicCalibration& found, double min_tilt) {
  double greatest = 0.0;
  for (const BoardViewReport& view : found.views) {
    const double cosine = std::abs(view.T_camera_board.linear()(2, 2));
    if (view.used) greatest = std::max(greatest, std::acos(std::min(1.0, cosine)));
  }
  if (greatest >= min_tilt) return;
  throw InputError(
      "images of the board",
      fmt::format("a board that is turned against the image by {:.0f} to 45 degrees, to "
                  "different sides, in some images (parallel to it, focal length and "
                  "distance cannot be told apart)",
                  degrees(min_tilt)),
      fmt::format("at most {:.0f} degrees", degrees(greatest)));
}

}  // namespace

bool has_board_calibration() { return true; }

IntrinsicCalibration calibrate_intrinsics(std::span<const BoardImage> images, Index width,
                                          Index height, const Board& board,
                                          const IntrinsicCalibrationOptions& options) try {
  board.validate();
  options.validate();
  require_images(images, options.min_views, board);
  IntrinsicCalibration result;
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < images.size(); ++i) {
    result.views.push_back({images[i].name, false, "", 0.0, Eigen::Isometry3d::Identity(), {}});
    used.push_back(i);
  }
  const cv::Size size(static_cast<int>(width), static_cast<int>(height));
  Solution solution;
  do {
    require_count(used.size(), options.min_views);
    std::vector<BoardPoints> placed;
    std::vector<ImagePoints> shown;
    for (const std::size_t i : used) {
      placed.push_back(board_points(images[i], board));
      shown.push_back(points_of(images[i].corners));
    }
    solution = solve(placed, shown, size, options.fits_k3);
  } while (leave_out_worst(used, solution, options.max_error_ratio, result.views));
  result.camera = model_of(solution.matrix, solution.coefficients, width, height);
  result.focal_deviation = solution.deviations.at<double>(0);
  result.center_deviation =
      std::max(solution.deviations.at<double>(2), solution.deviations.at<double>(3));
  std::vector<Eigen::Vector2d> all;
  for (std::size_t k = 0; k < used.size(); ++k) {
    BoardViewReport& view = result.views[used[k]];
    view.used = true;
    view.T_camera_board = pose_of(solution.rotations[k], solution.translations[k]);
    view.residuals = residuals_of(images[used[k]], result.camera, view.T_camera_board, board);
    view.error = root_mean_square_of(view.residuals);
    all.insert(all.end(), view.residuals.begin(), view.residuals.end());
  }
  result.error = root_mean_square_of(all);
  require_tilt(result, options.min_tilt);
  result.coverage = coverage_of(images, used, width, height);
  constexpr double enough = 0.6;
  if (result.coverage < enough)
    result.warnings.push_back(
        fmt::format("corners were seen in {:.0f} % of the image: distortion elsewhere is a guess "
                    "(record the board in the other parts)",
                    100.0 * result.coverage));
  return result;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

std::optional<Eigen::Isometry3d> board_pose(const BoardImage& image, const CameraModel& camera,
                                            const Board& board) try {
  board.validate();
  require_corners(image, board);
  const BoardPoints placed = board_points(image, board);
  const ImagePoints shown = points_of(image.corners);
  const cv::Mat matrix = matrix_of(camera.intrinsics);
  const cv::Mat coefficients = coefficients_of(camera.distortion);
  cv::Mat rotation, translation;
  const bool found = cv::solvePnP(placed, shown, matrix, coefficients, rotation, translation, false,
                                  cv::SOLVEPNP_IPPE);
  if (!found) return std::nullopt;
  cv::solvePnPRefineLM(placed, shown, matrix, coefficients, rotation, translation);
  return pose_of(rotation, translation);
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

ColorPose calibrate_color_pose(std::span<const BoardImage> depth_images,
                               std::span<const BoardImage> color_images, const CameraModel& depth,
                               const CameraModel& color, const Board& board) try {
  board.validate();
  if (depth_images.size() != color_images.size())
    throw InputError("pairs of images", fmt::format("{} colour images", depth_images.size()),
                     fmt::format("{}", color_images.size()));
  constexpr int least_pairs = 3;
  require_images(depth_images, least_pairs, board);
  require_images(color_images, least_pairs, board);
  std::vector<BoardPoints> points;
  std::vector<ImagePoints> first, second;
  for (std::size_t i = 0; i < depth_images.size(); ++i) {
    const auto [one, other] = shared_corners(depth_images[i], color_images[i]);
    if (one.corners.size() < BoardImage::least_corners) continue;
    points.push_back(board_points(one, board));
    first.push_back(points_of(one.corners));
    second.push_back(points_of(other.corners));
  }
  require_count(points.size(), least_pairs);
  cv::Mat K1 = matrix_of(depth.intrinsics), d1 = coefficients_of(depth.distortion);
  cv::Mat K2 = matrix_of(color.intrinsics), d2 = coefficients_of(color.distortion);
  cv::Mat R, t, E, F;
  ColorPose pose;
  pose.pairs = first.size();
  const bool fits_k3 = depth.distortion.k3 != 0.0 || color.distortion.k3 != 0.0;
  const int flags = cv::CALIB_USE_INTRINSIC_GUESS | (fits_k3 ? 0 : cv::CALIB_FIX_K3);
  const cv::Size size(static_cast<int>(depth.intrinsics.width),
                      static_cast<int>(depth.intrinsics.height));
  const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-10);
  pose.error =
      cv::stereoCalibrate(points, first, second, K1, d1, K2, d2, size, R, t, E, F, flags, until);
  pose.depth = model_of(K1, d1, depth.intrinsics.width, depth.intrinsics.height);
  pose.color = model_of(K2, d2, color.intrinsics.width, color.intrinsics.height);
  // OpenCV maps the frame of the first camera to that of the second.
  pose.T_depth_color = pose_of(R, t).inverse();
  return pose;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

#endif

}  // namespace symscene
