#include <array>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "gltf_document.hpp"
#include "mesh_builder.hpp"
#include "mesh_formats.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t triangles_mode = 4;
constexpr std::size_t strip_mode = 5;
constexpr std::size_t fan_mode = 6;

/// Nodes may share a mesh, so a small file can contain many primitives.
constexpr std::size_t max_primitives = 1'000'000;
/// Vertices and corners per byte of the file and its buffers, beyond the first million.
constexpr std::size_t max_expansion = 30;
constexpr std::size_t small_mesh = 1'000'000;

Eigen::Vector3d vector_or(const JsonCursor& node, const char* key, double otherwise) {
  const auto vector = node.find(key);
  return vector ? vector->vector3() : Eigen::Vector3d::Constant(otherwise);
}

Eigen::Matrix3d rotation_of(const JsonCursor& node) {
  const auto json = node.find("rotation");
  if (!json) return Eigen::Matrix3d::Identity();
  const auto q = json->items(4);
  const Eigen::Quaterniond rotation(q[3].number(), q[0].number(), q[1].number(), q[2].number());
  if (!(rotation.norm() > 0.0)) json->fail("a rotation");
  return rotation.normalized().toRotationMatrix();
}

Eigen::Affine3d transform_of(const JsonCursor& node) {
  Eigen::Affine3d T_parent_node = Eigen::Affine3d::Identity();
  if (const auto matrix = node.find("matrix")) {
    const auto numbers = matrix->items(16);  // by columns
    for (Eigen::Index i = 0; i < 16; ++i) {
      if (i % 4 == 3) continue;
      T_parent_node(i % 4, i / 4) = numbers[static_cast<std::size_t>(i)].number();
    }
    return T_parent_node;
  }
  T_parent_node.linear() = rotation_of(node) * vector_or(node, "scale", 1.0).asDiagonal();
  T_parent_node.translation() = vector_or(node, "translation", 0.0);
  return T_parent_node;
}

/// Joins the meshes of a scene, each transformed by its node.
class GltfJoiner {
 public:
  GltfJoiner(const GltfDocument& document, const std::string& name)
      : document_(document), builder_(name) {}

  TriangleMesh join() {
    const JsonCursor nodes = document_.root().at("nodes");
    std::vector<bool> visited(nodes.size(), false);
    std::vector<std::pair<JsonCursor, Eigen::Affine3d>> open;
    for (const JsonCursor& index : roots()) open.emplace_back(index, Eigen::Affine3d::Identity());
    while (!open.empty()) {
      const auto [index, T_world_parent] = open.back();
      open.pop_back();
      const JsonCursor node = nodes.at(index.count());
      if (visited[index.count()]) index.fail("a tree of nodes");
      visited[index.count()] = true;
      const Eigen::Affine3d T_world_node = T_world_parent * transform_of(node);
      if (const auto mesh = node.find("mesh")) add_mesh(*mesh, T_world_node);
      if (const auto children = node.find("children")) {
        for (const JsonCursor& child : children->items()) open.emplace_back(child, T_world_node);
      }
    }
    return builder_.build();
  }

 private:
  std::vector<JsonCursor> roots() const {
    const auto scene = document_.root().find("scene");
    const JsonCursor scenes = document_.root().at("scenes");
    return scenes.at(scene ? scene->count() : 0).at("nodes").items();
  }

  void add_mesh(const JsonCursor& index, const Eigen::Affine3d& T_world_mesh) {
    const JsonCursor mesh = document_.root().at("meshes").at(index.count());
    const JsonCursor primitives = mesh.at("primitives");
    const std::size_t count = primitives.size();
    if (count > max_primitives - primitives_) {
      throw InputError(primitives.where(),
                       fmt::format("at most {} primitives at all nodes", max_primitives), "more");
    }
    primitives_ += count;
    for (std::size_t i = 0; i < count; ++i) add_primitive(primitives.at(i), T_world_mesh);
  }

  void add_primitive(const JsonCursor& primitive, const Eigen::Affine3d& T_world_mesh) {
    const auto mode_json = primitive.find("mode");
    const std::size_t mode = mode_json ? mode_json->count() : triangles_mode;
    if (mode < triangles_mode || mode > fan_mode) return;
    const std::size_t first = builder_.vertices();
    add_vertices(primitive.at("attributes"), T_world_mesh);
    const bool mirrored = T_world_mesh.linear().determinant() < 0.0;
    const std::vector<Index> corners = corners_of(primitive, first);
    require_proportion(primitive, builder_.vertices() - first + corners.size());
    add_triangles(corners, mode, mirrored);
  }

  /// Counts what a primitive adds.
  void require_proportion(const JsonCursor& primitive, std::size_t added) {
    elements_ += added;
    if (elements_ <= small_mesh + max_expansion * document_.size()) return;
    throw InputError(
        primitive.where(),
        fmt::format("at most {} vertices and corners per byte of the file", max_expansion),
        "more, as many nodes share a mesh");
  }

  void add_vertices(const JsonCursor& attributes, const Eigen::Affine3d& T_world_mesh) {
    const JsonCursor position_index = attributes.at("POSITION");
    const GltfAccessor positions = document_.accessor(position_index);
    if (positions.components != 3) position_index.fail("positions of three numbers");
    std::optional<GltfAccessor> colors;
    if (const auto index = attributes.find("COLOR_0")) {
      colors = document_.accessor(*index);
      if (colors->components < 3 || colors->count != positions.count) {
        index->fail("one colour per vertex");
      }
    }
    for (std::size_t v = 0; v < positions.count; ++v) {
      const Eigen::Vector3d position(positions.value(v, 0), positions.value(v, 1),
                                     positions.value(v, 2));
      builder_.add_vertex((T_world_mesh * position).cast<float>());
      if (!colors) continue;
      const Eigen::Vector3d color(colors->fraction(v, 0), colors->fraction(v, 1),
                                  colors->fraction(v, 2));
      builder_.color_vertex(color.cast<float>());
    }
  }

  /// The vertices of a primitive, added from `first` on, in the order of its corners.
  std::vector<Index> corners_of(const JsonCursor& primitive, std::size_t first) const {
    const std::size_t vertices = builder_.vertices() - first;
    std::vector<Index> corners;
    const auto index = primitive.find("indices");
    if (!index) {
      for (std::size_t v = 0; v < vertices; ++v) corners.push_back(static_cast<Index>(first + v));
      return corners;
    }
    const GltfAccessor indices = document_.accessor(*index);
    for (std::size_t i = 0; i < indices.count; ++i) {
      const double vertex = indices.value(i, 0);
      if (!(vertex >= 0.0 && vertex < static_cast<double>(vertices))) {
        index->fail("indices of vertices that are there");
      }
      corners.push_back(static_cast<Index>(first + static_cast<std::size_t>(vertex)));
    }
    return corners;
  }

  void add_triangles(const std::vector<Index>& corners, std::size_t mode, bool mirrored) {
    const std::size_t step = mode == triangles_mode ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const std::size_t odd = mode == strip_mode ? i % 2 : 0;
      std::array<Index, 3> triangle = {corners[mode == fan_mode ? 0 : i], corners[i + 1 + odd],
                                       corners[i + 2 - odd]};
      if (mirrored) std::swap(triangle[1], triangle[2]);
      builder_.add_polygon(triangle);
    }
  }

  const GltfDocument& document_;
  ModelBuilder builder_;
  std::size_t primitives_ = 0;  ///< of all meshes, once per node that refers to them
  std::size_t elements_ = 0;    ///< vertices and corners of these
};

}  // namespace

TriangleMesh parse_gltf(std::string_view bytes, const std::string& name,
                        const ReadBeside& read_beside) {
  const GltfDocument document(bytes, name, read_beside);
  return GltfJoiner(document, name).join();
}

}  // namespace symscene
