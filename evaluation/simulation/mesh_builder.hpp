#pragma once

#include <vector>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Collects the vertices and triangles of a mesh whose size is not known beforehand.
class MeshBuilder {
 public:
  Index vertex_count() const { return static_cast<Index>(vertices_.size()); }
  Index add_vertex(const Eigen::Vector3d& p) {
    vertices_.push_back(p.cast<float>());
    return vertex_count() - 1;
  }
  void add_triangle(Index a, Index b, Index c) { triangles_.push_back({a, b, c}); }
  void add_quad(Index a, Index b, Index c, Index d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }

  TriangleMesh take() const {
    TriangleMesh mesh;
    mesh.vertices.resize(static_cast<Eigen::Index>(vertices_.size()), 3);
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (Index i = 0; i < vertices_.size(); ++i) mesh.vertices.row(i) = vertices_[i].transpose();
    for (Index i = 0; i < triangles_.size(); ++i) mesh.triangles.row(i) = triangles_[i].transpose();
    return mesh;
  }

 private:
  std::vector<Eigen::Vector3f> vertices_;
  std::vector<Eigen::Matrix<Index, 3, 1>> triangles_;
};

}  // namespace symscene
