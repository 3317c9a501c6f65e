#include "symscene/calibration/charuco.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::array dictionaries{
    "DICT_4X4_50",         "DICT_4X4_100",       "DICT_4X4_250",       "DICT_4X4_1000",
    "DICT_5X5_50",         "DICT_5X5_100",       "DICT_5X5_250",       "DICT_5X5_1000",
    "DICT_6X6_50",         "DICT_6X6_100",       "DICT_6X6_250",       "DICT_6X6_1000",
    "DICT_7X7_50",         "DICT_7X7_100",       "DICT_7X7_250",       "DICT_7X7_1000",
    "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_16h5", "DICT_APRILTAG_25h9", "DICT_APRILTAG_36h10",
    "DICT_APRILTAG_36h11"};
constexpr std::array<std::size_t, dictionaries.size()> markers_of{
    50,   100, 250, 1000, 50,   100,  250, 1000, 50,   100, 250,
    1000, 50,  100, 250,  1000, 1024, 30,  35,   2320, 587};

}  // namespace

std::span<const char* const> charuco_dictionaries() { return dictionaries; }

void CharucoBoard::validate() const {
  board.validate();
  const auto at = std::find(dictionaries.begin(), dictionaries.end(), dictionary);
  if (at == dictionaries.end())
    throw InputError("dictionary", fmt::format("one of {}", fmt::join(dictionaries, ", ")),
                     dictionary.empty() ? "none" : dictionary);
  const std::size_t most = markers_of[static_cast<std::size_t>(at - dictionaries.begin())];
  if (markers() > most)
    throw InputError("dictionary",
                     fmt::format("one of at least {} markers, as a board of {}x{} corners has",
                                 markers(), board.columns, board.rows),
                     fmt::format("{} with {}", dictionary, most));
  if (!(marker > 0.0 && marker < board.square))
    throw InputError("marker",
                     fmt::format("an edge between 0 and that of a square, {} m", board.square),
                     fmt::format("{} m", marker));
}

}  // namespace symscene
