// Tables of scanned objects that are cleared by grasps from tracked sweeps of a depth camera.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/atomic_file.hpp"
#include "program.hpp"
#include "symscene/clutter/graspability.hpp"
#include "symscene/clutter/table_clearing_report.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/physics/physics_world.hpp"
#include "symscene/simulation/scanned_models.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::filesystem::path meshes;
  std::string method = "symscene";
  std::filesystem::path attempts;
  std::filesystem::path first_looks;
  int tables = 30;
  int first = 0;
  std::size_t threads = 2;
  bool verbose = false;
  TableClearingOptions options;
};

void declare_tables(CLI::App& app, Arguments& a) {
  app.add_option("--objects", a.meshes, "folder of meshes in metres (.ply, .obj)")->required();
  app.add_option("--tables", a.tables, "tables")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--first", a.first, "number of the first table")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", a.options.seed, "seed of all tables")->capture_default_str();
  app.add_option("--min-objects", a.options.min_objects, "fewest objects on a table")
      ->capture_default_str();
  app.add_option("--max-objects", a.options.max_objects, "most objects on a table")
      ->capture_default_str();
  app.add_option("--spread", a.options.sweep.drop.spread,
                 "radius of the disc over which objects are dropped [m]")
      ->capture_default_str();
  app.add_option_function<double>(
         "--table-edge",
         [&table = a.options.sweep.tabletop.table](double edge) {
           table.length = table.width = edge;
         },
         "edge of the square table [m]")
      ->default_str("1.2");
  app.add_option("--min-thickness", a.options.sweep.drop.min_thickness,
                 "least extent of the thinnest mesh that is used [m]")
      ->capture_default_str();
  app.add_option("--density", a.options.sweep.drop.physics.density,
                 "density of objects, whose mass is this times the volume of the mesh [kg/m3]")
      ->capture_default_str();
}

void declare_looks(CLI::App& app, Arguments& a) {
  CameraArcOptions& camera = a.options.sweep.camera;
  app.add_option("--method", a.method, "symscene or cylinders")->capture_default_str();
  app.add_option("--looks", a.options.max_looks,
                 "at most so many looks at a table, which then counts for the first looks only; 0 "
                 "for no bound")
      ->capture_default_str();
  app.add_flag("--try-each", a.options.try_each_object,
               "try and undo the best grasp of each object of the first look");
  app.add_option("--frames", camera.frames, "frames of a sweep")->capture_default_str();
  app.add_option("--rate", a.options.sweep.frame_rate, "frames per second; of the hand's shake")
      ->capture_default_str();
  app.add_option("--distance", camera.radius, "distance of the camera from the table's middle [m]")
      ->capture_default_str();
  app.add_option_function<double>(
         "--arc", [&camera](double degrees) { camera.arc = radians(degrees); },
         "horizontal angle of the sweep [degrees]")
      ->default_str("60");
  app.add_option("--sensor", a.options.sweep.sensor.model, "structured-light, stereo or tof")
      ->capture_default_str();
  app.add_flag("--exact-poses", a.options.look.exact_poses,
               "take the poses of the frames from the simulation instead of tracking");
  app.add_flag("!--exact", a.options.sweep.sensor.enabled, "depth images without noise");
}

void declare_output(CLI::App& app, Arguments& a) {
  app.add_option("--attempts", a.attempts, "CSV file to write: one line per look");
  app.add_option("--first-looks", a.first_looks,
                 "CSV file to write: one line per object, what the first look found of it");
  app.add_option("--threads", a.threads, "at most so many threads")->capture_default_str();
  app.add_flag("-v,--verbose", a.verbose, "one line per look and per table");
}

void print_look(int table, const TableAttempt& a) {
  fmt::print("table {:3} look {:2}: {} of {} objects, {} of {} frames, {:.1f} mm off, {:.1f} s",
             table, a.number, a.found, a.present, a.fused, a.frames, 1e3 * a.drift,
             a.reconstruction_seconds + a.segmentation_seconds + a.grasping_seconds);
  if (a.tried)
    fmt::print("; {}, {} of quality {:.2f}: {}{}", a.aimed, to_string(a.grasp.source),
               a.grasp.quality, to_string(a.outcome.end),
               a.removed_other ? " (another object)" : "");
  fmt::print("\n");
  std::fflush(stdout);
}

void print_table(const TableClearing& table) {
  fmt::print("  {}, {} of {} removed, {} fallen; left: {}\n",
             table.stopped ? "stopped" : to_string(table.end), table.removed, table.placed,
             table.fallen, fmt::join(table.left, ", "));
  for (const FirstLookObject& object : table.first_look) {
    if (object.end && *object.end != GraspEnd::success)
      fmt::print("    {}: {}\n", object.name, to_string(*object.end));
    if (object.grasps == 0)
      fmt::print("    {}{}: {}\n", object.name, object.graspable ? "" : " (cannot be held)",
                 object.reason);
  }
  std::fflush(stdout);
}

/// Which of the meshes that are thick enough the hand could hold nowhere.
void print_models(const std::vector<ObjectModel>& models, const TableClearingOptions& options) {
  // Far below, so that it takes no room from the hand.
  const Plane table{Eigen::Vector3d::UnitZ(), 1e3};
  Gripper gripper = panda_hand();
  gripper.friction = options.physics.finger_friction;
  std::vector<std::string> impossible;
  std::size_t used = 0;
  for (const ObjectModel& model : models) {
    const Eigen::Vector3f extent = bounding_box(model.mesh.vertices).extent();
    if (static_cast<double>(extent.minCoeff()) < options.sweep.drop.min_thickness) continue;
    ++used;
    if (!graspability(model.mesh, table, gripper).at_all) impossible.push_back(model.name);
  }
  fmt::print(
      "{} of {} meshes are at least {:.0f} mm thick; {} of these have no place that the hand "
      "could hold: {}\n",
      used, models.size(), 1e3 * options.sweep.drop.min_thickness, impossible.size(),
      fmt::join(impossible, ", "));
}

/// Files are written after every table, so that a run that is stopped leaves what it has.
void write_tables(const Arguments& arguments, const std::vector<TableClearing>& tables) {
  if (!arguments.attempts.empty())
    write_file_atomically(arguments.attempts, format_looks_csv(tables));
  if (!arguments.first_looks.empty())
    write_file_atomically(arguments.first_looks, format_first_looks_csv(tables));
}

int run(const Arguments& arguments) {
  if (!has_physics()) {
    fmt::print(stderr, "this build has no physics: libmujoco-dev would add it\n");
    return 1;
  }
  const ThreadLimit limit(arguments.threads);
  const TableClearingOptions& options = arguments.options;
  const std::vector<ObjectModel> models = read_models(arguments.meshes, {}).models;
  fmt::print("{} tables of {} to {} objects, {} frames, method {}, seed {}\n", arguments.tables,
             options.min_objects, options.max_objects, options.sweep.camera.frames,
             to_string(options.method), options.seed);
  print_models(models, options);
  std::vector<TableClearing> tables;
  for (int k = arguments.first; k < arguments.first + arguments.tables; ++k) {
    tables.push_back(clear_table(models, options, k, [&](const TableAttempt& attempt) {
      if (arguments.verbose) print_look(k, attempt);
    }));
    if (arguments.verbose) print_table(tables.back());
    write_tables(arguments, tables);
  }
  fmt::print("{}", format_table_report(tables));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Tables of scanned objects that are cleared by grasps from tracked sweeps");
  declare_tables(app, arguments);
  declare_looks(app, arguments);
  declare_output(app, arguments);
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_tabletops", [&] {
    arguments.options.method = parse_grasp_method(arguments.method);
    return run(arguments);
  });
}
