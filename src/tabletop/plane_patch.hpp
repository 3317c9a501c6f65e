#pragma once

#include <cstdint>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Coordinates within a plane.
class PlaneFrame {
 public:
  explicit PlaneFrame(const Plane& plane)
      : plane_(plane), basis_(orthonormal_complement(plane.normal)) {}

  const Plane& plane() const { return plane_; }
  Eigen::Vector2d within(const Eigen::Vector3d& point) const { return basis_.transpose() * point; }
  Eigen::Vector3d lift(const Eigen::Vector2d& point) const {
    return basis_ * point - plane_.offset * plane_.normal;
  }

 private:
  Plane plane_;
  Eigen::Matrix<double, 3, 2> basis_;
};

/// A convex polygon, counter-clockwise.
class ConvexOutline {
 public:
  ConvexOutline() = default;
  /// The convex hull of points (Andrew 1979).
  explicit ConvexOutline(std::vector<Eigen::Vector2d> points);

  const std::vector<Eigen::Vector2d>& corners() const { return corners_; }
  /// Signed distance of a point, negative inside. Exact beside edges, a lower bound beyond corners;
  /// infinite without corners. [m]
  double distance(const Eigen::Vector2d& point) const;

 private:
  /// From a corner to the next one.
  struct Side {
    Eigen::Vector2d corner, edge;
    double length;  ///< [m]
  };

  std::vector<Eigen::Vector2d> corners_;
  std::vector<Side> sides_;  ///< one per corner
};

/// The outline with these corners, given in the space around the plane.
ConvexOutline outline_of(const std::vector<Eigen::Vector3d>& corners, const PlaneFrame& frame);

/// A grid over a plane; a cell is occupied if it holds points.
class PlaneCells {
 public:
  /// Cells of `edge` [m], or of a multiple where points are spread over more than 4 million cells.
  PlaneCells(const std::vector<Eigen::Vector2d>& points, double edge);

  /// Groups of cells that belong together, across gaps of one cell.
  struct Patches {
    std::vector<std::size_t> cells;      ///< of each patch
    std::vector<std::int32_t> of_point;  ///< the patch of each point
  };
  Patches patches() const;

  /// The indices of the points in the largest patch, ascending.
  std::vector<std::size_t> largest_patch() const;

  /// The indices of the points in all patches of a table, ascending: the largest, those larger than
  /// a hundredth of it within `gap` [m] of the others' convex hull, and those inside that hull.
  std::vector<std::size_t> table_patches(const std::vector<Eigen::Vector2d>& points,
                                         double gap) const;

  /// Calls visit(middle) for every occupied cell.
  template <class Visit>
  void for_each_occupied(const Visit& visit) const {
    for (std::size_t cell = 0; cell < holds_points_.size(); ++cell) {
      if (holds_points_[cell] == 0) continue;
      const auto at = static_cast<std::int32_t>(cell);
      visit(Eigen::Vector2d(low_ +
                            edge_ * Eigen::Vector2d(at % columns_ + 0.5, at / columns_ + 0.5)));
    }
  }

  /// The points that may be corners of the convex hull: those of cells without eight occupied
  /// neighbours.
  std::vector<std::size_t> border() const;

  double area(std::size_t cells) const { return static_cast<double>(cells) * edge_ * edge_; }
  /// The number of occupied cells.
  std::size_t occupied() const;

 private:
  std::int32_t cell_of(const Eigen::Vector2d& point) const;
  bool is_surrounded(std::int32_t cell) const;

  double edge_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<std::int32_t> cell_of_point_;
  std::vector<std::uint8_t> holds_points_;
};

}  // namespace symscene
