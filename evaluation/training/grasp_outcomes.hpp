#pragma once

#include <filesystem>
#include <vector>

#include "symscene/core/grasp.hpp"

namespace symscene::bench {

/// A grasp that was tried in physics.
struct GraspSample {
  std::size_t group = 0;  ///< samples of one round share it
  Grasp grasp;            ///< its source and features
  bool success = false;
};

/// The samples of CSV files that `symscene_bench_clutter --attempts` wrote. Throws InputError if a
/// file cannot be read or lacks a column.
std::vector<GraspSample> read_grasp_samples(const std::vector<std::filesystem::path>& files);

}  // namespace symscene::bench
