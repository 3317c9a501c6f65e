#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "config.hpp"
#include "symscene/io/sequence.hpp"

namespace CLI {
class App;
}

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

/// Puts a subcommand together: each call adds an option of it, in the order of its help.
class Arguments {
 public:
  Arguments(CLI::App& app, const char* name, const char* summary, const char* example);

  void input(std::filesystem::path& value, const char* name, const char* help);
  void required_output(SharedOptions& shared, const char* help);
  void optional_output(SharedOptions& shared, const char* help);
  void file(const char* flag, std::filesystem::path& value, const char* help);
  void folder(const char* flag, std::filesystem::path& value, const char* help);
  void text(const char* flag, std::string& value, const char* help);
  void count(const char* flag, std::optional<int>& value, const char* help);
  void flag(const char* flag, bool& value, const char* help);
  /// --intrinsics and --depth-scale, of which a sequence's files may say nothing.
  void sequence_options(SequenceOptions& options);
  void seed(std::optional<std::uint64_t>& value);
  void threads(SharedOptions& shared);
  /// -v, --quiet and --json.
  void reporting(SharedOptions& shared);
  /// --config and --dump-config. `configure` returns the fields with file and flags applied; the
  /// flags that it reads are to be added before.
  void config(SharedOptions& shared, std::function<OptionFields()> configure);
  /// What the subcommand does once the line is parsed.
  void run(std::function<void()> body);

 private:
  CLI::App& command_;
};

/// Throws InputError if writing `output` would change the file or folder `input`, or what is in it.
void require_not_input(const std::filesystem::path& output, const std::filesystem::path& input);

/// The last part of a folder's path, whether or not it ends in a slash or is a dot.
std::string folder_name(const std::filesystem::path& folder);

}  // namespace symscene::app
