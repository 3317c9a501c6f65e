#pragma once

#include "target.hpp"

namespace symscene {

/// Calls visit(i, along) for every sample within `radius` of the line through `origin` along
/// `direction`, a unit vector; `along` is the distance from the origin along it. [m]
template <class Visit>
void for_each_near_line(const SurfaceSamples& samples, const Eigen::Vector3f& origin,
                        const Eigen::Vector3f& direction, float radius, const Visit& visit) {
  const PointBlocks& blocks = samples.blocks;
  for (Eigen::Index block = 0; block < blocks.size(); ++block) {
    const Eigen::Vector3f offset = blocks.centres.row(block).transpose() - origin;
    if ((offset - offset.dot(direction) * direction).norm() > blocks.radii[block] + radius)
      continue;
    for (Eigen::Index i = blocks.begin(block); i < blocks.end(block); ++i) {
      const Eigen::Vector3f p = samples.positions.row(i).transpose() - origin;
      const float along = p.dot(direction);
      if ((p - along * direction).squaredNorm() <= radius * radius) visit(i, along);
    }
  }
}

}  // namespace symscene
