#pragma once

#include <algorithm>

#include "hand_shape.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// Up to `capacity` consecutive points in the tool frame, as one array per coordinate: each
/// operation on them becomes a few vector instructions.
class ToolPoints {
 public:
  static constexpr Eigen::Index capacity = 64;
  using Values = Eigen::Array<float, Eigen::Dynamic, 1, 0, capacity, 1>;

  /// Points from `begin` on, up to `end` or the capacity.
  ToolPoints(const Points& points_world, Eigen::Index begin, Eigen::Index end,
             const Eigen::Isometry3f& T_tool_world) {
    const auto world = points_world.middleRows(begin, std::min(end - begin, capacity));
    const auto coordinate = [&](Eigen::Index row) -> Values {
      const Eigen::RowVector4f t = T_tool_world.matrix().row(row);
      return t[0] * world.col(0).array() + t[1] * world.col(1).array() +
             t[2] * world.col(2).array() + t[3];
    };
    x_ = coordinate(0);
    y_ = coordinate(1);
    z_ = coordinate(2);
  }

  Eigen::Index size() const { return x_.size(); }
  Eigen::Vector3f operator[](Eigen::Index i) const { return {x_[i], y_[i], z_[i]}; }

  /// The greatest signed distance of each point from the planes of the faces: not greater than its
  /// distance from the box, and equal to that inside. [m]
  Values distance_from_faces(const HandBox& box) const {
    return ((x_ - box.centre.x()).abs() - box.half.x())
        .max((y_ - box.centre.y()).abs() - box.half.y())
        .max((z_ - box.centre.z()).abs() - box.half.z());
  }

 private:
  Values x_, y_, z_;
};

}  // namespace symscene
