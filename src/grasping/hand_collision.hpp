#pragma once

#include <span>

#include "hand_shape.hpp"
#include "target.hpp"

namespace symscene {

/// What bounds a search for the least distance. [m]
struct DistanceBounds {
  float irrelevant = 0.02F;  ///< greater distances count as this
  float enough = 0.0F;       ///< the search ends at the first distance below this
};

/// The least distance of the points from the boxes of a tool frame; negative inside. [m]
float least_distance(const SurfaceSamples& samples, const Eigen::Isometry3f& T_tool_world,
                     std::span<const HandBox> boxes, const DistanceBounds& bounds);

/// The least height of the boxes over a plane. [m]
double height_over(const Plane& table, const Eigen::Isometry3d& T_world_tool,
                   std::span<const HandBox> boxes);

}  // namespace symscene
