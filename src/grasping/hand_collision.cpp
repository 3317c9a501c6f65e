#include "hand_collision.hpp"

#include <algorithm>
#include <limits>

namespace symscene {
namespace {

/// The lesser of `least` and the distance of a block's points from a box.
float least_distance_in(const SurfaceSamples& samples, const PointBlock& block,
                        const Eigen::Isometry3f& T_tool_world, const HandBox& box,
                        const DistanceBounds& bounds, float least) {
  for (Eigen::Index i = block.begin; i < block.end; ++i) {
    const Eigen::Vector3f p = T_tool_world * Eigen::Vector3f(samples.positions.row(i).transpose());
    const float deepest = ((p - box.centre).cwiseAbs() - box.half).maxCoeff();
    if (deepest >= least) continue;  // most points; the distance is not less
    least = std::min(least, box.distance(p));
    if (least < bounds.enough) break;
  }
  return least;
}

}  // namespace

float least_distance(const SurfaceSamples& samples, const Eigen::Isometry3f& T_tool_world,
                     std::span<const HandBox> boxes, const DistanceBounds& bounds) {
  float least = bounds.irrelevant;
  for (const PointBlock& block : samples.blocks) {
    const Eigen::Vector3f centre = T_tool_world * block.centre;
    for (const HandBox& box : boxes) {
      if (box.distance(centre) - block.radius >= least) continue;
      least = least_distance_in(samples, block, T_tool_world, box, bounds, least);
      if (least < bounds.enough) return least;
    }
  }
  return least;
}

double height_over(const Plane& table, const Eigen::Isometry3d& T_world_tool,
                   std::span<const HandBox> boxes) {
  const Eigen::Vector3d normal = T_world_tool.linear().transpose() * table.normal;
  const double origin = table.signed_distance(T_world_tool.translation());
  double least = std::numeric_limits<double>::infinity();
  for (const HandBox& box : boxes) {
    least = std::min(least, origin + normal.dot(box.centre.cast<double>()) -
                                normal.cwiseAbs().dot(box.half.cast<double>()));
  }
  return least;
}

}  // namespace symscene
