#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene::io_test {

/// A temporary folder, removed at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "symscene-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// The names of its entries, including hidden files, sorted.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      result.push_back(entry.path().filename().string());
    }
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  std::filesystem::path path_;
};

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The folder of real data, if there is one.
inline std::optional<std::filesystem::path> data_folder() {
  const char* variable = std::getenv("SYMSCENE_DATA");
  const std::filesystem::path path =
      variable != nullptr ? std::filesystem::path(variable)
                          : std::filesystem::path(SYMSCENE_SOURCE_DIR) / "../shared/data";
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

inline PointCloud random_cloud(Eigen::Index size, unsigned seed, bool normals = true,
                               bool colors = true) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-2.0F, 2.0F);
  std::uniform_int_distribution<int> channel(0, 255);
  PointCloud cloud;
  cloud.positions = Points::NullaryExpr(size, 3, [&] { return coordinate(random); });
  if (normals) {
    cloud.normals = Points::NullaryExpr(size, 3, [&] { return coordinate(random); });
    cloud.normals.rowwise().normalize();
  }
  if (colors) {
    cloud.colors =
        Colors::NullaryExpr(size, 3, [&] { return static_cast<std::uint8_t>(channel(random)); });
  }
  return cloud;
}

/// Equal bit for bit, including NaN.
template <class Matrix>
::testing::AssertionResult same_bits(const Matrix& a, const Matrix& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) {
    return ::testing::AssertionFailure() << a.rows() << " and " << b.rows() << " rows";
  }
  const auto bytes = static_cast<std::size_t>(a.size()) * sizeof(typename Matrix::Scalar);
  if (bytes == 0 || std::memcmp(a.data(), b.data(), bytes) == 0) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << "values differ";
}

inline void expect_same(const PointCloud& a, const PointCloud& b) {
  EXPECT_TRUE(same_bits(a.positions, b.positions));
  EXPECT_TRUE(same_bits(a.normals, b.normals));
  EXPECT_TRUE(same_bits(a.colors, b.colors));
}

/// The text with its first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The sentence with which `call` refuses its input.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// Whether `call` returned (true) or threw InputError (false); other exceptions fail the test.
template <class Call>
bool accepts(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    EXPECT_FALSE(std::string(error.what()).empty());
    return false;
  }
  return true;
}

/// Truncates `bytes` at every length (at most `cuts` of them), flips single bits and overwrites
/// runs: `parse` must return or throw InputError. Returns how many truncations were accepted.
template <class Parse>
int damage(const std::string& bytes, const Parse& parse, std::size_t cuts = 2000,
           int flips = 2000) {
  int accepted_cuts = 0;
  const std::size_t step = bytes.size() / cuts + 1;
  for (std::size_t size = 0; size < bytes.size(); size += step) {
    // A copy of just that size, so that the address sanitizer sees a read behind the end.
    const std::vector<char> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    if (accepts([&] { parse(std::string_view(cut.data(), cut.size())); })) ++accepted_cuts;
  }
  std::mt19937 random(7);
  for (int flip = 0; flip < flips; ++flip) {
    std::string changed = bytes;
    const int runs = 1 + flip % 3;
    for (int run = 0; run < runs; ++run) {
      char& byte = changed[random() % changed.size()];
      byte = static_cast<char>(flip % 2 == 0 ? byte ^ (1 << (random() % 8))
                                             : static_cast<int>(random() % 256));
    }
    accepts([&] { parse(std::string_view(changed)); });
  }
  return accepted_cuts;
}

}  // namespace symscene::io_test
