#include "symscene/symmetry/edge_curves.hpp"

#include <optional>

#include "boundary_points.hpp"
#include "core/as_rows.hpp"
#include "measured_path.hpp"
#include "ordered_paths.hpp"
#include "path_joining.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// The sharpest turn of a path, if it is a corner.
std::optional<std::size_t> corner(const MeasuredPath& path, const EdgeCurveOptions& options) {
  std::optional<std::size_t> sharpest;
  double greatest = options.corner_angle;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double turn = path.turn(k, options.tangent_radius);
    if (turn <= greatest) continue;
    greatest = turn;
    sharpest = k;
  }
  return sharpest;
}

/// The parts of a path between its corners, without the corners.
void append_parts(const BoundaryNodes& nodes, PointIndices nodes_of_path,
                  const EdgeCurveOptions& options, std::vector<PointIndices>& parts) {
  std::vector<PointIndices> open{std::move(nodes_of_path)};
  while (!open.empty()) {
    const MeasuredPath path(nodes, std::move(open.back()));
    open.pop_back();
    if (path.size() == 0) continue;
    if (const std::optional<std::size_t> split = corner(path, options)) {
      open.push_back(path.part(*split + 1, path.size()));
      open.push_back(path.part(0, *split));
    } else {
      parts.push_back(path.path());
    }
  }
}

EdgeCurve curve_along(const BoundaryNodes& nodes, const MeasuredPath& path, double tangent_radius) {
  EdgeCurve curve;
  for (std::size_t k = 0; k < path.size(); ++k) {
    curve.points.push_back(nodes[path.path()[k]]);
    curve.points.back().tangent = path.tangent(k, tangent_radius);
  }
  return curve;
}

Eigen::Vector3f position_of(const EdgeCurve::Point& node) { return node.position.cast<float>(); }

}  // namespace

void EdgeCurveOptions::validate() const {
  check_fields(*this);
  require_option(link_distance > spacing, "link_distance", "a distance above spacing",
                 link_distance);
}

double EdgeCurve::length() const {
  double sum = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k)
    sum += (points[k].position - points[k - 1].position).norm();
  return sum;
}

std::vector<EdgeCurve> edge_curves(const PointCloud& cloud, const NeighborLists& neighbors,
                                   std::span<const Index> facets, const EdgeCurveOptions& options) {
  options.validate();
  const BoundaryNodes nodes =
      boundary_nodes(cloud, boundary_points(cloud, neighbors, facets, options), options);
  std::vector<PointIndices> parts;
  for (PointIndices& path : ordered_paths(as_rows(nodes, position_of), options.link_distance))
    append_parts(nodes, std::move(path), options, parts);
  std::vector<EdgeCurve> curves;
  for (PointIndices& joined : joined_paths(nodes, std::move(parts), options)) {
    const MeasuredPath path(nodes, std::move(joined));
    if (path.length() < options.min_length) continue;
    curves.push_back(curve_along(nodes, path, options.tangent_radius));
  }
  return curves;
}

}  // namespace symscene
