#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// A point seen from the table's plane.
struct PlaneSample {
  Eigen::Vector2d within = Eigen::Vector2d::Zero();  ///< place in the plane [m]
  double height = 0.0;                               ///< above the table [m]
};

/// The samples on floors of bowls, plates and trays, ascending. Floors lie so near to the table
/// that heights alone do not tell them from it: samples up to `clearance` [m] are of a floor if
/// samples above it enclose them, on a grid with cells of `edge` [m], and if their median height is
/// above that of the table around them by a third of the clearance.
std::vector<std::size_t> enclosed_floors(const std::vector<PlaneSample>& samples, double clearance,
                                         double edge);

}  // namespace symscene
