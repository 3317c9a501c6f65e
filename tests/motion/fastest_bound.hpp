#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "symscene/motion/trajectory.hpp"

namespace symscene::testing {

/// A bound of the fastest motion along a path by brute force, on a fine grid of the phase plane: it
/// shares no code with the trajectories. At each point of the path the greatest x = (ds/dt)² starts
/// at the curve of maximal velocity; passes forwards and backwards lower it to what some lower or
/// equal x of the neighbour reaches, by trying many, until nothing changes. No motion is faster.
class FastestBound {
 public:
  FastestBound(const JointPath& path, const MotionLimits& limits, int points) : limits_(limits) {
    for (const PathSegment& segment : path.segments()) {
      const int count = std::max(20, static_cast<int>(points * segment.length / path.length()));
      for (int i = 0; i < count; ++i) add_point(segment, segment.length * i / count, count);
    }
    add_end(path.segments().back());
    most_.front() = most_.back() = 0.0;
    // Corners that stay are stops.
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < path.segments().size(); ++i) {
      at += static_cast<std::size_t>(
          std::max(20, static_cast<int>(points * path.segments()[i].length / path.length())));
      if (path.stops_after(i)) most_[at] = 0.0;
    }
    for (int i = 0; i < 30 && lower(); ++i) {
    }
  }

  double duration() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < steps_.size(); ++i)
      sum += 2.0 * steps_[i] / (std::sqrt(most_[i]) + std::sqrt(most_[i + 1]));
    return sum;
  }

 private:
  struct Point {
    Eigen::VectorXd first, second;
  };

  void add_point(const PathSegment& segment, double s, int count) {
    steps_.push_back(segment.length / count);
    add({segment.first_derivative(s), segment.second_derivative(s)});
  }
  void add_end(const PathSegment& segment) {
    add({segment.first_derivative(segment.length), segment.second_derivative(segment.length)});
  }
  void add(const Point& point) {
    points_.push_back(point);
    double low = 0.0;
    double high = 1e9;
    for (Eigen::Index i = 0; i < point.first.size(); ++i) {
      const double slope = std::abs(point.first[i]);
      if (slope > 0.0) high = std::min(high, std::pow(limits_.velocity[i] / slope, 2));
    }
    if (range(point, high).first <= range(point, high).second) {
      low = high;
    }
    for (int i = 0; i < 60 && low < high; ++i) {
      const double x = 0.5 * (low + high);
      (range(point, x).first <= range(point, x).second ? low : high) = x;
    }
    most_.push_back(low);
  }

  /// The least and greatest d²s/dt² at a point.
  std::pair<double, double> range(const Point& point, double x) const {
    double low = -1e9;
    double high = 1e9;
    for (Eigen::Index i = 0; i < point.first.size(); ++i) {
      const double slope = point.first[i];
      const double limit = limits_.acceleration[i];
      const double bend = point.second[i] * x;
      if (std::abs(slope) < 1e-12) {
        if (std::abs(bend) > limit) return {1.0, -1.0};
        continue;
      }
      const double a = (-limit - bend) / slope;
      const double b = (limit - bend) / slope;
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return {low, high};
  }

  /// The greatest x that a step away from a point reaches from any x up to `most`.
  double reached(const Point& point, double most, double step, double sign) const {
    constexpr int tries = 24;
    double best = 0.0;
    for (int i = 0; i <= tries; ++i) {
      const double x = most * i / tries;
      const auto [low, high] = range(point, x);
      const double u = sign > 0.0 ? high : -low;
      if (low <= high) best = std::max(best, x + 2.0 * step * u);
    }
    return best;
  }

  bool lower() {
    bool changed = false;
    const auto apply = [&](std::size_t i, double bound) {
      changed = changed || bound < most_[i] * (1.0 - 1e-9);
      most_[i] = std::min(most_[i], bound);
    };
    for (std::size_t i = 0; i < steps_.size(); ++i)
      apply(i + 1, reached(points_[i], most_[i], steps_[i], 1.0));
    for (std::size_t i = steps_.size(); i-- > 0;)
      apply(i, reached(points_[i + 1], most_[i + 1], steps_[i], -1.0));
    return changed;
  }

  const MotionLimits& limits_;
  std::vector<Point> points_;
  std::vector<double> steps_;
  std::vector<double> most_;
};

}  // namespace symscene::testing
