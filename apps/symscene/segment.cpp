#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "common.hpp"
#include "results.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/io/result.hpp"
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
  int repeat = 0;

  OptionFields configure() {
    OptionFields fields = option_fields(options);
    if (!shared.config.empty()) read_config(shared.config, fields);
    options.validate();
    return fields;
  }

  void check_outputs() const {
    require_not_input(shared.output, scene);
    if (page.empty()) return;
    require_not_input(page, scene);
    require_not_input(page, shared.output);
  }

  /// The result, with the median times of `repeat` runs after a first one if that is asked for.
  SegmentationResult segment(const Scene& input, Session& session) const {
    SegmentationResult result = segment_scene(input, options, session.on_begin());
    std::vector<std::vector<StageTime>> runs;
    for (int run = 1; run <= repeat; ++run)
      runs.push_back(segment_scene(input, options, session.on_begin()).timings);
    if (!runs.empty()) result.timings = median_times(runs);
    return result;
  }

  PageOptions page_options(const SegmentationResult& result) const {
    PageOptions page_options;
    page_options.title = folder_name(scene);
    page_options.table = result.table;
    return page_options;
  }

  void run() {
    configure();
    check_outputs();
    Session session("segment", shared);
    session.on_begin()("read");
    const Scene input = read_scene(scene);
    const SegmentationResult result = segment(input, session);
    write_result(absolute(shared.output), result);
    if (!page.empty()) write_file_atomically(page, render_page(result, page_options(result)));
    session.say(format_objects(result));
    session.finish({{"output", shared.output.string()},
                    {"objects", result.objects.size()},
                    {"points", result.cloud.size()}},
                   result.timings);
  }
};

}  // namespace

void add_segment(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("segment", "Find the objects of a scene and their symmetries");
  const auto state = std::make_shared<Segment>();
  add_input(command, state->scene, "SCENE", "scene folder");
  add_output(command, state->shared, "result folder to write")->required();
  command.add_option("--page", state->page, "also write the page that shows the result")
      ->type_name("FILE");
  command
      .add_option("--repeat", state->repeat,
                  "run this many times more and report the median time of every stage")
      ->type_name("N")
      ->check(CLI::Range(1, 10000).description(""));
  add_threads(command, state->shared);
  add_reporting(command, state->shared);
  add_config(command, state->shared, [state] { return state->configure(); });
  set_example(command, "symscene segment scene -o result --page page.html");
  command.callback([state] { state->run(); });
}

}  // namespace symscene::app
