#include "arguments.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "print.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/camera_file.hpp"
#include "symscene/io/intrinsics.hpp"
#include "value_checks.hpp"

namespace symscene::app {
namespace fs = std::filesystem;

namespace {

/// The four numbers of "fx,fy,cx,cy", or the camera of a file; nothing if it is neither.
std::optional<CameraIntrinsics> parse_intrinsics_option(const std::string& text) {
  if (fs::is_regular_file(text)) return read_intrinsics(text);
  std::array<double, 4> numbers{};
  const char* rest = text.data();
  const char* const end = rest + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (rest == end || *rest++ != ',')) return std::nullopt;
    const auto [after, error] = std::from_chars(rest, end, numbers[i]);
    if (error != std::errc{} || !std::isfinite(numbers[i])) return std::nullopt;
    rest = after;
  }
  if (rest != end) return std::nullopt;
  return CameraIntrinsics{0, 0, numbers[0], numbers[1], numbers[2], numbers[3]};
}

bool names_camera_file(const std::string& text) {
  return is_camera_file(text) && fs::is_regular_file(text);
}

/// Without links, dots and a slash at the end.
fs::path plain_path(const fs::path& path) {
  const fs::path plain = fs::weakly_canonical(fs::absolute(path));
  return plain.has_filename() ? plain : plain.parent_path();
}

/// The way from `input` to `output` if that is the input or in it; empty if it is the input.
std::optional<fs::path> path_within(const fs::path& output, const fs::path& input) {
  const fs::path in = plain_path(input), out = plain_path(output);
  const auto [end_of_in, position] = std::mismatch(in.begin(), in.end(), out.begin(), out.end());
  if (end_of_in != in.end()) return std::nullopt;
  const fs::path way = out.lexically_relative(in);
  return way == "." ? fs::path() : way;
}

/// The folders in which readers of sequences look (docs/formats.md).
bool is_folder_of_images(const std::string& name) {
  constexpr std::array names = {"depth", "color", "rgb", "image", "meshes"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string check_intrinsics(const std::string& text) {
  try {
    if (names_camera_file(text)) return read_camera_model(text), "";
    if (parse_intrinsics_option(text)) return "";
  } catch (const InputError& error) {
    return error.what();
  }
  return "expected fx,fy,cx,cy in pixels or a file like intrinsics.txt or camera.yaml, found " +
         text;
}

}  // namespace

void add_options_of_all(CommandLine& line, SharedOptions& before) {
  Arguments arguments(line);
  arguments.threads(before);
  arguments.reporting(before);
}

Arguments::Arguments(CommandLine& line) : line_(line), command_(line.parser) {}

Arguments::Arguments(CommandLine& line, const char* name, const char* summary, const char* example)
    : line_(line), command_(*line.parser.add_subcommand(name, summary)) {
  command_.footer(fmt::format("Example:\n  {}", example));
}

void Arguments::input(fs::path& value, const char* name, const std::string& help) {
  command_.add_option(name, value, help)->required()->type_name("");
}

void Arguments::inputs(std::vector<fs::path>& values, const char* name, const std::string& help) {
  command_.add_option(name, values, help)->required()->type_name("");
}

void Arguments::optional_input(fs::path& value, const char* name, const std::string& help) {
  command_.add_option(name, value, help)->type_name("");
}

void Arguments::words(std::vector<std::string>& values, const char* name, const std::string& help) {
  command_.add_option(name, values, help)->type_name("");
}

void Arguments::word(std::string& value, const char* name, const std::vector<std::string>& choices,
                     const std::string& help) {
  command_.add_option(name, value, help)
      ->required()
      ->type_name(fmt::format("{}", fmt::join(choices, "|")))
      ->check([choices](const std::string& text) { return check_choice(text, choices); });
}

void Arguments::output_folder(SharedOptions& shared, const std::string& help) {
  command_.add_option("-o,--output", shared.output, help)->required()->type_name("FOLDER");
}

void Arguments::optional_output_folder(SharedOptions& shared, const std::string& help) {
  command_.add_option("-o,--output", shared.output, help)->type_name("FOLDER");
}

void Arguments::output_file(SharedOptions& shared, const std::string& help,
                            const std::vector<std::string>& formats) {
  command_.add_option("-o,--output", shared.output, help)
      ->required()
      ->type_name("FILE")
      ->check([formats](const std::string& text) { return check_ending(text, formats); });
}

void Arguments::optional_output_file(SharedOptions& shared, const std::string& help) {
  command_.add_option("-o,--output", shared.output, help)->type_name("FILE");
}

void Arguments::file(const char* flag, fs::path& value, const std::string& help) {
  command_.add_option(flag, value, help)->type_name("FILE");
}

void Arguments::folder(const char* flag, fs::path& value, const std::string& help) {
  command_.add_option(flag, value, help)->type_name("FOLDER");
}

void Arguments::flag(const char* name, bool& value, const std::string& help) {
  command_.add_flag(name, value, help)->disable_flag_override();
}

void Arguments::choice(const char* flag, std::string& value,
                       const std::vector<std::string>& choices, const std::string& help) {
  command_.add_option(flag, value, help)
      ->type_name(fmt::format("{}", fmt::join(choices, "|")))
      ->check([choices](const std::string& text) { return check_choice(text, choices); });
}

void Arguments::text(const char* flag, const char* kind, std::string& value,
                     const std::string& help) {
  command_.add_option(flag, value, help)->type_name(kind);
}

void Arguments::count(const char* flag, std::optional<int>& value, const Range& range,
                      const std::string& help) {
  command_.add_option(flag, value, help)
      ->type_name("NUMBER")
      ->check([range](const std::string& text) { return check_whole_number(text, range); });
}

void Arguments::every(std::optional<int>& value, const std::string& help) {
  count("--every", value, between(1, 1000000), help);
}

void Arguments::sequence_options(SequenceOptions& options) {
  command_
      .add_option_function<std::string>(
          "--intrinsics",
          [&options](const std::string& text) {
            if (names_camera_file(text))
              options.camera = read_camera_model(text);
            else
              options.intrinsics = parse_intrinsics_option(text);
          },
          "focal lengths and principal point of the camera [px], a file like intrinsics.txt, or a "
          "calibrated camera (camera.yaml of symscene calibrate, camera_info of ROS), by which "
          "frames are undistorted and corrected; replaces that of the sequence")
      ->type_name("FX,FY,CX,CY|FILE")
      ->check(check_intrinsics);
  command_
      .add_option("--depth-scale", options.depth_scale,
                  "values of the depth images per metre, e.g. 1000; replaces that of the sequence")
      ->type_name("NUMBER")
      ->check(check_depth_scale);
}

void Arguments::seed(std::optional<std::uint64_t>& value, std::uint64_t default_seed) {
  command_
      .add_option("--seed", value,
                  fmt::format("seed of all random numbers (default {})", default_seed))
      ->type_name("NUMBER")
      ->check([](const std::string& text) { return check_whole_number(text, at_least(0)); });
}

void Arguments::threads(SharedOptions& shared) {
  command_
      .add_option("--threads", shared.threads,
                  "maximal number of threads, 0 for all cores; results do not depend on it")
      ->type_name("NUMBER")
      ->check([](const std::string& text) { return check_whole_number(text, between(0, 4096)); });
}

void Arguments::reporting(SharedOptions& shared) {
  flag("-v,--verbose", shared.verbose, "print the time of each stage");
  flag("-q,--quiet", shared.quiet, "print nothing but warnings and errors");
  flag("--json", shared.json,
       "print a line of JSON, and nothing else, on standard output; what people read "
       "goes to standard error");
}

void Arguments::config(SharedOptions& shared, const std::function<OptionFields()>& configure) {
  file("--config", shared.config, "JSON file with options of the stages, see `symscene options`");
  const auto dump = [configure](const CLI::results_t& values) {
    const std::string& form = values.back();
    if (form != "true" && form != "annotated")
      throw CLI::ValidationError("--dump-config", "expected nothing or annotated, found " + form);
    print_output(format_config(configure(), form == "annotated"));
    throw CLI::Success();
    return true;
  };
  command_
      .add_option("--dump-config", dump,
                  "print all options of the stages as JSON in the format of --config; "
                  "--dump-config=annotated adds unit, range and help as comments, which --config "
                  "reads too")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->expected(0);
  line_.configurable.push_back({command_.get_name(), configure});
}

void Arguments::config_with(const char* flag, std::function<OptionFields()> configure) {
  line_.configurable.push_back(
      {fmt::format("{} {}", command_.get_name(), flag), std::move(configure)});
}

void Arguments::run(std::function<void()> body) { command_.callback(std::move(body)); }

std::string folder_name(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

bool is_output_folder(const fs::path& folder) {
  constexpr std::array names = {"scene.json", "objects.json", "masks.json"};
  return std::any_of(names.begin(), names.end(), [&](const char* name) {
    std::error_code error;
    return fs::exists(folder / name, error);
  });
}

void require_not_input(const fs::path& output, const fs::path& input) {
  if (path_within(output, input))
    throw InputError(output.string(), "a path outside the input", "a path in it");
}

void require_apart(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    if (outputs[k].empty()) continue;
    for (const fs::path& input : inputs) {
      if (!input.empty()) require_not_input(outputs[k], input);
    }
    for (std::size_t other = 0; other < outputs.size(); ++other) {
      if (other != k && !outputs[other].empty()) require_not_input(outputs[k], outputs[other]);
    }
  }
}

void require_beside_frames(const fs::path& output, const fs::path& sequence) {
  const std::optional<fs::path> within = path_within(output, sequence);
  if (!within) return;
  if (within->empty() || !fs::is_directory(sequence)) return require_not_input(output, sequence);
  const fs::path first = *within->begin();
  const bool is_free = !fs::exists(sequence / first) || is_output_folder(sequence / first);
  if (is_free && !is_folder_of_images(first.string())) return;
  throw InputError(output.string(), "a path outside the input, or a new folder beside its images",
                   "a path in it");
}

}  // namespace symscene::app
