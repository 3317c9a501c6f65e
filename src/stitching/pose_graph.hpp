#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

namespace symscene {

/// A pair of frames of which the relative pose is known.
struct PoseEdge {
  std::size_t first = 0;
  std::size_t second = 0;
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  double weight = 0.0;  ///< how sure it is, e.g. matches that agree
};

/// Poses of frames along the tree of edges of greatest weight (Kruskal 1956), in the frame of the
/// first of the largest group of frames that edges join; none for frames outside it.
std::vector<std::optional<Eigen::Isometry3d>> chain_poses(std::size_t frames,
                                                          std::span<const PoseEdge> edges);

}  // namespace symscene
