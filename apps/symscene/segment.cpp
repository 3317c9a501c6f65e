#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "core/naming.hpp"
#include "ground_truth.hpp"
#include "made_by.hpp"
#include "mask_images.hpp"
#include "result_page.hpp"
#include "results.hpp"
#include "segment_input.hpp"
#include "symscene/io/result.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "workflow/score_models.hpp"

namespace symscene::app {
namespace {

struct Segment {
  SharedOptions shared;
  SegmentOptions options;
  SegmentSource source;
  std::filesystem::path page;
  std::filesystem::path masks;
  std::optional<int> repeat;
  std::string reflectional;

  /// --reflectional, if it is given.
  void choose_planes() {
    if (reflectional.empty()) return;
    options.pipeline.planes_of_surfaces = reflectional != "curve";
    options.pipeline.planes_of_curves = reflectional != "surface";
  }

  OptionFields configure() {
    return configure_options(options, shared.config, [&] {
      read_score_models(options.pipeline.models);
      choose_planes();
    });
  }

  /// The result. With --repeat its times are the medians over that many further runs.
  SegmentationResult segment(const Scene& input, Session& session) const {
    SegmentationResult result = segment_scene(input, options.pipeline, session.on_begin());
    std::vector<std::vector<StageTime>> runs;
    for (int run = 1; run <= repeat.value_or(0); ++run)
      runs.push_back(segment_scene(input, options.pipeline, session.on_begin()).timings);
    if (!runs.empty()) result.timings = median_times(runs);
    return result;
  }

  /// Options as they were given, those of flags too.
  std::string described(const OptionFields& fields, Session& session) const {
    SegmentOptions defaults;
    return made_by("segment", source.path, changed_options(fields, option_fields(defaults)),
                   session);
  }

  /// The result does not depend on the ground truth: if it cannot be read, the page is without it.
  std::vector<PageTruth> truth_to_show(const PointCloud& cloud, Session& session) const {
    try {
      return page_truth(source.path, cloud);
    } catch (const InputError& error) {
      session.warn(std::string(error.what()) + "; the page shows no ground truth");
      return {};
    }
  }

  void write_outputs(const SegmentationResult& result, Surroundings around, std::string description,
                     Session& session) const {
    ResultExtras extras;
    extras.made_by = std::move(description);
    if (around.surface.triangles.rows() != 0) extras.surface = &around.surface;
    if (!around.trajectory.empty()) extras.trajectory = &around.trajectory;
    write_result(absolute(shared.output), result, extras);
    if (page.empty()) return;
    PageExtras shown;
    shown.truth = truth_to_show(result.cloud, session);
    write_result_page(page, source.path, result, std::move(around), std::move(shown));
  }

  void require_frame() const {
    if (masks.empty() || !source.is_cloud()) return;
    throw InputError(source.path.string(),
                     "a depth image, as --masks needs (symscene masks labels sequences)",
                     "a scene or a cloud");
  }

  void write_masks(const SegmentInput& input, const SegmentationResult& result) const {
    if (masks.empty()) return;
    LabelImageOptions mask_options = options.masks;
    mask_options.noise = input.sensor.noise.value_or(mask_options.noise);
    MaskImageWriter writer(absolute(masks), result, mask_options);
    writer.add(0, input.camera, *input.frame, Eigen::Isometry3d::Identity());
    writer.finish();
  }

  SegmentationResult objects_of(const Scene& scene, Session& session) const {
    if (scene.cloud.empty()) return nothing_found(scene);
    return naming(source.path, [&] { return segment(scene, session); });
  }

  void run() {
    const OptionFields fields = configure();
    source.table.table();  // before the work
    require_apart({shared.output, page, masks}, {source.path});
    require_frame();
    Session session("segment", shared);
    session.on_begin()("read");
    SegmentInput input = source.read(options, session);
    SegmentationResult result = objects_of(input.scene, session);
    session.warn(std::span(result.warnings).subspan(input.scene.warnings.size()));
    result.timings.insert(result.timings.begin(), input.stages.begin(), input.stages.end());
    session.on_begin()("write");
    write_outputs(
        result,
        {surface_around(input.surface, result, source.path, session), std::move(input.trajectory)},
        described(fields, session), session);
    write_masks(input, result);
    session.print_line(format_objects(result));
    std::vector<ReportMember> members{{"output", shared.output},
                                      {"objects", result.objects.size()},
                                      {"points", result.cloud.size()}};
    if (!input.sensor.json.empty())
      members.push_back(ReportMember::raw("sensor", input.sensor.json));
    session.finish(members, result.timings);
  }
};

}  // namespace

void add_segment(CommandLine& line) {
  const auto state = std::make_shared<Segment>();
  Arguments arguments(line, "segment", "Find the objects of a scene and their symmetries",
                      "symscene segment scene -o result --page page.html\n"
                      "  symscene segment depth.png --intrinsics 525,525,319.5,239.5 -o result\n"
                      "  symscene segment cloud.pcd -o result");
  arguments.input(state->source.path, "INPUT",
                  "scene folder, depth image, folder with one frame, or cloud (.ply, .pcd)");
  arguments.output_folder(state->shared, "result folder to write");
  arguments.file("--page", state->page, "also write a page that shows the result");
  arguments.folder("--masks", state->masks,
                   "also write the label image of a depth image, and an overlay");
  arguments.count("--repeat", state->repeat, between(1, 10000),
                  "run this many more times and report the median time of each stage");
  arguments.choice(
      "--reflectional", state->reflectional, {"curve", "surface", "both"},
      "what proposes reflection planes: pairs of edge curves, smooth segments, or both "
      "(default)");
  state->source.add_to(arguments);
  arguments.run_stages(state);
}

}  // namespace symscene::app
