#include "symscene/dataset/scene_maker.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/random.hpp"
#include "simulation/household_object.hpp"
#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"
#include "varied_scene.hpp"

namespace symscene {
namespace {

constexpr std::uint64_t choice_stream = std::uint64_t{1}
                                        << 41U;  // distinct from the streams of the simulation

bool is_droppable(const ObjectModel& model) {
  return is_solid(model.mesh) &&
         bounding_box(model.mesh.vertices).extent().minCoeff() >= DropOptions{}.min_thickness;
}

/// Draws models at random, none twice while there are others.
std::vector<ObjectModel> drawn(std::span<const ObjectModel> models, std::size_t count,
                               Random& random) {
  std::vector<ObjectModel> chosen;
  std::vector<std::size_t> left;
  while (chosen.size() < count) {
    if (left.empty()) {
      left.resize(models.size());
      std::iota(left.begin(), left.end(), std::size_t{0});
    }
    const std::size_t k = random.below(static_cast<std::uint32_t>(left.size()));
    chosen.push_back(models[left[k]]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return chosen;
}

/// A procedural object with a unique name, as the cache of convex parts is by name.
ObjectModel procedural(const DatasetOptions& options, std::size_t number, Random& random) {
  HouseholdObject object;
  do {
    const double scale =
        options.min_scale < options.max_scale
            ? std::exp(random.uniform(std::log(options.min_scale), std::log(options.max_scale)))
            : options.min_scale;
    object = make_household_object(random_object_kind(random), random, scale);
  } while (!is_droppable(object));
  ObjectModel& model = object;
  model.name += fmt::format("#{}", number);
  return std::move(model);
}

std::vector<ObjectModel> chosen_models(const DatasetOptions& options,
                                       std::span<const ObjectModel> models, std::size_t count,
                                       Random& random) {
  std::size_t scanned = 0;
  for (std::size_t i = 0; i < count && !models.empty(); ++i)
    scanned += random.chance(options.scanned) ? 1 : 0;
  std::vector<ObjectModel> chosen = drawn(models, scanned, random);
  while (chosen.size() < count) chosen.push_back(procedural(options, chosen.size(), random));
  return chosen;
}

Tabletop dropped(const DatasetOptions& options, std::span<const ObjectModel> models,
                 const TabletopOptions& tabletop) {
  Random random(tabletop.seed, choice_stream);
  const auto count = static_cast<std::size_t>(tabletop.objects);
  const std::vector<ObjectModel> chosen = chosen_models(options, models, count, random);
  DropOptions drop;
  drop.spread = random.uniform(options.min_spread, options.max_spread) *
                std::sqrt(static_cast<double>(count));
  Tabletop result = drop_tabletop(chosen, tabletop, drop);
  for (PlacedObject& placed : result.objects)
    placed.object.name = placed.object.name.substr(0, placed.object.name.find('#'));
  return result;
}

Tabletop arranged(const DatasetOptions& options, TabletopOptions tabletop) {
  Random random(tabletop.seed, choice_stream);
  tabletop.stacked = random.uniform(0.0, options.max_stacked);
  tabletop.touching = random.uniform(0.0, options.max_touching);
  return arrange_tabletop(tabletop);
}

/// Largest distance between the detected and the true table at the objects. [m]
double table_error(const SweptScene& made) {
  const Plane& found = *made.scene.table;
  double worst = 0.0;
  for (const TrueObject& object : made.truth.objects) {
    const Eigen::Vector3d foot =
        object.centroid -
        made.truth.table.signed_distance(object.centroid) * made.truth.table.normal;
    worst = std::max(worst, std::abs(found.signed_distance(foot)));
  }
  return worst;
}

/// Why a scene is not accurate enough; empty if it is.
std::string flaw(const SweptScene& made, const DatasetOptions& options) {
  const auto lost = static_cast<double>(made.frames - made.fused);
  if (made.fused < std::min<std::size_t>(3, made.frames) ||
      lost > options.max_lost * static_cast<double>(made.frames))
    return fmt::format("tracking lost {} of {} frames", made.frames - made.fused, made.frames);
  if (made.trajectory.absolute > options.max_error)
    return fmt::format("the camera's path is {:.1f} mm off", 1e3 * made.trajectory.absolute);
  if (!made.scene.table) return "no table was found";
  if (made.truth.objects.empty()) return "no object has enough points";
  const double error = table_error(made);
  if (error > options.max_table_error)
    return fmt::format("the table is {:.1f} mm off", 1e3 * error);
  return "";
}

ScenePlan plan_of(const DatasetOptions& options, std::uint64_t seed) {
  ScenePlan plan;
  plan.sweep.tabletop.seed = seed;
  plan.sweep.camera = options.camera;
  plan.sweep.shake = options.shake;
  plan.sweep.sensor = options.sensor;
  plan.sweep.frame_rate = options.frame_rate;
  plan.making = options.making;
  return vary_scene(options.variation, std::move(plan), seed);
}

bool is_dropped(const DatasetOptions& options, std::span<const ObjectModel> models,
                std::size_t index) {
  if (!models.empty() && !has_physics())
    throw InputError("the models", "a build with physics (MuJoCo) to drop them", "one without");
  if (!has_physics()) return false;
  const auto every = static_cast<std::size_t>(options.arranged_every);
  return every == 0 || index % every != every - 1;
}

/// Makes the scene of the seed in `made.facts`.
void try_seed(const DatasetOptions& options, std::span<const ObjectModel> models, MadeScene& made) {
  SceneFacts& facts = made.facts;
  StageTimer timer;
  Tabletop table = timer.time("place objects", [&] {
    return place_objects(options, models, static_cast<int>(facts.objects_asked), facts.seed,
                         facts.dropped);
  });
  ScenePlan plan = plan_of(options, facts.seed);
  fit_to_objects(options.variation, table, plan);
  SweptScene swept = reconstruct_sweep(table, plan.sweep, plan.making);
  if (!plan.with_occupancy) swept.scene.occupancy.reset();
  facts.objects_placed = table.objects.size();
  facts.objects_seen = swept.truth.objects.size();
  facts.frames = swept.frames;
  facts.fused = swept.fused;
  facts.path_error = swept.trajectory.absolute;
  const std::string reason = flaw(swept, options);
  facts.good = reason.empty();
  for (const std::vector<std::string>& warnings : {table.warnings, swept.scene.warnings})
    made.warnings.insert(made.warnings.end(), warnings.begin(), warnings.end());
  if (!facts.good) facts.failed.push_back({facts.seed, reason});
  if (options.variation.enabled) facts.plan = std::move(plan);
  made.scene = std::move(swept.scene);
  made.truth = std::move(swept.truth);
  for (const std::vector<StageTime>& times : {timer.stages(), swept.stages})
    made.stages.insert(made.stages.end(), times.begin(), times.end());
}

}  // namespace

void DatasetOptions::validate() const {
  check_fields(*this);
  require_option(max_objects >= min_objects, "max_objects", "at least min_objects", max_objects);
  require_option(max_scale >= min_scale, "max_scale", "at least min_scale", max_scale);
  require_option(max_spread >= min_spread, "max_spread", "at least min_spread", max_spread);
}

Tabletop place_objects(const DatasetOptions& options, std::span<const ObjectModel> models,
                       int objects, std::uint64_t seed, bool drop) {
  TabletopOptions tabletop;
  tabletop.objects = objects;
  tabletop.random_frame = true;
  tabletop.seed = seed;
  return drop ? dropped(options, models, tabletop) : arranged(options, tabletop);
}

MadeScene make_scene(const DatasetOptions& options, Split split,
                     std::span<const ObjectModel> models, std::size_t index) {
  options.validate();
  MadeScene made;
  made.facts.index = index;
  made.facts.split = split;
  made.facts.dropped = is_dropped(options, models, index);
  const auto patience = static_cast<std::size_t>(options.patience);
  const auto asked = static_cast<std::size_t>(
      object_count(options.seed, split, index, options.min_objects, options.max_objects));
  const auto attempts = static_cast<std::size_t>(options.attempts);
  for (std::size_t attempt = 0; attempt < attempts && !made.facts.good; ++attempt) {
    made.facts.seed = scene_seed(options.seed, split, index, attempt);
    // Tracking fails on a bare table with a single can: more objects constrain the camera.
    made.facts.objects_asked = asked + (attempt < patience ? 0 : attempt - patience + 1);
    made.facts.objects_asked =
        std::min(made.facts.objects_asked, static_cast<std::size_t>(options.max_objects));
    try {
      try_seed(options, models, made);
    } catch (const PhysicsDiverged& diverged) {
      made.facts.failed.push_back({made.facts.seed, diverged.what()});
      if (attempt + 1 == attempts) throw;
    }
  }
  return made;
}

std::vector<ObjectModel> droppable(std::vector<ObjectModel> models) {
  std::erase_if(models, [](const ObjectModel& model) { return !is_droppable(model); });
  return models;
}

}  // namespace symscene
