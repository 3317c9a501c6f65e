#pragma once

// The collisions of FCL (Pan, Chitta and Manocha 2012) between boxes of a hand and triangle meshes.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "grasping/hand_shape.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene::testing {

using FclGeometry = std::shared_ptr<fcl::CollisionGeometryd>;

inline FclGeometry fcl_mesh(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> vertices;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i)
    vertices.emplace_back(mesh.vertices.row(i).transpose().cast<double>());
  std::vector<fcl::Triangle> triangles;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    triangles.emplace_back(mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2));
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

inline fcl::CollisionObjectd fcl_box(const HandBox& box, const Eigen::Isometry3d& T_world_tool,
                                     double thinner) {
  const Eigen::Vector3d size = 2.0 * (box.half.cast<double>().array() - thinner).matrix();
  const Eigen::Isometry3d pose = T_world_tool * Eigen::Translation3d(box.centre.cast<double>());
  return {std::make_shared<fcl::Boxd>(size), pose};
}

/// Whether the boxes of a tool frame, with faces moved inwards by `thinner`, meet the geometry.
/// Boxes that are too thin for that are left out. [m]
inline bool fcl_collides(const FclGeometry& geometry, const Eigen::Isometry3d& T_world_tool,
                         std::span<const HandBox> boxes, double thinner) {
  const fcl::CollisionObjectd object(geometry, Eigen::Isometry3d::Identity());
  return std::any_of(boxes.begin(), boxes.end(), [&](const HandBox& box) {
    if (static_cast<double>(box.half.minCoeff()) <= thinner) return false;
    const fcl::CollisionObjectd hand = fcl_box(box, T_world_tool, thinner);
    fcl::CollisionResultd result;
    return fcl::collide(&object, &hand, fcl::CollisionRequestd(), result) > 0;
  });
}

/// The distance of the geometry from the boxes of a tool frame; 0 where they meet. [m]
inline double fcl_distance(const FclGeometry& geometry, const Eigen::Isometry3d& T_world_tool,
                           std::span<const HandBox> boxes) {
  if (fcl_collides(geometry, T_world_tool, boxes, 0.0)) return 0.0;
  const fcl::CollisionObjectd object(geometry, Eigen::Isometry3d::Identity());
  double least = std::numeric_limits<double>::infinity();
  for (const HandBox& box : boxes) {
    const fcl::CollisionObjectd hand = fcl_box(box, T_world_tool, 0.0);
    fcl::DistanceResultd result;
    least = std::min(least, fcl::distance(&object, &hand, fcl::DistanceRequestd(), result));
  }
  return std::max(least, 0.0);
}

}  // namespace symscene::testing
