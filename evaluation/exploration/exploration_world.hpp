#pragma once

#include <vector>

#include "simulation/depth_renderer.hpp"
#include "symscene/clutter/clutter_views.hpp"
#include "symscene/view_planning/view_candidates.hpp"
#include "true_coverage.hpp"

namespace symscene {

/// The first view is that of the outermost ring of views_on_sphere() which comes first.
constexpr std::size_t first_view = default_view_rings[0].views + default_view_rings[1].views;

/// What all candidates look at: the middle of objects on the table of the clutter benchmark. [m]
Eigen::Vector3d exploration_target();

/// Candidate views of a half sphere over the table of the clutter benchmark. [m], [rad]
std::vector<Eigen::Isometry3d> exploration_candidates(double radius, double first_azimuth);

/// Objects on that table, and its camera, which can look from any of the candidates. World frame of
/// the benchmark.
class ExplorationWorld {
 public:
  ExplorationWorld(const std::vector<TriangleMesh>& objects,
                   std::vector<Eigen::Isometry3d> candidates, const ClutterNoiseOptions& noise,
                   std::uint64_t noise_seed);

  const std::vector<Eigen::Isometry3d>& candidates() const { return candidates_; }
  const TrueCoverage& truth() const { return truth_; }
  /// The same noise each time that it looks from the same candidate.
  ClutterView look(std::size_t candidate) const;

 private:
  std::vector<Eigen::Isometry3d> candidates_;  ///< T_world_camera
  ClutterNoiseOptions noise_;
  std::uint64_t noise_seed_;
  DepthRenderer renderer_;
  TrueCoverage truth_;
};

}  // namespace symscene
