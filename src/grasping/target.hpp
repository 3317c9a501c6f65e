#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symscene/grasping/planner.hpp"

namespace symscene {

/// Points of one cube of space, consecutive in their arrays.
struct PointBlock {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float radius = 0.0F;  ///< of the ball around the points [m]
  Eigen::Index begin = 0;
  Eigen::Index end = 0;
};

/// Points of a surface about 4 mm apart, each with the area that it stands for, in blocks. Every
/// point of the surface has one within 4.5 mm; they lie up to 2 mm from it, as means of neighbours.
struct SurfaceSamples {
  Points positions;  ///< N×3 [m]
  Points normals;    ///< N×3, outwards; of mere points zero
  Eigen::VectorXf areas;
  std::vector<std::uint8_t> observed;
  std::vector<PointBlock> blocks;

  Eigen::Index size() const { return positions.rows(); }
};

/// Vertices of triangles with short edges, and points inside the others, merged within 4 mm.
SurfaceSamples surface_samples(const ObjectSurface& surface);

/// Mere points, in blocks.
SurfaceSamples surface_samples(const Points& points);

/// An object as the planner sees it while it grasps this one.
struct GraspTarget {
  int object = 0;
  const GraspObject& description;
  const SurfaceSamples& samples;
  SolidProperties solid;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< away from the table
  /// From where the object was seen, a unit vector; zero if that is not known.
  Eigen::Vector3d seen_from = Eigen::Vector3d::Zero();
};

/// The mean of the normals that were seen, as a unit vector: roughly the direction from the surface
/// to the camera. Zero for a surface that was seen from many sides.
Eigen::Vector3d mean_seen_normal(std::span<const SurfaceSamples> surfaces);

GraspTarget grasp_target(const GraspScene& scene, std::size_t id,
                         const std::vector<SurfaceSamples>& samples);

}  // namespace symscene
