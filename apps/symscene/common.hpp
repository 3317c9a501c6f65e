#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "config.hpp"
#include "progress.hpp"
#include "symscene/core/log.hpp"
#include "symscene/core/parallel.hpp"
#include "symscene/core/stage_timer.hpp"

namespace symscene::app {

/// What the options that subcommands share were set to.
struct SharedOptions {
  std::filesystem::path output;
  std::filesystem::path config;
  std::size_t threads = 0;
  bool verbose = false;
  bool quiet = false;
  bool json = false;
};

CLI::Option* add_input(CLI::App& command, std::filesystem::path& input, const char* name,
                       const char* help);
CLI::Option* add_output(CLI::App& command, SharedOptions& shared, const char* help);
void add_threads(CLI::App& command, SharedOptions& shared);
/// -v, --quiet and --json.
void add_reporting(CLI::App& command, SharedOptions& shared);
/// --config and --dump-config. `configure` returns the fields with file and flags applied. To be
/// added after the flags that it reads.
void add_config(CLI::App& command, SharedOptions& shared, std::function<OptionFields()> configure);
void set_example(CLI::App& command, const char* example);

/// Throws InputError if writing `output` would change the file or folder `input`, or what is in it.
void require_not_input(const std::filesystem::path& output, const std::filesystem::path& input);

/// The last part of a folder's path, whether or not it ends in a slash or is a dot.
std::string folder_name(const std::filesystem::path& folder);

/// A subcommand at work: bounds its threads, shows its progress and its warnings, and prints its
/// report at the end.
class Session {
 public:
  Session(std::string command, const SharedOptions& shared);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// To be called with the name of a stage as it begins.
  StageTimer::OnBegin on_begin();

  /// Output, where --quiet asks for it too.
  void print(const std::string& text);
  /// A line for a person to read; none with --quiet.
  void say(const std::string& line);
  /// What comes last: with -v the table of stage times, with --json one line with these members.
  void finish(nlohmann::ordered_json members, const std::vector<StageTime>& times);

 private:
  std::string command_;
  SharedOptions shared_;
  ThreadLimit threads_;
  Progress progress_;
  LogSink previous_sink_;
};

/// "stage   ms   share" for every stage, and the sum.
std::string format_times(const std::vector<StageTime>& times);

}  // namespace symscene::app
