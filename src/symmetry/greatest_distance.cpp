#include "symmetry/greatest_distance.hpp"

#include <algorithm>
#include <cmath>

#include "group_search.hpp"

namespace symscene {

PointIndices outermost_points(const Points& points) {
  constexpr int tried_directions = 1000;
  PointIndices outermost;
  if (points.rows() == 0) return outermost;
  for (const Eigen::Vector3d& direction : hemisphere(tried_directions)) {
    const Eigen::VectorXf along = points * direction.cast<float>();
    Eigen::Index low = 0, high = 0;
    along.minCoeff(&low);
    along.maxCoeff(&high);
    outermost.insert(outermost.end(), {static_cast<Index>(low), static_cast<Index>(high)});
  }
  std::sort(outermost.begin(), outermost.end());
  outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
  return outermost;
}

double greatest_distance(const Points& points) {
  // Only points that are outermost in some direction can be farthest apart.
  const PointIndices outermost = outermost_points(points);
  float squared = 0.0F;
  for (const Index a : outermost) {
    for (const Index b : outermost)
      squared = std::max(squared, (points.row(a) - points.row(b)).squaredNorm());
  }
  return std::sqrt(double{squared});
}

}  // namespace symscene
