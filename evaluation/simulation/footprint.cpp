#include "footprint.hpp"

#include <algorithm>
#include <limits>

namespace symscene {
namespace {

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The largest distance of `b` from a line through an edge of `a`. [m]
double gap_over_edges(const Footprint& a, const Footprint& b) {
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d edge = a[(i + 1) % a.size()] - a[i];
    const Eigen::Vector2d outward = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& p : b) nearest = std::min(nearest, outward.dot(p - a[i]));
    best = std::max(best, nearest);
  }
  return best;
}

}  // namespace

Footprint convex_outline(const Points& points) {
  std::vector<Eigen::Vector2d> sorted;
  for (Eigen::Index i = 0; i < points.rows(); ++i) sorted.emplace_back(points(i, 0), points(i, 1));
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Footprint hull;
  for (int pass = 0; pass < 2; ++pass) {  // the lower chain, then back along the upper one
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : sorted) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 1e-12) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(sorted.begin(), sorted.end());
  }
  return hull;
}

Footprint moved(const Footprint& footprint, double yaw, const Eigen::Vector2d& offset) {
  const Eigen::Rotation2Dd rotation(yaw);
  Footprint result;
  for (const Eigen::Vector2d& p : footprint) result.push_back(rotation * p + offset);
  return result;
}

double separation(const Footprint& a, const Footprint& b) {
  return std::max(gap_over_edges(a, b), gap_over_edges(b, a));
}

}  // namespace symscene
