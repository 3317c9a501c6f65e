#include "zero_surface.hpp"

#include <algorithm>
#include <array>

#include "core/as_rows.hpp"
#include "core/cell_triangles.hpp"

namespace symscene {
namespace {

constexpr float nearest_to_node = 0.02F;  // of an edge: vertices of several edges stay apart

class ZeroSurfaceExtractor {
 public:
  ZeroSurfaceExtractor(const NodeGrid& grid, const std::vector<float>& field)
      : grid_(grid), field_(field), vertices_(3 * grid.nodes(), 0) {}

  ZeroSurface extract() {
    place_vertices();
    connect_cells();
    ZeroSurface surface;
    surface.nodes = std::move(nodes_);
    surface.mesh.vertices = as_rows(places_);
    surface.mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      surface.mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles_[t][0],
          triangles_[t][1], triangles_[t][2];
    }
    return surface;
  }

 private:
  bool is_behind(std::size_t node) const { return field_[node] < 0.0F; }

  void place_vertices() {
    for_each_node(grid_, [&](std::size_t node, int x, int y, int z) {
      const Eigen::Vector3i at(x, y, z);
      for (int axis = 0; axis < 3; ++axis) {
        if (at[axis] + 1 >= grid_.size[axis]) continue;
        const std::size_t next = node + grid_.stride(axis);
        if (is_behind(node) == is_behind(next)) continue;
        const float between = std::clamp(field_[node] / (field_[node] - field_[next]),
                                         nearest_to_node, 1.0F - nearest_to_node);
        Eigen::Vector3f place = grid_.position(x, y, z);
        place[axis] += between * grid_.spacing;
        vertices_[3 * node + static_cast<std::size_t>(axis)] = static_cast<Index>(places_.size());
        places_.push_back(place);
        nodes_.push_back(between < 0.5F ? node : next);
      }
    });
  }

  void connect_cells() {
    for (int z = 0; z + 1 < grid_.size.z(); ++z) {
      for (int y = 0; y + 1 < grid_.size.y(); ++y) {
        for (int x = 0; x + 1 < grid_.size.x(); ++x) connect_cell(grid_.at(x, y, z));
      }
    }
  }

  std::size_t corner(std::size_t first, unsigned k) const {
    return first + (k & 1U) + (k >> 1U & 1U) * grid_.stride(1) + (k >> 2U) * grid_.stride(2);
  }

  void connect_cell(std::size_t first) {
    std::size_t behind = 0;
    for (unsigned k = 0; k < 8; ++k) {
      if (is_behind(corner(first, k))) behind |= std::size_t{1} << k;
    }
    const CellTriangles& cell = cell_triangles()[behind];
    for (std::size_t t = 0; t < cell.count; ++t) {
      std::array<Index, 3> triangle{};
      for (std::size_t c = 0; c < 3; ++c) {
        const CellEdge& edge = cell.triangles[t][c];
        triangle[c] = vertices_[3 * corner(first, edge.corner) + edge.axis];
      }
      triangles_.push_back(triangle);
    }
  }

  const NodeGrid& grid_;
  const std::vector<float>& field_;
  std::vector<Index> vertices_;  ///< by node and axis
  std::vector<Eigen::Vector3f> places_;
  std::vector<std::size_t> nodes_;
  std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace

ZeroSurface zero_surface(const NodeGrid& grid, const std::vector<float>& field) {
  return ZeroSurfaceExtractor(grid, field).extract();
}

}  // namespace symscene
