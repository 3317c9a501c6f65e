#pragma once

#include <span>
#include <vector>

#include "symmetry/fit_status.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/plane_fit_options.hpp"

namespace symscene {

/// A cloud with unit normals and the cell list of its positions. Both must outlive this.
struct IndexedCloud {
  const PointCloud& cloud;
  const CellList& cells;
};

/// A point and the point that its reflection corresponds to.
struct Correspondence {
  Index from;
  Index to;
  float squared_distance;  ///< between the reflected point and `to` [m²]
  float cosine;            ///< of the angle between their normals, folded where walls are thin
};

/// Finds the correspondences of the same points under several planes. Where the planes differ
/// little, as in the rounds of a fit, the last correspondence of a point bounds how far away the
/// next one is. That saves most of the search and does not change its result.
class ReflectionMatcher {
 public:
  /// `sources` are indices into `target.cloud`; both are referred to.
  ReflectionMatcher(const IndexedCloud& target, std::span<const Index> sources,
                    const CorrespondenceOptions& options);

  /// As reflect_onto().
  std::vector<Correspondence> match(const ReflectionPlane& plane);

 private:
  /// How far the correspondence of the k-th source may be from its reflection. [m]
  float reach(std::size_t k, const Eigen::Vector3f& reflected) const;

  IndexedCloud target_;
  std::span<const Index> sources_;
  CorrespondenceOptions options_;
  std::vector<Index> last_;  ///< per source the last nearest point
};

/// For every point of `sources` (indices into `target.cloud`) whose reflection lies near a point of
/// the target: the nearest such point. Several sources may share one.
std::vector<Correspondence> reflect_onto(const IndexedCloud& target, std::span<const Index> sources,
                                         const ReflectionPlane& plane,
                                         const CorrespondenceOptions& options);

/// Keeps one correspondence per `to`, ascending: the nearest reflection; ties go to the lower
/// source.
std::vector<Correspondence> one_to_one(const std::vector<Correspondence>& correspondences);

struct PlaneFit {
  ReflectionPlane plane;
  std::size_t correspondences = 0;
  FitStatus status = FitStatus::too_few_points;
};

/// The plane near `initial` that reflects `sources` onto `target`: alternates matching and
/// point-to-plane least squares (Eq. 3.7) in the plane's three degrees of freedom. Steps that the
/// correspondences do not determine (a flat face slid in its own plane) are not taken. The plane's
/// point is the foot of the sources' centroid. Throws InputError on invalid options.
PlaneFit fit_plane(const IndexedCloud& target, std::span<const Index> sources,
                   const ReflectionPlane& initial, const PlaneFitOptions& options = {});

}  // namespace symscene
