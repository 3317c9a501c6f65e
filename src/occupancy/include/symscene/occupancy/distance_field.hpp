#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

struct DistanceFieldOptions {
  double clamp = 0.03;
  bool grow_never_seen = true;
  bool table_depth_counts = true;
  int max_voxels = default_max_voxels;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("clamp", self.clamp, "m", strictly_between(0.0, 1.0), "largest distance (section 2.1.2)");
    visit("grow_never_seen", self.grow_never_seen, "", any_value(),
          "a free voxel beside a never-seen one counts as never seen");
    visit("table_depth_counts", self.table_depth_counts, "", any_value(),
          "below the table the distance is the depth: no object reaches into the table");
    visit("max_voxels", self.max_voxels, "", between(4096.0, 1 << 30),
          "voxels of the field, of three bytes each while it is computed; a larger space gets "
          "coarser ones, up to 16 times, with a warning");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The distance of a point from the nearest space that an object may fill: occupied or never seen.
/// Exact Euclidean distance between voxel centres, clamped, as squared voxels in 8 bits.
struct DistanceField {
  VoxelFrame frame;
  std::vector<std::uint8_t> squared;  ///< squared distance [voxels²]
  std::array<float, 256> metres{};    ///< squared voxels → distance [m]
  float outside = 0.0F;               ///< the distance outside the grid [m]

  /// The distance at a point of the world. [m]
  float at(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f voxel = (point - frame.origin) * inverse_resolution;
    if (!(voxel.x() >= 0.0F && voxel.y() >= 0.0F && voxel.z() >= 0.0F && voxel.x() < upper.x() &&
          voxel.y() < upper.y() && voxel.z() < upper.z())) {
      return outside;
    }
    const std::size_t index = static_cast<std::size_t>(voxel.z()) * frame.slice_length() +
                              static_cast<std::size_t>(voxel.y()) * frame.row_length() +
                              static_cast<std::size_t>(voxel.x());
    return metres[squared[index]];
  }

  float inverse_resolution = 200.0F;                ///< [1/m]
  Eigen::Vector3f upper = Eigen::Vector3f::Zero();  ///< frame.size as floats [voxels]
};

/// The clamped distance transform of a grid (section 2.1.2). The half space under `table` is an
/// obstacle. Separable: along x, y and z the minimum of the squared distance plus the squared step,
/// over the steps that the clamp leaves (Felzenszwalb and Huttenlocher 2012 without the envelope,
/// which pays only for long reaches).
/// Throws InputError if the voxels are so fine that more than 11 of them reach the clamp (a byte
/// holds no more) or not between 0.1 mm and 10 cm.
DistanceField distance_field(const OccupancyGrid& grid, const std::optional<Plane>& table,
                             const DistanceFieldOptions& options = {});

/// The field of a scene whose free space is not known: all distances are 0 except below the table.
DistanceField unknown_distance_field(const Box& box, float resolution,
                                     const std::optional<Plane>& table,
                                     const DistanceFieldOptions& options = {});

}  // namespace symscene
