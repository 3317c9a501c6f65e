#pragma once

#include <span>

#include "symscene/core/scene.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// Largest difference between a found and a true symmetry (Eqs. 3.11, 3.12), taken at the centroid
/// of the true object. Section 3.6.1 uses 10° and 10 cm; a grasp needs 1 cm.
struct SymmetryTolerance {
  double angle = radians(10.0);  ///< [rad]
  double distance = 0.01;        ///< [m]
};

/// The comparison of the found with the true symmetries of a scene, axes or planes. For each strict
/// true symmetry only the nearest found one counts as right. A found symmetry is one of
///  - right: the nearest to a strict true symmetry, within the tolerance;
///  - neither: close to a weak true symmetry, or a plane through the axis of a rotational object or
///    the centre of a sphere. It does not count. A true plane through an axis (strict or weak) of
///    its own object counts as weak too: it need not be found;
///  - wrong: all others, including further ones at a true symmetry that has a nearer one.
struct SymmetryMatch {
  std::vector<bool> truth_met;  ///< per strict true symmetry, in the order of the objects
  std::size_t right = 0;
  std::size_t neither = 0;
  std::size_t wrong = 0;

  DetectionCounts detections() const { return {right, right + wrong, truth_met.size()}; }
};

SymmetryMatch match_axes(const SceneTruth& truth, std::span<const RotationAxis> found,
                         const SymmetryTolerance& tolerance);
SymmetryMatch match_planes(const SceneTruth& truth, std::span<const ReflectionPlane> found,
                           const SymmetryTolerance& tolerance);

/// Whether the object has the symmetry within the tolerance, strict, weak or implied by a rotation.
bool is_symmetry_of(const TrueObject& object, const RotationAxis& axis,
                    const SymmetryTolerance& tolerance = {});
bool is_symmetry_of(const TrueObject& object, const ReflectionPlane& plane,
                    const SymmetryTolerance& tolerance = {});

/// All symmetries of the objects of a result, pooled as in section 4.5.2.
std::vector<RotationAxis> all_axes(const std::vector<SceneObject>& objects);
std::vector<ReflectionPlane> all_planes(const std::vector<SceneObject>& objects);

}  // namespace symscene
