#include "fitting.hpp"

#include <cstdio>
#include <ctime>
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/atomic_file.hpp"
#include "scene_variants.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/tree_model.hpp"

namespace symscene::bench {

void add_fit_options(CLI::App& app, FitArguments& arguments) {
  app.add_option("datasets", arguments.datasets, "datasets of the training split")->required();
  app.add_option("-o,--output", arguments.output, "folder to write models into, e.g. models");
  app.add_option("--models", arguments.models,
                 "folder of models that replace the embedded ones when scenes are segmented");
  app.add_option("--rounds", arguments.boosting.rounds, "number of trees")->capture_default_str();
  app.add_option("--depth", arguments.boosting.depth, "greatest depth of a tree")
      ->capture_default_str();
  app.add_option("--rate", arguments.boosting.rate, "learning rate")->capture_default_str();
  app.add_option("--min-leaf", arguments.boosting.min_leaf, "least number of samples of a leaf")
      ->capture_default_str();
  app.add_option("--sample-share", arguments.boosting.sample_share,
                 "share of the samples that a tree sees")
      ->capture_default_str();
  app.add_option("--feature-share", arguments.boosting.feature_share,
                 "share of the features that a tree sees")
      ->capture_default_str();
  app.add_option("--noise", arguments.noise,
                 "noise of normals [degrees]; each scene is used once with each");
  app.add_option("--without", arguments.without, "features to leave out");
  app.add_option("--data", arguments.data, "description of the datasets, written into the model");
}

int run_fit(CLI::App& app, int argc, char** argv, FitArguments& arguments,
            const std::function<void()>& work) {
  CLI11_PARSE(app, argc, argv);
  const std::string program = std::filesystem::path(argv[0]).filename().string();
  arguments.command = program;
  for (int k = 1; k < argc; ++k) arguments.command += fmt::format(" {}", argv[k]);
  try {
    work();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program.c_str(), error.what());
    return 1;
  }
}

PipelineOptions pipeline_options(const FitArguments& arguments) {
  PipelineOptions options;
  if (arguments.models.empty()) return options;
  const auto read = [&](const char* name, ModelChoice& choice) {
    const std::filesystem::path file = arguments.models / fmt::format("{}.txt", name);
    if (!exists(file)) return;
    choice = {file.string(), std::make_shared<const TreeModel>(read_tree_model(file))};
  };
  read("object_alone", options.models.object_alone);
  read("object_among_others", options.models.object_among_others);
  read("axis", options.models.axis);
  read("plane", options.models.plane);
  return options;
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

ModelOrigin origin_of(const FitArguments& arguments) {
  ModelOrigin origin{arguments.command,
                     fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr))),
                     arguments.data};
  if (!origin.data.empty()) return origin;
  std::vector<std::string> names;
  for (const std::filesystem::path& dataset : arguments.datasets)
    names.push_back(dataset.filename().string());
  origin.data = fmt::format("the datasets {}", fmt::join(names, " "));
  return origin;
}

void print_split_counts(const TreeModel& model) {
  std::vector<std::size_t> counts(model.features().size());
  for (std::size_t k = 0; k < model.trees(); ++k) {
    for (const TreeNode& node : model.tree(k)) {
      if (node.feature >= 0) ++counts[static_cast<std::size_t>(node.feature)];
    }
  }
  fmt::print("splits of {}:", model.name());
  for (std::size_t f = 0; f < counts.size(); ++f)
    fmt::print(" {} {}", model.features()[f], counts[f]);
  fmt::print("\n");
}

void write_model(const FitArguments& arguments, const TreeModel& model) {
  if (arguments.output.empty()) return;
  std::filesystem::create_directories(arguments.output);
  write_file_atomically(arguments.output / fmt::format("{}.txt", model.name()),
                        format_tree_model(model));
}

}  // namespace symscene::bench
