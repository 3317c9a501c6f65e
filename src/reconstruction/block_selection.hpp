#pragma once

#include <vector>

#include "reconstruction/block_index.hpp"
#include "reconstruction/measurement.hpp"
#include "symscene/reconstruction/surface_options.hpp"

namespace symscene {

/// Selects the blocks of a volume that a measurement concerns.
struct BlockSelection {
  const BlockIndex& index;
  const TsdfOptions& options;
  const MeasurementOptions& sensor;

  /// The blocks within the truncation distance of the measured surface that are not in the index,
  /// with repetitions.
  std::vector<Eigen::Vector3i> missing(const Measurement& measurement,
                                       const Eigen::Isometry3d& T_world_camera) const;

  /// The slots of the blocks that may lie in front of the measured surface or just behind it,
  /// ascending.
  std::vector<std::uint32_t> visible(const Measurement& measurement,
                                     const Eigen::Isometry3d& T_camera_world) const;
};

}  // namespace symscene
