#include "plane_placement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/dispatch.hpp"
#include "core/median.hpp"
#include "core/without_repeats.hpp"

namespace symscene {
namespace {

/// Plane normals in even steps of both spherical angles about the principal axes (section 3.5.3).
std::vector<Eigen::Vector3d> sphere_normals(const Eigen::Matrix3d& axes, int steps) {
  std::vector<Eigen::Vector3d> normals;
  const double step = std::numbers::pi / steps;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double polar = i * step;
      const double azimuth = j * step;
      normals.emplace_back(axes * Eigen::Vector3d(std::cos(polar),
                                                  std::sin(polar) * std::cos(azimuth),
                                                  std::sin(polar) * std::sin(azimuth)));
    }
  }
  return normals;
}

/// Normals of upright planes, beginning with the segment's longest horizontal extent.
std::vector<Eigen::Vector3d> upright_normals(const Eigen::Matrix3d& axes, const Eigen::Vector3d& up,
                                             int steps) {
  Eigen::Vector3d first = axes.col(0) - up.dot(axes.col(0)) * up;
  if (first.norm() < 0.1) first = axes.col(1) - up.dot(axes.col(1)) * up;
  first.normalize();
  const Eigen::Vector3d second = up.cross(first);
  std::vector<Eigen::Vector3d> normals;
  for (int i = 0; i < 2 * steps; ++i) {
    const double angle = i * std::numbers::pi / (2 * steps);
    normals.emplace_back(std::cos(angle) * first + std::sin(angle) * second);
  }
  return normals;
}

/// A point and those before it, with what the votes of their pairs depend on.
struct PairVotes {
  const float *squared_distance, *cosine, *heights, *facing;  ///< of the points before it
  float height, twice_facing;                                 ///< of the point
  float squared_radius, min_gap, min_cosine;
  std::size_t count;
};

/// Sets votes[j] to 1 for the points that a plane could swap with the point, to 0 for others.
SYMSCENE_MULTIVERSION
void find_partners(const PairVotes& pairs, std::int32_t* votes) {
  const PairVotes p = pairs;
  for (std::size_t j = 0; j < p.count; ++j) {
    const float gap = p.height - p.heights[j];
    const bool apart = std::abs(gap) >= p.min_gap;
    const bool near = p.squared_distance[j] - gap * gap <= p.squared_radius;
    const bool facing_alike = p.cosine[j] - p.twice_facing * p.facing[j] > p.min_cosine;
    votes[j] = (apart & near & facing_alike) ? 1 : 0;
  }
}

/// The offset of a plane of known normal: pairs of points that such a plane could swap vote for it.
class OffsetVotes {
 public:
  OffsetVotes(const PointCloud& points, const Eigen::Vector3d& reference, double min_plane_distance,
              const PlanePlacementOptions& options)
      : min_cosine_(static_cast<float>(std::cos(options.shift_angle))),
        min_gap_(2.0F * static_cast<float>(min_plane_distance)),
        points_(
            select(points, evenly_spread(points.size(), static_cast<Index>(options.max_points)))),
        radius_(reach(points, points_, options.shift_radius)) {
    points_.positions.rowwise() -= reference.cast<float>().transpose();
    for (Index i = 1; i < points_.size(); ++i) {
      for (Index j = 0; j < i; ++j) {
        squared_distances_.push_back(
            (points_.positions.row(i) - points_.positions.row(j)).squaredNorm());
        cosines_.push_back(points_.normals.row(i).dot(points_.normals.row(j)));
      }
    }
  }

  /// The median offset of the planes that swap two points, each (p_i + p_j) · n / 2 (Eq. 3.2,
  /// corrected); zero if there are none.
  double median(const Eigen::Vector3d& plane_normal) const {
    const Eigen::Vector3f n = plane_normal.cast<float>();
    const Eigen::VectorXf heights = points_.positions * n;
    const Eigen::VectorXf facing = points_.normals * n;
    std::vector<std::int32_t> votes(points_.size());
    std::vector<float> offsets;
    for (Index i = 1; i < points_.size(); ++i) {
      const std::size_t first = std::size_t{i} * (i - 1) / 2;
      find_partners({squared_distances_.data() + first, cosines_.data() + first, heights.data(),
                     facing.data(), heights[i], 2.0F * facing[i], radius_ * radius_, min_gap_,
                     min_cosine_, i},
                    votes.data());
      for (Index j = 0; j < i; ++j) {
        if (votes[j] != 0) offsets.push_back(0.5F * (heights[i] + heights[j]));
      }
    }
    return double{symscene::median(std::move(offsets)).value_or(0.0F)};
  }

 private:
  /// Subsampled points have fewer partners, so that the radius grows with their spacing.
  static float reach(const PointCloud& all, const PointCloud& subsampled, double radius) {
    const double thinning = static_cast<double>(all.size()) / subsampled.size();
    return static_cast<float>(radius * std::sqrt(std::max(1.0, 0.25 * thinning)));
  }

  float min_cosine_;
  float min_gap_;
  PointCloud points_;
  float radius_;
  std::vector<float> squared_distances_, cosines_;  ///< of pairs j < i, by i, then j
};

std::vector<Eigen::Vector3d> sampled_normals(const PointCloud& points,
                                             const std::optional<Eigen::Vector3d>& up, int steps) {
  const Eigen::Matrix3d axes = principal_axes(points.positions);
  std::vector<Eigen::Vector3d> normals = sphere_normals(axes, steps);
  if (up) {
    const std::vector<Eigen::Vector3d> upright = upright_normals(axes, *up, steps);
    normals.insert(normals.end(), upright.begin(), upright.end());
  }
  return without_repeats(std::move(normals),
                         [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                           return line_angle(a, b) < radians(1.0);
                         });
}

}  // namespace

std::vector<ReflectionPlane> placed_planes(const PointCloud& points,
                                           const std::optional<Eigen::Vector3d>& up,
                                           double min_plane_distance,
                                           const PlanePlacementOptions& options) {
  const Eigen::Vector3d reference = centroid(points.positions);
  const OffsetVotes votes(points, reference, min_plane_distance, options);
  std::vector<ReflectionPlane> planes;
  for (const Eigen::Vector3d& normal : sampled_normals(points, up, options.azimuth_steps))
    planes.push_back({reference + votes.median(normal) * normal, normal});  // Eq. 3.8
  return planes;
}

}  // namespace symscene
