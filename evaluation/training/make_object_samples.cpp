// Writes the proposals of datasets with ground truth as samples for symscene_fit_object_score
// (evaluation/training/README.md).
#include <CLI/CLI.hpp>
#include <cstdio>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "object_samples.hpp"
#include "scene_variants.hpp"
#include "symscene/core/error.hpp"
#include "symscene/dataset/dataset_folder.hpp"

namespace symscene::bench {
namespace {

struct Arguments {
  std::filesystem::path dataset;
  std::filesystem::path output;
  std::vector<std::string> variants{"as-is"};
};

SceneSamples samples_of(const DatasetEntry& entry, const std::string& variant, std::size_t number) {
  LoadedEntry loaded = load_entry(entry);
  if (loaded.scene.cloud.empty() || loaded.truth.objects.empty()) return {};
  vary(variant, number, loaded.scene, loaded.truth);
  SceneSamples samples = object_samples(loaded.scene, loaded.truth, {});
  samples.number = static_cast<std::uint32_t>(number);
  return samples;
}

void run(const Arguments& arguments) {
  const std::vector<DatasetEntry> entries = read_dataset(arguments.dataset).entries;
  const std::size_t variants = arguments.variants.size();
  std::vector<SceneSamples> scenes(entries.size() * variants);
  parallel_for_each(scenes.size(), [&](std::size_t k) {
    try {
      scenes[k] = samples_of(entries[k / variants], arguments.variants[k % variants], k / variants);
    } catch (const InputError& error) {  // such as a scene too large to be segmented
      fmt::print(stderr, "{} is left out: {}\n", entries[k / variants].name, error.what());
    }
  });
  std::erase_if(scenes, [](const SceneSamples& scene) { return scene.true_sizes.empty(); });
  write_samples(arguments.output, scenes);
  fmt::print("{}: {} scenes\n", arguments.output.string(), scenes.size());
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{
      "Writes the proposals of a dataset with ground truth as samples for "
      "symscene_fit_object_score."};
  app.add_option("dataset", arguments.dataset, "dataset of the training split")->required();
  app.add_option("-o,--output", arguments.output, "file of samples")->required();
  app.add_option("--variants", arguments.variants,
                 "each scene is used once as each of: as-is, posed (turned and shifted at random, "
                 "without occupancy), noisy (normals turned, points shifted along them)")
      ->check(CLI::IsMember(symscene::bench::scene_variants()))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    symscene::bench::run(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "symscene_make_object_samples: %s\n", error.what());
    return 1;
  }
}
