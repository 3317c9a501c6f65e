// Tables that a robot clears in physics: looks, picks and places, until nothing is left to take.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "program.hpp"
#include "symscene/clutter/round_share.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/io/robot.hpp"
#include "symscene/physics/physics_world.hpp"
#include "symscene/picking/simulated_picks.hpp"
#include "symscene/simulation/scanned_models.hpp"
#include "symscene/viewer/run_page.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::string robot = "panda";
  std::string objects = "household";
  std::string method = "symscene";
  int tables = 10;
  int first = 0;
  int min_objects = 1;
  int max_objects = 10;
  std::uint64_t seed = 1;
  std::size_t threads = 2;
  bool verbose = false;
  std::string pages;
  PickTableOptions table;
  SimulatedPickOptions options;
};

/// Sums over the tables.
struct Tally {
  int tables = 0, cleared = 0;
  std::vector<ShareCounts> attempts, graspable, in_some_pose, all;
  std::map<std::string, int> outcomes, ends, reasons;
  std::map<std::string, std::vector<double>> stages;  ///< wall times to the first in the bin [s]
  std::vector<double> to_first;                       ///< their sums [s]

  void add(const PickRun& run) {
    ++tables;
    cleared += run.all.in_bin == run.all.placed ? 1 : 0;
    ++ends[to_string(run.end)];
    std::size_t successes = 0;
    for (const PickAttempt& attempt : run.attempts) {
      ++outcomes[to_string(attempt.end)];
      successes += attempt.end == AttemptEnd::in_bin ? 1 : 0;
    }
    attempts.push_back({successes, run.attempts.size()});
    graspable.push_back({run.graspable.in_bin, run.graspable.placed});
    in_some_pose.push_back({run.graspable_in_some_pose.in_bin, run.graspable_in_some_pose.placed});
    all.push_back({run.all.in_bin, run.all.placed});
    for (const LeftObject& left : run.left) {
      if (left.graspable.as_it_lies) ++reasons[left.reason.substr(0, left.reason.find(" ("))];
    }
    add_times(run.to_first);
  }

  void print() const {
    print_share("attempts that put an object into the bin", attempts);
    print_share("objects in the bin, of those graspable as they lie", graspable);
    print_share("objects in the bin, of those graspable in some pose", in_some_pose);
    print_share("objects in the bin, of all", all);
    fmt::print("{} of {} tables cleared\n", cleared, tables);
    print_counts("attempts by outcome", outcomes);
    print_counts("tables by end", ends);
    print_counts("graspable objects that are left", reasons);
    fmt::print(
        "wall times to the first object in the bin, without physics and rendering, median "
        "and 90 % [s]\n");
    for (const auto& [stage, times] : stages) print_times(stage, times);
    print_times("sum", to_first);
  }

 private:
  void add_times(const std::vector<StageTime>& times) {
    double sum = 0.0;
    for (const StageTime& time : times) {
      stages[time.stage].push_back(time.seconds);
      sum += time.seconds;
    }
    if (!times.empty()) to_first.push_back(sum);
  }

  static void print_share(const char* what, const std::vector<ShareCounts>& counts) {
    fmt::print("{}: {}\n", what, share_with_interval(counts).text());
  }
  static void print_counts(const char* what, const std::map<std::string, int>& counts) {
    fmt::print("{}\n", what);
    for (const auto& [name, count] : counts) fmt::print("  {:>4}  {}\n", count, name);
  }
  static void print_times(const std::string& name, const std::vector<double>& times) {
    if (times.empty()) return;
    fmt::print("  {:<24}{:>8.2f}{:>8.2f}\n", name, quantile_of(times, 0.5),
               quantile_of(times, 0.9));
  }
};

const char* shortcoming(const Graspability& graspable) {
  if (graspable.as_it_lies) return "";
  return graspable.at_all ? " (cannot be held as it lay)" : " (cannot be held)";
}

void print_run(int number, const PickRun& run) {
  fmt::print("table {}: {} of {} objects in the bin ({} of {} graspable), {} attempts, {}\n",
             number, run.all.in_bin, run.all.placed, run.graspable.in_bin, run.graspable.placed,
             run.attempts.size(), description(run.end));
  for (const LeftObject& left : run.left)
    fmt::print("  {}{}: {}\n", left.name, shortcoming(left.graspable), left.reason);
  std::fflush(stdout);
}

void write_page(int number, const PickRun& run, const std::string& folder) {
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  write_run_page(std::filesystem::path(folder) / fmt::format("table_{}.html", number),
                 run.recording, fmt::format("Table {}", number));
}

PickObserver observer_of(const Arguments& arguments) {
  if (!arguments.verbose) return {};
  return {{}, [](const RecordedEvent& event) {
            fmt::print("  {:7.2f} s  {}\n", event.time, event.text);
            std::fflush(stdout);
          }};
}

int run(Arguments& arguments) {
  if (!has_physics()) {
    fmt::print(stderr, "this build has no physics: libmujoco-dev would add it\n");
    return 1;
  }
  const ThreadLimit limit(arguments.threads);
  const Robot robot = read_robot(arguments.robot);
  const Gripper gripper = named_gripper(*robot.grasping_arm().gripper);
  std::vector<ObjectModel> models;
  if (arguments.objects != "household") models = read_models(arguments.objects, {}).models;
  Tally tally;
  for (int k = arguments.first; k < arguments.first + arguments.tables; ++k) {
    const int counts = arguments.max_objects - arguments.min_objects + 1;
    arguments.table.tabletop.objects = arguments.min_objects + k % counts;
    arguments.table.tabletop.seed = arguments.options.seed =
        arguments.seed + static_cast<std::uint64_t>(k);
    const PickTable table = furnish_pick_table(models, arguments.table);
    const PickRun run =
        simulate_picks(table, robot, gripper, arguments.options, observer_of(arguments));
    print_run(k, run);
    write_page(k, run, arguments.pages);
    tally.add(run);
  }
  tally.print();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Tables that a robot clears in physics");
  app.add_option("--robot", arguments.robot,
                 "panda, baxter or a YAML file that names a built-in gripper")
      ->capture_default_str();
  app.add_option("--objects", arguments.objects, "folder of meshes in metres, or household")
      ->capture_default_str();
  app.add_option("--method", arguments.method, "symscene or cylinders")->capture_default_str();
  app.add_option("--tables", arguments.tables, "tables")->check(CLI::PositiveNumber);
  app.add_option("--first", arguments.first, "number of the first table")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--min-objects", arguments.min_objects, "fewest objects on a table")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  app.add_option("--max-objects", arguments.max_objects, "most objects on a table")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  app.add_option("--frames", arguments.options.look.frames, "images of a look")
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "of table 0")->capture_default_str();
  app.add_option("--threads", arguments.threads, "at most so many threads")->capture_default_str();
  app.add_option("--pages", arguments.pages, "folder for pages that play the runs");
  app.add_flag("-v,--verbose", arguments.verbose, "what happens, as it happens");
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_picks", [&] {
    arguments.max_objects = std::max(arguments.max_objects, arguments.min_objects);
    arguments.options.method = parse_grasp_method(arguments.method);
    return run(arguments);
  });
}
