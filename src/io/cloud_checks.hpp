#pragma once

#include <string>

#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Throws InputError unless there are no normals (colours) or one per point.
inline void require_consistent(const PointCloud& cloud, const std::string& what) {
  const auto check = [&](Eigen::Index rows, const char* expected) {
    if (rows == 0 || rows == cloud.positions.rows()) return;
    throw InputError(
        what, expected,
        std::to_string(rows) + " for " + std::to_string(cloud.positions.rows()) + " points");
  };
  check(cloud.normals.rows(), "no normals or one per point");
  check(cloud.colors.rows(), "no colours or one per point");
}

}  // namespace symscene
