#include "common.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene::app {
namespace fs = std::filesystem;

namespace {

/// Whether it arrived shows when the stream is flushed at the end.
void put(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

}  // namespace

CLI::Option* add_input(CLI::App& command, fs::path& input, const char* name, const char* help) {
  return command.add_option(name, input, help)->required()->type_name("");
}

CLI::Option* add_output(CLI::App& command, SharedOptions& shared, const char* help) {
  return command.add_option("-o,--output", shared.output, help)->type_name("OUT");
}

void add_threads(CLI::App& command, SharedOptions& shared) {
  command
      .add_option("--threads", shared.threads,
                  "threads to use at most, 0 for all cores; results do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(0, 4096).description(""));
}

void add_reporting(CLI::App& command, SharedOptions& shared) {
  command.add_flag("-v,--verbose", shared.verbose, "print the time of every stage");
  command.add_flag("--quiet", shared.quiet, "print no text for people but warnings");
  command.add_flag("--json", shared.json, "print one machine-readable line at the end");
}

void add_config(CLI::App& command, SharedOptions& shared, std::function<OptionFields()> configure) {
  command.add_option("--config", shared.config, "JSON file with options of the stages, by name")
      ->type_name("FILE");
  command.add_flag_callback(
      "--dump-config",
      [configure = std::move(configure)] {
        put(format_config(configure()));
        throw CLI::Success();
      },
      "print all options of the stages in the form of that file");
}

void set_example(CLI::App& command, const char* example) {
  command.footer(fmt::format("Example:\n  {}", example));
}

std::string folder_name(const std::filesystem::path& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

void require_not_input(const fs::path& output, const fs::path& input) {
  const fs::path in = fs::weakly_canonical(fs::absolute(input));
  const fs::path out = fs::weakly_canonical(fs::absolute(output));
  const auto [end_of_in, position] = std::mismatch(in.begin(), in.end(), out.begin(), out.end());
  if (end_of_in == in.end())
    throw InputError(output.string(), "a place outside the input", "a part of it");
}

Session::Session(std::string command, const SharedOptions& shared)
    : command_(std::move(command)),
      shared_(shared),
      threads_(shared.threads),
      progress_(!shared.quiet && stderr_is_terminal()) {
  previous_sink_ = set_log_sink([this](LogLevel level, std::string_view message) {
    if (level == LogLevel::warning)
      progress_.print_line(fmt::format("symscene {}: warning: {}", command_, message));
  });
}

Session::~Session() { set_log_sink(std::move(previous_sink_)); }

StageTimer::OnBegin Session::on_begin() {
  return [this](const std::string& stage) { progress_.begin(stage); };
}

void Session::print(const std::string& text) {
  progress_.stop();
  put(text);
}

void Session::say(const std::string& line) {
  if (!shared_.quiet) print(line + "\n");
}

void Session::finish(nlohmann::ordered_json members, const std::vector<StageTime>& times) {
  if (shared_.verbose && !shared_.quiet) print(format_times(times));
  if (!shared_.json) return;
  nlohmann::ordered_json line = {{"command", command_}};
  line.update(members);
  nlohmann::ordered_json& seconds = line["timings"] = nlohmann::ordered_json::object();
  for (const StageTime& time : times)
    seconds[time.stage] = seconds.value(time.stage, 0.0) + time.seconds;
  print(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

std::string format_times(const std::vector<StageTime>& times) {
  double total = 0.0;
  std::size_t width = 5;
  for (const StageTime& time : times) {
    total += time.seconds;
    width = std::max(width, time.stage.size());
  }
  std::string table = fmt::format("{:<{}}  {:>9}  share\n", "stage", width, "ms");
  for (const StageTime& time : times) {
    const double share = total > 0.0 ? 100.0 * time.seconds / total : 0.0;
    table +=
        fmt::format("{:<{}}  {:>9.2f}  {:>3.0f} %\n", time.stage, width, 1e3 * time.seconds, share);
  }
  return table + fmt::format("{:<{}}  {:>9.2f}\n", "total", width, 1e3 * total);
}

}  // namespace symscene::app
