#pragma once

#include "io/io_support.hpp"
#include "symscene/io/result.hpp"

namespace symscene::io_test {

/// Two objects, of which one shares a point with the other, with one of everything that a result
/// may have but surfaces.
inline SegmentationResult small_result() {
  SegmentationResult result;
  result.cloud = random_cloud(40, 1);
  SceneObject object;
  object.points = {0, 5, 39};
  object.score = 1.0 / 3.0;
  object.confidence = 0.25;
  object.rotational = {{{Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d(0.6, 0, 0.8)}, 0.01}};
  object.reflectional = {{{Eigen::Vector3d(1e-20, 2, 3), Eigen::Vector3d(0, 1, 0)}, 0.02}};
  object.centroid = Eigen::Vector3d(0.1, 0.7, -1e10);
  const Eigen::Quaterniond turned = Eigen::Quaterniond(0.1, 0.2, 0.3, 0.4).normalized();
  object.box = {{{1.0 / 3.0, 0.2, 0.3}, turned}, {{0.1, 1.0 / 7.0, 0.3}, turned}, {0.1, 0.2, 0.05}};
  SceneObject overlapping;
  overlapping.points = {5, 6};
  result.objects = {object, overlapping};
  result.completed = {random_cloud(7, 2), PointCloud{}};
  result.rejected = {{"rotational", "symmetry", 0.05, 0.03, 120},
                     {"reflectional", "occlusion", 0.5, 0.1, 7}};
  result.rejected[0].points = {3, 4};
  result.objects[0].score_effects = {{"convexity", 0.9, 0.5, 0.75}};
  result.funnel = {{"candidates", 50}, {"filtered", 3}};
  result.timings = {{"z first", 0.25}, {"a second", 0.5}};
  return result;
}

/// A tetrahedron whose last triangle was not seen.
inline ObjectSurface small_surface() {
  ObjectSurface surface;
  surface.mesh.vertices.resize(4, 3);
  surface.mesh.vertices << 0.1F, 0.0F, 1e-7F, 1.0F / 3.0F, 0, 0, 0, 1, 0, 0, 0, 1;
  surface.mesh.triangles.resize(4, 3);
  surface.mesh.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  surface.observed = {1, 1, 1, 0};
  return surface;
}

}  // namespace symscene::io_test
