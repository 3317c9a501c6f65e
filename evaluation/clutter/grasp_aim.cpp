#include "clutter/grasp_aim.hpp"

namespace symscene {

TrueSurface::Nearest aim_of(const Grasp& grasp, const TrueSurface& surface) {
  constexpr double tip_distance = 0.04;  // from the tool frame to that point [m]
  constexpr double reach = 0.5;          // [m]
  const Eigen::Vector3d point = grasp.T_world_tool * Eigen::Vector3d(0, 0, tip_distance);
  TrueSurface::Nearest nearest = surface.nearest(point, reach);
  if (nearest.mesh == TrueSurface::Nearest::nothing) nearest.mesh = 0;
  return nearest;
}

}  // namespace symscene
