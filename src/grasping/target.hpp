#pragma once

#include <cstdint>
#include <vector>

#include "symscene/grasping/planner.hpp"

namespace symscene {

/// Points of a closed surface, about 3 mm apart, each with the area that it stands for.
struct SurfaceSamples {
  Points positions;  ///< N×3 [m]
  Points normals;    ///< N×3, outwards
  Eigen::VectorXf areas;
  std::vector<std::uint8_t> observed;

  Index size() const { return static_cast<Index>(positions.rows()); }
};

/// Vertices of triangles with short edges, and points inside the others. Moves with the surface.
SurfaceSamples surface_samples(const ObjectSurface& surface);

/// An object as the planner sees it while it grasps this one.
struct GraspTarget {
  int object = 0;
  const GraspObject& description;
  SurfaceSamples samples;
  SolidProperties solid;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< away from the table
};

}  // namespace symscene
