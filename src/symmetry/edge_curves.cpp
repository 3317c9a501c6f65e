#include "symscene/symmetry/edge_curves.hpp"

#include <algorithm>
#include <optional>

#include <Eigen/Eigenvalues>

#include "boundary_points.hpp"
#include "ordered_paths.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// A path with the distance of every point from its start along it.
class MeasuredPath {
 public:
  MeasuredPath(const BoundaryNodes& nodes, PointIndices path)
      : nodes_(nodes), path_(std::move(path)), along_(path_.size(), 0.0) {
    for (std::size_t k = 1; k < path_.size(); ++k)
      along_[k] = along_[k - 1] + (position(k) - position(k - 1)).norm();
  }

  std::size_t size() const { return path_.size(); }
  double length() const { return along_.empty() ? 0.0 : along_.back(); }
  const Eigen::Vector3d& position(std::size_t k) const { return nodes_[path_[k]].position; }

  /// The points from `first` to `last`, both included, within `reach` of `k` along the path.
  struct Window {
    std::size_t first;
    std::size_t last;
  };
  Window window(std::size_t k, double reach) const {
    Window found{k, k};
    while (found.first > 0 && along_[k] - along_[found.first - 1] <= reach) --found.first;
    while (found.last + 1 < size() && along_[found.last + 1] - along_[k] <= reach) ++found.last;
    return found;
  }

  /// The direction of the line of least squares through the points around `k`.
  Eigen::Vector3d tangent(std::size_t k, double reach) const {
    const Window around = window(k, reach);
    const double count = static_cast<double>(around.last - around.first) + 1.0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t i = around.first; i <= around.last; ++i) mean += position(i) / count;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (std::size_t i = around.first; i <= around.last; ++i)
      scatter += (position(i) - mean) * (position(i) - mean).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  }

  /// How far the path turns at `k`; zero near its ends, where it is not known. [rad]
  double turn(std::size_t k, double reach) const {
    const double before = std::min(reach, along_[k]);
    const double after = std::min(reach, length() - along_[k]);
    if (std::min(before, after) < reach / 2.0) return 0.0;
    return angle_between(position(k) - position_at(along_[k] - before),
                         position_at(along_[k] + after) - position(k));
  }

  PointIndices part(std::size_t begin, std::size_t end) const {
    return {path_.begin() + static_cast<std::ptrdiff_t>(begin),
            path_.begin() + static_cast<std::ptrdiff_t>(end)};
  }

  EdgeCurve curve(double tangent_radius) const {
    EdgeCurve curve;
    for (std::size_t k = 0; k < size(); ++k) {
      curve.points.push_back(nodes_[path_[k]]);
      curve.points.back().tangent = tangent(k, tangent_radius);
    }
    return curve;
  }

 private:
  /// The point at a distance from the start along the path.
  Eigen::Vector3d position_at(double along) const {
    const auto next = std::upper_bound(along_.begin() + 1, along_.end() - 1, along);
    const auto k = static_cast<std::size_t>(next - along_.begin());
    const double share = (along - along_[k - 1]) / (along_[k] - along_[k - 1]);
    return position(k - 1) + std::clamp(share, 0.0, 1.0) * (position(k) - position(k - 1));
  }

  const BoundaryNodes& nodes_;
  PointIndices path_;
  std::vector<double> along_;
};

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

/// Appends the parts of a path between its corners that are long enough.
void append_curves(const BoundaryNodes& nodes, PointIndices nodes_of_path,
                   const EdgeCurveOptions& options, std::vector<EdgeCurve>& curves) {
  std::vector<PointIndices> open{std::move(nodes_of_path)};
  while (!open.empty()) {
    const MeasuredPath path(nodes, std::move(open.back()));
    open.pop_back();
    if (path.length() < options.min_length) continue;
    if (const std::optional<std::size_t> split = corner(path, options)) {
      open.push_back(path.part(*split + 1, path.size()));
      open.push_back(path.part(0, *split));
    } else {
      curves.push_back(path.curve(options.tangent_radius));
    }
  }
}

Points node_positions(const BoundaryNodes& nodes) {
  Points positions(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    positions.row(static_cast<Eigen::Index>(k)) = nodes[k].position.cast<float>().transpose();
  return positions;
}

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
  std::vector<EdgeCurve> curves;
  for (PointIndices& path : ordered_paths(node_positions(nodes), options.link_distance))
    append_curves(nodes, std::move(path), options, curves);
  return curves;
}

}  // namespace symscene
