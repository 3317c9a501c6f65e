#include "calibrate.hpp"

#include <charconv>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "symscene/core/error.hpp"

namespace symscene::app {
namespace {

/// The number that begins a text; what follows it is left in the text.
template <class Number>
std::optional<Number> number_at_front(std::string_view& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

double metres_of(const char* option, const char* what, const std::string& text) {
  std::string_view rest = text;
  const auto metres = number_at_front<double>(rest);
  if (!metres || !rest.empty())
    throw InputError(option, fmt::format("the edge of a {} in metres, like 0.0245", what),
                     text.empty() ? "none" : text);
  return *metres;
}

std::string size_of(const Board& board) { return fmt::format("{}x{}", board.columns, board.rows); }

/// Throws InputError with the name of the option whose value is wrong.
void validate_option(const BoardTarget& target) try {
  if (target.charuco)
    target.charuco->validate();
  else
    target.board.validate();
} catch (const InputError& error) {
  const char* const option = error.where() == "dictionary" ? "--charuco"
                             : error.where() == "marker"   ? "--marker"
                                                           : "--board";
  throw InputError(option, error.expected(), error.found());
}

}  // namespace

void BoardTarget::require_finder() const {
  // Each throws where it is missing.
  if (!has_board_calibration()) find_board({}, 0, 0, board);
  if (charuco && !has_charuco()) find_charuco({}, 0, 0, *charuco);
}

CharucoView BoardTarget::find(const std::vector<std::uint8_t>& grey, Index width,
                              Index height) const {
  if (charuco) return find_charuco(grey, width, height, *charuco);
  CharucoView view;
  auto corners = find_board(grey, width, height, board);
  if (corners)
    view.image.corners = std::move(*corners);
  else
    view.reason = "no board of " + size_of(board) + " corners";
  return view;
}

void BoardTarget::refuse_other(const std::vector<std::uint8_t>& grey, Index width, Index height,
                               const CharucoView& view) const {
  if (!charuco) {
    const auto other = find_other_board(grey, width, height, board);
    if (!other) return;
    throw InputError("--board",
                     fmt::format("the board that the images show, {} corners", size_of(*other)),
                     size_of(board));
  }
  if (view.markers > 0)
    throw InputError("--charuco",
                     fmt::format("a board of {} corners with markers of {}", size_of(board),
                                 charuco->dictionary),
                     view.reason);
  const std::string other = find_other_dictionary(grey, width, height, charuco->dictionary);
  if (!other.empty())
    throw InputError("--charuco", "the markers that the images show, " + other,
                     charuco->dictionary);
}

void BoardArguments::add_to(Arguments& arguments) {
  arguments.text("--board", "COLUMNSxROWS", size,
                 "corners of the checkerboard where four squares meet, along both edges, e.g. 8x6");
  arguments.text("--square", "METRES", square, "edge of a square [m], e.g. 0.0245");
  const auto names = charuco_dictionaries();
  arguments.choice("--charuco", dictionary, {names.begin(), names.end()},
                   "the board is a ChArUco board with markers of this dictionary of OpenCV; images "
                   "may show parts of it");
  arguments.text("--marker", "METRES", marker,
                 "edge of its markers with their black border [m], e.g. 0.018");
}

bool BoardArguments::are_given() const {
  return !size.empty() || !square.empty() || !dictionary.empty() || !marker.empty();
}

BoardTarget BoardArguments::target() const {
  std::string_view rest = size;
  const auto columns = number_at_front<int>(rest);
  const bool has_cross = rest.starts_with('x');
  if (has_cross) rest.remove_prefix(1);
  const auto rows = number_at_front<int>(rest);
  if (!columns || !has_cross || !rows || !rest.empty())
    throw InputError("--board", "the number of inner corners, like 8x6",
                     size.empty() ? "none" : size);
  BoardTarget target{{*columns, *rows, metres_of("--square", "square", square)}, std::nullopt};
  if (dictionary.empty() && !marker.empty())
    throw InputError("--marker", "--charuco with the dictionary of the markers", "none");
  if (!dictionary.empty())
    target.charuco =
        CharucoBoard{target.board, dictionary, metres_of("--marker", "marker", marker)};
  validate_option(target);
  return target;
}

std::vector<std::uint8_t> grey_values(const Colors& colors) {
  std::vector<std::uint8_t> grey(static_cast<std::size_t>(colors.rows()));
  for (std::size_t i = 0; i < grey.size(); ++i) {
    const auto row = colors.row(static_cast<Eigen::Index>(i));
    grey[i] =
        static_cast<std::uint8_t>((299U * row[0] + 587U * row[1] + 114U * row[2] + 500U) / 1000U);
  }
  return grey;
}

void add_calibrate(CommandLine& line) {
  CLI::App* const group =
      line.parser.add_subcommand("calibrate", "Calibrate a depth camera: lens and depth");
  group->require_subcommand(1);
  group->footer(
      "Example:\n"
      "  symscene calibrate intrinsics images --board 8x6 --square 0.0245 -o camera.yaml\n"
      "  symscene calibrate intrinsics images --board 8x6 --square 0.03 --charuco DICT_5X5_50 "
      "--marker 0.022 -o camera.yaml\n"
      "  symscene calibrate depth walls --wall --intrinsics camera.yaml -o camera.yaml\n"
      "  symscene reconstruct sweep --intrinsics camera.yaml -o scene");
  CommandLine inner{*group, {}};
  add_calibrate_intrinsics(inner);
  add_calibrate_depth(inner);
  for (const ConfigurableCommand& command : inner.configurable)
    line.configurable.push_back({"calibrate " + command.name, command.configure});
}

}  // namespace symscene::app
