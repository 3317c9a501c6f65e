#include "occupancy/frame_checks.hpp"

#include <algorithm>

namespace symscene {

bool is_unobserved(const OccupancyGrid& grid) {
  return std::all_of(grid.states.begin(), grid.states.end(),
                     [](VoxelState state) { return state == VoxelState::never_seen; });
}

std::vector<std::string> frame_warnings(const Points& points, const DistanceField& field,
                                        const std::optional<Plane>& table, double tolerance) {
  Eigen::Index below = 0;
  Eigen::Index in_free_space = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3f p = points.row(i);
    if (table && table->signed_distance(p.cast<double>()) < -tolerance) {
      ++below;
    } else if (field.at(p) > static_cast<float>(tolerance)) {
      ++in_free_space;
    }
  }
  std::vector<std::string> warnings;
  if (2 * below > points.rows()) {
    warnings.emplace_back(
        "most points lie below the table: does its normal point up, and is it in the cloud's "
        "frame?");
  }
  if (2 * in_free_space > points.rows()) {
    warnings.emplace_back(
        "most points lie in free space of the occupancy map: is it in the cloud's frame?");
  }
  return warnings;
}

}  // namespace symscene
