#include "path_shortcuts.hpp"

#include <algorithm>

#include "core/random.hpp"

namespace symscene {
namespace {

using Path = std::vector<Eigen::VectorXd>;

/// A point of a path: between waypoints `before` and `before` + 1.
struct PathPoint {
  std::size_t before = 0;
  Eigen::VectorXd positions;
};

double length_of(const Path& path) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += (path[i + 1] - path[i]).norm();
  return sum;
}

PathPoint point_at(const Path& path, double way) {
  std::size_t i = 0;
  for (; i + 2 < path.size(); ++i) {
    const double edge = (path[i + 1] - path[i]).norm();
    if (way <= edge) break;
    way -= edge;
  }
  const double edge = (path[i + 1] - path[i]).norm();
  const double share = edge > 0.0 ? std::min(way / edge, 1.0) : 0.0;
  return {i, path[i] + share * (path[i + 1] - path[i])};
}

/// The path with a straight line between two of its points.
Path with_line(const Path& path, const PathPoint& from, const PathPoint& to) {
  using Step = Path::difference_type;
  Path joined(path.begin(), path.begin() + static_cast<Step>(from.before) + 1);
  joined.push_back(from.positions);
  joined.push_back(to.positions);
  joined.insert(joined.end(), path.begin() + static_cast<Step>(to.before) + 1, path.end());
  return joined;
}

/// Leaves out waypoints whose neighbours are joined by a free line, the last ones first.
Path without_detours(Path path, const MotionCheck& is_free) {
  for (std::size_t i = path.size(); i-- > 1;) {
    if (i + 1 >= path.size() || !is_free(path[i - 1], path[i + 1])) continue;
    path.erase(path.begin() + static_cast<Path::difference_type>(i));
  }
  return path;
}

}  // namespace

std::vector<Eigen::VectorXd> shortened(std::vector<Eigen::VectorXd> path,
                                       const MotionCheck& is_free, int tries, Random& random) {
  if (path.size() < 3) return path;
  path = without_detours(std::move(path), is_free);
  for (int i = 0; i < tries && path.size() > 2; ++i) {
    const double length = length_of(path);
    const auto [near, far] =
        std::minmax({random.uniform(0.0, length), random.uniform(0.0, length)});
    const PathPoint from = point_at(path, near);
    const PathPoint to = point_at(path, far);
    if (from.before == to.before || !is_free(from.positions, to.positions)) continue;
    path = with_line(path, from, to);
  }
  return without_detours(std::move(path), is_free);
}

}  // namespace symscene
