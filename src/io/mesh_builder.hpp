#pragma once

#include <span>
#include <string>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Collects the vertices and triangles of a mesh file.
class ModelBuilder {
 public:
  explicit ModelBuilder(std::string name) : name_(std::move(name)) {}

  std::size_t vertices() const { return positions_.size() / 3; }
  void add_vertex(const Eigen::Vector3f& position);
  /// The colour of the vertex that was added last; white for those without, if any has one.
  void color_vertex(const Eigen::Vector3f& zero_to_one);
  /// A polygon as a fan about its first corner; nothing of fewer than three corners.
  void add_polygon(std::span<const Index> corners);

  /// The mesh, vertices at the same place made one.
  /// Throws InputError if there is no triangle or one names a vertex that was not added.
  TriangleMesh build() const;

 private:
  void require_room(std::size_t count) const;

  std::string name_;
  std::vector<float> positions_;
  std::vector<std::uint8_t> colors_;  ///< of the first vertices
  std::vector<Index> corners_;
};

}  // namespace symscene
