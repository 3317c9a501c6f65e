#include "symscene/completion/completion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <Eigen/Dense>

#include "core/perpendicular_planes.hpp"
#include "core/voxel_sampling.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// Collects oriented points, with colours if wanted.
class CloudBuilder {
 public:
  explicit CloudBuilder(bool with_colors) : with_colors_(with_colors) {}

  void add(const Eigen::Vector3d& position, const Eigen::Vector3d& normal,
           const Eigen::Matrix<std::uint8_t, 1, 3>& color) {
    positions_.push_back(position.cast<float>());
    normals_.push_back(normal.cast<float>());
    if (with_colors_) colors_.push_back(color);
  }

  PointCloud build() const {
    const auto count = static_cast<Eigen::Index>(positions_.size());
    PointCloud cloud;
    cloud.positions.resize(count, 3);
    cloud.normals.resize(count, 3);
    cloud.colors.resize(with_colors_ ? count : 0, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      cloud.positions.row(i) = positions_[k].transpose();
      cloud.normals.row(i) = normals_[k].transpose();
      if (with_colors_) cloud.colors.row(i) = colors_[k];
    }
    return cloud;
  }

 private:
  bool with_colors_;
  std::vector<Eigen::Vector3f> positions_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<Eigen::Matrix<std::uint8_t, 1, 3>> colors_;
};

Eigen::Matrix<std::uint8_t, 1, 3> color_of(const PointCloud& cloud, Index i) {
  return cloud.has_colors() ? Eigen::Matrix<std::uint8_t, 1, 3>(cloud.colors.row(i))
                            : Eigen::Matrix<std::uint8_t, 1, 3>(128, 128, 128);
}

PointCloud joined(const PointCloud& a, const PointCloud& b) {
  CloudBuilder builder(a.has_colors());
  for (const PointCloud* part : {&a, &b}) {
    for (Index i = 0; i < part->size(); ++i) {
      builder.add(part->position(i).cast<double>(), part->normal(i).cast<double>(),
                  color_of(*part, i));
    }
  }
  return builder.build();
}

/// One point of the curve whose rotation is the surface: height along the axis, distance from it,
/// and the components of its normal along the axis and away from it.
struct ProfilePoint {
  double height = 0.0, radius = 0.0, normal_along = 0.0, normal_away = 0.0;
  std::size_t count = 0;
  Index example = 0;
};

/// The profile, averaged in cells of `spacing`; the two faces of a thin wall have separate cells.
std::vector<ProfilePoint> profile_of(const PointCloud& cloud, const RotationAxis& axis,
                                     double spacing) {
  std::map<std::tuple<int, int, bool>, ProfilePoint> cells;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d q = cloud.position(i).cast<double>() - axis.point;
    const Eigen::Vector3d n = cloud.normal(i).cast<double>();
    const double height = axis.direction.dot(q);
    const Eigen::Vector3d away = q - height * axis.direction;
    const double radius = away.norm();
    const double facing = radius > 1e-9 ? n.dot(away) / radius : 0.0;
    ProfilePoint& cell = cells[{static_cast<int>(std::floor(height / spacing)),
                                static_cast<int>(std::floor(radius / spacing)), facing >= 0.0}];
    if (cell.count++ == 0) cell.example = i;
    cell.height += height;
    cell.radius += radius;
    cell.normal_along += n.dot(axis.direction);
    cell.normal_away += facing;
  }
  std::vector<ProfilePoint> profile;
  for (auto& [key, cell] : cells) {
    const auto count = static_cast<double>(cell.count);
    profile.push_back({cell.height / count, cell.radius / count, cell.normal_along,
                       cell.normal_away, cell.count, cell.example});
  }
  return profile;
}

PointCloud rotated_images(const PointCloud& cloud, const RotationAxis& axis, double spacing) {
  const Eigen::Matrix<double, 3, 2> across = orthonormal_complement(axis.direction);
  const Eigen::Vector3d u = across.col(0);
  const Eigen::Vector3d v = across.col(1);
  CloudBuilder images(cloud.has_colors());
  for (const ProfilePoint& point : profile_of(cloud, axis, spacing)) {
    const double turn = 2.0 * std::numbers::pi;
    const int steps =
        std::clamp(static_cast<int>(std::ceil(turn * point.radius / spacing)), 1, 4096);
    for (int step = 0; step < steps; ++step) {
      const double angle = turn * step / steps;
      const Eigen::Vector3d away = std::cos(angle) * u + std::sin(angle) * v;
      const Eigen::Vector3d normal = point.normal_along * axis.direction + point.normal_away * away;
      images.add(axis.point + point.height * axis.direction + point.radius * away,
                 normal.normalized(), color_of(cloud, point.example));
    }
  }
  return images.build();
}

PointCloud reflected_images(const PointCloud& cloud, const ReflectionPlane& plane) {
  CloudBuilder images(cloud.has_colors());
  for (Index i = 0; i < cloud.size(); ++i) {
    images.add(plane.reflect_point(cloud.position(i).cast<double>()),
               plane.reflect_direction(cloud.normal(i).cast<double>()), color_of(cloud, i));
  }
  return images.build();
}

/// The images that are not in observed free space and not near a point of `observed`.
PointCloud admissible(const PointCloud& images, const PointCloud& observed,
                      const DistanceField& field, const CompletionOptions& options) {
  const auto spacing = static_cast<float>(options.spacing);
  const auto tolerance = static_cast<float>(options.free_tolerance);
  const CellList observed_cells(observed.positions, 2.0F * spacing);
  PointIndices kept;
  for (Index i = 0; i < images.size(); ++i) {
    const Eigen::Vector3f p = images.position(i);
    if (field.at(p) <= tolerance && observed_cells.nearest(p, spacing).first == CellList::none)
      kept.push_back(i);
  }
  return select(images, kept);
}

/// The solution along the eigenvectors whose eigenvalues reach `min_eigenvalue`, zero along the
/// others: two planes a few degrees apart do not determine the direction of their bisector.
Eigen::Vector3d solve_where_determined(const Eigen::Matrix3d& matrix,
                                       const Eigen::Vector3d& right_side, double min_eigenvalue) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Eigen::Vector3d solution = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d direction = solver.eigenvectors().col(k);
    const double eigenvalue = solver.eigenvalues()[k];
    if (eigenvalue > min_eigenvalue) solution += direction.dot(right_side) / eigenvalue * direction;
  }
  return solution;
}

}  // namespace

PointCloud complete_object(const PointCloud& observed, const std::vector<ObjectAxis>& axes,
                           const std::vector<ObjectPlane>& planes, const DistanceField& field,
                           const CompletionOptions& options) {
  options.validate();
  PointCloud body = observed;  // grows by the images, so that later planes reflect them too
  const auto extend = [&](const PointCloud& images) {
    const PointCloud added = admissible(images, body, field, options);
    body = joined(body, voxel_downsample(added, options.spacing));
  };
  for (const ObjectAxis& rotational : axes)
    extend(rotated_images(observed, rotational.axis, options.spacing));
  for (const ReflectionPlane& plane : perpendicular_planes(planes, options.square_tolerance))
    extend(reflected_images(body, plane));
  PointIndices added;
  for (Index i = observed.size(); i < body.size(); ++i) added.push_back(i);
  return select(body, added);
}

Eigen::Vector3d centre_of_mass(const CompletedObject& object, const CompletionOptions& options) {
  options.validate();
  const auto observed_count = static_cast<double>(object.observed.size());
  const auto added_count = static_cast<double>(object.added.size());
  const Eigen::Vector3d mean = (centroid(object.observed.positions) * observed_count +
                                centroid(object.added.positions) * added_count) /
                               std::max(1.0, observed_count + added_count);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  const auto attract = [&](const Eigen::Matrix3d& across, const Eigen::Vector3d& point) {
    matrix += across;
    right_side += across * (point - mean);
  };
  for (const ObjectAxis& rotational : object.axes) {
    const Eigen::Vector3d& d = rotational.axis.direction;
    attract(Eigen::Matrix3d::Identity() - d * d.transpose(), rotational.axis.point);
  }
  for (const ObjectPlane& reflectional : object.planes) {
    const Eigen::Vector3d& n = reflectional.plane.normal;
    attract(n * n.transpose(), reflectional.plane.point);
  }
  return mean + solve_where_determined(matrix, right_side, options.min_determined);
}

}  // namespace symscene
