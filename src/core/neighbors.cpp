#include "symscene/core/neighbors.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nanoflann.hpp>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double max_cells = 1 << 27;
constexpr double free_cells = 1 << 20;  ///< as many cost next to nothing
constexpr double max_cells_per_point = 512.0;
constexpr float max_cell_growth = 16.0F;  ///< beyond it the units are hardly metres
constexpr std::size_t query_block = 1024;
constexpr float cell_rounding = 1e-3F;  ///< of a coordinate [cells]

/// A lower bound of the distance of a coordinate from a cell along an axis. [cells]
inline float distance_to_cell(float at, int cell) {
  const auto low = static_cast<float>(cell);
  return std::max(std::max(low - at, at - low - 1.0F) - cell_rounding, 0.0F);
}

Eigen::Array3d cells_along(const Eigen::Vector3f& extent, float cell_size) {
  return (extent.cast<double>().array() / double{cell_size}).floor() + 1.0;
}

/// The cell size from `wanted` on of which a box of that extent holds at most `most` cells.
float fitting_cell_size(const Eigen::Vector3f& extent, float wanted, double most) {
  constexpr float step = 1.25F;
  float size = wanted;
  while (cells_along(extent, size).prod() > most && size < max_cell_growth * wanted) size *= step;
  if (cells_along(extent, size).prod() <= max_cells) return size;
  throw InputError(
      "point cloud",
      fmt::format("an extent that a grid of {:.3g} m can cover (are the units metres?)",
                  max_cell_growth * wanted),
      fmt::format("{:.4g} x {:.4g} x {:.4g} m", extent.x(), extent.y(), extent.z()));
}

/// nanoflann's view of a point array.
struct PointsAdaptor {
  const Points& points;

  std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.rows()); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis));
  }
  template <class BoundingBox>
  bool kdtree_get_bbox(BoundingBox&) const {
    return false;
  }
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointsAdaptor>,
                                        PointsAdaptor, 3, Index>;

/// Joins the lists of consecutive blocks of points into one.
NeighborLists concatenate(const std::vector<NeighborLists>& blocks) {
  NeighborLists joined;
  joined.offsets.push_back(0);
  for (const NeighborLists& block : blocks) {
    const auto base = static_cast<Index>(joined.neighbors.size());
    for (const Index end : block.offsets) joined.offsets.push_back(base + end);
    joined.neighbors.insert(joined.neighbors.end(), block.neighbors.begin(), block.neighbors.end());
  }
  return joined;
}

/// Builds the lists block by block; append(i, neighbors) adds the neighbours of point i.
template <class Append>
NeighborLists build_lists(std::size_t count, const Append& append) {
  std::vector<NeighborLists> blocks((count + query_block - 1) / query_block);
  parallel_for_blocks(count, query_block, [&](std::size_t begin, std::size_t end) {
    NeighborLists& block = blocks[begin / query_block];
    for (std::size_t i = begin; i < end; ++i) {
      append(static_cast<Index>(i), block.neighbors);
      block.offsets.push_back(static_cast<Index>(block.neighbors.size()));
    }
  });
  return concatenate(blocks);
}

}  // namespace

CellList::CellList(const Points& points, float cell_size) {
  if (!(cell_size > 0.0F) || !std::isfinite(cell_size))
    throw InputError("neighbour search", "a positive radius", fmt::format("{} m", cell_size));
  if (!points.allFinite())
    throw InputError("point cloud", "finite coordinates", "a NaN or infinite one");
  const Box box = bounding_box(points);
  if (points.rows() == 0) return;
  const double most =
      std::clamp(max_cells_per_point * static_cast<double>(points.rows()), free_cells, max_cells);
  const float fitting = fitting_cell_size(box.extent(), cell_size, most);
  box_ = box;
  inverse_cell_size_ = 1.0F / fitting;
  cells_ = cells_along(box.extent(), fitting).cast<int>().matrix();
  sort(points);
}

std::size_t CellList::cell_of(const Eigen::Vector3f& point) const {
  const int x = clamped_cell(point.x(), 0);
  const int y = clamped_cell(point.y(), 1);
  const int z = clamped_cell(point.z(), 2);
  return row_begin(y, z) + static_cast<std::size_t>(x);
}

void CellList::sort(const Points& points) {
  // Counting sort: cell sizes, prefix sums, then the position of every point.
  cell_begin_.assign(static_cast<std::size_t>(cells_.cast<double>().prod()) + 1, 0);
  for (Eigen::Index i = 0; i < points.rows(); ++i) ++cell_begin_[cell_of(points.row(i)) + 1];
  for (std::size_t cell = 1; cell < cell_begin_.size(); ++cell)
    cell_begin_[cell] += cell_begin_[cell - 1];
  std::vector<Index> next(cell_begin_.begin(), cell_begin_.end() - 1);
  entries_.resize(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    entries_[next[cell_of(points.row(i))]++] = {points(i, 0), points(i, 1), points(i, 2),
                                                static_cast<Index>(i)};
  }
}

inline void CellList::visit_row(const Row& row, const Eigen::Vector3f& query,
                                std::pair<Index, float>& best) const {
  const std::size_t begin = row_begin(row.y, row.z);
  const Index end = cell_begin_[begin + static_cast<std::size_t>(row.x_high) + 1];
  for (Index k = cell_begin_[begin + static_cast<std::size_t>(row.x_low)]; k < end; ++k) {
    const Entry& entry = entries_[k];
    const float dx = entry.x - query.x();
    const float dy = entry.y - query.y();
    const float dz = entry.z - query.z();
    const float squared_distance = dx * dx + dy * dy + dz * dz;
    if (squared_distance < best.second ||
        (squared_distance == best.second && entry.index < best.first))
      best = {entry.index, squared_distance};
  }
}

int CellList::clamped_cell(float coordinate, int axis) const {
  const float cell = (coordinate - box_.min[axis]) * inverse_cell_size_;
  return static_cast<int>(std::clamp(cell, 0.0F, static_cast<float>(cells_[axis] - 1)));
}

std::pair<Index, float> CellList::nearest(const Eigen::Vector3f& query, float radius) const {
  constexpr std::pair<Index, float> nothing{none, std::numeric_limits<float>::infinity()};
  if (entries_.empty()) return nothing;
  const Eigen::Vector3f at = (query - box_.min) * inverse_cell_size_;  // in cells, like all below
  const float reach = radius * inverse_cell_size_ + cell_rounding;
  Eigen::Vector3i low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<float>(cells_[axis] - 1);
    if (at[axis] + reach < 0.0F || at[axis] - reach > last + 1.0F) return nothing;
    low[axis] = static_cast<int>(std::clamp(at[axis] - reach, 0.0F, last));
    high[axis] = static_cast<int>(std::clamp(at[axis] + reach, 0.0F, last));
  }
  std::pair<Index, float> best{none, radius * radius};
  const int own_y = std::clamp(static_cast<int>(at.y()), low.y(), high.y());
  const int own_z = std::clamp(static_cast<int>(at.z()), low.z(), high.z());
  visit_row({own_y, own_z, low.x(), high.x()}, query, best);
  const float squared_inverse = inverse_cell_size_ * inverse_cell_size_;
  const auto length = static_cast<std::size_t>(cells_.x());
  const std::size_t first = static_cast<std::size_t>(low.x());
  const std::size_t end = static_cast<std::size_t>(high.x()) + 1;
  for (int z = low.z(); z <= high.z(); ++z) {
    const float dz = distance_to_cell(at.z(), z);
    // What lies farther than the nearest point so far cannot change the result.
    if (dz * dz > best.second * squared_inverse) continue;
    const Index* row = cell_begin_.data() + row_begin(low.y(), z);
    for (int y = low.y(); y <= high.y(); ++y, row += length) {
      // Most rows are empty, as the points lie on a surface.
      if (row[first] == row[end] || (y == own_y && z == own_z)) continue;
      const float dy = distance_to_cell(at.y(), y);
      if (dy * dy + dz * dz > best.second * squared_inverse) continue;
      visit_row({y, z, low.x(), high.x()}, query, best);
    }
  }
  return best.first == none ? nothing : best;
}

NeighborLists radius_neighbors(const Points& points, float radius) {
  const CellList cells(points, radius);
  return build_lists(
      static_cast<std::size_t>(points.rows()), [&](Index i, std::vector<Index>& neighbors) {
        const auto begin = static_cast<std::ptrdiff_t>(neighbors.size());
        cells.for_each_within(points.row(i).transpose(), radius, [&](Index j, float) {
          if (j != i) neighbors.push_back(j);
        });
        std::sort(neighbors.begin() + begin, neighbors.end());
      });
}

NeighborLists nearest_neighbors(const Points& points, std::size_t count) {
  const PointsAdaptor adaptor{points};
  KdTree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  return build_lists(
      static_cast<std::size_t>(points.rows()), [&](Index i, std::vector<Index>& neighbors) {
        const Eigen::Vector3f query = points.row(i).transpose();
        std::vector<Index> found(count + 1);
        std::vector<float> squared_distances(count + 1);
        const std::size_t n =
            tree.knnSearch(query.data(), count + 1, found.data(), squared_distances.data());
        const std::size_t end = neighbors.size() + std::min(count, n - 1);
        for (std::size_t k = 0; k < n && neighbors.size() < end; ++k) {
          if (found[k] != i) neighbors.push_back(found[k]);
        }
      });
}

std::vector<std::pair<Index, Index>> nearest_pairs(const Points& points, std::size_t count,
                                                   float radius) {
  const CellList cells(points, radius);
  const auto size = static_cast<std::size_t>(points.rows());
  std::vector<std::vector<std::pair<Index, Index>>> blocks((size + query_block - 1) / query_block);
  parallel_for_blocks(size, query_block, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<float, Index>> near;  // by squared distance
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      near.clear();
      cells.for_each_within(points.row(i).transpose(), radius, [&](Index j, float distance) {
        if (j != i) near.emplace_back(distance, j);
      });
      const std::size_t kept = std::min(near.size(), count);
      std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
      for (std::size_t k = 0; k < kept; ++k)
        blocks[begin / query_block].push_back(std::minmax(i, near[k].second));
    }
  });
  std::vector<std::pair<Index, Index>> pairs;
  for (const auto& part : blocks) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace symscene
