#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "faults/fault_kinds.hpp"

namespace symscene::testing {

/// Calls of each kind that a run made.
using CallCounts = std::array<std::uint64_t, kinds.size()>;

/// Files below a folder with their bytes; folders end in a slash.
using Files = std::map<std::string, std::string>;

Files files_below(const std::filesystem::path& folder);
void restore_files(const std::filesystem::path& folder, const Files& files);

/// How a run of the command ended.
struct FaultyRun {
  int code = -1;   ///< exit code, -1 after a signal
  int signal = 0;  ///< signal that ended it, 0 if none
  std::string err;
  CallCounts counts{};
};

/// Runs `symscene LINE` in `folder`. Of `kind`, the call of number `call` fails; with 0 none does.
/// A run that takes longer than a minute is ended by SIGALRM.
FaultyRun run_with_fault(const std::filesystem::path& folder, const std::string& line,
                         Kind kind = Kind::open, std::uint64_t call = 0);

}  // namespace symscene::testing
