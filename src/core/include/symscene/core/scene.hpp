#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/stage_timer.hpp"

namespace symscene {

/// A scene as it lies on disk: what stands on the table and what is known of the space around it.
/// World frame.
struct Scene {
  PointCloud cloud;
  std::optional<OccupancyMap>
      occupancy;               ///< without one, all space off the surface counts as never seen
  std::optional<Plane> table;  ///< unit normal that points up
  std::vector<std::string> warnings = {};  ///< what its reader warns of, a sentence each
};

/// A symmetry of an object with its residual: 0 is a perfect fit.
struct ScoredAxis {
  RotationAxis axis;
  double residual = 0.0;
};
struct ScoredPlane {
  ReflectionPlane plane;
  double residual = 0.0;
};

/// An object of the result.
struct SceneObject {
  PointIndices points;                 ///< into the result's cloud, ascending
  double score = 0.0;                  ///< confidence in [0, 1]
  std::vector<ScoredAxis> rotational;  ///< by rising residual
  std::vector<ScoredPlane> reflectional;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< centre of mass under the symmetries [m]
};

/// A candidate that did not become an object, or was merged, and the bound that it failed.
struct Rejection {
  std::string kind;          ///< "rotational", "reflectional" or "surface"
  std::string reason;        ///< the score that failed: "symmetry", "occlusion", "smoothness", ...
  double value = 0.0;        ///< what was measured
  double bound = 0.0;        ///< what was allowed
  std::size_t size = 0;      ///< points of the hypothesis
  PointIndices points = {};  ///< they, into the result's cloud, where known; not kept in files
};

/// How many candidates were left after a step, in order.
struct FunnelStep {
  std::string step;
  std::size_t count = 0;
};

/// What segmentation returns.
struct SegmentationResult {
  PointCloud cloud;                   ///< the 5 mm cloud that the indices count in
  std::optional<Plane> table;         ///< of the scene, where it is known
  std::vector<SceneObject> objects;   ///< by falling score
  std::vector<PointCloud> completed;  ///< one an object: the points that its symmetries add
  std::vector<Rejection> rejected;    ///< hypotheses that were cut out and then refused
  std::vector<FunnelStep> funnel;
  std::vector<StageTime> timings;
  std::vector<std::string> warnings;  ///< what to doubt about the result, a sentence each
};

/// A symmetry that is known to be true. `strict` is false where the symmetry is weak: neither right
/// nor wrong.
struct TrueAxis {
  RotationAxis axis;
  bool strict = true;
};
struct TruePlane {
  ReflectionPlane plane;
  bool strict = true;
};

/// What is known of an object in a scene with truth. World frame.
struct TrueObject {
  std::string name;
  PointIndices points;  ///< into the scene's cloud.ply, ascending
  std::vector<TrueAxis> rotational;
  std::vector<TruePlane> reflectional;
  bool sphere = false;  ///< any axis through the centroid is right
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  std::string mesh = {};  ///< the name of its model, where that is known
  std::optional<Eigen::Isometry3d> T_world_mesh = std::nullopt;  ///< where that stands
};

struct SceneTruth {
  Plane table;
  std::vector<TrueObject> objects;
};

}  // namespace symscene
