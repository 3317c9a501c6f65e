#include "distinct_candidates.hpp"

#include <algorithm>

#include "core/without_repeats.hpp"

namespace symscene {
namespace {

struct PlacedCandidate {
  ReflectionalCandidate candidate;
  Eigen::Vector3d centroid;  ///< of its support [m]
};

std::vector<PlacedCandidate> placed_candidates(std::vector<ReflectionalCandidate> candidates,
                                               const PointCloud& cloud) {
  std::vector<PlacedCandidate> placed;
  for (ReflectionalCandidate& candidate : candidates) {
    const Eigen::Vector3d here = centroid(cloud.positions, candidate.support);
    placed.push_back({std::move(candidate), here});
  }
  return placed;
}

std::vector<ReflectionalCandidate> candidates_of(std::vector<PlacedCandidate> placed) {
  std::vector<ReflectionalCandidate> candidates;
  for (PlacedCandidate& kept : placed) candidates.push_back(std::move(kept.candidate));
  return candidates;
}

/// Whether `a` repeats `b`.
bool repeats(const PlacedCandidate& a, const PlacedCandidate& b, const EqualPlanes& equal) {
  const SameSymmetry same{a.centroid, equal.angle, equal.distance};
  return (a.centroid - b.centroid).norm() < equal.max_support_distance &&
         same(a.candidate.plane, b.candidate.plane);
}

}  // namespace

std::vector<ReflectionalCandidate> distinct_candidates(
    std::vector<ReflectionalCandidate> candidates, const PointCloud& cloud,
    const EqualPlanes& equal) {
  return candidates_of(without_repeats(
      placed_candidates(std::move(candidates), cloud),
      [&](const PlacedCandidate& a, const PlacedCandidate& b) { return repeats(a, b, equal); }));
}

std::vector<ReflectionalCandidate> without_known(std::vector<ReflectionalCandidate> others,
                                                 const std::vector<ReflectionalCandidate>& known,
                                                 const PointCloud& cloud,
                                                 const EqualPlanes& equal) {
  const std::vector<PlacedCandidate> placed = placed_candidates(known, cloud);
  std::vector<PlacedCandidate> further = placed_candidates(std::move(others), cloud);
  std::erase_if(further, [&](const PlacedCandidate& other) {
    return std::any_of(placed.begin(), placed.end(), [&](const PlacedCandidate& before) {
      return repeats(other, before, equal);
    });
  });
  return candidates_of(std::move(further));
}

}  // namespace symscene
