#include "factor_fit.hpp"

#include <algorithm>
#include <array>

#include <Eigen/SparseCholesky>

namespace symscene {
namespace {

constexpr double first_difference = 1e-3;  ///< weight relative to that of second differences

struct Corner {
  Eigen::Index cell = 0;
  double weight = 0.0;
};

/// The eight nodes around a sample and their weights. Those of no weight may repeat.
std::array<Corner, 8> corners_of(const DepthSample& sample, const DepthCorrection& grid) {
  const AxisPlace x = place_in_image(sample.u, grid.width, grid.columns);
  const AxisPlace y = place_in_image(sample.v, grid.height, grid.rows);
  const AxisPlace z =
      place_on_axis((sample.depth - grid.first_range) / grid.range_step, grid.ranges);
  std::array<Corner, 8> corners;
  for (Index k = 0; k < 8; ++k) {
    const Index dx = k & 1U, dy = (k >> 1U) & 1U, dz = k >> 2U;
    const auto share = [](const AxisPlace& place, Index d) {
      return d == 0 ? 1.0 - place.beyond : place.beyond;
    };
    corners[k].cell = static_cast<Eigen::Index>(grid.cell(std::min(z.node + dz, grid.ranges - 1),
                                                          std::min(y.node + dy, grid.rows - 1),
                                                          std::min(x.node + dx, grid.columns - 1)));
    corners[k].weight = share(x, dx) * share(y, dy) * share(z, dz);
  }
  return corners;
}

class NormalEquations {
 public:
  explicit NormalEquations(const DepthCorrection& grid)
      : grid_(grid),
        right_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(grid.cells()))),
        weight_(right_),
        near_(27 * grid.cells(), 0.0) {}

  void add(const FactorSample& sample) {
    const std::array<Corner, 8> corners = corners_of(sample.at, grid_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner& a = corners[i];
      if (a.weight == 0.0) continue;
      right_[a.cell] += sample.weight * a.weight * sample.factor;
      weight_[a.cell] += sample.weight * a.weight;
      for (std::size_t j = 0; j < corners.size(); ++j) {
        if (corners[j].weight == 0.0) continue;
        // Both nodes differ by at most one along each axis.
        const std::size_t offset = 13 + step(i, j, 0) + 3 * step(i, j, 1) + 9 * step(i, j, 2);
        near_[27 * static_cast<std::size_t>(a.cell) + offset] +=
            sample.weight * a.weight * corners[j].weight;
      }
    }
  }

  /// The mean weight of the cells that have any.
  double mean_weight() const {
    const auto cells = (weight_.array() > 0.0).count();
    return cells == 0 ? 0.0 : weight_.sum() / static_cast<double>(cells);
  }
  const Eigen::VectorXd& weights() const { return weight_; }

  Eigen::VectorXd solve(double smoothness) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index k = 0; k < grid_.ranges; ++k) {
      for (Index j = 0; j < grid_.rows; ++j) {
        for (Index i = 0; i < grid_.columns; ++i) add_cell({i, j, k}, smoothness, entries);
      }
    }
    const Eigen::Index n = right_.size();
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right_);
  }

 private:
  using Node = std::array<Index, 3>;  ///< column, row, range

  /// −1, 0 or 1 as an unsigned number that wraps around.
  static std::size_t step(std::size_t from, std::size_t to, unsigned axis) {
    return ((to >> axis) & 1U) - ((from >> axis) & 1U);
  }

  Eigen::Index cell(const Node& node) const {
    return static_cast<Eigen::Index>(grid_.cell(node[2], node[1], node[0]));
  }

  void add_cell(const Node& node, double smoothness,
                std::vector<Eigen::Triplet<double>>& entries) const {
    add_samples(node, entries);
    const std::array<Index, 3> count{grid_.columns, grid_.rows, grid_.ranges};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Node next = node, after = node;
      next[axis] += 1, after[axis] += 2;
      const std::array<Eigen::Index, 3> cells{cell(node), next[axis] < count[axis] ? cell(next) : 0,
                                              after[axis] < count[axis] ? cell(after) : 0};
      if (next[axis] < count[axis])
        add_difference(std::span(cells).first(2), {1.0, -1.0, 0.0}, first_difference * smoothness,
                       entries);
      if (after[axis] < count[axis]) add_difference(cells, {1.0, -2.0, 1.0}, smoothness, entries);
    }
  }

  void add_samples(const Node& node, std::vector<Eigen::Triplet<double>>& entries) const {
    const Eigen::Index own = cell(node);
    const double* const near = near_.data() + 27 * static_cast<std::size_t>(own);
    for (Index offset = 0; offset < 27; ++offset) {
      if (near[offset] == 0.0) continue;
      const Node other{node[0] + offset % 3 - 1, node[1] + offset / 3 % 3 - 1,
                       node[2] + offset / 9 - 1};
      entries.emplace_back(own, cell(other), near[offset]);
    }
  }

  static void add_difference(std::span<const Eigen::Index> cells,
                             const std::array<double, 3>& factors, double weight,
                             std::vector<Eigen::Triplet<double>>& entries) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (std::size_t j = 0; j < cells.size(); ++j)
        entries.emplace_back(cells[i], cells[j], weight * factors[i] * factors[j]);
    }
  }

  const DepthCorrection& grid_;
  Eigen::VectorXd right_;
  Eigen::VectorXd weight_;
  std::vector<double> near_;  ///< per cell: with the cells around it, 3×3×3
};

}  // namespace

DepthCorrection empty_correction(const CameraIntrinsics& camera, double least_depth,
                                 double greatest_depth, const DepthCorrectionOptions& options) {
  DepthCorrection grid;
  grid.width = camera.width;
  grid.height = camera.height;
  grid.columns = std::min(camera.width, static_cast<Index>(options.columns));
  grid.rows = std::min(camera.height, static_cast<Index>(options.rows));
  grid.ranges = static_cast<Index>(options.ranges);
  grid.first_range = least_depth;
  const double spread = std::max(greatest_depth - least_depth, 1e-3 * least_depth);
  grid.range_step = spread / std::max(1, options.ranges - 1);
  grid.factors.assign(grid.cells(), 1.0F);
  grid.measured.assign(grid.cells(), 0);
  return grid;
}

DepthCorrection fitted(DepthCorrection grid, std::span<const FactorSample> samples,
                       const DepthCorrectionOptions& options) {
  NormalEquations equations(grid);
  for (const FactorSample& sample : samples) equations.add(sample);
  const double mean = equations.mean_weight();
  if (mean == 0.0) return grid;
  const Eigen::VectorXd factors = equations.solve(options.smoothness * mean);
  for (std::size_t i = 0; i < grid.cells(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    grid.factors[i] = static_cast<float>(std::clamp(factors[at], 0.5, 2.0));
    grid.measured[i] = equations.weights()[at] >= options.min_samples ? 1 : 0;
  }
  return grid;
}

}  // namespace symscene
