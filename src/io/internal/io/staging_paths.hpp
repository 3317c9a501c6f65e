#pragma once

#include <cstddef>
#include <filesystem>

namespace symscene {

/// A temporary file or folder that is removed if a signal ends the process: see
/// remove_staging_on_signals(). Forked processes leave it alone.
class StagingPath {
 public:
  explicit StagingPath(const std::filesystem::path& path);
  ~StagingPath();
  StagingPath(const StagingPath&) = delete;
  StagingPath& operator=(const StagingPath&) = delete;

 private:
  std::size_t slot_;
};

/// Removes what processes that live no more left beside `path` while they wrote it. What stood
/// there before and was set aside gets its name back if nothing has it.
void remove_stale_staging(const std::filesystem::path& path);

}  // namespace symscene
