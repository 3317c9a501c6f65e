#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// Index of a point in a cloud.
using Index = std::uint32_t;

/// Indices into a cloud, ascending where they represent a set of points.
using PointIndices = std::vector<Index>;

/// Points or directions as a structure of arrays: N×3, the columns x, y and z contiguous. [m]
using Points = Eigen::Matrix<float, Eigen::Dynamic, 3>;

/// Red, green and blue, N×3, rows contiguous.
using Colors = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

}  // namespace symscene
