// Fitted dimensions of boxes, cylinders and spheres against the true ones: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "core/median.hpp"
#include "core/random.hpp"
#include "program.hpp"
#include "simulated_sweeps.hpp"
#include "simulation/shapes.hpp"
#include "stopwatch.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/dataset/swept_scene.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::bench {
namespace {

constexpr double min_overlap = 0.75;     // of a mask whose object is compared
constexpr double max_path_error = 0.01;  // of a sweep that is used [m]

struct Arguments {
  SweepArguments sweeps{.sweeps = 12, .frames = 60, .min_objects = 3, .max_objects = 9};
  double min_distance = 0.5;
  double max_distance = 2.0;
  std::string sensor;
  bool list = false;
};

/// The dimensions that an object truly has, by name.
struct TrueDimensions {
  std::string kind;  ///< "box", "cylinder", "sphere", or empty for another shape
  std::vector<std::pair<std::string, double>> values;  ///< [m]
};

Eigen::Vector3d extent_of(const TriangleMesh& mesh) {
  return (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff())
      .transpose()
      .cast<double>();
}

TrueDimensions true_dimensions(const ObjectModel& model) {
  const Eigen::Vector3d size = extent_of(model.mesh);
  if (model.sphere) return {"sphere", {{"radius", 0.5 * size.z()}}};
  if (model.name == "box")
    return {"box", {{"length", size.x()}, {"width", size.y()}, {"height", size.z()}}};
  if (model.name == "can") return {"cylinder", {{"radius", 0.5 * size.x()}, {"height", size.z()}}};
  if (model.name == "lying_can")
    return {"cylinder", {{"radius", 0.5 * size.z()}, {"height", size.x()}}};
  return {};
}

/// A ball on the table in place of a toy, not larger than it.
ObjectModel ball_for(const ObjectModel& toy) {
  constexpr int steps = 48;
  const Eigen::Vector3d size = extent_of(toy.mesh);
  const double radius = 0.4 * std::min({size.x(), size.y(), size.z()});
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= steps; ++k) {
    const double angle = std::numbers::pi * k / steps;
    const bool is_end = k == 0 || k == steps;
    profile.push_back({is_end ? 0.0 : radius * std::sin(angle), radius * (1.0 - std::cos(angle))});
  }
  ObjectModel ball;
  ball.name = "ball";
  ball.sphere = true;
  ball.mesh = make_revolution(profile, 96, 0.005);
  return ball;
}

Tabletop with_balls(Tabletop tabletop) {
  for (PlacedObject& placed : tabletop.objects) {
    if (placed.object.name == "toy") placed.object = ball_for(placed.object);
  }
  return tabletop;
}

/// How scene i is seen: sensors in turn, distances evenly in their logarithm.
SweepOptions sweep_options(const Arguments& arguments, int i) {
  constexpr std::array<SimulatedSensor, 3> sensors = {
      SimulatedSensor::structured_light, SimulatedSensor::stereo, SimulatedSensor::time_of_flight};
  SweepOptions options = arguments.sweeps.options(i);
  options.sensor.model = arguments.sensor.empty()
                             ? to_string(sensors[static_cast<std::size_t>(i) % sensors.size()])
                             : arguments.sensor;
  Random random(arguments.sweeps.seed_of(i));
  const double share = random.uniform();
  options.camera.radius =
      arguments.min_distance * std::pow(arguments.max_distance / arguments.min_distance, share);
  return options;
}

/// A dimension that was fitted.
struct Comparison {
  std::string sensor, kind, name;
  double distance = 0.0;             ///< of the camera [m]
  double truth = 0.0;                ///< [m]
  double error = 0.0;                ///< [m]
  std::optional<double> sigma = {};  ///< none for a lower bound [m]

  bool within(double sigmas) const { return std::abs(error) <= sigmas * *sigma; }
};

/// Classes that were found, by true kind, and all dimensions of those that are right.
struct Tally {
  std::map<std::string, std::map<std::string, int>> classes;
  std::vector<Comparison> dimensions;
};

/// The names of a box's sides do not tell which is which: each fitted one is compared with the true
/// side for which the sum of differences is least.
std::vector<double> matched_truth(const ObjectClass& found, const TrueDimensions& truth) {
  std::vector<double> best, values;
  for (const auto& [name, value] : truth.values) values.push_back(value);
  if (truth.kind != "box") {
    for (const Dimension& dimension : found.dimensions) {
      for (const auto& [name, value] : truth.values) {
        if (name == dimension.name) best.push_back(value);
      }
    }
    return best;
  }
  double least = 1e30;
  std::sort(values.begin(), values.end());
  do {
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Dimension& dimension = found.dimensions[k];
      const double excess = dimension.value - values[k];
      sum += dimension.sigma ? std::abs(excess) : std::max(0.0, excess);
    }
    if (sum >= least) continue;
    least = sum;
    best = values;
  } while (std::next_permutation(values.begin(), values.end()));
  return best;
}

void compare_object(const Arguments& arguments, const SweepOptions& sweep, const ObjectModel& model,
                    const ObjectClass& found, Tally& tally) {
  const TrueDimensions truth = true_dimensions(model);
  const std::string kind = truth.kind.empty() ? model.name : truth.kind;
  const std::string found_kind =
      std::string(to_string(found.kind)) + (found.dimensions.empty() ? "" : " (fitted)");
  ++tally.classes[kind][found_kind];
  if (arguments.list)
    fmt::print("{:16} {:.2f} m {:10} -> {:20} explained {:.2f}\n", sweep.sensor.model,
               sweep.camera.radius, model.name, found_kind, found.explained);
  if (truth.kind != to_string(found.kind) || found.dimensions.empty()) return;
  const std::vector<double> values = matched_truth(found, truth);
  for (std::size_t k = 0; k < found.dimensions.size(); ++k) {
    const Dimension& dimension = found.dimensions[k];
    tally.dimensions.push_back({sweep.sensor.model, truth.kind, dimension.name, sweep.camera.radius,
                                values[k], dimension.value - values[k], dimension.sigma});
    if (!arguments.list) continue;
    fmt::print("    {:8} {:7.1f} mm  error {:+6.2f}  sigma {:5.2f} {}\n", dimension.name,
               1e3 * values[k], 1e3 * (dimension.value - values[k]),
               1e3 * dimension.sigma.value_or(0.0), dimension.reason);
  }
}

void run_scene(const Arguments& arguments, int i, Tally& tally) {
  const SweepOptions sweep = sweep_options(arguments, i);
  const Tabletop tabletop = with_balls(table_of(sweep, {}));
  const SweptScene swept = reconstruct_sweep(tabletop, sweep, {});
  if (swept.scene.cloud.empty() || swept.trajectory.absolute > max_path_error) return;
  const SegmentationResult result = segment_scene(swept.scene);
  const std::vector<PointIndices> masks =
      transfer_masks(swept.scene.cloud, swept.truth, result.cloud);
  const std::vector<std::string> names = mesh_names(tabletop);
  for (std::size_t k = 0; k < masks.size(); ++k) {
    for (const SceneObject& object : result.objects) {
      if (intersection_over_union(masks[k], object.points) <= min_overlap) continue;
      const auto at =
          std::find(names.begin(), names.end(), swept.truth.objects[k].mesh) - names.begin();
      if (object.symmetry_class)
        compare_object(arguments, sweep, tabletop.objects[static_cast<std::size_t>(at)].object,
                       *object.symmetry_class, tally);
    }
  }
}

std::string summary_row(const std::string& name, const std::vector<Comparison>& compared) {
  std::vector<double> errors, sigmas;
  double sum = 0.0;
  int within_one = 0, within_two = 0, bounds = 0, false_bounds = 0;
  for (const Comparison& dimension : compared) {
    if (!dimension.sigma) {
      ++bounds;
      false_bounds += dimension.error > 0.01 * dimension.truth + 0.005 ? 1 : 0;
      continue;
    }
    errors.push_back(std::abs(dimension.error));
    sigmas.push_back(*dimension.sigma);
    sum += dimension.error;
    within_one += dimension.within(1.0) ? 1 : 0;
    within_two += dimension.within(2.0) ? 1 : 0;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, errors.size()));
  return fmt::format(
      "{:26} {:4} | {:5.2f} | {:+5.2f} | {:5.2f} | {:5.2f} | {:3.0f} % | {:3.0f} % | {:3} ({})\n",
      name, errors.size(), 1e3 * median(errors).value_or(0.0), 1e3 * sum / count,
      1e3 * quantile(errors, 0.9).value_or(0.0), 1e3 * median(sigmas).value_or(0.0),
      100.0 * within_one / count, 100.0 * within_two / count, bounds, false_bounds);
}

void print_tables(const Tally& tally) {
  for (const auto& [kind, found] : tally.classes) {
    fmt::print("{:10}", kind);
    for (const auto& [name, count] : found) fmt::print("  {} {}", count, name);
    fmt::print("\n");
  }
  std::map<std::string, std::vector<Comparison>> groups;
  for (const Comparison& dimension : tally.dimensions) {
    groups["kind: " + dimension.kind + " " + dimension.name].push_back(dimension);
    groups["sensor: " + dimension.sensor].push_back(dimension);
    const char* range = dimension.distance < 0.8    ? "0.5"
                        : dimension.distance < 1.25 ? "0.8"
                                                    : "1.25";
    groups[fmt::format("distance: from {} m", range)].push_back(dimension);
  }
  fmt::print("\nmm; errors of fitted dimensions\n{:26} {:>4} | {} | {} | {} | {} | {} | {} | {}\n",
             "", "n", "median |e|", "mean e", "90 % |e|", "median s", "in 1 s", "in 2 s",
             "bounds (false)");
  for (const auto& [name, group] : groups) fmt::print("{}", summary_row(name, group));
  fmt::print("{}", summary_row("all", tally.dimensions));
}

void run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.sweeps.threads);
  Tally tally;
  for (int i = 0; i < arguments.sweeps.sweeps; ++i) {
    run_scene(arguments, i, tally);
    std::fflush(stdout);
  }
  print_tables(tally);
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{
      "Fitted dimensions of boxes, cylinders and balls of simulated scenes against the true ones."};
  arguments.sweeps.add_to(app);
  app.add_option("--min-distance", arguments.min_distance, "least distance of the camera [m]");
  app.add_option("--max-distance", arguments.max_distance, "greatest distance of the camera [m]");
  app.add_option("--sensor", arguments.sensor,
                 "structured-light, stereo or tof; all in turn without");
  app.add_flag("--list", arguments.list, "print a line per object and dimension");
  CLI11_PARSE(app, argc, argv);
  arguments.sweeps.complete();
  return symscene::bench::exit_code_of("symscene_bench_dimensions", [&] {
    symscene::bench::run(arguments);
    return 0;
  });
}
