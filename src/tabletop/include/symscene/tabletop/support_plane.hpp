#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct SupportPlaneOptions {
  double inlier_distance = 0.01;    ///< from the plane; drift bends tables by as much [m]
  double normal_angle = 0.4363323;  ///< of an inlier's normal with the plane's, 25° [rad]
  int sample = 6000;                ///< points that hypotheses are drawn from and counted on
  int hypotheses = 300;             ///< planes that are tried for each that is found
  int max_planes = 6;               ///< that are looked for, walls too
  double min_area = 0.03;           ///< of a plane that supports something [m²]
  double max_tilt = 1.2217305;   ///< of its normal from up, where up is known, 70°: a camera that
                                 ///< looks down on a table is tilted itself [rad]
  double min_clearance = 0.005;  ///< height over the plane from which points are not its own [m]
  double max_height = 0.6;       ///< up to which a plane supports what is above it [m]
  double ambiguity = 0.5;        ///< share of the best plane's score that makes another a rival
  std::uint64_t seed = 1;        ///< of the hypotheses

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("inlier_distance", self.inlier_distance, "m", "distance of a plane's points from it");
    visit("normal_angle", self.normal_angle, "rad", "angle of its points' normals with its own");
    visit("sample", self.sample, "", "points that hypotheses are counted on");
    visit("hypotheses", self.hypotheses, "", "planes that are tried for each that is found");
    visit("max_planes", self.max_planes, "", "planes that are looked for, walls too");
    visit("min_area", self.min_area, "m^2", "area of a plane that supports something");
    visit("max_tilt", self.max_tilt, "rad", "tilt from up, where up is known");
    visit("min_clearance", self.min_clearance, "m", "least height of what stands on a plane");
    visit("max_height", self.max_height, "m", "height up to which things stand on a plane");
    visit("ambiguity", self.ambiguity, "", "share of the best score that makes a rival");
    visit("seed", self.seed, "", "seed of the hypotheses");
  }
  void validate() const;
};

/// A plane of the scene, and how well it would do as a table.
struct SupportPlane {
  Plane plane;               ///< the least-squares plane of the inliers; its normal points to where
                             ///< the surface was seen from
  double residual = 0.0;     ///< root mean square distance of the inliers [m]
  double area = 0.0;         ///< that the inliers cover [m²]
  double object_area = 0.0;  ///< of that, what has something above it [m²]
  double score = 0.0;        ///< the geometric mean of both: a table is large and carries things
  PointIndices inliers;      ///< into the cloud, ascending: one connected patch
  std::vector<Eigen::Vector3d>
      outline;  ///< the corners of the patch' convex hull, on the plane, counter-clockwise [m]
};

enum class SupportStatus : std::uint8_t { found, none, several };

struct SupportPlanes {
  SupportStatus status = SupportStatus::none;
  std::vector<SupportPlane> supports;  ///< by falling score; rivals of the first if several
  std::vector<SupportPlane> others;    ///< walls, and what is too small
};

/// Looks for the planes that things stand on: RANSAC on the positions and normals of a sample of
/// the points, one plane after the other, each refined by least squares on all points of its
/// largest connected patch. Where `up` is known (gravity, or the mean of the cameras' −y axes)
/// only planes that face it are tables. Throws InputError if points have no normals.
SupportPlanes find_support_planes(const PointCloud& cloud, const SupportPlaneOptions& options = {},
                                  const std::optional<Eigen::Vector3d>& up = std::nullopt);

/// A plane that is given: its inliers, area and outline in the cloud; the plane stays as it is but
/// for its normal's length. Without any inlier the outline is empty.
SupportPlane measure_support_plane(const PointCloud& cloud, const Plane& plane,
                                   const SupportPlaneOptions& options = {});

}  // namespace symscene
