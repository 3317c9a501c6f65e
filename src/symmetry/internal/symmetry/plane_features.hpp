#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "symmetry/point_residuals.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/object_symmetry_options.hpp"

namespace symscene {

/// Locations of the images of an object's points under a plane. Shares leave out points so near to
/// the plane that they correspond to themselves; the rest of the images is unobserved.
struct ImageFeatures {
  double matched = 0.0;        ///< share of images on the surface
  double empty = 0.0;          ///< share in observed free space
  double off_surface = 0.0;    ///< share near the surface, but off it or facing elsewhere
  double buried = 0.0;         ///< share inside the object
  double exact = 0.0;          ///< share that match within max_exact_offset and min_exact_cosine
  double residual = 0.0;       ///< mean offset of matched images from the surface [m]
  double turn = 0.0;           ///< mean angle between normals of matched images and surface [rad]
  double steep_matched = 0.0;  ///< share of matched images among points steep to the plane

  double contradicted() const { return empty + off_surface + buried; }

  /// Residual of the plane on all points, in [0, 1]. Unobserved images have a low weight.
  double plane_residual() const { return 0.75 * contradicted() + 0.25 * (1.0 - matched); }
};

/// A plane with its features on the images of an object's points.
struct MatchedPlane {
  ReflectionPlane plane;
  ImageFeatures images;
};

/// Features of a plane as a reflectional symmetry of an object whose points are known.
struct PlaneFeatures {
  ImageFeatures images;
  double near = 0.0;          ///< share of all points that are near the plane
  double balance = 0.0;       ///< share of all points on the side with fewer
  double across = 0.0;        ///< share of all points with a normal that lies in the plane
  double facing = 0.0;        ///< share of all points with a normal along the plane's
  double tilted = 0.0;        ///< greatest share matched by planes tilted by a small angle
  double shifted = 0.0;       ///< greatest share matched by planes shifted by a small distance
  double extent = 0.0;        ///< of the points along the plane's normal [m]
  double length = 0.0;        ///< greatest extent of the points along a principal axis [m]
  double thickness = 0.0;     ///< least one [m]
  double size = 0.0;          ///< natural logarithm of the number of points
  double roundness = 0.0;     ///< mean distance off the sphere through the points, over its radius
  double upright = 0.0;       ///< |cosine| of the plane's normal and the table's; -1 without one
  double along_axis = 0.0;    ///< |cosine| of the plane's normal and the object's axis; -1 without
  double object_score = 0.0;  ///< of the object
  // Compared with the other planes of the object, by ascending residual:
  double rank = 0.0;          ///< number of planes of lower residual
  double nearest = 0.0;       ///< least angle to one of these; a right angle without any [rad]
  double off_square = 0.0;    ///< least |cosine| with one of these; -1 without any
  double best_matched = 0.0;  ///< share matched by the plane of lowest residual

  /// Calls visit(name, value) for every feature, in this order.
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
    visit("matched", self.images.matched);
    visit("empty", self.images.empty);
    visit("off_surface", self.images.off_surface);
    visit("buried", self.images.buried);
    visit("exact", self.images.exact);
    visit("residual", self.images.residual);
    visit("turn", self.images.turn);
    visit("steep_matched", self.images.steep_matched);
    visit("near", self.near);
    visit("balance", self.balance);
    visit("across", self.across);
    visit("facing", self.facing);
    visit("tilted", self.tilted);
    visit("shifted", self.shifted);
    visit("extent", self.extent);
    visit("length", self.length);
    visit("thickness", self.thickness);
    visit("size", self.size);
    visit("roundness", self.roundness);
    visit("upright", self.upright);
    visit("along_axis", self.along_axis);
    visit("object_score", self.object_score);
    visit("rank", self.rank);
    visit("nearest", self.nearest);
    visit("off_square", self.off_square);
    visit("best_matched", self.best_matched);
  }
};

/// Inputs of the features of a plane besides the points of the object.
struct PlaneContext {
  double object_score = 0.0;
  std::optional<RotationAxis> axis = std::nullopt;
  std::span<const MatchedPlane> better = {};  ///< planes of lower residual, sorted by residual
};

/// Computes the features of planes on the points of one object.
class PlaneFeatureExtractor {
 public:
  /// `points` has unit normals and is not empty. The arguments must outlive this, except the table.
  PlaneFeatureExtractor(const PointCloud& points, const DistanceField& field,
                        const std::optional<Plane>& table, const PlaneFeatureOptions& options);

  MatchedPlane match(const ReflectionPlane& plane) const { return {plane, images_of(plane)}; }

  /// Every feature of a plane that match() returned.
  PlaneFeatures features(const MatchedPlane& matched, const PlaneContext& context) const;

 private:
  enum class Match { none, agrees, disagrees };
  struct Image {
    Match match = Match::none;
    float offset = 0.0F;  ///< from the tangent plane that it matches [m]
    float cosine = 1.0F;  ///< of its normal and that plane's
  };

  ImageFeatures images_of(const ReflectionPlane& plane) const;
  double share_matched_tilted(const ReflectionPlane& plane) const;
  double share_matched_shifted(const ReflectionPlane& plane, double distance) const;
  bool matches_itself(const PlaneReflector& reflector, Index i) const;
  Image matched_image(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const;
  bool is_buried(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const;
  double share_matched(const ReflectionPlane& plane) const;

  const PointCloud& points_;
  const DistanceField& field_;
  std::optional<Plane> table_;
  const PlaneFeatureOptions& options_;
  CellList cells_;
  PointIndices sample_;
  PointIndices neighbor_sample_;
  PointCloud shell_;
  float shell_gap_;
  Eigen::Vector3d centroid_;
  double length_ = 0.0;
  double thickness_ = 0.0;
  double roundness_ = 0.0;
};

}  // namespace symscene
