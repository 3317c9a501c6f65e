#include <algorithm>

#include <fmt/format.h>

#include "core/vertex_normals.hpp"
#include "mesh_builder.hpp"
#include "mesh_formats.hpp"
#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {
namespace {

constexpr const char* observed_group = "observed";
constexpr const char* inferred_group = "inferred";

class ObjReader {
 public:
  explicit ObjReader(const std::string& name) : name_(name), builder_(name) {}

  void add_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    if (keyword == "v") add_vertex(rest, line);
    if (keyword == "f") add_face(rest, line);
    if (keyword == "g") is_observed_ = next_word(rest) != inferred_group;
  }

  TriangleMesh build() const { return builder_.build(); }
  /// Per triangle, before those without an area are left out.
  const std::vector<std::uint8_t>& observed() const { return observed_; }

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
    for (std::size_t k = 2; k < polygon_.size(); ++k) observed_.push_back(is_observed_ ? 1 : 0);
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
  bool is_observed_ = true;  ///< of the present group
  std::vector<std::uint8_t> observed_;
};

ObjReader read_lines(std::string_view bytes, const std::string& name) {
  ObjReader reader(name);
  while (!bytes.empty()) reader.add_line(take_line(bytes));
  return reader;
}

void append_group(const ObjectSurface& surface, bool observed, std::string& text) {
  text += fmt::format("g {}\n", observed ? observed_group : inferred_group);
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
    if ((surface.observed[static_cast<std::size_t>(t)] != 0) != observed) continue;
    const auto corners = surface.mesh.triangles.row(t);
    text += fmt::format("f {} {} {}\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
  }
}

}  // namespace

TriangleMesh parse_obj(std::string_view bytes, const std::string& name) {
  return read_lines(bytes, name).build();
}

ObjectSurface parse_obj_surface(std::string_view bytes, const std::string& name) {
  const ObjReader reader = read_lines(bytes, name);
  ObjectSurface surface{reader.build(), reader.observed()};
  if (static_cast<Eigen::Index>(surface.observed.size()) != surface.mesh.triangles.rows())
    throw InputError(name, "triangles with three different corners", "others");
  surface.mesh.normals = vertex_normals(surface.mesh);
  return surface;
}

std::string format_obj(const ObjectSurface& surface) {
  std::string text = "# Closed surface of an object: metres, world frame.\n";
  for (Eigen::Index v = 0; v < surface.mesh.vertices.rows(); ++v) {
    const auto place = surface.mesh.vertices.row(v);
    text += fmt::format("v {} {} {}\n", place[0], place[1], place[2]);
  }
  for (const bool observed : {true, false}) append_group(surface, observed, text);
  return text;
}

}  // namespace symscene
