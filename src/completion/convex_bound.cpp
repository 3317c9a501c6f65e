#include "convex_bound.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/dispatch.hpp"

namespace symscene {
namespace {

constexpr int even_directions = 100;  // 20° apart: bounds of a ball are up to 1.5 % too far

/// Directions on a Fibonacci lattice of the half sphere, each with its opposite.
void append_even_directions(std::vector<Eigen::Vector3f>& directions) {
  for (int k = 0; k < even_directions / 2; ++k) {
    const double height = (k + 0.5) / (even_directions / 2);
    const double angle = 2.0 * std::numbers::pi * std::numbers::phi * k;
    const double radius = std::sqrt(1.0 - height * height);
    const Eigen::Vector3d direction(radius * std::cos(angle), radius * std::sin(angle), height);
    directions.push_back(direction.cast<float>());
    directions.push_back(-directions.back());
  }
}

/// value[k] = max(value[k], first + k · step)
SYMSCENE_MULTIVERSION
void raise_to_line(float first, float step, std::size_t length, float* value) {
  for (std::size_t k = 0; k < length; ++k)
    value[k] = std::max(value[k], first + step * static_cast<float>(static_cast<int>(k)));
}

}  // namespace

ConvexBound::ConvexBound(std::vector<Eigen::Vector3f> directions, const Points& points)
    : directions_(std::move(directions)) {
  append_even_directions(directions_);
  for (const Eigen::Vector3f& direction : directions_) {
    const Eigen::ArrayXf along = points * direction;
    offsets_.push_back(along.maxCoeff());
    least_width_ = std::min(least_width_, offsets_.back() - along.minCoeff());
  }
}

float ConvexBound::exit_distance(const Eigen::Vector3f& point,
                                 const Eigen::Vector3f& direction) const {
  float least = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    const float along = directions_[k].dot(direction);
    if (along > 0.0F) least = std::min(least, (offsets_[k] - directions_[k].dot(point)) / along);
  }
  return least;
}

ConvexBound::Interval ConvexBound::within(const Eigen::Vector3f& start, float spacing, float count,
                                          float margin) const {
  Interval interval{0.0F, count};
  for (std::size_t k = 0; k < directions_.size(); ++k) {
    const float room = offsets_[k] + margin - directions_[k].dot(start);
    const float step = directions_[k].x() * spacing;
    if (step > 0.0F) {
      interval.end = std::min(interval.end, room / step + 1.0F);
    } else if (step < 0.0F) {
      interval.begin = std::max(interval.begin, room / step);
    } else if (room < 0.0F) {
      return {0.0F, 0.0F};
    }
  }
  // Within the row, as steps of nearly zero give any number.
  return {std::min(interval.begin, count), std::max(interval.end, 0.0F)};
}

std::vector<float> ConvexBound::distances(const NodeGrid& grid, float margin) const {
  std::vector<float> distances(grid.nodes(), margin);
  const auto length = static_cast<float>(grid.size.x());
  for (int z = 0; z < grid.size.z(); ++z) {
    for (int y = 0; y < grid.size.y(); ++y) {
      const Eigen::Vector3f start = grid.position(0, y, z);
      const Interval inside = within(start, grid.spacing, length, margin);
      const int begin = static_cast<int>(inside.begin), end = static_cast<int>(inside.end);
      if (begin >= end) continue;
      float* row = distances.data() + grid.at(begin, y, z);
      std::fill_n(row, end - begin, -std::numeric_limits<float>::max());
      const Eigen::Vector3f first = grid.position(begin, y, z);
      for (std::size_t k = 0; k < directions_.size(); ++k)
        raise_to_line(directions_[k].dot(first) - offsets_[k], directions_[k].x() * grid.spacing,
                      static_cast<std::size_t>(end - begin), row);
    }
  }
  return distances;
}

}  // namespace symscene
