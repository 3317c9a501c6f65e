#include "plane_mode.hpp"

#include <algorithm>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

constexpr int max_shifts = 30;
constexpr double shift_tolerance = 1e-3;  ///< in units of the bandwidths

double sign_towards(const MirrorSample& a, const MirrorSample& b) {
  return a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
}

/// Epanechnikov's estimate, whose maxima mean shift with a flat kernel climbs.
double density(const std::vector<MirrorSample>& samples, const MirrorSample& at,
               const PlaneKernel& kernel) {
  double sum = 0.0;
  for (const MirrorSample& sample : samples)
    sum += std::max(0.0, 1.0 - kernel.squared_distance(sample, at));
  return sum;
}

/// The mean of the samples in the kernel around `at`.
MirrorSample shifted(const std::vector<MirrorSample>& samples, const MirrorSample& at,
                     const PlaneKernel& kernel) {
  MirrorSample sum{Eigen::Vector3d::Zero(), 0.0};
  double count = 0.0;
  for (const MirrorSample& sample : samples) {
    if (kernel.squared_distance(sample, at) > 1.0) continue;
    const double sign = sign_towards(sample, at);
    sum.normal += sign * sample.normal;
    sum.offset += sign * sample.offset;
    count += 1.0;
  }
  return count > 0.0 ? MirrorSample{sum.normal.normalized(), sum.offset / count} : at;
}

}  // namespace

double PlaneKernel::squared_distance(const MirrorSample& a, const MirrorSample& b) const {
  const double apart = (a.offset - sign_towards(a, b) * b.offset) / offset;
  // The chord between the unit normals, which is nearly their angle.
  const double turned = (a.normal - sign_towards(a, b) * b.normal).norm() / angle;
  return apart * apart + turned * turned;
}

std::optional<MirrorSample> dominant_plane(const std::vector<MirrorSample>& samples,
                                           const PlaneKernel& kernel, int max_starts) {
  if (samples.empty()) return std::nullopt;
  const PointIndices starts =
      evenly_spread(static_cast<Index>(samples.size()), static_cast<Index>(max_starts));
  MirrorSample mode = samples[starts.front()];
  double densest = -1.0;
  for (const Index start : starts) {
    const double here = density(samples, samples[start], kernel);
    if (here <= densest) continue;
    densest = here;
    mode = samples[start];
  }
  for (int shift = 0; shift < max_shifts; ++shift) {
    const MirrorSample next = shifted(samples, mode, kernel);
    const double moved = kernel.squared_distance(next, mode);
    mode = next;
    if (moved < shift_tolerance * shift_tolerance) break;
  }
  return mode;
}

}  // namespace symscene
