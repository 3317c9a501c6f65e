#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// A plane about a reference point: its unit normal and signed distance from that point [m].
/// (n, d) and (−n, −d) are one plane.
struct MirrorSample {
  Eigen::Vector3d normal;
  double offset;
};

/// Kernel of the density of planes: their difference in angle and in distance at the reference
/// point, each in units of its bandwidth. Unlike n / d, which the thesis clusters, it treats planes
/// through the reference point as any other.
struct PlaneKernel {
  double angle;   ///< [rad]
  double offset;  ///< [m]

  /// In units of the bandwidths; 1 is the kernel's edge.
  double squared_distance(const MirrorSample& a, const MirrorSample& b) const;
};

/// The dominant mode of the density of samples by mean shift with a flat kernel (section 3.4.2),
/// from the densest of `max_starts` samples, evenly spread; none without samples.
std::optional<MirrorSample> dominant_plane(const std::vector<MirrorSample>& samples,
                                           const PlaneKernel& kernel, int max_starts);

}  // namespace symscene
