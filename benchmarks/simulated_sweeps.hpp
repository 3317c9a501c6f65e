#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>

#include "symscene/simulation/scanned_models.hpp"
#include "symscene/simulation/sweep.hpp"

namespace symscene::bench {

/// Sweeps of a hand-held camera over simulated tables. Sweep i has the next seed and the next
/// number of objects, cyclically.
struct SweepArguments {
  int sweeps = 0;
  std::uint64_t seed = 2000;
  int frames = 0;
  int min_objects = 0;
  int max_objects = 0;
  std::size_t threads = 0;
  std::filesystem::path meshes = {};  ///< to drop; household objects are arranged without
  std::filesystem::path symmetries = {};

  void add_to(CLI::App& app);
  /// After the command line was read.
  void complete();

  /// The models in `meshes`; none without.
  ModelFolder models() const;
  std::uint64_t seed_of(int i) const { return seed + static_cast<std::uint64_t>(i); }
  SweepOptions options(int i) const;
};

/// The table of a sweep.
Tabletop table_of(const SweepOptions& options, const std::vector<ObjectModel>& models);

}  // namespace symscene::bench
