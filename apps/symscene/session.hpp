#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "core/log.hpp"
#include "core/parallel.hpp"
#include "progress.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/stage_timer.hpp"

namespace symscene::app {

/// A member of the machine-readable line.
struct ReportMember {
  ReportMember(std::string member, std::uint64_t number)
      : name(std::move(member)), json(std::to_string(number)) {}
  ReportMember(std::string member, const std::filesystem::path& path);

  /// A member whose value is JSON already.
  static ReportMember raw(std::string member, std::string json);

  std::string name;
  std::string json;
};

/// Runs `work`; what it finds wrong with its input is said to be wrong with `path`.
template <class Work>
auto naming(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.where(), error.expected(), error.found());
  }
}

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
  /// A warning, as the library's are shown.
  void warn(const std::string& line);
  void warn(const std::vector<std::string>& lines);
  /// What comes last: with -v the table of stage times, with --json one line with these members.
  void finish(const std::vector<ReportMember>& members, const std::vector<StageTime>& times);

 private:
  std::string command_;
  SharedOptions shared_;
  ThreadLimit threads_;
  Progress progress_;
  LogSink previous_sink_;
};

/// Stage, milliseconds and share for every stage, and the sum.
std::string format_times(const std::vector<StageTime>& times);

}  // namespace symscene::app
