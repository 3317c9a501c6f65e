#pragma once

#include <optional>

#include "surface_fit.hpp"
#include "symscene/classes/classification.hpp"

namespace symscene {

/// The class of an object whose points a surface explains, with its dimensions; none if much of
/// the surface lies in space that was seen empty, or points lie far beyond its ends.
std::optional<ObjectClass> surface_class(const SurfaceFit& fit, const ClassifiedObject& object,
                                         const PointCloud& others, const FitBounds& bounds,
                                         const ClassOptions& options);

/// Whether the deviation of a radius or apothem is at most that share of it. A surface whose radius
/// the points hardly constrain is as well a plane.
bool has_determined_size(const ObjectClass& found, double max_deviation);

}  // namespace symscene
