#include "distinct_candidates.hpp"

#include "core/without_repeats.hpp"

namespace symscene {
namespace {

struct PlacedCandidate {
  ReflectionalCandidate candidate;
  Eigen::Vector3d centroid;  ///< of its support [m]
};

}  // namespace

std::vector<ReflectionalCandidate> distinct_candidates(
    std::vector<ReflectionalCandidate> candidates, const PointCloud& cloud,
    const EqualPlanes& equal) {
  std::vector<PlacedCandidate> placed;
  for (ReflectionalCandidate& candidate : candidates) {
    const Eigen::Vector3d here = centroid(cloud.positions, candidate.support);
    placed.push_back({std::move(candidate), here});
  }
  placed =
      without_repeats(std::move(placed), [&](const PlacedCandidate& a, const PlacedCandidate& b) {
        const SameSymmetry same{a.centroid, equal.angle, equal.distance};
        return (a.centroid - b.centroid).norm() < equal.max_support_distance &&
               same(a.candidate.plane, b.candidate.plane);
      });
  candidates.clear();
  for (PlacedCandidate& kept : placed) candidates.push_back(std::move(kept.candidate));
  return candidates;
}

}  // namespace symscene
