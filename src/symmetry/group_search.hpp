#pragma once

#include <vector>

#include "motion_fit.hpp"
#include "surface_distance.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene {

/// Directions evenly spread over a hemisphere (Fibonacci lattice; Swinbank and Purser 2006).
std::vector<Eigen::Vector3d> hemisphere(int count);

/// A surface of diameter one about its centroid, and the samples of it that are moved.
struct SymmetryModel {
  SymmetryModel(const PointCloud& cloud, const SymmetryGroupOptions& options)
      : surface(cloud),
        coarse(evenly_spread(cloud.size(), static_cast<Index>(options.coarse_points))),
        fitted(evenly_spread(cloud.size(), static_cast<Index>(options.fit_points))),
        judged(evenly_spread(cloud.size(), static_cast<Index>(options.residual_points))) {}

  double residual(const ReflectionPlane& plane) const {
    return mean_distance(surface, judged, motion_of(plane));
  }
  double residual(const RotationAxis& axis, std::span<const double> angles) const {
    return mean_distance(surface, judged, axis, angles);
  }

  /// Whether a motion takes a part, such as a handle, off the surface.
  bool moves_part(const Eigen::Affine3d& motion, const SymmetryGroupOptions& options) const {
    return share_beyond(surface, judged, motion, options.part_distance) > options.part_share;
  }

  /// The mean distance of the surface from an axis.
  double mean_radius(const RotationAxis& axis) const {
    double sum = 0.0;
    for (const Index i : judged) sum += axis.distance(surface.samples().position(i).cast<double>());
    return sum / static_cast<double>(judged.size());
  }

  SurfaceDistance surface;
  PointIndices coarse, fitted, judged;
};

/// The search for the symmetries of a model: planes and axes through its centroid in all
/// directions.
class GroupSearch {
 public:
  GroupSearch(const SymmetryModel& model, const SymmetryGroupOptions& options)
      : model_(model), options_(options), directions_(hemisphere(options.directions)) {}

  /// The planes, best first.
  std::vector<GroupPlane> planes() const;
  /// The axes of an order, best first.
  std::vector<GroupAxis> axes(int order) const;
  /// Axes of all orders, one per direction.
  std::vector<GroupAxis> finite_axes() const;
  /// The other symmetries of a surface of revolution: a plane and half turns across its axis.
  void complete(const GroupAxis& axis, SymmetryGroup& group) const;

 private:
  /// The minima of a distance over all directions that may be within the tolerance, best first.
  template <class Distance>
  std::vector<Eigen::Vector3d> candidates(const Distance& distance_of) const;
  /// Fits of the orders that are multiples of an axis' prime order, and of no lower prime.
  std::vector<GroupAxis> multiples(const GroupAxis& axis) const;
  bool is_least_around(std::size_t k, const std::vector<double>& distances) const;

  const SymmetryModel& model_;
  const SymmetryGroupOptions& options_;
  std::vector<Eigen::Vector3d> directions_;
};

}  // namespace symscene
