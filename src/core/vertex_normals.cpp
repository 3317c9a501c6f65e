#include "core/vertex_normals.hpp"

#include <Eigen/Geometry>

namespace symscene {

Points vertex_normals(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3f a = mesh.vertices.row(mesh.triangles(t, 0));
    const Eigen::Vector3f b = mesh.vertices.row(mesh.triangles(t, 1));
    const Eigen::Vector3f c = mesh.vertices.row(mesh.triangles(t, 2));
    const Eigen::Vector3f normal = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k) normals.row(mesh.triangles(t, k)) += normal.transpose();
  }
  normals.rowwise().normalize();
  return normals;
}

}  // namespace symscene
