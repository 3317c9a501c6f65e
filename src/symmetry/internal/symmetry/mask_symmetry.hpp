#pragma once

#include <optional>
#include <vector>

#include "symmetry/axis_features.hpp"
#include "symmetry/plane_features.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/symmetry/object_symmetry_bounds.hpp"

namespace symscene {

/// An axis that an object may turn about.
struct MeasuredAxis {
  RotationAxis axis;
  AxisFeatures features;
  double probability = 0.0;  ///< axis_probability()
};

/// A plane that may be a mirror of an object.
struct MeasuredPlane {
  ReflectionPlane plane;
  PlaneFeatures features;
  double probability = 0.0;  ///< plane_probability()
};

/// All that is known of the symmetries of an object whose points are known.
struct MeasuredSymmetries {
  std::optional<MeasuredAxis> axis;
  std::vector<MeasuredPlane> planes;  ///< by rising misfit
};

/// The axis that an object's points fit best, of those under which it was cut out and those that
/// its points propose by themselves; none where they fit none, or without the rotational stream.
std::optional<MeasuredAxis> measured_axis(const ObservedScene& scene,
                                          const WholeObjectOptions& options,
                                          const SceneObject& object);

/// That axis, and the distinct planes that the points propose and under which they were cut out.
/// Planes that follow from the axis are left out if it is more likely than not.
MeasuredSymmetries measure_symmetries(const ObservedScene& scene, const WholeObjectOptions& options,
                                      const SceneObject& object);

/// Lists in an object what is probable enough to be a symmetry of it, by rising misfit.
void list_symmetries(const MeasuredSymmetries& measured, const ObjectSymmetryBounds& bounds,
                     SceneObject& object);

}  // namespace symscene
