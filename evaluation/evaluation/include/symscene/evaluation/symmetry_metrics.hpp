#pragma once

#include <span>

#include "symscene/core/scene.hpp"
#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene {

/// How near a found symmetry has to be to a true one (Eqs. 3.11, 3.12), measured where the true
/// object is. Section 3.6.1 uses 10° and 10 cm; 1 cm is what a grasp needs.
struct SymmetryTolerance {
  double angle = radians(10.0);  ///< [rad]
  double distance = 0.01;        ///< [m]
};

/// How the true symmetries of a scene were met, axis by axis or plane by plane. A found symmetry is
/// one of
///  - right: the nearest to a true symmetry that is strict, within the tolerance;
///  - neither: near a weak true symmetry, or a plane through the axis of a rotational object or the
///    centre of a sphere; it does not count. A true plane of that kind, through an axis (strict or
///    weak) of its own object, counts as weak itself: nobody has to find it;
///  - wrong: all others, with those that come second to a true symmetry.
struct SymmetryMatch {
  std::vector<bool> truth_met;  ///< a strict true symmetry each, in the order of the objects
  std::size_t right = 0;
  std::size_t neither = 0;
  std::size_t wrong = 0;

  Score score() const { return {right, right + wrong, truth_met.size()}; }
};

SymmetryMatch match_axes(const SceneTruth& truth, std::span<const RotationAxis> found,
                         const SymmetryTolerance& tolerance);
SymmetryMatch match_planes(const SceneTruth& truth, std::span<const ReflectionPlane> found,
                           const SymmetryTolerance& tolerance);

/// How many symmetries of each object have to be found: its part of `truth_met`.
std::vector<std::size_t> axis_targets(const SceneTruth& truth);
std::vector<std::size_t> plane_targets(const SceneTruth& truth);

/// Whether the symmetry is one of the object, strict, weak or implied by a rotation.
bool is_symmetry_of(const TrueObject& object, const RotationAxis& axis,
                    const SymmetryTolerance& tolerance = {});
bool is_symmetry_of(const TrueObject& object, const ReflectionPlane& plane,
                    const SymmetryTolerance& tolerance = {});

/// All symmetries of a result's objects, as section 4.5.2 pools them.
std::vector<RotationAxis> all_axes(const std::vector<SceneObject>& objects);
std::vector<ReflectionPlane> all_planes(const std::vector<SceneObject>& objects);

}  // namespace symscene
