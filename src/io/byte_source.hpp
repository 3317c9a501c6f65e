#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "symscene/core/error.hpp"

namespace symscene {

/// The bytes of a file that may be larger than memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// At most `size` bytes from `offset` on, until the next call; fewer where the bytes end.
  virtual std::string_view at(std::uint64_t offset, std::size_t size) = 0;
};

class BytesInMemory final : public ByteSource {
 public:
  explicit BytesInMemory(std::string_view bytes) : bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_.size(); }
  std::string_view at(std::uint64_t offset, std::size_t size) override {
    return offset < bytes_.size() ? bytes_.substr(offset, size) : std::string_view();
  }

 private:
  std::string_view bytes_;
};

class BytesInFile final : public ByteSource {
 public:
  /// Throws InputError if the file cannot be read.
  explicit BytesInFile(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    std::error_code unknown;
    size_ = std::filesystem::file_size(path, unknown);
    if (!stream_ || unknown) throw InputError(path.string(), "a file that can be read", "none");
  }
  std::uint64_t size() const override { return size_; }
  std::string_view at(std::uint64_t offset, std::size_t size) override {
    buffer_.resize(std::min<std::uint64_t>(size, offset < size_ ? size_ - offset : 0));
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream_.gcount(), 0)));
    return buffer_;
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::string buffer_;
};

}  // namespace symscene
