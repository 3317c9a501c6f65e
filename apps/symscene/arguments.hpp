#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config.hpp"
#include "symscene/io/sequence.hpp"

namespace CLI {
class App;
}

namespace symscene::app {

/// Values of the options that subcommands share.
struct SharedOptions {
  std::filesystem::path output;
  std::filesystem::path config;
  std::size_t threads = 0;
  bool verbose = false;
  bool quiet = false;
  bool json = false;
};

/// A subcommand with --config: its name, with the flags that choose among its sets of options, and
/// its options as the command line and the file have set them.
struct ConfigurableCommand {
  std::string name;
  std::function<OptionFields()> configure;
};

/// The command line of symscene while subcommands are added to it.
struct CommandLine {
  CLI::App& parser;
  std::vector<ConfigurableCommand> configurable;
};

/// Builds a subcommand: each call adds one of its options, in the order of its help.
class Arguments {
 public:
  Arguments(CommandLine& line, const char* name, const char* summary, const char* example);

  void input(std::filesystem::path& value, const char* name, const std::string& help);
  /// One or more.
  void inputs(std::vector<std::filesystem::path>& values, const char* name,
              const std::string& help);
  void required_output(SharedOptions& shared, const std::string& help);
  void optional_output(SharedOptions& shared, const std::string& help);
  void file(const char* flag, std::filesystem::path& value, const std::string& help);
  void folder(const char* flag, std::filesystem::path& value, const std::string& help);
  void flag(const char* name, bool& value, const std::string& help);
  /// One of `choices`, or none.
  void choice(const char* flag, std::string& value, const std::vector<std::string>& choices,
              const std::string& help);
  void text(const char* flag, std::string& value, const std::string& help);
  void count(const char* flag, std::optional<int>& value, const std::string& help);
  /// --intrinsics and --depth-scale, for sequences whose files do not give them.
  void sequence_options(SequenceOptions& options);
  void seed(std::optional<std::uint64_t>& value, std::uint64_t default_seed);
  void threads(SharedOptions& shared);
  /// -v, --quiet and --json.
  void reporting(SharedOptions& shared);
  /// --config and --dump-config. `configure` returns the fields with file and flags applied; add
  /// the flags that it reads before.
  void config(SharedOptions& shared, const std::function<OptionFields()>& configure);
  /// Documents the options that the subcommand has with `flag` in place of the others.
  void config_with(const char* flag, std::function<OptionFields()> configure);
  /// Runs the subcommand after the command line is parsed.
  void run(std::function<void()> body);

 private:
  CommandLine& line_;
  CLI::App& command_;
};

/// Throws InputError if writing `output` would change the file or folder `input` or its contents.
void require_not_input(const std::filesystem::path& output, const std::filesystem::path& input);

/// The last component of a folder's path, also if the path ends in a slash or is a dot.
std::string folder_name(const std::filesystem::path& folder);

}  // namespace symscene::app
