#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "io/staging_paths.hpp"

namespace symscene {

/// Files of more bytes are not read at once.
constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

/// Throws InputError if there is no regular file of this name: a pipe or a device has no end.
void require_regular_file(const std::filesystem::path& path);

/// Reads a file. Throws InputError if it is not a regular file of at most `largest` bytes or cannot
/// be read.
std::string read_file(const std::filesystem::path& path, std::uintmax_t largest = largest_file);

/// Writes a file so that a reader sees either the old or the new content: a temporary file beside
/// it is renamed when it is complete. The folder must exist. Throws InputError if the file cannot
/// be written; the old file is then unchanged.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Waits until a file or folder is on its disk, so that after a crash of the machine a renamed file
/// is not an empty one. Throws InputError, with the name `shown`, if the disk fails.
void sync_to_disk(const std::filesystem::path& path, const std::filesystem::path& shown);

/// The layout of a kind of output folder, by which a previous output is distinguished from the
/// user's own files.
struct DirectoryLayout {
  std::string what;    ///< for messages: "a result folder"
  std::string marker;  ///< a file that every folder of this kind contains
  /// Whether a file, by its path relative to the folder ("objects/0.ply"), belongs there.
  std::function<bool(const std::string& relative)> belongs;
};

/// Writes a folder so that a reader sees either the old or the new one: files are written to a
/// temporary folder beside it, and commit() swaps the two. Without commit() nothing remains.
class AtomicDirectory {
 public:
  /// Begins to write `target`, whose parents are created if necessary.
  /// Throws InputError if `target` is a file, or a folder that is neither empty nor of this layout.
  AtomicDirectory(const std::filesystem::path& target, DirectoryLayout layout);
  ~AtomicDirectory();
  AtomicDirectory(const AtomicDirectory&) = delete;
  AtomicDirectory& operator=(const AtomicDirectory&) = delete;

  /// The folder to write into until commit().
  const std::filesystem::path& staging() const { return staging_; }

  /// Writes one file by its path relative to the folder. Throws InputError if that fails, also if
  /// somebody has removed the temporary folder.
  void write(const std::filesystem::path& relative, std::string_view bytes) const;

  /// Replaces the old folder by the new one.
  /// Throws InputError if that fails; the old folder is then unchanged.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path staging_;
  StagingPath on_signal_;
  DirectoryLayout layout_;
};

}  // namespace symscene
