#pragma once

#include <cstddef>
#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/object_symmetry_bounds.hpp"
#include "symscene/symmetry/point_scores.hpp"

namespace symscene {

/// What speaks for and against a plane being a mirror of an object whose points are known. Shares
/// are of the points that are not so near to the plane that they match themselves.
struct PlaneFeatures {
  double matched = 0.0;      ///< share of images on the surface
  double empty = 0.0;        ///< share in space that was seen empty
  double off_surface = 0.0;  ///< share near the surface, but off it or facing elsewhere
  double buried = 0.0;       ///< share inside the body; what is left is hidden
  double exact = 0.0;        ///< share of images within 1 mm of the surface and 10° of its normal
  double residual = 0.0;     ///< mean distance of matched images off the surface [m]
  double turn = 0.0;         ///< mean angle of matched images and the surface [rad]
  double steep_matched =
      0.0;                    ///< share of matched images where the surface is not across the plane
  double near = 0.0;          ///< share of all points that are near the plane
  double balance = 0.0;       ///< share of all points on the side with fewer
  double across = 0.0;        ///< share of all points with a normal that lies in the plane
  double facing = 0.0;        ///< share of all points with a normal along the plane's
  double tilted = 0.0;        ///< greatest share matched by planes that are turned a little
  double shifted = 0.0;       ///< greatest share matched by planes that are shifted a little
  double extent = 0.0;        ///< of the points along the plane's normal [m]
  double length = 0.0;        ///< greatest extent of the points along a principal axis [m]
  double thickness = 0.0;     ///< least one [m]
  double size = 0.0;          ///< natural logarithm of the number of points
  double roundness = 0.0;     ///< mean distance off the sphere through the points, by its radius
  double upright = 0.0;       ///< |cosine| of the plane's normal and the table's; -1 without one
  double along_axis = 0.0;    ///< |cosine| of the plane's normal and the object's axis; -1 without
  double object_score = 0.0;  ///< of the object
  // Beside other planes of the object, by rising misfit:
  double rank = 0.0;     ///< how many planes fit better
  double nearest = 0.0;  ///< least angle to one of these; a right one without any [rad]
  double off_square =
      0.0;  ///< least sine of how far it is off a right angle to one; -1 without any
  double best_matched = 0.0;  ///< share matched by the first

  /// Calls visit(name, value) for every measure, in this order.
  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("matched", self.matched);
    visit("empty", self.empty);
    visit("off_surface", self.off_surface);
    visit("buried", self.buried);
    visit("exact", self.exact);
    visit("residual", self.residual);
    visit("turn", self.turn);
    visit("steep_matched", self.steep_matched);
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
  static constexpr std::size_t count = 26;

  /// How far the plane is from explaining all points, in [0, 1]: what is hidden speaks neither for
  /// nor against it.
  double misfit() const { return 0.75 * contradicted() + 0.25 * (1.0 - matched); }
  double contradicted() const { return empty + off_surface + buried; }
};

/// Measures planes on the points of one object.
class PlaneMeter {
 public:
  /// What is referred to has to stay. `points` has normals and is not empty.
  PlaneMeter(const PointCloud& points, const DistanceField& field,
             const std::optional<Plane>& table, const ObjectSymmetryBounds& bounds);

  /// What becomes of the points' images, up to `steep_matched`.
  PlaneFeatures measure_images(const ReflectionPlane& plane) const;

  /// Adds all else but the object's score, its axis and its other planes.
  void measure_shape(const ReflectionPlane& plane, PlaneFeatures& features) const;

 private:
  enum class Meeting { none, agrees, disagrees };
  struct Image {
    Meeting meeting = Meeting::none;
    float offset = 0.0F;  ///< off the surface [m]
    float cosine = 1.0F;  ///< of its normal and the surface's
  };

  bool matches_itself(const PlaneReflector& reflector, Index i) const;
  Image meet(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const;
  bool is_buried(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const;
  double share_matched(const ReflectionPlane& plane) const;

  const PointCloud& points_;
  const DistanceField& field_;
  std::optional<Plane> table_;
  const ObjectSymmetryBounds& bounds_;
  CellList cells_;
  PointIndices sample_;
  PointIndices thin_sample_;
  PointCloud shell_;
  float shell_gap_;
  Eigen::Vector3d centroid_;
  double length_ = 0.0;
  double thickness_ = 0.0;
  double roundness_ = 0.0;
};

}  // namespace symscene
