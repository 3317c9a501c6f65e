// The corners of checkerboards in images, by OpenCV.
#include "symscene/calibration/intrinsic_calibration.hpp"
#include "without_opencv.hpp"

#ifdef SYMSCENE_HAS_OPENCV
#include <opencv2/calib3d.hpp>

#include "core/opencv_memory.hpp"
#include "opencv_images.hpp"
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_OPENCV

std::optional<std::vector<Eigen::Vector2d>> find_board(std::span<const std::uint8_t>, Index, Index,
                                                       const Board&) {
  throw_no_opencv();
}
std::optional<Board> find_other_board(std::span<const std::uint8_t>, Index, Index, const Board&) {
  throw_no_opencv();
}

#else

std::optional<std::vector<Eigen::Vector2d>> find_board(std::span<const std::uint8_t> grey,
                                                       Index width, Index height,
                                                       const Board& board) try {
  board.validate();
  const cv::Mat image = image_of(grey, width, height);
  ImagePoints corners;
  const bool found =
      cv::findChessboardCornersSB(image, {board.columns, board.rows}, corners,
                                  cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_ACCURACY);
  if (!found || corners.size() != board.corners()) return std::nullopt;
  std::vector<Eigen::Vector2d> result;
  for (const cv::Point2f& p : corners) result.emplace_back(p.x, p.y);
  return result;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

std::optional<Board> find_other_board(std::span<const std::uint8_t> grey, Index width, Index height,
                                      const Board& board) try {
  const cv::Mat image = image_of(grey, width, height);
  ImagePoints corners;
  cv::Mat pattern;
  // Grown from the smallest board that there is.
  const bool found = cv::findChessboardCornersSB(
      image, {3, 3}, corners, cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_LARGER, pattern);
  if (!found) return std::nullopt;
  const Board other{pattern.cols, pattern.rows, board.square};
  const bool same = (other.columns == board.columns && other.rows == board.rows) ||
                    (other.columns == board.rows && other.rows == board.columns);
  return same ? std::nullopt : std::optional(other);
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

#endif

}  // namespace symscene
