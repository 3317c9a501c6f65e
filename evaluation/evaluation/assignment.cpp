#include "assignment.hpp"

#include <algorithm>
#include <limits>

namespace symscene {
namespace {

/// Shortest augmenting paths with potentials on costs of at most as many rows as columns. Row and
/// column 0 stand for "none".
class Assignment {
 public:
  explicit Assignment(const Eigen::MatrixXd& costs)
      : costs_(costs),
        row_potential_(static_cast<std::size_t>(costs.rows()) + 1, 0.0),
        column_potential_(static_cast<std::size_t>(costs.cols()) + 1, 0.0),
        row_of_(static_cast<std::size_t>(costs.cols()) + 1, 0) {
    for (std::size_t row = 1; row < row_potential_.size(); ++row) insert(row);
  }

  /// The row of each column, both from 1; 0 where it has none.
  const std::vector<std::size_t>& row_of() const { return row_of_; }

 private:
  void insert(std::size_t row) {
    const std::size_t columns = row_of_.size();
    std::vector<double> least(columns, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> previous(columns, 0);
    std::vector<bool> visited(columns, false);
    row_of_[0] = row;
    std::size_t column = 0;
    do {
      visited[column] = true;
      column = advance(column, least, previous, visited);
    } while (row_of_[column] != 0);
    while (column != 0) {
      row_of_[column] = row_of_[previous[column]];
      column = previous[column];
    }
  }

  /// Relaxes the edges of the column's row and steps to the nearest column not visited.
  std::size_t advance(std::size_t column, std::vector<double>& least,
                      std::vector<std::size_t>& previous, const std::vector<bool>& visited) {
    const std::size_t row = row_of_[column];
    std::size_t next = 0;
    double delta = std::numeric_limits<double>::infinity();
    for (std::size_t j = 1; j < row_of_.size(); ++j) {
      if (visited[j]) continue;
      const double reduced =
          costs_(static_cast<Eigen::Index>(row - 1), static_cast<Eigen::Index>(j - 1)) -
          row_potential_[row] - column_potential_[j];
      if (reduced < least[j]) {
        least[j] = reduced;
        previous[j] = column;
      }
      if (least[j] < delta) {
        delta = least[j];
        next = j;
      }
    }
    for (std::size_t j = 0; j < row_of_.size(); ++j) {
      if (visited[j]) {
        row_potential_[row_of_[j]] += delta;
        column_potential_[j] -= delta;
      } else {
        least[j] -= delta;
      }
    }
    return next;
  }

  const Eigen::MatrixXd& costs_;
  std::vector<double> row_potential_;
  std::vector<double> column_potential_;
  std::vector<std::size_t> row_of_;
};

}  // namespace

std::vector<MaskPair> assign_masks(const OverlapMatrix& gains) {
  if (gains.size() == 0) return {};
  const bool swapped = gains.rows() > gains.cols();
  const Eigen::MatrixXd costs = swapped ? Eigen::MatrixXd(-gains.transpose()) : -gains;
  const Assignment assignment(costs);
  std::vector<MaskPair> pairs;
  for (std::size_t column = 1; column < assignment.row_of().size(); ++column) {
    if (assignment.row_of()[column] == 0) continue;
    auto truth = static_cast<Index>(assignment.row_of()[column] - 1);
    auto found = static_cast<Index>(column - 1);
    if (swapped) std::swap(truth, found);
    if (gains(truth, found) > 0.0) pairs.push_back({truth, found, gains(truth, found)});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const MaskPair& a, const MaskPair& b) { return a.truth < b.truth; });
  return pairs;
}

}  // namespace symscene
