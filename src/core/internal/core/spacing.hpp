#pragma once

#include <optional>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The median distance from a point to its nearest other point; none for fewer than two points. [m]
std::optional<float> median_spacing(const Points& points);

}  // namespace symscene
