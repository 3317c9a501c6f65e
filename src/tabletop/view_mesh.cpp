#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "symscene/core/error.hpp"
#include "symscene/tabletop/view_points.hpp"

namespace symscene {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();

/// The points of a coarser grid of pixels.
class PointGrid {
 public:
  PointGrid(const ViewPoints& points, Index stride)
      : columns_((points.camera.width + stride - 1) / stride),
        rows_((points.camera.height + stride - 1) / stride),
        vertices_(std::size_t{columns_} * rows_, none) {
    for (std::size_t k = 0; k < points.pixels.size(); ++k) {
      const Index u = points.pixels[k] % points.camera.width;
      const Index v = points.pixels[k] / points.camera.width;
      if (u % stride != 0 || v % stride != 0) continue;
      vertices_[std::size_t{v / stride} * columns_ + u / stride] = static_cast<Index>(used_.size());
      used_.push_back(static_cast<Index>(k));
    }
  }

  const PointIndices& used() const { return used_; }

  /// Two triangles per square of four vertices, fewer where vertices are missing or not connected.
  template <class Connected>
  std::vector<std::array<Index, 3>> triangles(const Connected& connected) const {
    std::vector<std::array<Index, 3>> found;
    const auto add = [&](Index a, Index b, Index c) {
      if (a == none || b == none || c == none) return;
      if (connected(used_[a], used_[b]) && connected(used_[b], used_[c]) &&
          connected(used_[c], used_[a]))
        found.push_back({a, b, c});
    };
    for (Index v = 0; v + 1 < rows_; ++v) {
      for (Index u = 0; u + 1 < columns_; ++u) {
        const std::size_t i = std::size_t{v} * columns_ + u;
        const Index top = vertices_[i], right = vertices_[i + 1];
        const Index below = vertices_[i + columns_], across = vertices_[i + columns_ + 1];
        // Counter-clockwise as the camera sees them.
        add(top, below, right);
        add(right, below, across);
      }
    }
    return found;
  }

 private:
  Index columns_, rows_;
  std::vector<Index> vertices_;  ///< of each grid pixel
  PointIndices used_;            ///< the point of each vertex
};

}  // namespace

TriangleMesh view_mesh(const ViewPoints& points, const ViewPointOptions& options, Index stride) {
  options.validate();
  require_option(stride > 0, "stride", "at least one pixel", stride);
  const PointGrid grid(points, stride);
  const double focal = std::sqrt(points.camera.fx * points.camera.fy);
  const double slant = stride * std::tan(options.max_slant) / focal;
  const auto connected = [&](Index a, Index b) {
    const double za = points.cloud.positions(a, 2), zb = points.cloud.positions(b, 2);
    const double step = std::abs(1.0 / za - 1.0 / zb);
    return step <= options.edge_sigmas * options.noise + slant / std::max(za, zb);
  };
  const std::vector<std::array<Index, 3>> triangles = grid.triangles(connected);
  const PointCloud vertices = select(points.cloud, grid.used());
  TriangleMesh mesh;
  mesh.vertices = vertices.positions;
  mesh.normals = vertices.normals;
  mesh.colors = vertices.colors;
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k)
      mesh.triangles(static_cast<Eigen::Index>(t), k) = triangles[t][static_cast<std::size_t>(k)];
  }
  return mesh;
}

}  // namespace symscene
