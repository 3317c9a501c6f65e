#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/object_box.hpp"
#include "symscene/core/object_class.hpp"
#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/solid.hpp"
#include "symscene/core/stage_timer.hpp"

namespace symscene {

/// A scene: the cloud of a table with objects, the occupancy of the space around it, and the table
/// plane. World frame.
struct Scene {
  PointCloud cloud;
  std::optional<OccupancyMap>
      occupancy;               ///< without one, all space off the surface counts as never seen
  std::optional<Plane> table;  ///< unit normal that points up
  std::vector<std::string> warnings = {};  ///< of its reader or builder, one sentence each
};

/// A symmetry of an object or a hypothesis and its residual over their points, 0 for a perfect fit.
struct ObjectAxis {
  RotationAxis axis;
  double residual = 0.0;
};
struct ObjectPlane {
  ReflectionPlane plane;
  double residual = 0.0;
};

/// How a feature moves the score of a proposal, compared with the score that the proposal would
/// have if the feature had its median over all proposals of the scene.
struct ScoreEffect {
  std::string feature;  ///< as in the models' files
  double value = 0.0;
  double median = 0.0;
  double effect = 0.0;  ///< of the log-odds of the score; above 0 it speaks for an object
};

/// An object of the result.
struct SceneObject {
  PointIndices points;  ///< into the result's cloud, ascending
  /// Probability of being one whole object; none without selection.by_score.
  std::optional<double> score = {};
  double confidence = 0.0;  ///< of its best hypothesis (section 4.3.3), in [0, 1]; 0 for none
  std::vector<ObjectAxis> rotational = {};  ///< in ascending order of residual
  std::vector<ObjectPlane> reflectional = {};
  /// Centre of mass under the symmetries, once the object is completed. [m]
  std::optional<Eigen::Vector3d> centroid = {};
  std::optional<ObjectClass> symmetry_class = {};
  std::optional<ObjectBox> box = {};          ///< around it once it is completed
  std::optional<SolidProperties> solid = {};  ///< of its closed surface, if that is not empty
  /// The features that decided its score, see score_effects(); none without selection.by_score.
  std::vector<ScoreEffect> score_effects = {};

  /// By which objects are sorted.
  double rank() const { return score.value_or(confidence); }
};

/// The closed surface of an object: the observed part and what is inferred of its hidden side.
struct ObjectSurface {
  TriangleMesh mesh;
  std::vector<std::uint8_t> observed = {};  ///< per triangle: 1 observed, 0 inferred
};

/// A hypothesis that was rejected or merged, and the bound that it failed.
struct Rejection {
  std::string kind;      ///< "rotational", "reflectional" or "surface"
  std::string reason;    ///< the bound that failed: "symmetry", "occlusion", "smoothness", ...
  double value = 0.0;    ///< value compared with the bound
  double bound = 0.0;    ///< the bound itself
  std::size_t size = 0;  ///< points of the hypothesis
  /// Into the result's cloud, ascending, if known. Files keep at most 128 of them, evenly spread.
  PointIndices points = {};
  /// Of the proposals of the highest scores among those rejected by score.
  std::vector<ScoreEffect> score_effects = {};
};

/// The number of candidates that remain after a step.
struct FunnelStep {
  std::string step;
  std::size_t count = 0;
};

/// The result of segmentation.
struct SegmentationResult {
  PointCloud cloud;                   ///< downsampled, by default to 5 mm; all indices refer to it
  std::optional<Plane> table;         ///< of the scene, if known
  std::vector<SceneObject> objects;   ///< in descending order of rank()
  std::vector<PointCloud> completed;  ///< per object: the points that its symmetries add
  std::vector<ObjectSurface> surfaces = {};  ///< per object: closed, or empty
  std::vector<Rejection> rejected;           ///< hypotheses that did not become objects
  std::vector<FunnelStep> funnel;
  std::vector<StageTime> timings;
  std::vector<std::string> warnings;  ///< limitations of the result, one sentence each
};

}  // namespace symscene
