#include "symscene/symmetry/object_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <Eigen/Dense>

#include "core/voxel_sampling.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Maps between the object's frame and the normalised one: x = origin + scale · x'.
struct Normalization {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double scale = 1.0;

  Eigen::Vector3d restored(const Eigen::Vector3d& p) const { return origin + scale * p; }
};

Normalization normalize(const ObjectSymmetryOptions& options, PointCloud& cloud) {
  const Eigen::Vector3d extent = bounding_box(cloud.positions).extent().cast<double>();
  if (cloud.empty() || !(extent.norm() > 0.0) || !extent.allFinite()) {
    throw InputError("object", "points that span a finite extent",
                     std::to_string(cloud.size()) + " points that do not");
  }
  const Normalization normalization{centroid(cloud.positions),
                                    extent.norm() / options.normalized_diagonal};
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p =
        (cloud.position(i).cast<double>() - normalization.origin) / normalization.scale;
    cloud.positions.row(i) = p.cast<float>().transpose();
  }
  return normalization;
}

/// Outwards is away from the middle, which holds on the whole for any closed or convex surface.
OutwardVote away_from_centre() {
  return [](const Eigen::Vector3f& p, const Eigen::Vector3f& n) { return double{p.dot(n)}; };
}

void complete_normals(const ObjectSymmetryOptions& options, PointCloud& cloud) {
  if (oriented_points(cloud).empty())
    cloud.normals = estimate_normals(cloud.positions, away_from_centre(), options.normals);
  const PointIndices oriented = oriented_points(cloud);
  cloud = select(cloud, oriented);
  if (cloud.empty()) throw InputError("object", "a surface with normals", "points that span none");
}

/// The point that the lines of all normals come nearest to: Σ (I − n nᵀ)(p − c) = 0.
Eigen::Vector3d meeting_point_of_normals(const PointCloud& cloud) {
  Eigen::Matrix3d matrix = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d n = cloud.normal(i).cast<double>();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - n * n.transpose();
    matrix += across;
    right_side += across * cloud.position(i).cast<double>();
  }
  return matrix.ldlt().solve(right_side);
}

/// The centre if the surface is a ball's: normals along the radii, all radii alike.
std::optional<Eigen::Vector3d> centre_of_sphere(const PointCloud& cloud) {
  constexpr double max_mean_angle = radians(8.0);
  constexpr double max_radius_deviation = 0.05;
  const Eigen::Vector3d centre = meeting_point_of_normals(cloud);
  double angles = 0.0;
  double radii = 0.0;
  double squared_radii = 0.0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d radius = cloud.position(i).cast<double>() - centre;
    angles += line_angle(radius, cloud.normal(i).cast<double>());
    radii += radius.norm();
    squared_radii += radius.squaredNorm();
  }
  const auto count = static_cast<double>(cloud.size());
  const double mean = radii / count;
  const double deviation = std::sqrt(std::max(0.0, squared_radii / count - mean * mean));
  const bool is_sphere = angles / count < max_mean_angle && deviation < max_radius_deviation * mean;
  return is_sphere ? std::optional(centre) : std::nullopt;
}

/// A plane that contains the axis says nothing that the axis does not.
bool contains(const ReflectionPlane& plane, const RotationAxis& axis,
              const ReflectionalDetectionOptions& options) {
  const double off_axis = std::abs(plane.signed_distance(axis.point));
  return std::abs(line_angle(plane.normal, axis.direction) - std::numbers::pi / 2) <
             options.same_angle &&
         off_axis < options.same_distance;
}

}  // namespace

void ObjectSymmetryOptions::validate() const {
  require_option(normalized_diagonal > 0.0, "normalized_diagonal", "a length above 0 m",
                 normalized_diagonal);
  require_option(voxel_size > 0.0 && voxel_size < normalized_diagonal, "voxel_size",
                 "a length in (0, normalized_diagonal) m", voxel_size);
  normals.validate();
  rotational.validate();
  reflectional.validate();
}

ObjectSymmetries detect_object_symmetries(const PointCloud& cloud,
                                          const ObjectSymmetryOptions& options) {
  options.validate();
  PointCloud object = select(cloud, finite_points(cloud.positions));
  const Normalization normalization = normalize(options, object);
  object = voxel_downsample(object, options.voxel_size);
  complete_normals(options, object);

  const DistanceField unknown = unknown_distance_field(
      bounding_box(object.positions), static_cast<float>(options.voxel_size), std::nullopt);
  PointIndices everything(object.size());
  std::iota(everything.begin(), everything.end(), Index{0});
  const std::vector<PointIndices> segments{everything};

  ObjectSymmetries symmetries;
  symmetries.points = object.size();
  symmetries.centroid = normalization.restored(centroid(object.positions));
  if (const auto centre = centre_of_sphere(object)) {
    symmetries.sphere = true;
    symmetries.centroid = normalization.restored(*centre);
    return symmetries;
  }
  const RotationalDetection axes =
      detect_rotational(object, segments, unknown, std::nullopt, options.rotational);
  const ReflectionalDetection planes =
      detect_reflectional(object, segments, unknown, std::nullopt, options.reflectional);
  for (const RotationalCandidate& candidate : axes.candidates) {
    symmetries.rotational.push_back(
        {{normalization.restored(candidate.axis.point), candidate.axis.direction},
         candidate.scores.symmetry_residual});
  }
  for (const ReflectionalCandidate& candidate : planes.candidates) {
    const bool implied =
        std::any_of(axes.candidates.begin(), axes.candidates.end(), [&](const auto& axis) {
          return contains(candidate.plane, axis.axis, options.reflectional);
        });
    if (implied) continue;
    symmetries.reflectional.push_back(
        {{normalization.restored(candidate.plane.point), candidate.plane.normal},
         1.0 - candidate.scores.inlier_score});
  }
  std::stable_sort(
      symmetries.reflectional.begin(), symmetries.reflectional.end(),
      [](const ScoredPlane& a, const ScoredPlane& b) { return a.residual < b.residual; });
  return symmetries;
}

}  // namespace symscene
