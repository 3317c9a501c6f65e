#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace symscene {

/// The bytes of a file.
/// Throws InputError if there is no such file, if it is a folder or if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Writes a file so that a reader sees the old bytes or all of the new ones: a temporary file
/// beside it takes its name when it is complete. The folder must exist. Throws InputError if the
/// file cannot be written; the old file is then as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// What a kind of output folder looks like: how a previous output is told from other people's
/// files.
struct DirectoryLayout {
  std::string what;    ///< for messages: "a result folder"
  std::string marker;  ///< the file that every folder of this kind holds
  /// Whether a file, by its path relative to the folder ("objects/0.ply"), belongs there.
  std::function<bool(const std::string& relative)> belongs;
};

/// Writes a folder so that a reader sees the old one or all of the new one: the files go into a
/// temporary folder beside it, and commit() swaps the two. Without commit() nothing is left behind.
class AtomicDirectory {
 public:
  /// Begins to write `target`, whose parents are made if need be.
  /// Throws InputError if `target` is a file, or a folder that is neither empty nor of this layout.
  AtomicDirectory(std::filesystem::path target, DirectoryLayout layout);
  ~AtomicDirectory();
  AtomicDirectory(const AtomicDirectory&) = delete;
  AtomicDirectory& operator=(const AtomicDirectory&) = delete;

  /// The folder to write into until commit().
  const std::filesystem::path& staging() const { return staging_; }

  /// Writes one file by its path relative to the folder. Throws InputError if that fails.
  void write(const std::filesystem::path& relative, std::string_view bytes) const;

  /// Puts the new folder in the place of the old one, whose files are removed.
  /// Throws InputError if that fails; the old folder is then as it was.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path staging_;
  DirectoryLayout layout_;
};

}  // namespace symscene
