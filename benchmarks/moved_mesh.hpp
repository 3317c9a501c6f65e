#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene::bench {

/// How far motions move a mesh off itself, by exact distances from its triangles. It shares no code
/// with the search for symmetries, whose residuals it checks.
class MovedMesh {
 public:
  /// Throws InputError if the mesh has no triangle of positive area.
  explicit MovedMesh(const TriangleMesh& mesh);

  /// The mean distance of the moved surface from the mesh, on 700 points. [unit of the mesh]
  double residual(const Eigen::Affine3d& motion) const;
  double residual(const ReflectionPlane& plane) const;
  /// For the worst of the turns by multiples of 2π / order; of some turns if `order` is 0.
  double residual(const RotationAxis& axis, int order) const;

  /// The centroid of the surface, which every symmetry leaves in place.
  const Eigen::Vector3d& centroid() const { return centroid_; }

 private:
  struct Triangle {
    Eigen::Vector3d a, b, c, middle;
    double radius = 0.0;  ///< greatest distance of a corner from the middle
  };
  double distance(const Eigen::Vector3d& point) const;

  std::vector<Triangle> triangles_;
  std::vector<Eigen::Vector3d> samples_;
  Eigen::Vector3d centroid_ = Eigen::Vector3d::Zero();
};

}  // namespace symscene::bench
