#include "least_rectangle.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace symscene {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Adds the points, in this order, to a chain that turns left at every vertex.
void add_chain(std::span<const Eigen::Vector2d> points, std::vector<Eigen::Vector2d>& hull) {
  const std::size_t first = hull.size();
  for (const Eigen::Vector2d& p : points) {
    while (hull.size() >= first + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
      hull.pop_back();
    hull.push_back(p);
  }
  if (!hull.empty()) hull.pop_back();  // it begins the other chain
}

double extent_along(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& direction) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const Eigen::Vector2d& p : points) {
    low = std::min(low, p.dot(direction));
    high = std::max(high, p.dot(direction));
  }
  return high - low;
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull;
  add_chain(points, hull);
  std::reverse(points.begin(), points.end());
  add_chain(points, hull);
  return hull;
}

Eigen::Vector2d least_rectangle(const std::vector<Eigen::Vector2d>& points) {
  const std::vector<Eigen::Vector2d> hull = convex_hull(points);
  Eigen::Vector2d best = Eigen::Vector2d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    if (!(edge.norm() > 0.0)) continue;
    const Eigen::Vector2d along = edge.normalized();
    const double area =
        extent_along(hull, along) * extent_along(hull, Eigen::Vector2d(-along.y(), along.x()));
    if (area >= least) continue;
    least = area;
    best = along;
  }
  return best;
}

}  // namespace symscene
