#pragma once

#include <vector>

#include "symscene/core/scene.hpp"

namespace symscene {

/// At most three planes at right angles to each other, those of lowest residual first. Their
/// reflections and products are a finite group of eight. Planes at other angles generate an
/// infinite group unless the angles are exact. `tolerance`: of a right angle. [rad]
std::vector<ReflectionPlane> perpendicular_planes(const std::vector<ObjectPlane>& planes,
                                                  double tolerance);

}  // namespace symscene
