#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/occupancy/distance_field.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

/// Whether no voxel of the grid was observed: the occupancy map is of another place or frame.
bool is_unobserved(const OccupancyGrid& grid);

/// Warnings (one sentence each) if the cloud, the table and the occupancy are likely in different
/// frames: more than half of the points (N×3, world frame) lie farther than `tolerance` [m] below
/// the table or inside free space.
std::vector<std::string> frame_warnings(const Points& points, const DistanceField& field,
                                        const std::optional<Plane>& table, double tolerance);

}  // namespace symscene
