#pragma once

#include <optional>
#include <vector>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The distance of each point that has another one to its nearest other point. [m]
std::vector<float> nearest_distances(const Points& points);

/// The median distance from a point to its nearest other point; none for fewer than two points. [m]
std::optional<float> median_spacing(const Points& points);

}  // namespace symscene
