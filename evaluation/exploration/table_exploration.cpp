#include "symscene/exploration/table_exploration.hpp"

#include <numbers>
#include <utility>

#include "benchmark_frame.hpp"
#include "core/random.hpp"
#include "exploration_loop.hpp"
#include "symscene/core/error.hpp"
#include "symscene/simulation/settling.hpp"

namespace symscene {
namespace {

TabletopOptions tabletop_options(const TableExplorationOptions& options) {
  TabletopOptions tabletop;
  tabletop.objects = options.objects;
  tabletop.seed = options.seed;
  tabletop.stacked = 0.0;
  return tabletop;
}

DropOptions drop_options(const TableExplorationOptions& options) {
  DropOptions drop;
  drop.spread = options.spread;
  drop.upright = options.kind == ClutterKind::packed ? 1.0 : 0.0;
  return drop;
}

std::vector<ObjectModel> household_models(const TabletopOptions& options) {
  std::vector<ObjectModel> models;
  for (PlacedObject& placed : arrange_tabletop(options).objects)
    models.push_back(std::move(placed.object));
  return models;
}

Tabletop dropped(std::span<const ObjectModel> models, const TableExplorationOptions& options) {
  return drop_tabletop(models, tabletop_options(options), drop_options(options));
}

std::vector<TriangleMesh> object_meshes(const Tabletop& table) {
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : table.objects) meshes.push_back(world_mesh(placed));
  return meshes;
}

ExploredView explored(const ExplorationLook& look, const ExplorationStep& step) {
  return {step,
          look.view.T_world_camera,
          look.view.frame.depth,
          look.result.objects,
          look.result.surfaces,
          look.next,
          look.expected,
          look.timings};
}

}  // namespace

bool needs_physics(const TableExplorationOptions& options, bool has_models) {
  return has_models || options.kind == ClutterKind::pile;
}

Tabletop furnish_exploration(std::span<const ObjectModel> models,
                             const TableExplorationOptions& options) {
  options.validate();
  const TabletopOptions arrangement = tabletop_options(options);
  if (!needs_physics(options, !models.empty()))
    return in_benchmark_frame(arrange_tabletop(arrangement));
  if (!models.empty()) return in_benchmark_frame(dropped(models, options));
  return in_benchmark_frame(dropped(household_models(arrangement), options));
}

TableExploration explore_table(const Tabletop& table, const TableExplorationOptions& options,
                               const ExplorationObserver& observer) {
  options.validate();
  Random random(options.seed);
  const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
  const ExplorationWorld world(object_meshes(table),
                               exploration_candidates(options.radius, azimuth), options.noise,
                               random.seed());
  ViewChooser chooser(options.policy, world.candidates(), first_view, options.choice,
                      Random(random.seed()));
  ClutterMethodOptions sensing;
  sensing.pipeline = options.pipeline;
  TableExploration exploration;
  exploration.policy = options.policy;
  exploration.camera = clutter_camera();
  exploration.candidates = world.candidates();
  const auto keep = [&](const ExplorationLook& look, const ExplorationStep& step) {
    exploration.views.push_back(explored(look, step));
    exploration.scene = look.scene;
    exploration.result = look.result;
    if (observer.on_view) observer.on_view(exploration.views.back());
  };
  exploration.end =
      explore(world, chooser, sensing, {options.views, true, keep, observer.on_begin}).end;
  exploration.seen = world.truth().shares(exploration.scene.cloud.positions);
  return exploration;
}

}  // namespace symscene
