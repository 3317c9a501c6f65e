#pragma once

#include <span>
#include <string>

#include "arguments.hpp"
#include "symscene/calibration/depth_calibration.hpp"
#include "symscene/calibration/intrinsic_calibration.hpp"

namespace symscene::app {

// The two commands of `symscene calibrate`.
void add_calibrate_intrinsics(CommandLine& line);
void add_calibrate_depth(CommandLine& line);

/// --board and --square.
struct BoardArguments {
  std::string size;
  std::string square;

  void add_to(Arguments& arguments);
  /// Throws InputError if they are not like 8x6 and 0.0245.
  Board board() const;
};

/// Luma of Rec. 601.
std::vector<std::uint8_t> grey_values(const Colors& colors);

/// A page with coverage and residual vectors of every image. Self-contained, without scripts.
std::string intrinsics_page(const IntrinsicCalibration& found, std::span<const BoardImage> images);

/// A page with maps of the correction at every range and a table of the images.
std::string depth_page(const DepthCalibration& found);

}  // namespace symscene::app
