#include "enclosed_floors.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"

namespace symscene {
namespace {

constexpr double max_columns = 2000.0;  ///< a room gets coarser cells
constexpr std::size_t margin = 5;       ///< of the table that a floor is compared with [cells]
constexpr std::size_t min_cells = 4;    ///< of a floor

/// A grid over the table, whose outermost cells are empty.
class FloorGrid {
 public:
  FloorGrid(const std::vector<PlaneSample>& samples, double clearance, double edge)
      : clearance_(clearance), edge_(edge) {
    Eigen::Vector2d low = samples.front().within, high = low;
    for (const PlaneSample& sample : samples) {
      low = low.cwiseMin(sample.within);
      high = high.cwiseMax(sample.within);
    }
    edge_ = std::max(edge_, (high - low).maxCoeff() / max_columns);
    low_ = low.array() - edge_;
    columns_ = static_cast<std::size_t>((high.x() - low_.x()) / edge_) + 2;
    rows_ = static_cast<std::size_t>((high.y() - low_.y()) / edge_) + 2;
    cells_.assign(columns_ * rows_, Cell::unseen);
    heights_.assign(cells_.size(), 0.0);
    fill(samples);
    take_table();
  }

  void find_floors() {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      if (cells_[cell] != Cell::low && cells_[cell] != Cell::raised) continue;
      const std::vector<std::size_t> region = region_of(cell);
      if (region.size() < min_cells || !is_walled(region) || lift_of(region) <= clearance_ / 3.0)
        continue;
      for (const std::size_t k : region) cells_[k] = Cell::floor;
    }
  }

  bool is_floor(const PlaneSample& sample) const {
    return std::abs(sample.height) <= clearance_ && cells_[cell_of(sample)] == Cell::floor;
  }

 private:
  /// The mean height of a raised cell is above half of the clearance: a rim that a sensor smooths
  /// away still encloses.
  enum class Cell : std::uint8_t { unseen, low, raised, high, table, outside, enclosed, floor };

  std::size_t cell_of(const PlaneSample& sample) const {
    const Eigen::Vector2d at = (sample.within - low_) / edge_;
    return static_cast<std::size_t>(at.y()) * columns_ + static_cast<std::size_t>(at.x());
  }

  /// Calls visit(neighbor) for the four neighbors of a cell.
  template <class Visit>
  void for_each_neighbor(std::size_t cell, const Visit& visit) const {
    const std::size_t x = cell % columns_, y = cell / columns_;
    if (x > 0) visit(cell - 1);
    if (x + 1 < columns_) visit(cell + 1);
    if (y > 0) visit(cell - columns_);
    if (y + 1 < rows_) visit(cell + columns_);
  }

  /// High cells are those with a sample that noise does not explain, and those whose mean is high.
  void fill(const std::vector<PlaneSample>& samples) {
    std::vector<std::uint32_t> counts(cells_.size(), 0);
    for (const PlaneSample& sample : samples) {
      const std::size_t cell = cell_of(sample);
      if (sample.height > 2.0 * clearance_) cells_[cell] = Cell::high;
      if (sample.height < -clearance_) continue;
      heights_[cell] += sample.height;
      ++counts[cell];
    }
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (cells_[k] == Cell::high || counts[k] == 0) continue;
      heights_[k] /= counts[k];
      cells_[k] = heights_[k] > clearance_         ? Cell::high
                  : heights_[k] > clearance_ / 2.0 ? Cell::raised
                                                   : Cell::low;
    }
  }

  /// The table is what the border of the grid reaches, with the raised cells along it: there the
  /// surfaces of things run out.
  void take_table() {
    std::vector<std::size_t> open = {0}, reached;
    cells_[0] = Cell::outside;
    while (!open.empty()) {
      const std::size_t cell = open.back();
      open.pop_back();
      reached.push_back(cell);
      for_each_neighbor(cell, [&](std::size_t other) {
        if (cells_[other] != Cell::unseen && cells_[other] != Cell::low) return;
        cells_[other] = cells_[other] == Cell::low ? Cell::table : Cell::outside;
        open.push_back(other);
      });
    }
    for (const std::size_t cell : reached) {
      for_each_neighbor(cell, [&](std::size_t other) {
        if (cells_[other] == Cell::raised) cells_[other] = Cell::outside;
      });
    }
  }

  /// The low and raised cells that connect to a cell; they become enclosed.
  std::vector<std::size_t> region_of(std::size_t seed) {
    std::vector<std::size_t> region = {seed};
    cells_[seed] = Cell::enclosed;
    for (std::size_t k = 0; k < region.size(); ++k) {
      for_each_neighbor(region[k], [&](std::size_t other) {
        if (cells_[other] != Cell::low && cells_[other] != Cell::raised) return;
        cells_[other] = Cell::enclosed;
        region.push_back(other);
      });
    }
    return region;
  }

  /// Whether at least half of the cells around a region are high.
  bool is_walled(const std::vector<std::size_t>& region) const {
    std::size_t high = 0, around = 0;
    for (const std::size_t cell : region) {
      for_each_neighbor(cell, [&](std::size_t other) {
        if (cells_[other] == Cell::enclosed) return;
        ++around;
        high += cells_[other] == Cell::high ? 1 : 0;
      });
    }
    return 2 * high >= around;
  }

  /// How much higher the cells are than the table around them, by medians. [m]
  double lift_of(const std::vector<std::size_t>& region) const {
    std::size_t left = columns_, right = 0, bottom = rows_, top = 0;
    std::vector<double> floor, table;
    for (const std::size_t cell : region) {
      left = std::min(left, cell % columns_);
      right = std::max(right, cell % columns_);
      bottom = std::min(bottom, cell / columns_);
      top = std::max(top, cell / columns_);
      floor.push_back(heights_[cell]);
    }
    // The walls of a vessel lie between its floor and the table: as wide as the floor, at most.
    const std::size_t reach = margin + std::max(right - left, top - bottom) + 1;
    for (std::size_t y = bottom - std::min(bottom, reach); y < std::min(rows_, top + reach); ++y) {
      for (std::size_t x = left - std::min(left, reach); x < std::min(columns_, right + reach);
           ++x) {
        if (cells_[y * columns_ + x] == Cell::table) table.push_back(heights_[y * columns_ + x]);
      }
    }
    return *median(std::move(floor)) - median(std::move(table)).value_or(0.0);
  }

  double clearance_;
  double edge_;
  Eigen::Vector2d low_;
  std::size_t columns_, rows_;
  std::vector<Cell> cells_;
  std::vector<double> heights_;  ///< mean heights of cells that are not high [m]
};

}  // namespace

std::vector<std::size_t> enclosed_floors(const std::vector<PlaneSample>& samples, double clearance,
                                         double edge) {
  std::vector<std::size_t> floors;
  if (samples.empty()) return floors;
  FloorGrid grid(samples, clearance, edge);
  grid.find_floors();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (grid.is_floor(samples[i])) floors.push_back(i);
  }
  return floors;
}

}  // namespace symscene
