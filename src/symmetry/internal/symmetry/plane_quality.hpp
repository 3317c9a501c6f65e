#pragma once

#include <span>

#include "symmetry/plane_fit.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"

namespace symscene {

/// The quality of `plane` on the points `members` of `target.cloud`, matched among the points of
/// its cell list; the worst possible if there are none.
PlaneQuality plane_quality(const IndexedCloud& target, std::span<const Index> members,
                           const ReflectionPlane& plane, const DistanceField& field,
                           const ReflectionalDetectionOptions& options);

}  // namespace symscene
