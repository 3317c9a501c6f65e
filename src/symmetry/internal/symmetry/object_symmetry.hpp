#pragma once

#include <optional>
#include <vector>

#include "symmetry/axis_features.hpp"
#include "symmetry/plane_features.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/symmetry/object_symmetry_options.hpp"
#include "symscene/symmetry/observed_scene.hpp"

/// The symmetries of an object whose points are known: candidates are detected on its points alone,
/// their features computed, and the probable ones listed. segment_scene() does so for every object
/// of a scene, detect_object_symmetries() for a single object without a scene.
namespace symscene {

/// A candidate for the rotational symmetry of an object.
struct AxisCandidate {
  RotationAxis axis;
  AxisFeatures features;
  double probability = 0.0;  ///< axis_probability()
};

/// A candidate for a reflectional symmetry of an object.
struct PlaneCandidate {
  ReflectionPlane plane;
  PlaneFeatures features;
  double probability = 0.0;  ///< plane_probability()
};

/// An object whose symmetries are searched.
struct SearchedObject {
  PointIndices points;                       ///< into the scene's cloud, ascending
  double score = 0.0;                        ///< probability of being one whole object
  std::vector<RotationAxis> axes = {};       ///< under which it was segmented
  std::vector<ReflectionPlane> planes = {};  ///< the same, and proposed for its points
};

struct SymmetryCandidates {
  std::optional<AxisCandidate> axis;
  std::vector<PlaneCandidate> planes;  ///< distinct, by ascending residual
};

/// The axis of lowest residual within the bounds, of those under which the object was segmented and
/// those that its points propose; none without such an axis or without the rotational stream.
/// Throws InputError on invalid detection options.
std::optional<AxisCandidate> axis_candidate(const ObservedScene& scene,
                                            const SearchedObject& object,
                                            const SymmetrySearchOptions& options);

/// That axis, and the distinct planes under which the object was segmented or that its points
/// propose. Planes that hold a sufficiently probable axis are implied by it and left out.
SymmetryCandidates symmetry_candidates(const ObservedScene& scene, const SearchedObject& object,
                                       const SymmetrySearchOptions& options);

/// The symmetries of an object, by ascending residual.
struct ListedSymmetries {
  std::vector<ObjectAxis> rotational;
  std::vector<ObjectPlane> reflectional;
};

/// The candidates that are sufficiently probable.
ListedSymmetries list_symmetries(const SymmetryCandidates& candidates,
                                 const ObjectSymmetryOptions& options);

/// Gives symmetries of an object the residuals of list_symmetries() on its points, and sorts them
/// by these. `points` has unit normals and is not empty.
ListedSymmetries with_measured_residuals(ListedSymmetries listed, const PointCloud& points,
                                         const DistanceField& field,
                                         const SymmetrySearchOptions& options);

}  // namespace symscene
