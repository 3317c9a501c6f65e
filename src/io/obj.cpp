#include "mesh_builder.hpp"
#include "mesh_formats.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

class ObjReader {
 public:
  explicit ObjReader(const std::string& name) : name_(name), builder_(name) {}

  void add_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    if (keyword == "v") add_vertex(rest, line);
    if (keyword == "f") add_face(rest, line);
  }

  TriangleMesh build() const { return builder_.build(); }

 private:
  [[noreturn]] void fail(const char* expected, std::string_view line) const {
    throw InputError(name_, expected, in_quotes(line));
  }

  void add_vertex(std::string_view rest, std::string_view line) {
    std::vector<float> numbers;
    for (const std::string_view word : words_of(rest)) {
      const auto number = to_number<double>(word);
      if (!number) fail("a vertex v X Y Z", line);
      numbers.push_back(static_cast<float>(*number));
    }
    if (numbers.size() < 3) fail("a vertex v X Y Z", line);
    builder_.add_vertex({numbers[0], numbers[1], numbers[2]});
    if (numbers.size() == 6) builder_.color_vertex({numbers[3], numbers[4], numbers[5]});
  }

  void add_face(std::string_view rest, std::string_view line) {
    polygon_.clear();
    for (const std::string_view word : words_of(rest)) {
      const auto corner = to_number<std::int64_t>(word.substr(0, word.find('/')));
      if (!corner) fail("a face f V V V", line);
      polygon_.push_back(vertex_of(*corner, line));
    }
    builder_.add_polygon(polygon_);
  }

  /// Vertices count from 1, or from the last one backwards with −1.
  Index vertex_of(std::int64_t corner, std::string_view line) const {
    const auto count = static_cast<std::int64_t>(builder_.vertices());
    if (corner == 0 || corner < -count || corner > std::int64_t{~Index{0}}) {
      fail("a face of vertices that are there", line);
    }
    return static_cast<Index>(corner > 0 ? corner - 1 : count + corner);
  }

  std::string name_;
  ModelBuilder builder_;
  std::vector<Index> polygon_;
};

}  // namespace

TriangleMesh parse_obj(std::string_view bytes, const std::string& name) {
  ObjReader reader(name);
  while (!bytes.empty()) reader.add_line(take_line(bytes));
  return reader.build();
}

}  // namespace symscene
