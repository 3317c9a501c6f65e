#pragma once

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"
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

/// A scene from a reconstruction, with its table.
struct BuiltScene {
  Scene scene;
  LogOddsMap log_odds;  ///< of the space that the scene's occupancy covers
  TableScene table;
};

/// Finds the table in a reconstructed surface (`plane` if it is given) and the objects on it, and
/// crops the occupancy to a box around them. `up` is the direction that the table faces, if it is
/// known. Without a table the scene and the map are empty. Throws InputError if the surface has no
/// vertices.
BuiltScene build_scene(const TriangleMesh& surface, const OccupancyVolume& occupancy,
                       const std::optional<Plane>& plane, const std::optional<Eigen::Vector3d>& up,
                       const SceneBuildingOptions& options = {});

/// The mean of the cameras' −y axes, which is up for cameras that were held upright; none if they
/// point in different directions.
std::optional<Eigen::Vector3d> upward(const Trajectory& cameras);

}  // namespace symscene
