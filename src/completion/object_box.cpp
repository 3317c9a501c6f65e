#include "symscene/completion/object_box.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "least_rectangle.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

/// Extent of points along three axes.
struct Extent {
  Eigen::Vector3d min, max;

  double volume() const { return (max - min).prod(); }
};

Extent extent_along(const Points& points, const Eigen::Matrix3d& axes) {
  const Eigen::Matrix<double, Eigen::Dynamic, 3> along = points.cast<double>() * axes;
  return {along.colwise().minCoeff().transpose(), along.colwise().maxCoeff().transpose()};
}

/// The axis with two others across it along which the box is least.
Eigen::Matrix3d least_box_about(const Eigen::Vector3d& axis, const Points& points) {
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i).transpose().cast<double>();
    flat.emplace_back(p.dot(u), p.dot(v));
  }
  const Eigen::Vector2d along = least_rectangle(flat);
  Eigen::Matrix3d axes;
  axes.col(0) = axis;
  axes.col(1) = along.x() * u + along.y() * v;
  axes.col(2) = axis.cross(axes.col(1));
  return axes;
}

/// Of a box about the table's normal or a principal axis of the points, the least.
Eigen::Matrix3d least_box(const Points& points, const std::optional<Eigen::Vector3d>& up) {
  std::vector<Eigen::Vector3d> edges;
  if (up) edges.push_back(*up);
  const Eigen::Matrix3d principal = principal_axes(points);
  for (int k = 0; k < 3; ++k) edges.push_back(principal.col(k));
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& edge : edges) {
    const Eigen::Matrix3d axes = least_box_about(edge, points);
    const double volume = extent_along(points, axes).volume();
    if (volume >= least) continue;
    least = volume;
    best = axes;
  }
  return best;
}

/// Moves the column nearest to `direction` to the end.
void end_with_nearest(const Eigen::Vector3d& direction, int first, Eigen::Matrix3d& axes) {
  int nearest = first;
  for (int k = first; k < 3; ++k) {
    if (std::abs(axes.col(k).dot(direction)) > std::abs(axes.col(nearest).dot(direction)))
      nearest = k;
  }
  axes.col(nearest).swap(axes.col(2));
}

Eigen::Matrix3d axes_of(const Points& points, const std::optional<ObjectClass>& symmetry_class,
                        const std::optional<Eigen::Vector3d>& up) {
  const SymmetryClass kind = symmetry_class ? symmetry_class->kind : SymmetryClass::none;
  const Eigen::Vector3d direction = up.value_or(Eigen::Vector3d::UnitZ());
  Eigen::Matrix3d axes;
  switch (kind) {
    case SymmetryClass::none:
      axes = least_box(points, up);
      end_with_nearest(direction, 0, axes);
      return axes;
    case SymmetryClass::mirror:
      axes = least_box_about(symmetry_class->axes.col(0), points);
      end_with_nearest(direction, 1, axes);
      return axes;
    case SymmetryClass::n_fold:
      axes = least_box_about(symmetry_class->axes.col(2), points);
      axes.col(0).swap(axes.col(2));
      return axes;
    case SymmetryClass::prism:
    case SymmetryClass::box:
    case SymmetryClass::revolution:
    case SymmetryClass::cylinder:
    case SymmetryClass::sphere:
      break;
  }
  return symmetry_class->axes;
}

/// The direction or its opposite: that which points up, or whose largest coordinate is positive.
Eigen::Vector3d signed_along(const Eigen::Vector3d& axis, const Eigen::Vector3d& up) {
  constexpr double level = 1e-9;
  const double rise = axis.dot(up);
  if (std::abs(rise) > level) return rise < 0.0 ? Eigen::Vector3d(-axis) : axis;
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0.0 ? Eigen::Vector3d(-axis) : axis;
}

/// Right-handed, with unit columns: z up, x to the positive side.
Eigen::Matrix3d oriented(const Eigen::Matrix3d& axes, const std::optional<Eigen::Vector3d>& up) {
  Eigen::Matrix3d frame;
  frame.col(2) = signed_along(axes.col(2), up.value_or(Eigen::Vector3d::UnitZ())).normalized();
  const Eigen::Vector3d x = signed_along(axes.col(0), Eigen::Vector3d::Zero());
  frame.col(1) = frame.col(2).cross(x).normalized();
  frame.col(0) = frame.col(1).cross(frame.col(2));
  return frame;
}

}  // namespace

std::optional<ObjectBox> object_box(const Points& points,
                                    const std::optional<ObjectClass>& symmetry_class,
                                    const std::optional<Eigen::Vector3d>& up) {
  if (points.rows() == 0) return std::nullopt;
  const Eigen::Matrix3d axes = oriented(axes_of(points, symmetry_class, up), up);
  const Extent extent = extent_along(points, axes);
  Eigen::Quaterniond orientation(axes);
  orientation.normalize();
  if (orientation.w() < 0.0) orientation.coeffs() *= -1.0;
  const Eigen::Vector3d middle = axes * (0.5 * (extent.min + extent.max));
  const bool has_center = symmetry_class && symmetry_class->kind != SymmetryClass::none;
  return ObjectBox{{has_center ? symmetry_class->center : middle, orientation},
                   {middle, orientation},
                   extent.max - extent.min};
}

}  // namespace symscene
