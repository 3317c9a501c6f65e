#include "plane_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace symscene {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// One half of the hull of sorted points.
template <class Iterator>
std::vector<Eigen::Vector2d> half_hull(Iterator begin, Iterator end) {
  std::vector<Eigen::Vector2d> chain;
  for (Iterator point = begin; point != end; ++point) {
    while (chain.size() >= 2) {
      const Eigen::Vector2d& last = chain.back();
      if (cross(last - chain[chain.size() - 2], *point - last) > 0.0) break;
      chain.pop_back();
    }
    chain.push_back(*point);
  }
  chain.pop_back();
  return chain;
}

}  // namespace

ConvexOutline::ConvexOutline(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return;
  corners_ = half_hull(points.begin(), points.end());
  const std::vector<Eigen::Vector2d> upper = half_hull(points.rbegin(), points.rend());
  corners_.insert(corners_.end(), upper.begin(), upper.end());
  if (corners_.size() < 3) corners_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector2d edge = corners_[(i + 1) % corners_.size()] - corners_[i];
    sides_.push_back({corners_[i], edge, edge.norm()});
  }
}

double ConvexOutline::distance(const Eigen::Vector2d& point) const {
  if (corners_.empty()) return std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Side& side : sides_)
    farthest = std::max(farthest, cross(point - side.corner, side.edge) / side.length);
  return farthest;
}

ConvexOutline outline_of(const std::vector<Eigen::Vector3d>& corners, const PlaneFrame& frame) {
  std::vector<Eigen::Vector2d> within;
  for (const Eigen::Vector3d& corner : corners) within.push_back(frame.within(corner));
  return ConvexOutline(std::move(within));
}

PlaneCells::PlaneCells(const std::vector<Eigen::Vector2d>& points, double edge) : edge_(edge) {
  if (points.empty()) return;
  low_ = points[0];
  Eigen::Vector2d high = points[0];
  for (const Eigen::Vector2d& point : points) {
    low_ = low_.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  constexpr double max_cells = 1 << 22;
  while (((high - low_).array() / edge_ + 1.0).prod() > max_cells) edge_ *= 2.0;
  columns_ = static_cast<std::int32_t>((high.x() - low_.x()) / edge_) + 1;
  rows_ = static_cast<std::int32_t>((high.y() - low_.y()) / edge_) + 1;
  holds_points_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  cell_of_point_.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    cell_of_point_.push_back(cell_of(point));
    holds_points_[static_cast<std::size_t>(cell_of_point_.back())] = 1;
  }
}

std::int32_t PlaneCells::cell_of(const Eigen::Vector2d& point) const {
  const auto column = static_cast<std::int32_t>((point.x() - low_.x()) / edge_);
  const auto row = static_cast<std::int32_t>((point.y() - low_.y()) / edge_);
  return row * columns_ + column;
}

bool PlaneCells::is_surrounded(std::int32_t cell) const {
  const std::int32_t row = cell / columns_;
  const std::int32_t column = cell % columns_;
  if (row == 0 || column == 0 || row + 1 == rows_ || column + 1 == columns_) return false;
  for (std::int32_t r = row - 1; r <= row + 1; ++r) {
    for (std::int32_t c = column - 1; c <= column + 1; ++c) {
      if (holds_points_[static_cast<std::size_t>(r * columns_ + c)] == 0) return false;
    }
  }
  return true;
}

std::vector<std::size_t> PlaneCells::border() const {
  std::vector<bool> surrounded(holds_points_.size());
  for (std::size_t cell = 0; cell < holds_points_.size(); ++cell) {
    surrounded[cell] = holds_points_[cell] != 0 && is_surrounded(static_cast<std::int32_t>(cell));
  }
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < cell_of_point_.size(); ++i) {
    if (!surrounded[static_cast<std::size_t>(cell_of_point_[i])]) points.push_back(i);
  }
  return points;
}

std::size_t PlaneCells::occupied() const {
  return static_cast<std::size_t>(
      std::count(holds_points_.begin(), holds_points_.end(), std::uint8_t{1}));
}

PlaneCells::Patches PlaneCells::patches() const {
  constexpr std::int32_t gap = 2;
  std::vector<std::int32_t> patch_of(holds_points_.size(), -1);
  std::vector<std::size_t> sizes;
  std::vector<std::int32_t> open;
  for (std::size_t seed = 0; seed < holds_points_.size(); ++seed) {
    if (holds_points_[seed] == 0 || patch_of[seed] >= 0) continue;
    const auto patch = static_cast<std::int32_t>(sizes.size());
    sizes.push_back(0);
    patch_of[seed] = patch;
    open.push_back(static_cast<std::int32_t>(seed));
    while (!open.empty()) {
      const std::int32_t cell = open.back();
      open.pop_back();
      ++sizes.back();
      const std::int32_t row = cell / columns_;
      const std::int32_t column = cell % columns_;
      for (std::int32_t r = std::max(row - gap, 0); r <= std::min(row + gap, rows_ - 1); ++r) {
        for (std::int32_t c = std::max(column - gap, 0); c <= std::min(column + gap, columns_ - 1);
             ++c) {
          const auto other = static_cast<std::size_t>(r * columns_ + c);
          if (holds_points_[other] == 0 || patch_of[other] >= 0) continue;
          patch_of[other] = patch;
          open.push_back(static_cast<std::int32_t>(other));
        }
      }
    }
  }
  Patches patches{std::move(sizes), {}};
  patches.of_point.reserve(cell_of_point_.size());
  for (const std::int32_t cell : cell_of_point_)
    patches.of_point.push_back(patch_of[static_cast<std::size_t>(cell)]);
  return patches;
}

namespace {

std::int32_t largest(const PlaneCells::Patches& patches) {
  return static_cast<std::int32_t>(std::max_element(patches.cells.begin(), patches.cells.end()) -
                                   patches.cells.begin());
}

}  // namespace

std::vector<std::size_t> PlaneCells::largest_patch() const {
  const Patches all = patches();
  std::vector<std::size_t> members;
  if (all.cells.empty()) return members;
  const std::int32_t main = largest(all);
  for (std::size_t i = 0; i < all.of_point.size(); ++i) {
    if (all.of_point[i] == main) members.push_back(i);
  }
  return members;
}

std::vector<std::size_t> PlaneCells::table_patches(const std::vector<Eigen::Vector2d>& points,
                                                   double gap) const {
  constexpr std::size_t least_cells = 4;
  const Patches all = patches();
  std::vector<std::size_t> members;
  if (all.cells.empty()) return members;
  const auto main = static_cast<std::size_t>(largest(all));
  const std::size_t least = std::max(least_cells, all.cells[main] / 100);
  std::vector<std::vector<Eigen::Vector2d>> borders(all.cells.size());
  for (const std::size_t i : border()) {
    borders[static_cast<std::size_t>(all.of_point[i])].push_back(points[i]);
  }
  std::vector<bool> kept(all.cells.size(), false);
  kept[main] = true;
  ConvexOutline hull(borders[main]);
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t patch = 0; patch < borders.size(); ++patch) {
      if (kept[patch] || all.cells[patch] < least) continue;
      const auto near = [&](const Eigen::Vector2d& point) { return hull.distance(point) < gap; };
      if (!std::any_of(borders[patch].begin(), borders[patch].end(), near)) continue;
      kept[patch] = grew = true;
      std::vector<Eigen::Vector2d> corners = hull.corners();
      corners.insert(corners.end(), borders[patch].begin(), borders[patch].end());
      hull = ConvexOutline(std::move(corners));
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool member = kept[static_cast<std::size_t>(all.of_point[i])];
    if (member || hull.distance(points[i]) < 0.0) members.push_back(i);
  }
  return members;
}

}  // namespace symscene
