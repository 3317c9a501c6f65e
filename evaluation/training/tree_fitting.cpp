#include "tree_fitting.hpp"

#include <cstdio>

#include "core/random.hpp"
#include "symscene/core/error.hpp"

namespace symscene::bench {

void add_fit_options(CLI::App& app, FitArguments& arguments) {
  app.add_option("datasets", arguments.datasets, "datasets of the tune split")->required();
  app.add_option("-o,--output", arguments.output, "table to write, under src/pipeline");
  app.add_option("--rounds", arguments.boosting.rounds, "trees")->capture_default_str();
  app.add_option("--depth", arguments.boosting.depth, "questions in a row")->capture_default_str();
  app.add_option("--rate", arguments.boosting.rate, "share of a step")->capture_default_str();
  app.add_option("--min-leaf", arguments.boosting.min_leaf, "samples")->capture_default_str();
  app.add_option("--noise", arguments.noise, "of normals: each scene once with each [degrees]");
  app.add_option("--without", arguments.without, "measures to leave out");
}

int run_fit(CLI::App& app, int argc, char** argv, const char* name,
            const std::function<void()>& work) {
  CLI11_PARSE(app, argc, argv);
  try {
    work();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

std::vector<FitScene> fit_scenes(const FitArguments& arguments) {
  std::vector<FitScene> scenes;
  std::size_t number = 0;
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
    for (const DatasetEntry& entry : read_dataset(arguments.datasets[d]).entries) {
      for (const double noise : arguments.noise) scenes.push_back({entry, d, number, noise});
      ++number;
    }
  }
  return scenes;
}

LoadedEntry load(const FitScene& scene) {
  LoadedEntry loaded = load_entry(scene.entry);
  loaded.scene.cloud = with_noise(std::move(loaded.scene.cloud), scene.noise, scene.dataset);
  return loaded;
}

PointCloud with_noise(PointCloud cloud, double degrees, std::uint64_t seed) {
  constexpr double cell = 0.01;               // [m]
  constexpr double offset_per_degree = 1e-4;  // [m]
  const auto sigma = static_cast<float>(radians(degrees));
  if (sigma > 0.0F && !cloud.has_normals())
    throw InputError("--noise", "clouds with normals", "one without");
  for (Index i = 0; i < cloud.size() && sigma > 0.0F; ++i) {
    const Eigen::Vector3d at = (cloud.position(i).cast<double>() / cell).array().floor();
    const auto key = static_cast<std::uint64_t>((at.x() * 73856093.0) + (at.y() * 19349663.0) +
                                                (at.z() * 83492791.0) + 1e12);
    Random shared(key, seed), own(i, seed + 1);
    const auto turn = [&](Random& random) {
      return Eigen::Vector3f(static_cast<float>(random.normal()),
                             static_cast<float>(random.normal()),
                             static_cast<float>(random.normal()));
    };
    const Eigen::Vector3f n =
        (cloud.normal(i) + sigma * (turn(shared) + 0.5F * turn(own))).normalized();
    const auto off = static_cast<float>(degrees * offset_per_degree * shared.normal());
    cloud.positions.row(i) += off * cloud.normals.row(i);
    cloud.normals.row(i) = n.transpose();
  }
  return cloud;
}

std::string as_table(const BoostedTrees& model, const std::string& program,
                     const std::string& name) {
  std::string roots, nodes;
  std::size_t count = 0;
  for (const Tree& tree : model.trees) {
    roots += fmt::format("{}{},", count % 16 == 0 ? "\n    " : " ", count);
    for (const TreeNode& node : tree) {
      const double value = node.feature >= 0 ? double{node.bound} : node.value;
      nodes += fmt::format("    {{{}, {}, {:#.9g}F}},\n", node.feature, node.right, value);
    }
    count += tree.size();
  }
  return fmt::format(
      "// Written by {0}.\n"
      "constexpr float {1}_base = {2:.6f}F;\n"
      "constexpr std::int32_t {1}_roots[] = {{{3}\n}};\n"
      "constexpr TreeNode {1}_nodes[] = {{\n{4}}};\n",
      program, name, model.base, roots, nodes);
}

}  // namespace symscene::bench
