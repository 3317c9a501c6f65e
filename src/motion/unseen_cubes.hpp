#pragma once

#include <cstdint>
#include <vector>

#include "symscene/grasping/planner.hpp"

namespace symscene {

/// A cube of space that is not free.
struct UnseenCube {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  bool is_occupied = false;  ///< in part; else all of it was never seen
  std::int16_t object = -1;  ///< nearest object within reach of a cube that was never seen
};

/// Cubes of about 1 cm of a grid, no voxel of which is free. Occupied ones are left out where a
/// surface is known: within 2 cm of `surfaces` (points per object, those of no object last), as are
/// cubes that reach the table or lie below it, and never-seen ones that no object on the table
/// could reach (FreeColumns). Returns the edge of a cube too. [m]
std::vector<UnseenCube> unseen_cubes(const OccupancyGrid& grid,
                                     const std::vector<std::vector<Eigen::Vector3f>>& surfaces,
                                     const std::optional<Plane>& table, float reach, float& edge);

}  // namespace symscene
