#include "distinct_candidates.hpp"

#include <algorithm>

#include "core/without_repeats.hpp"

namespace symscene {
namespace {

/// The plane of a candidate, and where it was proposed.
struct PlacedPlane {
  ReflectionPlane plane;
  Eigen::Vector3d centroid;  ///< of its support [m]
};

PlacedPlane placed_plane(const ReflectionalCandidate& candidate, const PointCloud& cloud) {
  return {candidate.plane, centroid(cloud.positions, candidate.support)};
}

/// Whether `a` repeats `b`.
bool repeats(const PlacedPlane& a, const PlacedPlane& b, const EqualPlanes& equal) {
  const SameSymmetry same{a.centroid, equal.angle, equal.distance};
  return (a.centroid - b.centroid).norm() < equal.max_support_distance && same(a.plane, b.plane);
}

struct PlacedCandidate {
  ReflectionalCandidate candidate;
  PlacedPlane place;
};

}  // namespace

std::vector<ReflectionalCandidate> distinct_candidates(
    std::vector<ReflectionalCandidate> candidates, const PointCloud& cloud,
    const EqualPlanes& equal) {
  std::vector<PlacedCandidate> placed;
  for (ReflectionalCandidate& candidate : candidates) {
    const PlacedPlane place = placed_plane(candidate, cloud);
    placed.push_back({std::move(candidate), place});
  }
  placed =
      without_repeats(std::move(placed), [&](const PlacedCandidate& a, const PlacedCandidate& b) {
        return repeats(a.place, b.place, equal);
      });
  candidates.clear();
  for (PlacedCandidate& kept : placed) candidates.push_back(std::move(kept.candidate));
  return candidates;
}

std::vector<ReflectionalCandidate> without_known(std::vector<ReflectionalCandidate> others,
                                                 const std::vector<ReflectionalCandidate>& known,
                                                 const PointCloud& cloud,
                                                 const EqualPlanes& equal) {
  std::vector<PlacedPlane> before;
  for (const ReflectionalCandidate& candidate : known)
    before.push_back(placed_plane(candidate, cloud));
  std::erase_if(others, [&](const ReflectionalCandidate& other) {
    const PlacedPlane place = placed_plane(other, cloud);
    return std::any_of(before.begin(), before.end(), [&](const PlacedPlane& known_plane) {
      return repeats(place, known_plane, equal);
    });
  });
  return others;
}

}  // namespace symscene
