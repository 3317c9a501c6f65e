#pragma once

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"
#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

struct SceneBuildingOptions {
  TableSceneOptions table;
  double margin = 0.2;
  double table_thickness = 0.03;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("table", self.table);
    visit("margin", self.margin, "m", at_least(0.0), "mapped space around and above the objects");
    visit("table_thickness", self.table_thickness, "m", at_least(0.0),
          "mapped space below the table's plane");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A scene from oriented points, with its table.
struct BuiltScene {
  Scene scene;         ///< without a table all points, without `table`
  OrientedBox region;  ///< the space that the scene's occupancy covers; min > max without points
  TableScene table;
};

/// Finds the table in the oriented points of a reconstruction or a single view (the given one if
/// `known` has it) and the objects on it, and crops the occupancy to a box around them. If there is
/// no table, the scene holds all points; it is empty if the table is bare. Throws InputError if
/// there is no point, points have no normals, or no point is on a given plane.
BuiltScene build_scene(const PointCloud& points, const OccupancyVolume& occupancy,
                       const TablePrior& known = {}, const SceneBuildingOptions& options = {});

/// What is known about the table from the poses of cameras: up is the mean of their −y axes, as
/// they were held upright, and not known if these point in different directions.
TablePrior prior_of(const Trajectory& cameras);

}  // namespace symscene
