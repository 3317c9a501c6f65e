#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "color.hpp"
#include "io/atomic_file.hpp"
#include "io/ply.hpp"
#include "ply_body.hpp"
#include "ply_points.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double max_index = std::numeric_limits<Index>::max();

/// The properties of the vertices to read, by their position in the element.
struct VertexColumns {
  std::vector<std::size_t> properties;  ///< x, y, z, then those present of normal, colour, mark
  bool normals = false;
  bool colors = false;
  bool observed = false;

  /// Adds properties if all exist as single values. Returns whether they do.
  bool add(const PlyElement& vertex, std::initializer_list<const char*> names) {
    std::vector<std::size_t> found;
    for (const char* name : names) {
      const auto p = vertex.find(name);
      if (!p || vertex.properties[*p].is_list()) return false;
      found.push_back(*p);
    }
    properties.insert(properties.end(), found.begin(), found.end());
    return true;
  }
};

VertexColumns choose_columns(const PlyElement& vertex, const std::string& name) {
  VertexColumns columns;
  if (!columns.add(vertex, {"x", "y", "z"})) {
    throw InputError(name, "vertices with x, y and z", "other properties");
  }
  columns.normals = columns.add(vertex, {"nx", "ny", "nz"});
  columns.colors = columns.add(vertex, {"red", "green", "blue"}) ||
                   columns.add(vertex, {"diffuse_red", "diffuse_green", "diffuse_blue"});
  columns.observed = columns.add(vertex, {"observed"});
  return columns;
}

float color_scale(ScalarType type) {
  if (is_float(type)) return 255.0F;
  return type == ScalarType::uint16 ? 1.0F / 257.0F : 1.0F;
}

MarkedCloud read_vertices(PlyBody& body, const PlyElement& vertex, const std::string& name) {
  if (static_cast<double>(vertex.count) > max_index) {
    throw InputError(name, "fewer than 2^32 vertices", std::to_string(vertex.count));
  }
  const VertexColumns columns = choose_columns(vertex, name);
  const Eigen::MatrixXf values = body.read_columns(vertex, columns.properties);
  MarkedCloud result;
  result.cloud.positions = values.leftCols<3>();
  Eigen::Index next = 3;
  if (columns.normals) {
    result.cloud.normals = values.middleCols<3>(next);
    next += 3;
  }
  if (columns.colors) {
    const auto first = columns.properties[static_cast<std::size_t>(next)];
    result.cloud.colors =
        to_colors(values.middleCols<3>(next), color_scale(vertex.properties[first].type));
    next += 3;
  }
  if (columns.observed) {
    const auto marks = values.col(next);
    result.observed.resize(vertex.count);
    std::transform(marks.begin(), marks.end(), result.observed.begin(),
                   [](float mark) -> std::uint8_t { return mark != 0.0F ? 1 : 0; });
  }
  return result;
}

/// Collects triangles while they are read, three indices each.
using Corners = std::vector<Index>;

void add_fan(std::span<const double> polygon, Corners& corners, const std::string& name) {
  for (const double index : polygon) {
    if (!(index >= 0 && index <= max_index && index == std::floor(index))) {
      throw InputError(name, "a face of vertex indices", fmt::format("{}", index));
    }
  }
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    for (const std::size_t corner : {std::size_t{0}, k - 1, k}) {
      corners.push_back(static_cast<Index>(polygon[corner]));
    }
  }
}

Corners read_faces(PlyBody& body, const PlyElement& face, const std::string& name) {
  auto list = face.find("vertex_indices");
  if (!list) list = face.find("vertex_index");
  if (!list || !face.properties[*list].is_list()) {
    throw InputError(name, "faces with a list vertex_indices", "other properties");
  }
  Corners corners;
  body.read_lists(face, *list,
                  [&](std::span<const double> polygon) { add_fan(polygon, corners, name); });
  return corners;
}

const PlyElement& require_element(const PlyHeader& header, const char* element,
                                  const std::string& name) {
  const PlyElement* found = header.find(element);
  if (found == nullptr) {
    throw InputError(name, fmt::format("an element {} in the PLY header", element), "none");
  }
  return *found;
}

void require_corners_below(const Corners& corners, Index count, const std::string& name) {
  const auto largest = std::max_element(corners.begin(), corners.end());
  if (largest == corners.end() || *largest < count) return;
  throw InputError(name, fmt::format("faces of {} vertices", count),
                   fmt::format("vertex {}", *largest));
}

}  // namespace

MarkedCloud parse_ply_marked(std::string_view bytes, const std::string& name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  const PlyElement& vertex = require_element(header, "vertex", name);
  PlyBody body(bytes.substr(header.size), header.encoding, name);
  MarkedCloud cloud;
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex)
      cloud = read_vertices(body, vertex, name);
    else
      body.skip(element);
  }
  body.require_end();
  return cloud;
}

PointCloud parse_ply_cloud(std::string_view bytes, const std::string& name) {
  return parse_ply_marked(bytes, name).cloud;
}

TriangleMesh parse_ply_mesh(std::string_view bytes, const std::string& name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  const PlyElement& vertex = require_element(header, "vertex", name);
  const PlyElement& face = require_element(header, "face", name);
  PlyBody body(bytes.substr(header.size), header.encoding, name);
  PointCloud points;
  Corners corners;
  for (const PlyElement& element : header.elements) {
    if (&element == &vertex) {
      points = read_vertices(body, element, name).cloud;
    } else if (&element == &face) {
      corners = read_faces(body, element, name);
    } else {
      body.skip(element);
    }
  }
  body.require_end();
  require_corners_below(corners, points.size(), name);
  TriangleMesh mesh;
  mesh.vertices = std::move(points.positions);
  mesh.colors = std::move(points.colors);
  mesh.normals = std::move(points.normals);
  mesh.triangles = Eigen::Map<decltype(mesh.triangles)>(
      corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
  return mesh;
}

}  // namespace symscene
