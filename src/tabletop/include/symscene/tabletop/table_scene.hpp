#pragma once

#include "symscene/tabletop/support_plane.hpp"

namespace symscene {

struct TableCropOptions {
  double voxel_size = 0.005;     ///< spacing of the objects' points, section 2.1.2 [m]
  double min_clearance = 0.005;  ///< height over the table from which points are not its own [m]
  double max_clearance = 0.015;  ///< the same where the table's points are rough [m]
  double max_height = 0.6;       ///< of the objects [m]
  double overhang = 0.05;        ///< of an object over the table's border [m]
  double link = 0.012;           ///< points closer than this are of one fragment [m]
  int min_fragment = 40;         ///< points at voxel_size that a fragment needs
  bool follow_bend = true;       ///< heights are over a quadric: drift bends tables

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", "spacing of the objects' points");
    visit("min_clearance", self.min_clearance, "m",
          "least height of points that are not the table's");
    visit("max_clearance", self.max_clearance, "m", "the same where the table is rough");
    visit("max_height", self.max_height, "m", "height of the objects");
    visit("overhang", self.overhang, "m", "how far an object may reach over the border");
    visit("link", self.link, "m", "points closer than this are of one fragment");
    visit("min_fragment", self.min_fragment, "", "points of the smallest fragment that is kept");
    visit("follow_bend", self.follow_bend, "", "measure heights over the table as it is bent");
  }
  void validate() const;
};

struct TableSceneOptions {
  SupportPlaneOptions plane;
  TableCropOptions crop;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("plane", self.plane);
    visit("crop", self.crop);
  }
  void validate() const;
};

/// What stands on a table.
struct TableObjects {
  PointCloud cloud;                   ///< a point a voxel
  double clearance = 0.0;             ///< height from which points were taken [m]
  std::size_t dropped_fragments = 0;  ///< small, or off the table for the most part
  std::size_t dropped_points = 0;     ///< of these, a point a voxel
};

/// The points over the table and inside its outline, thinned to a point a voxel, without stray
/// fragments. A connected fragment is kept or dropped whole: it is kept if half of its points or
/// more are inside the outline. Points of `walls` are left out.
TableObjects objects_on(const PointCloud& cloud, const SupportPlane& table,
                        const std::vector<SupportPlane>& walls,
                        const TableCropOptions& options = {});

/// A table and what stands on it; empty without a table.
struct TableScene {
  SupportPlanes planes;  ///< the table is the first of the supports
  TableObjects objects;
};

/// Finds the table in the oriented points of a whole reconstruction and what stands on it.
TableScene find_table_scene(const PointCloud& cloud, const TableSceneOptions& options = {},
                            const std::optional<Eigen::Vector3d>& up = std::nullopt);

/// The same with a table that is given.
TableScene table_scene_on(const PointCloud& cloud, const Plane& table,
                          const TableSceneOptions& options = {});

}  // namespace symscene
