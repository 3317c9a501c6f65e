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
  /// Colours the vertex that was added last. If any vertex has a colour, those without are white.
  void color_vertex(const Eigen::Vector3f& zero_to_one);
  /// Adds a polygon as a fan about its first corner; ignores one of fewer than three corners.
  void add_polygon(std::span<const Index> corners);

  /// The mesh, vertices at equal positions merged.
  /// Throws InputError if there is no triangle or one refers to a vertex that was not added.
  TriangleMesh build() const;

 private:
  void require_room(std::size_t count) const;

  std::string name_;
  std::vector<float> positions_;
  std::vector<std::uint8_t> colors_;  ///< of the first vertices; the others are white
  std::vector<Index> corners_;
};

}  // namespace symscene
