#pragma once

#include <optional>
#include <span>
#include <string>

#include "arguments.hpp"
#include "symscene/calibration/charuco.hpp"
#include "symscene/calibration/depth_calibration.hpp"
#include "symscene/calibration/intrinsic_calibration.hpp"

namespace symscene::app {

// The two commands of `symscene calibrate`.
void add_calibrate_intrinsics(CommandLine& line);
void add_calibrate_depth(CommandLine& line);

/// The board that is looked for: a plain checkerboard, or one with markers.
struct BoardTarget {
  Board board;
  std::optional<CharucoBoard> charuco;

  /// Throws InputError, which tells what to install, if this build cannot find it.
  void require_finder() const;
  /// The corners in a grey image, or why there are none.
  CharucoView find(const std::vector<std::uint8_t>& grey, Index width, Index height) const;
  /// Throws InputError if the image, in which `view` found no board, shows another one.
  void refuse_other(const std::vector<std::uint8_t>& grey, Index width, Index height,
                    const CharucoView& view) const;
};

/// --board, --square, --charuco and --marker.
struct BoardArguments {
  std::string size;
  std::string square;
  std::string dictionary;
  std::string marker;

  void add_to(Arguments& arguments);
  bool are_given() const;
  /// Throws InputError if they are not like 8x6 and 0.0245.
  BoardTarget target() const;
};

/// Luma of Rec. 601.
std::vector<std::uint8_t> grey_values(const Colors& colors);

/// A page with coverage and residual vectors of every image. Self-contained, without scripts.
std::string intrinsics_page(const IntrinsicCalibration& found, std::span<const BoardImage> images);

/// A page with maps of the correction at every range and a table of the images.
std::string depth_page(const DepthCalibration& found);

}  // namespace symscene::app
