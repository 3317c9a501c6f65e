// ChArUco boards by OpenCV; no other file of this room sees its types of markers.
#include <algorithm>

#include <fmt/format.h>

#include "core/median.hpp"
#include "symscene/calibration/charuco.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_ARUCO
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>

#include "core/opencv_memory.hpp"
#include "opencv_images.hpp"
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_ARUCO

namespace {

[[noreturn]] void throw_no_aruco() {
  throw InputError("ChArUco boards",
                   "a build with OpenCV's module aruco (install libopencv-contrib-dev and build "
                   "again)",
                   "one without");
}

}  // namespace

bool has_charuco() { return false; }

CharucoView find_charuco(std::span<const std::uint8_t>, Index, Index, const CharucoBoard&) {
  throw_no_aruco();
}
std::string find_other_dictionary(std::span<const std::uint8_t>, Index, Index, const std::string&) {
  throw_no_aruco();
}
CharucoPicture charuco_picture(const CharucoBoard&, Index) { throw_no_aruco(); }

#else

namespace {

using cv::aruco::Dictionary;

static_assert(cv::aruco::DICT_7X7_1000 == 15 && cv::aruco::DICT_APRILTAG_36h11 == 20);

/// `number` counts charuco_dictionaries().
cv::Ptr<Dictionary> dictionary_of(std::size_t number) {
  return cv::aruco::getPredefinedDictionary(static_cast<int>(number));
}

cv::Ptr<cv::aruco::CharucoBoard> layout_of(const CharucoBoard& board) {
  const auto names = charuco_dictionaries();
  const auto at = std::find(names.begin(), names.end(), board.dictionary);
  return cv::aruco::CharucoBoard::create(
      board.board.columns + 1, board.board.rows + 1, static_cast<float>(board.board.square),
      static_cast<float>(board.marker),
      dictionary_of(static_cast<std::size_t>(at - names.begin())));
}

struct Markers {
  std::vector<ImagePoints> corners;  ///< four per marker [px]
  std::vector<int> numbers;
};

/// Part of a square by which what a homography places may be off: a lens bends lines of squares.
constexpr double placement_tolerance = 0.25;

Markers markers_in(const cv::Mat& image, const cv::Ptr<Dictionary>& dictionary) {
  Markers found;
  cv::aruco::detectMarkers(image, dictionary, found.corners, found.numbers);
  return found;
}

template <class Point>
Point middle_of(const std::vector<Point>& corners) {
  Point sum = corners.front();
  for (std::size_t i = 1; i < corners.size(); ++i) sum += corners[i];
  return sum * (1.0F / static_cast<float>(corners.size()));
}

/// The homography from the image to the plane of the board by the centres of markers, which do not
/// depend on the size of the markers. Empty unless nearly all agree.
cv::Mat plane_homography(const Markers& markers, const cv::aruco::CharucoBoard& layout,
                         double square) {
  ImagePoints shown, placed;
  for (std::size_t i = 0; i < markers.numbers.size(); ++i) {
    const cv::Point3f p = middle_of(layout.objPoints[static_cast<std::size_t>(markers.numbers[i])]);
    shown.push_back(middle_of(markers.corners[i]));
    placed.emplace_back(p.x, p.y);
  }
  constexpr double least_share = 0.8;
  cv::Mat agrees;
  const cv::Mat homography =
      cv::findHomography(shown, placed, cv::RANSAC, placement_tolerance * square, agrees);
  const bool is_board = !homography.empty() &&
                        cv::countNonZero(agrees) >= least_share * static_cast<double>(shown.size());
  return is_board ? homography : cv::Mat();
}

/// Median edge of the markers in the plane of the board. [m]
double marker_edge(const Markers& markers, const cv::Mat& homography) {
  std::vector<double> edges;
  for (const ImagePoints& shown : markers.corners) {
    ImagePoints placed;
    cv::perspectiveTransform(shown, placed, homography);
    for (std::size_t i = 0; i < placed.size(); ++i)
      edges.push_back(cv::norm(placed[i] - placed[(i + 1) % placed.size()]));
  }
  return median(std::move(edges)).value_or(0.0);
}

/// What the markers tell of an image: the homography to the plane of the board, or why there is
/// none.
struct Placement {
  cv::Mat homography;
  std::string reason;
};

Placement placement_of(const Markers& markers, const CharucoBoard& board,
                       const cv::aruco::CharucoBoard& layout) {
  constexpr std::size_t least_markers = 4;
  const int greatest = markers.numbers.empty()
                           ? 0
                           : *std::max_element(markers.numbers.begin(), markers.numbers.end());
  if (static_cast<std::size_t>(greatest) >= layout.ids.size())
    return {{},
            fmt::format("marker {} is in view, a board of {}x{} corners has those up to {}",
                        greatest, board.board.columns, board.board.rows, layout.ids.size() - 1)};
  if (markers.numbers.size() < least_markers)
    return {{},
            fmt::format("{} markers of {}, at least {} are needed", markers.numbers.size(),
                        board.dictionary, least_markers)};
  Placement placement{plane_homography(markers, layout, board.board.square), {}};
  if (placement.homography.empty()) {
    placement.reason = fmt::format("the markers are not where a board of {}x{} corners has them",
                                   board.board.columns, board.board.rows);
    return placement;
  }
  constexpr double tolerance = 0.1;
  const double edge = marker_edge(markers, placement.homography);
  if (std::abs(edge / board.marker - 1.0) > tolerance)
    placement.reason =
        fmt::format("markers of about {:.1f} mm where squares have {:.1f} mm, instead of {:.1f} mm",
                    1e3 * edge, 1e3 * board.board.square, 1e3 * board.marker);
  return placement;
}

/// Corners between markers. Few of OpenCV 4.6 are those of another square: corners far from where
/// the markers have them are left out.
BoardImage corners_between(const Markers& markers, const cv::Mat& image, const Board& board,
                           const cv::Ptr<cv::aruco::CharucoBoard>& layout,
                           const cv::Mat& homography) {
  ImagePoints corners, placed;
  std::vector<int> numbers;
  cv::aruco::interpolateCornersCharuco(markers.corners, markers.numbers, image, layout, corners,
                                       numbers);
  BoardImage found;
  if (corners.empty()) return found;
  cv::perspectiveTransform(corners, placed, homography);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto number = static_cast<std::size_t>(numbers[i]);
    const cv::Point3f& p = layout->chessboardCorners[number];
    if (cv::norm(placed[i] - cv::Point2f(p.x, p.y)) > placement_tolerance * board.square) continue;
    // From 4.5.4 on they are half a pixel off: the middle of the first pixel is at (0.5, 0.5).
    found.corners.emplace_back(corners[i].x - 0.5, corners[i].y - 0.5);
    found.numbers.push_back(number);
  }
  return found;
}

bool are_on_a_line(const std::vector<std::size_t>& numbers, const Board& board) {
  const Eigen::Vector3d first = board.corner(numbers.front());
  const Eigen::Vector3d along = board.corner(numbers.back()) - first;
  return std::all_of(numbers.begin(), numbers.end(), [&](std::size_t i) {
    return along.cross(board.corner(i) - first).norm() < 1e-6 * board.square * board.square;
  });
}

}  // namespace

bool has_charuco() { return true; }

CharucoView find_charuco(std::span<const std::uint8_t> grey, Index width, Index height,
                         const CharucoBoard& board) try {
  board.validate();
  const cv::Mat image = image_of(grey, width, height);
  const auto layout = layout_of(board);
  const Markers markers = markers_in(image, layout->dictionary);
  CharucoView view;
  view.markers = markers.numbers.size();
  const Placement placement = placement_of(markers, board, *layout);
  view.reason = placement.reason;
  if (!view.is_found()) return view;
  BoardImage found = corners_between(markers, image, board.board, layout, placement.homography);
  if (found.corners.size() >= BoardImage::least_corners &&
      !are_on_a_line(found.numbers, board.board))
    view.image = std::move(found);
  else
    view.reason = fmt::format("{} corners between markers, at least {} in two rows are needed",
                              found.corners.size(), BoardImage::least_corners);
  return view;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

std::string find_other_dictionary(std::span<const std::uint8_t> grey, Index width, Index height,
                                  const std::string& dictionary) try {
  const cv::Mat image = image_of(grey, width, height);
  const auto names = charuco_dictionaries();
  // Small dictionaries of coarse markers mistake other patterns for theirs: a few do not count.
  std::size_t most = 3;
  std::string best;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == dictionary) continue;
    const std::size_t count = markers_in(image, dictionary_of(i)).numbers.size();
    if (count > most) most = count, best = names[i];
  }
  return best;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

CharucoPicture charuco_picture(const CharucoBoard& board, Index pixels_per_square) try {
  board.validate();
  CharucoPicture picture;
  picture.width = static_cast<Index>(board.board.columns + 1) * pixels_per_square;
  picture.height = static_cast<Index>(board.board.rows + 1) * pixels_per_square;
  cv::Mat image;
  layout_of(board)->draw({static_cast<int>(picture.width), static_cast<int>(picture.height)},
                         image);
  picture.grey.assign(image.begin<std::uint8_t>(), image.end<std::uint8_t>());
  return picture;
} catch (const cv::Exception& error) {
  rethrow_opencv(error);
}

#endif

}  // namespace symscene
