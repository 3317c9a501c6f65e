#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "folder_swap.hpp"
#include "io/atomic_file.hpp"
#include "symscene/core/error.hpp"
#include "temporary_name.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// The folder of a path: without trailing slash, symbolic links followed.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path), error);
  if (error) result = fs::absolute(path).lexically_normal();
  return result.has_filename() ? result : result.parent_path();
}

/// The first file below `dir` that does not belong there, relative to it; empty if there is none.
std::string first_foreign_file(const fs::path& dir, const DirectoryLayout& layout) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(dir)) {
    const std::string relative = entry.path().lexically_relative(dir).generic_string();
    const bool folder = entry.is_directory() && !entry.is_symlink();
    if (!layout.belongs(folder ? relative + "/" : relative)) return relative;
  }
  return {};
}

void require_replaceable(const fs::path& dir, const DirectoryLayout& layout) {
  if (!fs::exists(dir)) return;
  const std::string expected = "no folder yet, an empty one, or " + layout.what + " to replace";
  if (!fs::is_directory(dir)) throw InputError(dir.string(), expected, "a file");
  if (fs::is_empty(dir)) return;
  const std::string foreign = first_foreign_file(dir, layout);
  if (!foreign.empty()) {
    throw InputError(dir.string(), expected, "a folder that holds " + foreign);
  }
  if (!fs::exists(dir / layout.marker)) {
    throw InputError(dir.string(), expected, "a folder without " + layout.marker);
  }
}

/// Waits until all files and folders below `staging` are on the disk.
void sync_tree(const fs::path& staging, const fs::path& target) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(staging))
    if (!entry.is_symlink()) sync_to_disk(entry.path(), target);
  sync_to_disk(staging, target);
}

[[noreturn]] void fail(const fs::path& target, const fs::filesystem_error& error) {
  throw InputError(target.string(), "a folder that can be written", error.code().message());
}

[[noreturn]] void fail_without_staging(const fs::path& target) {
  throw InputError(target.string(), "the temporary folder that it is written to",
                   "that it was removed");
}

}  // namespace

AtomicDirectory::AtomicDirectory(const fs::path& target, DirectoryLayout layout)
    : target_(resolved(target)),
      staging_(temporary_beside(target_)),
      on_signal_(staging_),
      layout_(std::move(layout)) {
  try {
    remove_stale_staging(target_);
    require_replaceable(target_, layout_);
    fs::create_directories(target_.parent_path());
    fs::create_directory(staging_);
  } catch (const fs::filesystem_error& error) {
    fail(target_, error);
  }
}

AtomicDirectory::~AtomicDirectory() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

void AtomicDirectory::write(const fs::path& relative, std::string_view bytes) const {
  const fs::path file = staging_ / relative;
  std::error_code error;
  // Files that were written before would be missing.
  if (!fs::exists(staging_, error)) fail_without_staging(target_);
  fs::create_directories(file.parent_path(), error);
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) return;
  throw InputError((target_ / relative).string(), "a place that can be written",
                   std::generic_category().message(errno == 0 ? EIO : errno));
}

void AtomicDirectory::commit() {
  if (!fs::exists(staging_)) fail_without_staging(target_);
  try {
    require_replaceable(target_, layout_);
    sync_tree(staging_, target_);
    if (fs::exists(target_)) {
      swap_folders(staging_, target_);  // the destructor removes the old one
      std::error_code ignored;
      fs::remove_all(staging_, ignored);
    } else {
      fs::rename(staging_, target_);
    }
  } catch (const fs::filesystem_error& error) {
    fail(target_, error);
  }
}

}  // namespace symscene
