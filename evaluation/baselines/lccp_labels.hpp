#pragma once

#include <span>

#include "symscene/baselines/lccp.hpp"

// Implemented by lccp_pcl.cpp, the only file that includes PCL.
namespace symscene {

/// For every tolerance [rad] the segment of each point, or `no_segment` if it is in no supervoxel.
/// The cloud has points and normals.
std::vector<std::vector<Index>> lccp_labels(const PointCloud& cloud, const LccpOptions& options,
                                            std::span<const double> tolerances);

}  // namespace symscene
