#include "symscene/symmetry/single_object.hpp"

#include <optional>
#include <string>
#include <utility>

#include "core/voxel_sampling.hpp"
#include "object_normals.hpp"
#include "sphere_fit.hpp"
#include "symmetry/object_symmetry.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Maps between the object's frame and the normalised one: x = origin + scale · x'.
struct Normalization {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double scale = 1.0;

  Eigen::Vector3d restored(const Eigen::Vector3d& p) const { return origin + scale * p; }
};

/// Scales `cloud` about its centroid to the normalised diagonal.
Normalization normalize(const SingleObjectOptions& options, PointCloud& cloud) {
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

/// The object as the only one of a scene in which no space is known to be free.
ListedSymmetries search_alone(const PointCloud& points, const SingleObjectOptions& options) {
  const DistanceField unknown = unknown_distance_field(
      bounding_box(points.positions), static_cast<float>(options.voxel_size), std::nullopt);
  const std::optional<Plane> no_table;
  const SearchedObject object{evenly_spread(points.size(), points.size()), 1.0};
  return list_symmetries(symmetry_candidates({points, unknown, no_table}, object, options.search),
                         options.search.object_symmetry);
}

}  // namespace

SingleObjectOptions::SingleObjectOptions() {
  ReflectionalDetectionOptions& planes = search.reflectional_detection;
  planes.placement.azimuth_steps = 8;
  planes.max_points = 1500;
  planes.search.coarse_points = planes.max_points;
  planes.fit.angle_tolerance = PlaneFitOptions{}.angle_tolerance;
  planes.fit.distance_tolerance = PlaneFitOptions{}.distance_tolerance;
  for (CorrespondenceOptions* matching : {&planes.fit.matching, &planes.scoring})
    matching->min_plane_distance = 0.003;
  // Free space does not refute candidates here: more of the surface must support them.
  ObjectSymmetryOptions& bounds = search.object_symmetry;
  bounds.max_axis_residual = 0.06;
  bounds.min_axis_coverage = 0.3;
  bounds.min_plane_matched = 0.5;
  bounds.min_plane_probability = 0.3;
}

void SingleObjectOptions::validate() const {
  check_fields(*this);
  search.validate();
  require_option(voxel_size < normalized_diagonal, "voxel_size",
                 "a length in (0, normalized_diagonal) m", voxel_size);
}

ObjectSymmetries detect_object_symmetries(const PointCloud& cloud,
                                          const SingleObjectOptions& options) {
  options.validate();
  PointCloud points = select(cloud, finite_points(cloud.positions));
  const Normalization normalization = normalize(options, points);
  points = oriented_surface(voxel_downsample(points, options.voxel_size), Eigen::Vector3f::Zero(),
                            options.normals);

  ObjectSymmetries symmetries;
  symmetries.points = points.size();
  symmetries.centroid = normalization.restored(centroid(points.positions));
  if (const auto center = sphere_center(points, options.sphere)) {
    symmetries.sphere = true;
    symmetries.centroid = normalization.restored(*center);
    return symmetries;
  }
  ListedSymmetries listed = search_alone(points, options);
  for (ObjectAxis& found : listed.rotational)
    found.axis.point = normalization.restored(found.axis.point);
  for (ObjectPlane& found : listed.reflectional)
    found.plane.point = normalization.restored(found.plane.point);
  symmetries.rotational = std::move(listed.rotational);
  symmetries.reflectional = std::move(listed.reflectional);
  return symmetries;
}

}  // namespace symscene
