#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "symscene/tabletop/view_points.hpp"

namespace symscene {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();

/// The point of each pixel, or `none`.
std::vector<Index> points_of_pixels(const ViewPoints& points) {
  std::vector<Index> point_of(points.camera.pixels(), none);
  for (Index k = 0; k < points.pixels.size(); ++k) point_of[points.pixels[k]] = k;
  return point_of;
}

/// Two triangles per square of four pixels, fewer where points are missing or not connected.
template <class Connected>
std::vector<std::array<Index, 3>> triangles_of(const ViewPoints& points,
                                               const Connected& connected) {
  const std::vector<Index> point_of = points_of_pixels(points);
  const std::size_t columns = points.camera.width;
  std::vector<std::array<Index, 3>> found;
  const auto add = [&](Index a, Index b, Index c) {
    if (a == none || b == none || c == none) return;
    if (connected(a, b) && connected(b, c) && connected(c, a)) found.push_back({a, b, c});
  };
  for (std::size_t v = 0; v + 1 < points.camera.height; ++v) {
    for (std::size_t u = 0; u + 1 < columns; ++u) {
      const std::size_t i = v * columns + u;
      const Index top = point_of[i], right = point_of[i + 1];
      const Index below = point_of[i + columns], across = point_of[i + columns + 1];
      // Counter-clockwise as the camera sees them.
      add(top, below, right);
      add(right, below, across);
    }
  }
  return found;
}

}  // namespace

TriangleMesh view_mesh(const ViewPoints& points, const ViewPointOptions& options) {
  options.validate();
  const double focal = std::sqrt(points.camera.fx * points.camera.fy);
  const double slant = std::tan(options.max_slant) / focal;
  const auto connected = [&](Index a, Index b) {
    const double za = points.cloud.positions(a, 2), zb = points.cloud.positions(b, 2);
    const double step = std::abs(1.0 / za - 1.0 / zb);
    return step <= options.edge_sigmas * options.noise + slant / std::max(za, zb);
  };
  const std::vector<std::array<Index, 3>> triangles = triangles_of(points, connected);
  TriangleMesh mesh;
  mesh.vertices = points.cloud.positions;
  mesh.normals = points.cloud.normals;
  mesh.colors = points.cloud.colors;
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k)
      mesh.triangles(static_cast<Eigen::Index>(t), k) = triangles[t][static_cast<std::size_t>(k)];
  }
  return mesh;
}

}  // namespace symscene
