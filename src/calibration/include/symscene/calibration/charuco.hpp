#pragma once

#include <span>
#include <string>
#include <vector>

#include "symscene/calibration/intrinsic_calibration.hpp"

namespace symscene {

/// A checkerboard with a marker in each white square. Markers tell which corners an image shows, so
/// that parts of the board are enough (Garrido-Jurado et al. 2014). Its first square is black and
/// markers are numbered row by row, as OpenCV draws it from version 4.6 on.
struct CharucoBoard {
  Board board;
  std::string dictionary;  ///< one of charuco_dictionaries()
  double marker = 0.0;     ///< edge of a marker with its black border [m]

  /// Markers on the board.
  std::size_t markers() const {
    return static_cast<std::size_t>((board.columns + 1) * (board.rows + 1) / 2);
  }
  /// Throws InputError unless the board is valid, the dictionary is known and has enough markers,
  /// and markers are smaller than squares.
  void validate() const;
};

/// Names of OpenCV's sets of markers, such as DICT_4X4_50, in the order of its enumeration.
std::span<const char* const> charuco_dictionaries();

/// What an image shows of a board.
struct CharucoView {
  BoardImage image;         ///< without name; no corners unless it was found
  std::size_t markers = 0;  ///< markers of the dictionary in the image
  std::string reason;       ///< why the board was not found

  bool is_found() const { return reason.empty(); }
};

/// Whether this build can find such boards (OpenCV's contrib package is optional).
bool has_charuco();

/// The corners of a board in a grey image, to a fraction of a pixel. An image of at least four
/// markers and six corners is enough. Boards whose markers stand elsewhere or have another size
/// than said are not found. Throws InputError if the number of pixels is not that of the size or
/// this build cannot.
CharucoView find_charuco(std::span<const std::uint8_t> grey, Index width, Index height,
                         const CharucoBoard& board);

/// The dictionary of the most markers of an image, other than `dictionary`; of those with as many
/// the first. Empty without markers. Throws as find_charuco().
std::string find_other_dictionary(std::span<const std::uint8_t> grey, Index width, Index height,
                                  const std::string& dictionary);

/// A board as it is printed.
struct CharucoPicture {
  Index width = 0;
  Index height = 0;
  std::vector<std::uint8_t> grey;  ///< row by row; the first corner is one square from both edges
};

/// Throws InputError if this build cannot.
CharucoPicture charuco_picture(const CharucoBoard& board, Index pixels_per_square);

}  // namespace symscene
