#pragma once

#include <optional>

#include "symscene/core/object_box.hpp"
#include "symscene/core/object_class.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// The frame fixed to an object and the box around its points (N×3, world frame) [m]. Axes that
/// the class fixes are the axes of the frame, in the order of ObjectClass::axes. What it leaves
/// free turns the box to the least volume; without a class one of the edges is along `up`, the
/// unit normal of the table, or along a principal axis of the points, whichever gives the smaller
/// box. z is the axis of the class or, for classes without one and for none, the edge nearest to
/// `up`, and points up. None without points.
std::optional<ObjectBox> object_box(const Points& points,
                                    const std::optional<ObjectClass>& symmetry_class,
                                    const std::optional<Eigen::Vector3d>& up);

}  // namespace symscene
