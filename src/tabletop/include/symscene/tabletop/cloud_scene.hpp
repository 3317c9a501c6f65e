#pragma once

#include "symscene/core/normal_estimation.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene {

/// The options of cloud_scene().
struct CloudSceneOptions {
  NormalEstimationOptions normals;
  SceneBuildingOptions scene;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("normals", self.normals);
    visit("scene", self.scene);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Makes a scene of a cloud that may still contain its table. Normals are estimated if there are
/// none. They point to `viewpoint`, the position of the sensor, if the cloud is a single view; in a
/// fused cloud their signs spread over connected surfaces. Without a table the scene holds all
/// points. The scene has no occupancy. Throws InputError if no coordinate is finite.
BuiltScene cloud_scene(const PointCloud& cloud, const Eigen::Vector3d& viewpoint,
                       TablePrior known = {}, const CloudSceneOptions& options = {});

}  // namespace symscene
