#include <array>

#include <fmt/format.h>

#include "file_end.hpp"
#include "mesh_builder.hpp"
#include "mesh_formats.hpp"
#include "scalar.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr std::size_t header_size = 84;  ///< 80 arbitrary bytes, then the number of triangles
constexpr std::size_t triangle_size = 50;
constexpr std::size_t normal_size = 12;

/// The number of triangles that a binary file declares.
std::uint64_t declared_triangles(std::string_view bytes) {
  return bytes.size() < header_size ? 0 : load<std::uint32_t>(bytes.data() + 80);
}

bool is_binary(std::string_view bytes) {
  if (bytes.size() < header_size) return false;
  const bool exact = bytes.size() == header_size + triangle_size * declared_triangles(bytes);
  return exact || !bytes.starts_with("solid");
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& name) {
  const std::uint64_t triangles = declared_triangles(bytes);
  if (triangles > (bytes.size() - header_size) / triangle_size) {
    throw InputError(name, fmt::format("{} triangles", triangles),
                     fmt::format("only {} bytes", bytes.size()));
  }
  require_end(bytes.substr(header_size + triangle_size * triangles), name);
  ModelBuilder builder(name);
  for (std::uint64_t t = 0; t < triangles; ++t) {
    const char* corner = bytes.data() + header_size + t * triangle_size + normal_size;
    for (int k = 0; k < 3; ++k, corner += 12) {
      builder.add_vertex({load<float>(corner), load<float>(corner + 4), load<float>(corner + 8)});
    }
    const auto first = static_cast<Index>(3 * t);
    builder.add_polygon(std::array{first, first + 1, first + 2});
  }
  return builder.build();
}

/// Reads the text format line by line.
class TextReader {
 public:
  explicit TextReader(const std::string& name) : name_(name), builder_(name) {}

  void add_line(std::string_view line) {
    const auto words = words_of(line);
    if (words.empty() || words[0] == "solid" || words[0] == "facet" || words[0] == "outer") return;
    if (words[0] == "vertex") {
      add_vertex(words, line);
    } else if (words[0] == "endloop") {
      builder_.add_polygon(loop_);
      loop_.clear();
    } else if (words[0] == "endsolid") {
      ended_ = true;
    } else if (words[0] != "endfacet") {
      throw InputError(name_, "a line of an STL file", in_quotes(line));
    }
  }

  TriangleMesh build() const {
    if (!ended_ || !loop_.empty()) throw InputError(name_, "endsolid", "the end of the file");
    return builder_.build();
  }

 private:
  void add_vertex(const std::vector<std::string_view>& words, std::string_view line) {
    Eigen::Vector3f position;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = words.size() == 4 ? to_number<double>(words[k + 1]) : std::nullopt;
      if (!number) throw InputError(name_, "vertex X Y Z", in_quotes(line));
      position[static_cast<Eigen::Index>(k)] = static_cast<float>(*number);
    }
    loop_.push_back(static_cast<Index>(builder_.vertices()));
    builder_.add_vertex(position);
  }

  std::string name_;
  ModelBuilder builder_;
  std::vector<Index> loop_;
  bool ended_ = false;
};

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name) {
  if (is_binary(bytes)) return parse_binary(bytes, name);
  if (!bytes.starts_with("solid")) {
    throw InputError(name, "an STL file", in_quotes(bytes.substr(0, bytes.find('\n'))));
  }
  TextReader reader(name);
  while (!bytes.empty()) reader.add_line(take_line(bytes));
  return reader.build();
}

}  // namespace symscene
