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

}  // namespace

void BoardArguments::add_to(Arguments& arguments) {
  arguments.text("--board", "COLUMNSxROWS", size,
                 "corners of the checkerboard where four squares meet, along both edges, e.g. 8x6");
  arguments.text("--square", "METRES", square, "edge of a square [m], e.g. 0.0245");
}

Board BoardArguments::board() const {
  Board board;
  std::string_view rest = size;
  const auto columns = number_at_front<int>(rest);
  const bool has_cross = rest.starts_with('x');
  if (has_cross) rest.remove_prefix(1);
  const auto rows = number_at_front<int>(rest);
  if (!columns || !has_cross || !rows || !rest.empty())
    throw InputError("--board", "the number of inner corners, like 8x6",
                     size.empty() ? "none" : size);
  std::string_view edge = square;
  const auto metres = number_at_front<double>(edge);
  if (!metres || !edge.empty())
    throw InputError("--square", "the edge of a square in metres, like 0.0245",
                     square.empty() ? "none" : square);
  board = {*columns, *rows, *metres};
  board.validate();
  return board;
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
      "  symscene calibrate depth walls --wall --intrinsics camera.yaml -o camera.yaml\n"
      "  symscene reconstruct sweep --intrinsics camera.yaml -o scene");
  CommandLine inner{*group, {}};
  add_calibrate_intrinsics(inner);
  add_calibrate_depth(inner);
  for (const ConfigurableCommand& command : inner.configurable)
    line.configurable.push_back({"calibrate " + command.name, command.configure});
}

}  // namespace symscene::app
