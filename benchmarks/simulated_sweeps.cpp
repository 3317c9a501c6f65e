#include "simulated_sweeps.hpp"

#include <algorithm>

namespace symscene::bench {

void SweepArguments::add_to(CLI::App& app) {
  app.add_option("--sweeps", sweeps, "number of sweeps")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", seed, "seed of the first sweep")->capture_default_str();
  app.add_option("--frames", frames, "frames per sweep; 1 for single views")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--min-objects", min_objects, "fewest objects")->check(CLI::Range(1, 15));
  app.add_option("--max-objects", max_objects, "most objects")->check(CLI::Range(1, 15));
  app.add_option("--meshes", meshes, "folder of meshes to drop instead of household objects");
  app.add_option("--symmetries", symmetries, "JSON file with the meshes' symmetries");
  app.add_option("--threads", threads, "bound on the threads, 0 for all cores");
}

void SweepArguments::complete() { max_objects = std::max(max_objects, min_objects); }

ModelFolder SweepArguments::models() const {
  return meshes.empty() ? ModelFolder{} : read_models(meshes, symmetries);
}

SweepOptions SweepArguments::options(int i) const {
  SweepOptions options;
  options.tabletop.seed = seed_of(i);
  options.tabletop.objects = min_objects + i % (max_objects - min_objects + 1);
  options.tabletop.random_frame = true;
  options.camera.frames = frames;
  return options;
}

Tabletop table_of(const SweepOptions& options, const std::vector<ObjectModel>& models) {
  return models.empty() ? arrange_tabletop(options.tabletop)
                        : drop_tabletop(models, options.tabletop, options.drop);
}

}  // namespace symscene::bench
