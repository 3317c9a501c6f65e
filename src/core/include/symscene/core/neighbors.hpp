#pragma once

#include <limits>
#include <span>
#include <utility>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The neighbours of every point, concatenated in one array.
struct NeighborLists {
  std::vector<Index> offsets;  ///< N+1: the neighbours of i are [offsets[i], offsets[i + 1])
  std::vector<Index> neighbors;

  std::size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const Index> of(std::size_t i) const {
    return {neighbors.data() + offsets[i], neighbors.data() + offsets[i + 1]};
  }
};

/// Fixed-radius neighbour search: points sorted into the cells of a dense grid in which a row of
/// cells along x is contiguous. For clouds of even density, where it is faster than a tree.
class CellList {
 public:
  /// Sorts `points` into cells with an edge of `cell_size` [m], or of up to about 16 times as much
  /// where the box of the points is so large that most cells would be empty. Throws InputError if
  /// a coordinate is not finite or the box holds more than 2^27 cells even then.
  CellList(const Points& points, float cell_size);

  /// Calls visit(index, squared distance) for every point within `radius` of `query`, in a fixed
  /// order.
  template <class Visit>
  void for_each_within(const Eigen::Vector3f& query, float radius, Visit&& visit) const;

  /// The nearest point within `radius` and its squared distance; `none` if there is no such point.
  /// Ties go to the lower index.
  std::pair<Index, float> nearest(const Eigen::Vector3f& query, float radius) const;

  static constexpr Index none = ~Index{0};

 private:
  struct Entry {
    float x, y, z;
    Index index;
  };

  /// The cells x_low to x_high of a row along x.
  struct Row {
    int y, z, x_low, x_high;
  };

  /// Sorts the points by cell.
  void sort(const Points& points);
  std::size_t cell_of(const Eigen::Vector3f& point) const;
  int clamped_cell(float coordinate, int axis) const;
  /// The first cell of the row along x at (y, z).
  std::size_t row_begin(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_.y()) +
            static_cast<std::size_t>(y)) *
           static_cast<std::size_t>(cells_.x());
  }
  /// Replaces `best` by the nearest point of a row, if it is nearer.
  void visit_row(const Row& row, const Eigen::Vector3f& query, std::pair<Index, float>& best) const;

  Box box_;
  float inverse_cell_size_ = 1.0F;
  Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
  std::vector<Index> cell_begin_;
  std::vector<Entry> entries_;  ///< by cell, then by index
};

/// For every point the other points within `radius` [m], ascending.
NeighborLists radius_neighbors(const Points& points, float radius);

/// For every point its `count` nearest other points, nearest first; fewer if the cloud has fewer.
NeighborLists nearest_neighbors(const Points& points, std::size_t count);

/// The pairs a < b of points within `radius` [m] where one is among the `count` nearest neighbours
/// of the other, each once, ascending.
std::vector<std::pair<Index, Index>> nearest_pairs(const Points& points, std::size_t count,
                                                   float radius);

template <class Visit>
void CellList::for_each_within(const Eigen::Vector3f& query, float radius, Visit&& visit) const {
  if (entries_.empty()) return;
  const float squared_radius = radius * radius;
  // A distance that rounds to the radius may be a few units in the last place longer.
  const float reach = radius * (1.0F + 8.0F * std::numeric_limits<float>::epsilon());
  Eigen::Vector3i low;
  Eigen::Vector3i high;
  for (int axis = 0; axis < 3; ++axis) {
    if (query[axis] + reach < box_.min[axis] || query[axis] - reach > box_.max[axis]) return;
    low[axis] = clamped_cell(query[axis] - reach, axis);
    high[axis] = clamped_cell(query[axis] + reach, axis);
  }
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      const std::size_t row = row_begin(y, z);
      const Index begin = cell_begin_[row + static_cast<std::size_t>(low.x())];
      const Index end = cell_begin_[row + static_cast<std::size_t>(high.x()) + 1];
      for (Index k = begin; k < end; ++k) {
        const Entry& entry = entries_[k];
        const float dx = entry.x - query.x();
        const float dy = entry.y - query.y();
        const float dz = entry.z - query.z();
        const float squared_distance = dx * dx + dy * dy + dz * dz;
        if (squared_distance <= squared_radius) visit(entry.index, squared_distance);
      }
    }
  }
}

}  // namespace symscene
