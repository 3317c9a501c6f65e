#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

namespace symscene {

/// The relative pose of two frames.
struct PoseEdge {
  std::size_t first = 0;
  std::size_t second = 0;
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  double weight = 0.0;  ///< confidence, e.g. the number of inliers
};

/// Poses of frames along the tree of edges of greatest weight (Kruskal 1956), in the frame of the
/// first of the largest group of frames that edges join; none for frames outside it.
std::vector<std::optional<Eigen::Isometry3d>> chain_poses(std::size_t frames,
                                                          std::span<const PoseEdge> edges);

}  // namespace symscene
