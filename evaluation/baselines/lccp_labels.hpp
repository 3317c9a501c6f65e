#pragma once

#include <span>

#include "symscene/baselines/lccp.hpp"

// What PCL does: the one file that includes it, lccp_pcl.cpp, implements this.
namespace symscene {

/// For every tolerance the segment of each point, or `no_segment` where supervoxels did not reach
/// it. The cloud has points and normals. [rad]
std::vector<std::vector<Index>> lccp_labels(const PointCloud& cloud, const LccpOptions& options,
                                            std::span<const double> tolerances);

}  // namespace symscene
