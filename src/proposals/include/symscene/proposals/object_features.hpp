#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// What speaks for and against a set of points being one whole object, whatever proposed it.
struct ObjectFeatures {
  double size = 0.0;         ///< natural logarithm of the number of points
  double broken = 0.0;       ///< weight of the edges that leave the set, by the root of its size
  double torn = 0.0;         ///< share of the leaving edges that do not bend inwards clearly
  double rim = 0.0;          ///< points with an edge that leaves the set, by the root of its size
  double bend = 0.0;         ///< mean weakness of the edges inside that bend inwards
  double crease = 0.0;       ///< share of the edges inside that bend inwards clearly
  double seam = 0.0;         ///< weakness of the border at which it comes apart (SurfaceRegions)
  double unity = 0.0;        ///< share of the largest connected piece
  double convexity = 0.0;    ///< share of pairs of points of which none is before the other
  double empty = 0.0;        ///< share of places between two points that were seen empty
  double length = 0.0;       ///< extents along the principal axes, longest first [m]
  double width = 0.0;        ///< [m]
  double thickness = 0.0;    ///< [m]
  double foot = 0.0;         ///< height of the lowest point over the table, 0 to 0.1 [m]
  double top = 0.0;          ///< of the highest one, 0 to 0.3 [m]
  double near_others = 0.0;  ///< share of points with one outside the set within 2 cm
  double axes = 0.0;         ///< rotational symmetries under which it was cut out
  double axis_misfit = 1.0;  ///< symmetry score of the best of them (Eq. 3.5)
  double axis_occlusion = 1.0;   ///< its occlusion score (Eq. 4.3)
  double planes = 0.0;           ///< reflectional symmetries under which it was cut out
  double plane_inlier = 0.0;     ///< share of points that agree with the best of them (Eq. 3.10)
  double plane_occlusion = 1.0;  ///< its occlusion score (Eq. 4.7)

  double continued = 0.0;   ///< how much another set continues it behind what hides it
  double confidence = 0.0;  ///< of the best cut that made it (section 4.3.3); 0 for none

  /// Calls visit(name, value) for every measure, in this order.
  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("size", self.size);
    visit("broken", self.broken);
    visit("torn", self.torn);
    visit("rim", self.rim);
    visit("bend", self.bend);
    visit("crease", self.crease);
    visit("seam", self.seam);
    visit("unity", self.unity);
    visit("convexity", self.convexity);
    visit("empty", self.empty);
    visit("length", self.length);
    visit("width", self.width);
    visit("thickness", self.thickness);
    visit("foot", self.foot);
    visit("top", self.top);
    visit("near_others", self.near_others);
    visit("axes", self.axes);
    visit("axis_misfit", self.axis_misfit);
    visit("axis_occlusion", self.axis_occlusion);
    visit("planes", self.planes);
    visit("plane_inlier", self.plane_inlier);
    visit("plane_occlusion", self.plane_occlusion);
    visit("continued", self.continued);
    visit("confidence", self.confidence);
  }
  static constexpr std::size_t count = 24;
};

/// Measures sets of points of one scene.
class ObjectMeter {
 public:
  /// `edges` is the surface graph of `cloud`, with weights in [0, 1]; what is referred to has to
  /// stay.
  ObjectMeter(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
              const DistanceField& field, const std::optional<Plane>& table);

  /// All but the seam and what concerns symmetries. `points` are ascending and not empty.
  ObjectFeatures measure(const PointIndices& points) const;

 private:
  struct Neighbor {
    Index index;
    float weight;
    bool concave;
  };

  void measure_edges(const PointIndices& points, const std::vector<std::uint8_t>& inside,
                     ObjectFeatures& features) const;
  void measure_pairs(const PointIndices& points, ObjectFeatures& features) const;
  void measure_extent(const PointIndices& points, ObjectFeatures& features) const;
  double largest_piece(const PointIndices& points, std::vector<std::uint8_t> inside) const;
  double share_near_others(const PointIndices& points,
                           const std::vector<std::uint8_t>& inside) const;

  const PointCloud& cloud_;
  const DistanceField& field_;
  std::optional<Plane> table_;
  std::vector<Index> first_;  ///< N+1: the neighbours of i are [first_[i], first_[i + 1])
  std::vector<Neighbor> neighbors_;
  CellList cells_;
};

}  // namespace symscene
