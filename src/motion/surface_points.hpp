#pragma once

#include "symscene/grasping/planner.hpp"

namespace symscene {

/// Points of an object's closed surface at most about `spacing` apart, or its observed points if it
/// has none: one in each cube of half that edge. [m]
std::vector<Eigen::Vector3f> surface_points(const GraspObject& object, float spacing);

/// One of the points in each cube of that edge, in order of the cubes.
std::vector<Eigen::Vector3f> one_per_cube(const std::vector<Eigen::Vector3f>& points, float edge);

}  // namespace symscene
