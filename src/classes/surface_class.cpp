#include "surface_class.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/median.hpp"
#include "surface_ends.hpp"

namespace symscene {
namespace {

using Ends = std::array<SurfaceEnd, SurfaceModel::planar_faces>;

/// What makes dimensions of a fit.
struct FittedSurface {
  const SurfaceFit& fit;
  const Ends& ends;
  double inflation = 1.0;      ///< of the covariance, for correlated and systematic errors
  double face_variance = 0.0;  ///< systematic, of an observed face [m²]
};

double low_offset(const Ends& ends, int axis) {
  return ends[static_cast<std::size_t>(2 * axis)].offset;
}
double high_offset(const Ends& ends, int axis) {
  return ends[static_cast<std::size_t>(2 * axis + 1)].offset;
}

/// The distance between the two ends along an axis.
Dimension extent(const FittedSurface& surface, int axis, const char* name) {
  Dimension dimension{name, low_offset(surface.ends, axis) + high_offset(surface.ends, axis)};
  SurfaceStep sum = SurfaceStep::Zero();
  double variance = 0.0;
  bool on_table = false;
  for (const int f : {2 * axis, 2 * axis + 1}) {
    const SurfaceEnd& end = surface.ends[static_cast<std::size_t>(f)];
    if (end.source == SurfaceEnd::Source::hidden) {
      dimension.reason = "an end is hidden";
      return dimension;
    }
    on_table |= end.source == SurfaceEnd::Source::table;
    if (end.source == SurfaceEnd::Source::face) sum[7 + f] = 1.0;
    if (end.source != SurfaceEnd::Source::face) variance += end.variance;
  }
  // Smooth errors of the depth shift a face with the table below it.
  if (!on_table) variance += sum.sum() * surface.face_variance;
  variance += surface.inflation * sum.dot(surface.fit.covariance * sum);
  dimension.sigma = std::sqrt(variance);
  return dimension;
}

Dimension size_dimension(const FittedSurface& surface, const char* name) {
  const double variance = surface.inflation * surface.fit.covariance(6, 6) + surface.face_variance;
  return {name, surface.fit.model.size, std::sqrt(variance)};
}

Eigen::Vector3d middle_of(const SurfaceModel& model, const Ends& ends) {
  Eigen::Vector3d local = Eigen::Vector3d::Zero();
  for (int axis = model.first_axis(); axis < 3; ++axis)
    local[axis] = 0.5 * (high_offset(ends, axis) - low_offset(ends, axis));
  return model.origin + model.axes * local;
}

/// The order in which the axes of a box are listed: the one nearest to the table's normal last,
/// without a table the shortest; before it the longer one.
std::array<int, 3> box_order(const Eigen::Matrix3d& axes, const Ends& ends,
                             const std::optional<Plane>& table) {
  std::array<int, 3> order = {0, 1, 2};
  const auto length = [&](int axis) { return low_offset(ends, axis) + high_offset(ends, axis); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return length(a) > length(b); });
  if (!table) return order;
  const Eigen::Vector3d upright = (axes.transpose() * table->normal).cwiseAbs();
  Eigen::Index last = 0;
  upright.maxCoeff(&last);
  std::stable_partition(order.begin(), order.end(),
                        [&](int axis) { return axis != static_cast<int>(last); });
  return order;
}

Eigen::Matrix3d right_handed(Eigen::Matrix3d axes, const std::optional<Plane>& table) {
  if (table && axes.col(2).dot(table->normal) < 0.0) axes.col(2) = -axes.col(2);
  if (axes.determinant() < 0.0) axes.col(1) = -axes.col(1);
  return axes;
}

void describe_box(const FittedSurface& surface, const std::optional<Plane>& table,
                  ObjectClass& found) {
  const Eigen::Matrix3d& axes = surface.fit.model.axes;
  const std::array<int, 3> order = box_order(axes, surface.ends, table);
  constexpr std::array<const char*, 3> names = {"length", "width", "height"};
  for (std::size_t k = 0; k < order.size(); ++k) {
    found.axes.col(static_cast<Eigen::Index>(k)) = axes.col(order[k]);
    found.dimensions.push_back(extent(surface, order[k], names[k]));
  }
  found.kind = SymmetryClass::box;
}

void describe_other(const FittedSurface& surface, ObjectClass& found) {
  const SurfaceModel& model = surface.fit.model;
  found.axes = model.axes;
  if (model.kind == SurfaceModel::Kind::prism) {
    found.kind = SymmetryClass::n_fold;
    found.order = model.sides;
    found.dimensions.push_back(size_dimension(surface, "apothem"));
  } else {
    const bool is_sphere = model.kind == SurfaceModel::Kind::sphere;
    found.kind = is_sphere ? SymmetryClass::sphere : SymmetryClass::cylinder;
    found.dimensions.push_back(size_dimension(surface, "radius"));
    if (is_sphere) return;
  }
  found.dimensions.push_back(extent(surface, 2, "height"));
}

/// Points on the surface between its ends, evenly spread in its parameters.
std::vector<Eigen::Vector3d> surface_grid(const SurfaceModel& model, const Ends& ends) {
  constexpr int steps = 8;
  std::vector<Eigen::Vector3d> grid;
  const auto between = [&](int axis, int k) {
    return -low_offset(ends, axis) +
           (k + 0.5) / steps * (low_offset(ends, axis) + high_offset(ends, axis));
  };
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < steps; ++k) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5) / steps;
      const Eigen::Vector3d around(std::cos(angle), std::sin(angle), 0.0);
      if (model.kind == SurfaceModel::Kind::sphere) {
        const double z = 2.0 * (k + 0.5) / steps - 1.0;
        grid.push_back(model.size *
                       (std::sqrt(1.0 - z * z) * around + z * Eigen::Vector3d::UnitZ()));
      } else if (model.kind == SurfaceModel::Kind::box) {
        for (int f = 0; f < SurfaceModel::planar_faces; ++f) {
          const int a = (f / 2 + 1) % 3, b = (f / 2 + 2) % 3;
          Eigen::Vector3d p =
              ends[static_cast<std::size_t>(f)].offset * SurfaceModel::planar_normal(f);
          p[a] = between(a, i);
          p[b] = between(b, k);
          grid.push_back(p);
        }
      } else {
        grid.push_back(model.size * around + between(2, k) * Eigen::Vector3d::UnitZ());
        const double radius = model.size * std::sqrt((k + 0.5) / steps);
        grid.push_back(radius * around + high_offset(ends, 2) * Eigen::Vector3d::UnitZ());
        grid.push_back(radius * around - low_offset(ends, 2) * Eigen::Vector3d::UnitZ());
      }
    }
  }
  return grid;
}

/// The share of the surface that lies inside observed free space by more than the tolerance.
double empty_share(const SurfaceModel& model, const Ends& ends, const DistanceField& field,
                   double tolerance) {
  const std::vector<Eigen::Vector3d> grid = surface_grid(model, ends);
  const double bound = tolerance + 1.5 * static_cast<double>(field.frame.resolution);
  std::size_t empty = 0;
  for (const Eigen::Vector3d& local : grid) {
    const Eigen::Vector3d world = model.origin + model.axes * local;
    empty += static_cast<double>(field.at(world.cast<float>())) > bound ? 1 : 0;
  }
  return static_cast<double>(empty) / static_cast<double>(grid.size());
}

/// Whether points of the object lie beyond an end of the surface by more than noise explains and
/// more than its length there allows. A fit explains the points on its faces only, and where an end
/// is hidden a face ends where its own points do.
bool is_left_by_points(const SurfaceModel& model, const Ends& ends, const PointCloud& points,
                       double tolerance) {
  constexpr double few = 0.02;   // share of the points, of which outliers may be
  constexpr double noise = 3.0;  // in tolerances
  constexpr double max_overhang = 0.25;
  for (int f = 2 * model.first_axis(); f < SurfaceModel::planar_faces; ++f) {
    const Eigen::Vector3d direction = model.axes * SurfaceModel::planar_normal(f);
    std::vector<double> offsets;
    for (Index i = 0; i < points.size(); ++i)
      offsets.push_back(direction.dot(points.position(i).cast<double>() - model.origin));
    const double beyond = quantile(std::move(offsets), 1.0 - few).value_or(0.0) -
                          ends[static_cast<std::size_t>(f)].offset;
    const double length = low_offset(ends, f / 2) + high_offset(ends, f / 2);
    if (beyond > std::max(noise * tolerance, max_overhang * length)) return true;
  }
  return false;
}

}  // namespace

bool has_determined_size(const ObjectClass& found, double max_deviation) {
  if (found.kind == SymmetryClass::box) return true;
  const Dimension& size = found.dimensions.front();
  return *size.sigma <= max_deviation * size.value;
}

std::optional<ObjectClass> surface_class(const SurfaceFit& fit, const ClassifiedObject& object,
                                         const PointCloud& others, const FitBounds& bounds,
                                         const ClassOptions& options) {
  const Ends ends = surface_ends(fit, object, others, bounds.tolerance, options);
  if (empty_share(fit.model, ends, object.field, bounds.tolerance) > options.max_empty)
    return std::nullopt;
  if (is_left_by_points(fit.model, ends, object.points, bounds.tolerance)) return std::nullopt;
  const double error = systematic_error(fit, object.spacing, options);
  const double over_scale = options.fit_error * error / fit.scale;
  const double face_error =
      std::hypot(options.face_error * error, options.least_face_error * object.spacing);
  const FittedSurface surface{fit, ends, bounds.correlated * over_scale * over_scale,
                              face_error * face_error};
  ObjectClass found;
  found.center = middle_of(fit.model, ends);
  found.residual = fit.residual;
  found.explained = fit.explained;
  if (fit.model.kind == SurfaceModel::Kind::box) {
    describe_box(surface, object.table, found);
  } else {
    describe_other(surface, found);
  }
  found.axes = right_handed(found.axes, object.table);
  return found;
}

}  // namespace symscene
