#include "surface_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/dispatch.hpp"

namespace symscene {
namespace {

/// The options in single precision, as the points are.
struct Tolerances {
  explicit Tolerances(const ContinuationOptions& options)
      : max_gap(static_cast<float>(options.max_gap)),
        max_plane_offset(static_cast<float>(options.max_plane_offset)),
        min_normal_cosine(static_cast<float>(options.min_normal_cosine)),
        empty_distance(static_cast<float>(options.empty_distance)),
        probe_depth(static_cast<float>(options.probe_depth)) {}

  float max_gap, max_plane_offset, min_normal_cosine, empty_distance, probe_depth;
};

/// A point of a surface and its normal, against the points and normals of another.
struct TangentTest {
  float px, py, pz, nx, ny, nz;
  const float *x, *y, *z, *mx, *my, *mz;
  std::size_t count;
};

/// Sets fits[j] to 1 where both points have the same tangent plane, else to 0; whether some point
/// is nearer than the greatest gap. Without sums or minima of floats, which are not vectorised.
SYMSCENE_MULTIVERSION
bool test_tangents(const TangentTest& test, const Tolerances& limits, std::int32_t* fits) {
  const TangentTest t = test;
  const float squared_gap = limits.max_gap * limits.max_gap;
  const float min_cosine = limits.min_normal_cosine, max_offset = limits.max_plane_offset;
  std::int32_t near = 0;
  for (std::size_t j = 0; j < t.count; ++j) {
    const float dx = t.x[j] - t.px, dy = t.y[j] - t.py, dz = t.z[j] - t.pz;
    const float squared = dx * dx + (dy * dy + dz * dz);
    const float cosine = t.nx * t.mx[j] + (t.ny * t.my[j] + t.nz * t.mz[j]);
    const float offset = t.nx * dx + (t.ny * dy + t.nz * dz);
    const float back = t.mx[j] * dx + (t.my[j] * dy + t.mz[j] * dz);
    near |= squared < squared_gap ? 1 : 0;
    const std::int32_t turned = cosine < min_cosine ? 1 : 0;
    const std::int32_t above = std::abs(offset) > max_offset ? 1 : 0;
    const std::int32_t below = std::abs(back) > max_offset ? 1 : 0;
    fits[j] = 1 - (turned | above | below);
  }
  return near != 0;
}

/// The share of points with a flag.
double share(const std::vector<std::uint8_t>& flags) {
  return static_cast<double>(std::count(flags.begin(), flags.end(), std::uint8_t{1})) /
         static_cast<double>(flags.size());
}

}  // namespace

SurfaceSample sample_surface(const PointCloud& cloud, const PointIndices& points,
                             Index max_points) {
  PointIndices chosen;
  for (const Index k : evenly_spread(static_cast<Index>(points.size()), max_points))
    chosen.push_back(points[k]);
  const PointCloud part = select(cloud, chosen);
  SurfaceSample sample{part.positions, part.normals, {}, 0.0F};
  sample.center = centroid(part.positions).cast<float>();
  sample.radius = std::sqrt(
      (part.positions.rowwise() - sample.center.transpose()).rowwise().squaredNorm().maxCoeff());
  return sample;
}

double continuation(const SurfaceSample& a, const SurfaceSample& b, const DistanceField& field,
                    const ContinuationOptions& options) {
  const Tolerances limits(options);
  if ((a.center - b.center).norm() > a.radius + b.radius + limits.max_gap) return 0.0;
  std::vector<std::uint8_t> of_a(static_cast<std::size_t>(a.positions.rows()), 0);
  std::vector<std::uint8_t> of_b(static_cast<std::size_t>(b.positions.rows()), 0);
  const auto count = static_cast<std::size_t>(b.positions.rows());
  std::vector<std::int32_t> fits(count);
  double pairs = 0.0, hidden = 0.0;
  bool near = false;
  for (Eigen::Index i = 0; i < a.positions.rows(); ++i) {
    const Eigen::Vector3f p = a.positions.row(i).transpose(), n = a.normals.row(i).transpose();
    const TangentTest test{p.x(),
                           p.y(),
                           p.z(),
                           n.x(),
                           n.y(),
                           n.z(),
                           b.positions.col(0).data(),
                           b.positions.col(1).data(),
                           b.positions.col(2).data(),
                           b.normals.col(0).data(),
                           b.normals.col(1).data(),
                           b.normals.col(2).data(),
                           count};
    const bool is_near = test_tangents(test, limits, fits.data());
    near = near || is_near;
    for (Eigen::Index j = 0; j < b.positions.rows(); ++j) {
      if (fits[static_cast<std::size_t>(j)] == 0) continue;
      const Eigen::Vector3f across = b.positions.row(j).transpose() - p;
      of_a[static_cast<std::size_t>(i)] = of_b[static_cast<std::size_t>(j)] = 1;
      pairs += 1.0;
      // A little below the surface, where noise does not make it empty.
      const Eigen::Vector3f probe = p + 0.5F * across - limits.probe_depth * n;
      hidden += field.at(probe) <= limits.empty_distance ? 1.0 : 0.0;
    }
  }
  if (!near || pairs == 0.0 || hidden < options.min_hidden_share * pairs) return 0.0;
  return std::min(share(of_a), share(of_b));
}

}  // namespace symscene
