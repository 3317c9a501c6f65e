#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/tabletop/tabletop_options.hpp"

namespace symscene {

/// What is known about the table before the search.
struct TablePrior {
  std::optional<Plane> plane = std::nullopt;         ///< the table itself
  std::optional<Eigen::Vector3d> up = std::nullopt;  ///< the direction that the table faces
  std::vector<Eigen::Vector3d> viewpoints = {};      ///< positions of the cameras [m]
  bool absent = false;                               ///< there is no table: none is searched
  bool any_up = false;  ///< the sensor was not held upright: its pose does not tell `up`
};

/// A plane of the scene, rated as a table.
struct SupportPlane {
  Plane plane;               ///< least-squares plane of the inliers; its normal points to the side
                             ///< from which the surface was seen
  double residual = 0.0;     ///< root mean square distance of the inliers [m]
  double area = 0.0;         ///< area that the inliers cover [m²]
  double object_area = 0.0;  ///< area of the table below objects [m²]
  double beneath = 0.0;      ///< points of surfaces at an angle just below it, over its inliers
  bool is_tilted = false;    ///< more than max_tilt from the known upward direction
  double score = 0.0;        ///< geometric mean of both extents: a table is large and carries
                             ///< objects. Solid angles where the cameras are known, else areas
  PointIndices inliers;  ///< into the searched points, ascending: all patches of a table, else one
  std::vector<Eigen::Vector3d> outline;  ///< corners of the convex hull of the inliers, on the
                                         ///< plane, counter-clockwise [m]
};

enum class SupportStatus : std::uint8_t { found, none, several };

struct SupportPlanes {
  SupportStatus status = SupportStatus::none;
  std::vector<SupportPlane> supports;  ///< by descending score; if several, with the alternatives
  std::vector<SupportPlane> others;    ///< walls and small planes
};

/// The objects on a table.
struct TableObjects {
  PointCloud cloud;                   ///< one point per voxel
  double clearance = 0.0;             ///< height from which points were taken [m]
  std::size_t dropped_fragments = 0;  ///< small, or mostly off the table
  std::size_t dropped_points = 0;     ///< of these, one per voxel
};

/// A table and the objects on it; empty without a table.
struct TableScene {
  SupportPlanes planes;  ///< the table is the first of the supports
  TableObjects objects;
  bool is_against_up = false;  ///< found where `up` was disregarded, as no table with objects faces
                               ///< up: the camera was not upright
};

}  // namespace symscene
