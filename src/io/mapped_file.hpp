#pragma once

#include <filesystem>
#include <string_view>

namespace symscene {

/// A file mapped into memory: only the bytes that are accessed are read.
class MappedFile {
 public:
  /// Throws InputError if the file does not exist or cannot be read.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const { return {static_cast<const char*>(data_), size_}; }

 private:
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace symscene
