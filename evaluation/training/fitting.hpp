#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boosting.hpp"
#include "core/model_features.hpp"
#include "core/parallel.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::bench {

/// The arguments that the training programs share.
struct FitArguments {
  std::vector<std::filesystem::path> datasets;
  std::filesystem::path output;  ///< folder for the models; empty: none is written
  std::filesystem::path models;  ///< folder of models in place of the embedded ones
  BoostingOptions boosting;
  std::vector<std::string> without;  ///< features that are left out
  std::vector<double> noise{0.0};    ///< standard deviations of normals [degrees]
  std::string data;                  ///< description of the datasets
  std::string command;
};

void add_fit_options(CLI::App& app, FitArguments& arguments);

/// Parses the arguments and runs `work`. Returns the exit status.
int run_fit(CLI::App& app, int argc, char** argv, FitArguments& arguments,
            const std::function<void()>& work);

/// Default options with the models in `arguments.models`.
PipelineOptions pipeline_options(const FitArguments& arguments);

/// A scene of the training split with added noise.
struct FitScene {
  DatasetEntry entry;
  std::size_t dataset = 0;
  std::size_t number = 0;  ///< the same for a scene and its noisy copies
  double noise = 0.0;      ///< [degrees]
};

/// The scenes of all datasets, each once per noise level.
std::vector<FitScene> fit_scenes(const FitArguments& arguments);

LoadedEntry load(const FitScene& scene);

/// `extract` applied to every scene, in parallel, in order.
template <class Scene, class Extract>
std::vector<Scene> extract_all(const FitArguments& arguments, const Extract& extract) {
  const std::vector<FitScene> given = fit_scenes(arguments);
  std::vector<Scene> scenes(given.size());
  parallel_for_each(given.size(), [&](std::size_t k) { scenes[k] = extract(given[k]); });
  return scenes;
}

/// The features as a sample; those in `without` are 0.
template <class Features>
Sample sample_of(const Features& features, double target, const std::vector<std::string>& without) {
  Sample sample;
  Features::visit_fields(features, [&](const std::string& name, double value) {
    const bool left_out = std::find(without.begin(), without.end(), name) != without.end();
    sample.features.push_back(left_out ? 0.0 : value);
  });
  sample.target = target;
  return sample;
}

/// Command, date and data of a model.
ModelOrigin origin_of(const FitArguments& arguments);

/// Samples of these features for the model of this name.
template <class... Features>
TrainingSet training_set(const std::string& name, const FitArguments& arguments,
                         std::vector<Sample> samples) {
  return {name, names_of<Features...>(), origin_of(arguments), std::move(samples)};
}

/// One model per dataset, fitted to the scenes of all others: `fit(d)` leaves out dataset d.
template <class Model, class Fit>
std::vector<std::optional<Model>> fit_without_each(const FitArguments& arguments, const Fit& fit) {
  std::vector<std::optional<Model>> models(arguments.datasets.size());
  parallel_for_each(models.size(), [&](std::size_t d) { models[d].emplace(fit(d)); });
  return models;
}

/// Prints how many splits use each feature.
void print_split_counts(const TreeModel& model);

/// Writes NAME.txt into the output folder, if there is one.
void write_model(const FitArguments& arguments, const TreeModel& model);

}  // namespace symscene::bench
