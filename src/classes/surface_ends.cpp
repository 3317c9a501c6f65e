#include "surface_ends.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/median.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr double strip_width = 1.5;  // of the strips along a direction, in spacings
constexpr double least_cosine =
    0.6;  // of normals with the face's: those at edges are between faces
constexpr int least_strip_points = 2;
constexpr std::size_t least_strips = 3;
constexpr double least_free_strips = 0.6;  // share of them
constexpr double beyond = 3.0;             // where space beyond a strip is probed, in spacings
constexpr double above = 2.0;              // the same, above the face
constexpr double visible_share = 0.95;     // of the strips that end before what is seen
constexpr double upright_cosine = 0.995;   // of an axis along the table's normal
constexpr double usual_base_gap = 2.0;     // below points of an object on the table, in spacings
constexpr double support_distance = 2.0;   // of a surface on which an object stands, in spacings
constexpr double support_cosine = 0.7;     // of its normal and the table's
constexpr double least_supported = 0.5;    // share of the strips that reach the lowest points

/// Points of a surface in its frame that are on it.
struct LocalPoints {
  std::vector<Eigen::Vector3d> positions, normals;
};

LocalPoints explained_points(const SurfaceModel& model, const PointCloud& points,
                             double tolerance) {
  LocalPoints local;
  for (Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d position = points.position(i).cast<double>();
    const Eigen::Vector3d normal = points.normal(i).cast<double>();
    if (!is_explained(model, position, normal, tolerance)) continue;
    local.positions.push_back(model.to_local(position));
    local.normals.push_back(model.axes.transpose() * normal);
  }
  return local;
}

/// A strip of points of one face along the direction of an end.
struct Strip {
  int count = 0;
  double last = -1e30;    ///< offset of its last point [m]
  Eigen::Vector3d point;  ///< the last one
  Eigen::Vector3d face_normal;
};

/// The coordinate across strips: along the face, at right angles to the end's direction.
double strip_coordinate(const SurfaceModel& model, int face, int axis,
                        const Eigen::Vector3d& local) {
  if (face < SurfaceModel::planar_faces) return local[3 - axis - face / 2];
  if (model.kind == SurfaceModel::Kind::cylinder)
    return model.size * std::atan2(local.y(), local.x());
  const Eigen::Vector3d normal = model.normal(face, local);
  return normal.x() * local.y() - normal.y() * local.x();
}

/// The strips of all faces at right angles to an end.
std::vector<Strip> strips_towards(int end, const SurfaceModel& model, const LocalPoints& points,
                                  double width) {
  const int axis = end / 2;
  const double sign = end % 2 == 0 ? -1.0 : 1.0;
  std::map<std::pair<int, int>, Strip> strips;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const Eigen::Vector3d& p = points.positions[i];
    const std::optional<int> face = nearest_face(model, p, points.normals[i], least_cosine);
    if (!face || *face / 2 == axis) continue;
    const int at = static_cast<int>(std::floor(strip_coordinate(model, *face, axis, p) / width));
    Strip& strip = strips[{*face, at}];
    ++strip.count;
    if (sign * p[axis] <= strip.last) continue;
    strip.last = sign * p[axis];
    strip.point = p;
    strip.face_normal = model.normal(*face, p);
  }
  std::vector<Strip> kept;
  for (const auto& [key, strip] : strips) {
    if (strip.count >= least_strip_points) kept.push_back(strip);
  }
  return kept;
}

/// The end of faces in free space: the median of their strips. Where others hide it, what is seen
/// is the bound: the farthest strips, since those that an occluder cuts say nothing of the end.
SurfaceEnd edge_end(int end, const SurfaceModel& model, const std::vector<Strip>& strips,
                    const ClassifiedObject& object, double error, const ClassOptions& options) {
  const Eigen::Vector3d direction = SurfaceModel::planar_normal(end);
  SurfaceEnd found;
  std::vector<double> free, all;
  for (const Strip& strip : strips) {
    const Eigen::Vector3d probe =
        strip.point + object.spacing * (beyond * direction + above * strip.face_normal);
    const Eigen::Vector3d world = model.origin + model.axes * probe;
    all.push_back(strip.last);
    if (object.field.at(world.cast<float>()) > 0.0F) free.push_back(strip.last);
  }
  if (all.empty()) return found;
  found.offset = quantile(all, visible_share).value_or(0.0);
  if (free.size() < least_strips ||
      static_cast<double>(free.size()) < least_free_strips * static_cast<double>(all.size()))
    return found;
  const double middle = median(free).value_or(0.0);
  std::vector<double> deviations;
  for (const double value : free) deviations.push_back(std::abs(value - middle));
  const double spread = 1.4826 * median(std::move(deviations)).value_or(0.0);
  const double systematic =
      std::hypot(options.edge_error * error, options.least_edge_error * object.spacing);
  found.source = SurfaceEnd::Source::edge;
  found.offset = middle + options.edge_offset * object.spacing;
  found.variance = systematic * systematic +
                   spread * spread * options.correlation / static_cast<double>(free.size());
  return found;
}

/// Whether surfaces of others that face up adjoin the lowest points, at `last`: what an object
/// stands on or in, if it does not stand on the table. Strips that end higher are cut by occluders.
bool stands_on_others(const SurfaceModel& model, const std::vector<Strip>& strips, double last,
                      const ClassifiedObject& object, const PointCloud& others) {
  const Eigen::Vector3f up = object.table->normal.cast<float>();
  PointIndices facing_up;
  for (Index i = 0; i < others.size(); ++i) {
    if (others.normal(i).dot(up) > static_cast<float>(support_cosine)) facing_up.push_back(i);
  }
  if (facing_up.empty()) return false;
  const auto reach = static_cast<float>(support_distance * object.spacing);
  const CellList cells(select(others, facing_up).positions, reach);
  int lowest = 0, supported = 0;
  for (const Strip& strip : strips) {
    if (strip.last < last - usual_base_gap * object.spacing) continue;
    const Eigen::Vector3d end = model.origin + model.axes * strip.point;
    ++lowest;
    supported += cells.nearest(end.cast<float>(), reach).first != CellList::none ? 1 : 0;
  }
  return supported >= least_supported * lowest;
}

/// The table under an upright object whose last points are near it. A gap that is larger than what
/// cropping the table leaves may be of another thing under the object.
std::optional<SurfaceEnd> table_end(int end, const SurfaceModel& model,
                                    const std::vector<Strip>& strips,
                                    const ClassifiedObject& object, const PointCloud& others,
                                    double error, const ClassOptions& options) {
  if (!object.table || strips.empty()) return std::nullopt;
  const Eigen::Vector3d direction = model.axes * SurfaceModel::planar_normal(end);
  const double down = -direction.dot(object.table->normal);
  if (down < upright_cosine) return std::nullopt;
  double last = -1e30;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Strip& strip : strips) {
    last = std::max(last, strip.last);
    middle += strip.point / static_cast<double>(strips.size());
  }
  // The offset where the middle of the strips projects onto the table.
  Eigen::Vector3d below = middle;
  below[end / 2] = 0.0;
  const Eigen::Vector3d from = model.origin + model.axes * below;
  const double offset = object.table->signed_distance(from) / down;
  const double gap = std::abs(offset - last);
  if (gap > options.max_base_gap * object.spacing ||
      stands_on_others(model, strips, last, object, others))
    return std::nullopt;
  const double unusual = std::max(0.0, gap - usual_base_gap * object.spacing);
  const double deviation = std::hypot(options.table_error * error, unusual);
  return SurfaceEnd{offset, deviation * deviation, SurfaceEnd::Source::table};
}

}  // namespace

double systematic_error(const SurfaceFit& fit, double spacing, const ClassOptions& options) {
  return fit.residual * std::hypot(1.0, options.error_growth * fit.residual / spacing);
}

std::array<SurfaceEnd, SurfaceModel::planar_faces> surface_ends(const SurfaceFit& fit,
                                                                const ClassifiedObject& object,
                                                                const PointCloud& others,
                                                                double tolerance,
                                                                const ClassOptions& options) {
  const SurfaceModel& model = fit.model;
  const double error = systematic_error(fit, object.spacing, options);
  const LocalPoints points = explained_points(model, object.points, tolerance);
  std::array<SurfaceEnd, SurfaceModel::planar_faces> ends;
  for (int f = 2 * model.first_axis(); f < SurfaceModel::planar_faces; ++f) {
    const auto at = static_cast<std::size_t>(f);
    if (model.present[at]) {
      ends[at] = {model.offsets[at], 0.0, SurfaceEnd::Source::face};
      continue;
    }
    const std::vector<Strip> strips =
        strips_towards(f, model, points, strip_width * object.spacing);
    const auto on_table = table_end(f, model, strips, object, others, error, options);
    ends[at] = on_table ? *on_table : edge_end(f, model, strips, object, error, options);
  }
  return ends;
}

}  // namespace symscene
