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

void Arguments::output_folder(SharedOptions& shared, const std::string& help) {
  command_.add_option("-o,--output", shared.output, help)->required()->type_name("FOLDER");
}

void Arguments::optional_output_folder(SharedOptions& shared, const std::string& help) {
  command_.add_option("-o,--output", shared.output, help)->type_name("FOLDER");
}

void Arguments::output_file(SharedOptions& shared, const std::string& help) {
  command_.add_option("-o,--output", shared.output, help)->required()->type_name("FILE");
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

void require_not_input(const fs::path& output, const fs::path& input) {
  const fs::path in = fs::weakly_canonical(fs::absolute(input));
  const fs::path out = fs::weakly_canonical(fs::absolute(output));
  const auto [end_of_in, position] = std::mismatch(in.begin(), in.end(), out.begin(), out.end());
  if (end_of_in == in.end())
    throw InputError(output.string(), "a path outside the input", "a path in it");
}

}  // namespace symscene::app
