#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symscene/grasping/planner.hpp"

namespace symscene {

/// Points in blocks, each of one cube of space and consecutive in its arrays.
struct PointBlocks {
  Points centres;                       ///< of the balls around the points of blocks, B×3 [m]
  Eigen::ArrayXf radii;                 ///< of these balls [m]
  std::vector<Eigen::Index> ends = {};  ///< of blocks; each begins where the one before it ends

  Eigen::Index size() const { return radii.size(); }
  Eigen::Index begin(Eigen::Index block) const {
    return block == 0 ? 0 : ends[static_cast<std::size_t>(block) - 1];
  }
  Eigen::Index end(Eigen::Index block) const { return ends[static_cast<std::size_t>(block)]; }
};

/// Points of a surface about 4 mm apart, each with the area that it stands for, in blocks. Every
/// point of the surface has one within 4.5 mm; they lie up to 2 mm from it, as means of neighbours.
struct SurfaceSamples {
  Points positions;  ///< N×3 [m]
  Points normals;    ///< N×3, outwards; of mere points zero
  Eigen::VectorXf areas;
  std::vector<std::uint8_t> observed;
  PointBlocks blocks;

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
  /// Away from the table; without a table `seen_from`, or along z if that is not known.
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /// From where the object was seen, a unit vector; zero if that is not known.
  Eigen::Vector3d seen_from = Eigen::Vector3d::Zero();
};

/// The mean of the normals that were seen, as a unit vector: roughly the direction from the surface
/// to the camera. Zero for a surface that was seen from many sides.
Eigen::Vector3d mean_seen_normal(std::span<const SurfaceSamples> surfaces);

/// `samples` are those of the object, `seen_from` is mean_seen_normal().
GraspTarget grasp_target(const GraspScene& scene, std::size_t id, const SurfaceSamples& samples,
                         const Eigen::Vector3d& seen_from);

}  // namespace symscene
