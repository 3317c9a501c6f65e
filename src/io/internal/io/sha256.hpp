#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace symscene {

/// The SHA-256 hash of bytes that come in parts (FIPS 180-4).
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// 64 hexadecimal digits, as sha256sum prints them. Ends the hash.
  std::string digest();

 private:
  void add_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> rest_{};
  std::size_t rest_size_ = 0;
  std::uint64_t size_ = 0;
};

std::string sha256(std::string_view bytes);

/// The hash of a file, read in parts. Throws InputError if it is not a regular file or cannot be
/// read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace symscene
