#pragma once

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Throws InputError unless every point has a finite position and a finite normal.
void require_oriented(const PointCloud& cloud);

}  // namespace symscene
