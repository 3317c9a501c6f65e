#include "core/rigid_motion.hpp"

namespace symscene {

PointCloud transformed(PointCloud cloud, const Eigen::Isometry3d& motion) {
  const Eigen::Isometry3f m = motion.cast<float>();
  cloud.positions = (cloud.positions * m.linear().transpose()).eval();
  cloud.positions.rowwise() += m.translation().transpose();
  cloud.normals = (cloud.normals * m.linear().transpose()).eval();
  return cloud;
}

TriangleMesh transformed(TriangleMesh mesh, const Eigen::Isometry3d& motion) {
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3d p = mesh.vertices.row(i).transpose().cast<double>();
    mesh.vertices.row(i) = (motion * p).cast<float>().transpose();
  }
  const Eigen::Matrix3f rotation = motion.linear().cast<float>();
  mesh.normals = (mesh.normals * rotation.transpose()).eval();
  return mesh;
}

Plane transformed(const Plane& plane, const Eigen::Isometry3d& motion) {
  const Eigen::Vector3d normal = motion.linear() * plane.normal;
  return {normal, plane.offset - normal.dot(motion.translation())};
}

}  // namespace symscene
