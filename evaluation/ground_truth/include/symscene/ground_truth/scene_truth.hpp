#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// A ground-truth symmetry. `strict` is false for a weak symmetry, whose detection counts neither
/// as correct nor as wrong.
struct TrueAxis {
  RotationAxis axis;
  bool strict = true;
};
struct TruePlane {
  ReflectionPlane plane;
  bool strict = true;
};

/// The ground truth of an object. World frame.
struct TrueObject {
  std::string name;
  PointIndices points;  ///< into the scene's cloud.ply, ascending
  std::vector<TrueAxis> rotational;
  std::vector<TruePlane> reflectional;
  bool sphere = false;  ///< any axis through the centroid is correct
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::string mesh = {};                                         ///< name of its model, if known
  std::optional<Eigen::Isometry3d> T_world_mesh = std::nullopt;  ///< pose of the model
};

/// The ground truth of a scene. World frame.
struct SceneTruth {
  Plane table;
  std::vector<TrueObject> objects;
};

}  // namespace symscene
