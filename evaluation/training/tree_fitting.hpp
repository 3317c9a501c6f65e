#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "boosted_trees.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/dataset/dataset_folder.hpp"

namespace symscene::bench {

/// What the programs that fit a probability to datasets share.
struct FitArguments {
  std::vector<std::filesystem::path> datasets;
  std::filesystem::path output;
  BoostingOptions boosting;
  std::vector<std::string> without;
  std::vector<double> noise{0.0};  ///< of normals, each scene once with each [degrees]
};

void add_fit_options(CLI::App& app, FitArguments& arguments);

/// Runs `work` after the arguments are parsed; the status with which the program ends.
int run_fit(CLI::App& app, int argc, char** argv, const char* name,
            const std::function<void()>& work);

/// A scene to learn from, with the noise that is added to it.
struct FitScene {
  DatasetEntry entry;
  std::size_t dataset = 0;
  std::size_t number = 0;  ///< alike for a scene and its noisy copies
  double noise = 0.0;      ///< [degrees]
};

/// The scenes of all datasets, each once with each noise.
std::vector<FitScene> fit_scenes(const FitArguments& arguments);

LoadedEntry load(const FitScene& scene);

/// The cloud as a worse sensor would have it: normals turned at random, alike within a centimetre,
/// as the noise of a depth image is, and points off the surface in proportion.
PointCloud with_noise(PointCloud cloud, double degrees, std::uint64_t seed);

/// The C++ table of a model, whose constants begin with `name`.
std::string as_table(const BoostedTrees& model, const std::string& program,
                     const std::string& name);

/// The measures as features; those left out are 0.
template <class Measures>
Sample sample_of(const Measures& features, double target, const std::vector<std::string>& without) {
  Sample sample;
  Measures::visit_fields(features, [&](const std::string& name, double value) {
    const bool left_out = std::find(without.begin(), without.end(), name) != without.end();
    sample.features.push_back(left_out ? 0.0 : value);
  });
  sample.target = target;
  return sample;
}

/// How much each measure's questions gain is told by how often it is asked.
template <class Measures>
void print_use(const BoostedTrees& model) {
  std::vector<std::size_t> asked(Measures::count);
  for (const Tree& tree : model.trees) {
    for (const TreeNode& node : tree) {
      if (node.feature >= 0) ++asked[static_cast<std::size_t>(node.feature)];
    }
  }
  std::size_t next = 0;
  const Measures none;
  Measures::visit_fields(
      none, [&](const char* name, double) { fmt::print("{} {}, ", name, asked[next++]); });
  fmt::print("\n");
}

}  // namespace symscene::bench
