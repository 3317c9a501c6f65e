#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
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
  /// Adds options to the whole command.
  explicit Arguments(CommandLine& line);

  void input(std::filesystem::path& value, const char* name, const std::string& help);
  /// One or more.
  void inputs(std::vector<std::filesystem::path>& values, const char* name,
              const std::string& help);
  void optional_input(std::filesystem::path& value, const char* name, const std::string& help);
  /// None, one or more.
  void words(std::vector<std::string>& values, const char* name, const std::string& help);
  /// One of `choices`, required.
  void word(std::string& value, const char* name, const std::vector<std::string>& choices,
            const std::string& help);
  void output_folder(SharedOptions& shared, const std::string& help);
  void optional_output_folder(SharedOptions& shared, const std::string& help);
  /// A file of one of the formats that these endings name, or without an ending; any without
  /// formats.
  void output_file(SharedOptions& shared, const std::string& help,
                   const std::vector<std::string>& formats = {});
  void optional_output_file(SharedOptions& shared, const std::string& help);
  void file(const char* flag, std::filesystem::path& value, const std::string& help);
  void folder(const char* flag, std::filesystem::path& value, const std::string& help);
  void flag(const char* name, bool& value, const std::string& help);
  /// One of `choices`, or none.
  void choice(const char* flag, std::string& value, const std::vector<std::string>& choices,
              const std::string& help);
  /// `kind` says in the help what the text is: NAME, X,Y,Z.
  void text(const char* flag, const char* kind, std::string& value, const std::string& help);
  /// A whole number; `range` is that of the option of a stage that it sets, see range_of().
  void count(const char* flag, std::optional<int>& value, const Range& range,
             const std::string& help);
  /// --every, which takes every N-th frame.
  void every(std::optional<int>& value, const std::string& help);
  /// --intrinsics and --depth-scale, for sequences whose files do not give them.
  void sequence_options(SequenceOptions& options);
  void seed(std::optional<std::uint64_t>& value, std::uint64_t default_seed);
  void threads(SharedOptions& shared);
  /// -v, -q and --json.
  void reporting(SharedOptions& shared);
  /// --config and --dump-config. `configure` returns the fields with file and flags applied; add
  /// the flags that it reads before.
  void config(SharedOptions& shared, const std::function<OptionFields()>& configure);
  /// Documents the options that the subcommand has with `flag` in place of the others.
  void config_with(const char* flag, std::function<OptionFields()> configure);
  /// Runs the subcommand after the command line is parsed.
  void run(std::function<void()> body);
  /// What subcommands that run stages end with: --threads, -v, -q, --json, --config and
  /// --dump-config, and the run of `command`, which has `shared`, configure() and run().
  template <class Command>
  void run_stages(const std::shared_ptr<Command>& command) {
    threads(command->shared);
    reporting(command->shared);
    config(command->shared, [command] { return command->configure(); });
    run([command] { command->run(); });
  }

 private:
  CommandLine& line_;
  CLI::App& command_;
};

/// Adds --threads, -v, -q and --json to the whole command, where they may stand before the
/// subcommand. main() moves them behind it; `before` gets them where there is none.
void add_options_of_all(CommandLine& line, SharedOptions& before);

/// Throws InputError if writing `output` would change the file or folder `input` or its contents.
void require_not_input(const std::filesystem::path& output, const std::filesystem::path& input);

/// The same for each output and each input, and for each two outputs. Paths that are empty are not
/// looked at.
void require_apart(const std::vector<std::filesystem::path>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

/// Whether a folder is one that symscene wrote for a scene, a result or masks. No folder that
/// cannot be read is one.
bool is_output_folder(const std::filesystem::path& folder);

/// The same as require_not_input() for a folder beside the frames of a sequence: it may lie in the
/// folder of the sequence where no reader of sequences looks, under a new name or in place of an
/// earlier output.
void require_beside_frames(const std::filesystem::path& output,
                           const std::filesystem::path& sequence);

/// The last component of a folder's path, also if the path ends in a slash or is a dot.
std::string folder_name(const std::filesystem::path& folder);

}  // namespace symscene::app
