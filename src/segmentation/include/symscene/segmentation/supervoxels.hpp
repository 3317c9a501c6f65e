#pragma once

#include <numbers>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct SupervoxelOptions {
  double seed_spacing = 0.025;
  double spatial_weight = 0.4;
  double normal_weight = 1.0;
  int iterations = 5;
  double merge_angle = radians(20.0);

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("seed_spacing", self.seed_spacing, "m", above(0.0),
          "distance between the seeds of supervoxels, R_seed (Papon et al. 2013)");
    visit("spatial_weight", self.spatial_weight, "", at_least(0.0),
          "weight of the distance in a supervoxel's metric, in units of seed_spacing (Papon et al. "
          "2013)");
    visit("normal_weight", self.normal_weight, "", at_least(0.0),
          "weight of the difference of normals in a supervoxel's metric (Papon et al. 2013)");
    visit("iterations", self.iterations, "", at_least(1.0),
          "rounds of growing supervoxels and of moving their centres (Papon et al. 2013)");
    visit("merge_angle", self.merge_angle, "rad", between(0.0, std::numbers::pi),
          "adjacent supervoxels whose mean normals differ by less are merged (section 3.4.1)");
  }
  /// Throws InputError if a field is out of its range or both weights are zero.
  void validate() const;
};

/// A partition of a cloud: the label of every point, 0 … count − 1, none without points.
struct Partition {
  std::vector<Index> labels;
  Index count = 0;
};

/// Supervoxels that keep to boundaries of the surface (Papon et al. 2013, without colour), on a
/// cloud of one point per voxel with unit normals. `neighbors` holds the points in adjacent voxels.
/// Every point belongs to one supervoxel, and each supervoxel is connected: points that no path of
/// neighbours joins never share one. In place of the paper's grid, seeds are at least
/// `seed_spacing` apart along the surface, so that supervoxels move with the cloud.
Partition supervoxels(const PointCloud& cloud, const NeighborLists& neighbors,
                      const SupervoxelOptions& options = {});

/// Supervoxels, adjacent ones with nearly equal normals merged (section 3.4.1): the borders that
/// are left lie where the surface bends.
Partition facets(const PointCloud& cloud, const NeighborLists& neighbors,
                 const SupervoxelOptions& options = {});

}  // namespace symscene
