#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "progress.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/core/thread_limit.hpp"

namespace symscene::app {

/// A member of the line that --json prints.
struct ReportMember {
  ReportMember(std::string member, std::uint64_t number)
      : name(std::move(member)), json(std::to_string(number)) {}
  ReportMember(std::string member, const std::filesystem::path& path);

  /// A member whose value is given as JSON.
  static ReportMember raw(std::string member, std::string json);

  std::string name;
  std::string json;
};

/// A run of a subcommand: bounds its threads, shows progress and warnings, prints the report.
class Session {
 public:
  Session(std::string command, const SharedOptions& shared);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// A callback that takes the name of each stage as it begins.
  StageTimer::OnBegin on_begin();

  /// Prints output that --quiet does not suppress.
  void print(const std::string& text);
  /// Prints a line for people: not with --quiet, with --json on standard error.
  void print_line(const std::string& line);
  /// Prints warnings on standard error, with --quiet too.
  void warn(const std::string& line);
  void warn(std::span<const std::string> lines);
  /// Ends the run: with -v prints the table of stage times, with --json a line with these members,
  /// which is all that standard output gets.
  void finish(const std::vector<ReportMember>& members, const std::vector<StageTime>& times);

 private:
  std::string command_;
  SharedOptions shared_;
  ThreadLimit threads_;
  Progress progress_;
};

/// A table with milliseconds and share per stage, and their sum.
std::string format_times(const std::vector<StageTime>& times);

}  // namespace symscene::app
