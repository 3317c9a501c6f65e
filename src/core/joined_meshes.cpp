#include "core/joined_meshes.hpp"

namespace symscene {

TriangleMesh joined(std::span<const TriangleMesh> meshes) {
  Eigen::Index vertices = 0, triangles = 0;
  for (const TriangleMesh& mesh : meshes) {
    vertices += mesh.vertices.rows();
    triangles += mesh.triangles.rows();
  }
  TriangleMesh all;
  all.vertices.resize(vertices, 3);
  all.triangles.resize(triangles, 3);
  vertices = triangles = 0;
  for (const TriangleMesh& mesh : meshes) {
    all.vertices.middleRows(vertices, mesh.vertices.rows()) = mesh.vertices;
    all.triangles.middleRows(triangles, mesh.triangles.rows()) =
        mesh.triangles.array() + static_cast<Index>(vertices);
    vertices += mesh.vertices.rows();
    triangles += mesh.triangles.rows();
  }
  return all;
}

}  // namespace symscene
