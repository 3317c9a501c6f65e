#pragma once

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"
#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

struct SceneBuildingOptions {
  TableSceneOptions table;
  double margin = 0.2;            ///< of mapped space around and above the objects [m]
  double table_thickness = 0.03;  ///< of mapped space below the table's plane [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("table", self.table);
    visit("margin", self.margin, "m", "mapped space around and above the objects");
    visit("table_thickness", self.table_thickness, "m", "mapped space below the table's plane");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// A scene made of a reconstruction, and how its table was found.
struct BuiltScene {
  Scene scene;
  LogOddsMap log_odds;  ///< of the space that the scene's occupancy covers
  TableScene table;
};

/// Finds the table in a reconstructed surface (`plane` if it is given) and what stands on it, and
/// cuts the occupancy out around that. `up` is where the table may face, if that is known. Without
/// a table scene and map are empty. Throws InputError if the surface has no vertices.
BuiltScene build_scene(const TriangleMesh& surface, const OccupancyVolume& occupancy,
                       const std::optional<Plane>& plane, const std::optional<Eigen::Vector3d>& up,
                       const SceneBuildingOptions& options = {});

/// The mean of the cameras' −y axes: up, for cameras that were held upright.
std::optional<Eigen::Vector3d> upward(const Trajectory& cameras);

}  // namespace symscene
