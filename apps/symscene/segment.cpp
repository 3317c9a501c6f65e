#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "io/atomic_file.hpp"
#include "results.hpp"
#include "score_models.hpp"
#include "surroundings.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {
namespace {

struct Segment {
  SharedOptions shared;
  PipelineOptions options;
  std::filesystem::path scene;
  std::filesystem::path page;
  std::optional<int> repeat;

  OptionFields configure() {
    return configure_options(options, shared.config, [&] { read_score_models(options.models); });
  }

  void check_outputs() const {
    require_not_input(shared.output, scene);
    if (page.empty()) return;
    require_not_input(page, scene);
    require_not_input(page, shared.output);
  }

  /// The result. With --repeat its times are the medians over that many further runs.
  SegmentationResult segment(const Scene& input, Session& session) const {
    SegmentationResult result = segment_scene(input, options, session.on_begin());
    std::vector<std::vector<StageTime>> runs;
    for (int run = 1; run <= repeat.value_or(0); ++run)
      runs.push_back(segment_scene(input, options, session.on_begin()).timings);
    if (!runs.empty()) result.timings = median_times(runs);
    return result;
  }

  void write_outputs(const SegmentationResult& result, Surroundings around) const {
    ResultExtras extras;
    if (around.surface.triangles.rows() != 0) extras.surface = &around.surface;
    if (!around.trajectory.empty()) extras.trajectory = &around.trajectory;
    write_result(absolute(shared.output), result, extras);
    if (page.empty()) return;
    PageOptions page_options;
    page_options.title = folder_name(scene);
    page_options.table = result.table;
    page_options.surface = std::move(around.surface);
    page_options.trajectory = std::move(around.trajectory);
    write_file_atomically(page, render_page(result, page_options));
  }

  void run() {
    configure();
    check_outputs();
    Session session("segment", shared);
    session.on_begin()("read");
    const Scene input = read_scene(scene);
    // Those of the reader first: they explain why segmentation may fail. The result repeats them.
    session.warn(input.warnings);
    const SegmentationResult result = naming(scene, [&] { return segment(input, session); });
    session.warn(std::span(result.warnings).subspan(input.warnings.size()));
    session.on_begin()("write");
    write_outputs(result, scene_surroundings(scene, result, session));
    session.print_line(format_objects(result));
    session.finish({{"output", shared.output},
                    {"objects", result.objects.size()},
                    {"points", result.cloud.size()}},
                   result.timings);
  }
};

}  // namespace

void add_segment(CommandLine& line) {
  const auto state = std::make_shared<Segment>();
  Arguments arguments(line, "segment", "Find the objects of a scene and their symmetries",
                      "symscene segment scene -o result --page page.html");
  arguments.input(state->scene, "SCENE", "scene folder");
  arguments.required_output(state->shared, "result folder to write");
  arguments.file("--page", state->page, "also write a page that shows the result");
  arguments.count("--repeat", state->repeat,
                  "run N more times and report the median time of each stage");
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
