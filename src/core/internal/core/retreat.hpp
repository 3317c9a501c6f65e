#pragma once

#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/core/grasp.hpp"

namespace symscene {

/// Whether a hand leaves back the way that it came, and not straight up from the table: if it came
/// steeply, or if no table tells what is up. `approach`: the direction in which it came, unit
/// vector in the frame of the table.
inline bool retreats_backwards(const Eigen::Vector3d& approach, const std::optional<Plane>& table) {
  return !table || angle_between(approach, -table->normal) <= backwards_tilt;
}

}  // namespace symscene
