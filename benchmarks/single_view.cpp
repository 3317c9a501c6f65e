// Time of a single view by stages, from the depth image in memory to the objects.
#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/median.hpp"
#include "program.hpp"
#include "stopwatch.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/simulation/simulation.hpp"
#include "symscene/tabletop/view_scene.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::string view;  ///< a sequence of one frame; a simulated view without it
  std::uint64_t seed = 2000;
  int objects = 10;
  double distance = 0.9;
  int repeat = 10;
  std::size_t threads = 2;
};

/// A depth image with its camera.
struct View {
  DepthFrame frame;
  CameraIntrinsics camera;
};

View simulated_view(const Arguments& arguments) {
  SimulationOptions options;
  options.tabletop.seed = arguments.seed;
  options.tabletop.objects = arguments.objects;
  options.camera.frames = 1;
  options.camera.radius = arguments.distance;
  const Tabletop tabletop = arrange_tabletop(options.tabletop);
  std::vector<SensorFrame> frames = capture_frames(tabletop, options);
  return {{0.0, std::move(frames.front().depth), {}}, options.camera.intrinsics()};
}

View read_view(const std::string& path) {
  const auto sequence = open_sequence(path);
  return {sequence->read(0), sequence->camera()};
}

/// The times of each stage over the runs, stages in the order in which they first ran.
class StageRuns {
 public:
  void begin(const std::string& stage) {
    end();
    stage_ = stage;
    start_ = now();
  }
  void end() {
    if (!stage_) return;
    const Seconds stop = now();
    if (runs_.count(*stage_) == 0) order_.push_back(*stage_);
    runs_[*stage_].push_back(stop - start_);
    stage_.reset();
  }
  void print() const {
    fmt::print("{:<32}{:>10}{:>14}\n", "stage, median", "wall [ms]", "processor [ms]");
    Seconds total;
    for (const std::string& stage : order_) {
      const Seconds median = median_of(runs_.at(stage));
      total = total + median;
      print_row(stage, median);
    }
    print_row("sum", total);
  }

 private:
  static Seconds now() {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
    return {wall.count(), processor_seconds()};
  }
  static Seconds median_of(const std::vector<Seconds>& runs) {
    std::vector<double> wall, processor;
    for (const Seconds& run : runs) {
      wall.push_back(run.wall);
      processor.push_back(run.processor);
    }
    return {quantile(wall, 0.5).value_or(0.0), quantile(processor, 0.5).value_or(0.0)};
  }
  static void print_row(const std::string& stage, const Seconds& time) {
    fmt::print("{:<32}{:>10.1f}{:>14.1f}\n", stage, 1e3 * time.wall, 1e3 * time.processor);
  }

  std::optional<std::string> stage_;
  Seconds start_;
  std::vector<std::string> order_;
  std::map<std::string, std::vector<Seconds>> runs_;
};

/// Segments the view once; returns the number of objects.
std::size_t segment(const View& view, StageRuns& runs) {
  runs.begin("view to scene");
  const ViewScene scene = view_scene({view.frame, view.camera});
  const SegmentationResult result =
      segment_scene(scene.built.scene, {}, [&](const std::string& stage) { runs.begin(stage); });
  runs.end();
  return result.objects.size();
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Time of a single view by stages, from the depth image in memory to the objects");
  app.add_option("view", arguments.view, "depth sequence of one frame (default: a simulated view)");
  app.add_option("--seed", arguments.seed, "seed of the simulated table")->capture_default_str();
  app.add_option("--objects", arguments.objects, "objects on it")->capture_default_str();
  app.add_option("--distance", arguments.distance, "of the camera [m]")->capture_default_str();
  app.add_option("--repeat", arguments.repeat, "runs that are timed, after one that is not")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--threads", arguments.threads, "at most so many threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_view", [&] {
    const View view =
        arguments.view.empty() ? simulated_view(arguments) : read_view(arguments.view);
    const ThreadLimit limit(arguments.threads);
    StageRuns first, runs;
    const std::size_t objects = segment(view, first);
    for (int run = 0; run < arguments.repeat; ++run) segment(view, runs);
    fmt::print("{} x {}, {} objects found, {} threads, {} runs\n", view.camera.width,
               view.camera.height, objects, arguments.threads, arguments.repeat);
    runs.print();
    return 0;
  });
}
