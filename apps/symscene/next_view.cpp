#include <memory>
#include <utility>

#include "commands.hpp"
#include "core/naming.hpp"
#include "io/atomic_file.hpp"
#include "next_view_output.hpp"
#include "object_input.hpp"
#include "result_page.hpp"
#include "session.hpp"
#include "symscene/view_planning/next_view.hpp"
#include "view_candidate_choice.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// The options of `symscene next-view`.
struct NextViewCommandOptions {
  double radius = 0.0;
  NextViewOptions choice;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("radius", self.radius, "m", between(0.0, 100.0),
          "of the half sphere of candidates about the middle of the objects; 0: so large that the "
          "objects fill the image");
    visit("choice", self.choice);
  }
  void validate() const { check_fields(*this); }
};

struct NextViewCommand {
  SharedOptions shared;
  NextViewCommandOptions options;
  ObjectInput input{.use = viewing_use};
  ViewCandidateChoice candidates;
  std::string policy = to_string(ViewPolicy::symmetry);
  fs::path page;

  OptionFields configure() { return configure_options(options, shared.config); }

  /// The folder that may hold the camera of the input.
  fs::path scene_folder() const { return input.scene.empty() ? input.source.path : input.scene; }

  static std::string best_of(const NextViews& views) {
    return views.ranked.empty() ? "null" : std::to_string(views.ranked.front().candidate);
  }

  void run() {
    configure();
    require_apart({shared.output, page}, input.paths());
    require_apart({shared.output, page}, candidates.files());
    const ViewPolicy by = view_policy(policy);
    input.with_page = !page.empty();
    Session session("next-view", shared);
    StageTimer timer(session.on_begin());
    SegmentedInput read = input.read(timer, session);
    const CameraIntrinsics camera = candidates.camera(scene_folder(), read.camera);
    const std::vector<Eigen::Isometry3d> poses =
        candidates.poses(read.result, camera, {options.radius, options.choice.min_depth});
    const std::vector<double> costs = candidates.read_costs(poses.size());
    if (!costs.empty() && options.choice.cost_weight == 0.0)
      session.warn(
          "the option choice.cost_weight is 0, so that costs count only where they are inf");
    const bool knows_space = read.scene && read.scene->occupancy;
    const NextViews views = naming(input.source.path, [&] {
      return rank_views({read.result, knows_space ? &*read.scene->occupancy : nullptr}, camera,
                        poses, options.choice, by, costs);
    });
    for (const StageTime& stage : views.timings) timer.add(stage.stage, stage.seconds);
    const RankedCandidates ranked{camera, poses, views, by};
    timer.time("write", [&] {
      write_file_atomically(shared.output, format_next_views_json(ranked));
      if (!page.empty()) {
        write_result_page(page, input.source.path, read.result, std::move(read.around),
                          {.views = page_views(ranked), .subject = "next views"});
      }
    });
    session.print_line(format_next_views(ranked));
    session.finish({{"output", shared.output},
                    {"candidates", poses.size()},
                    {"ranked", views.ranked.size()},
                    ReportMember::raw("best", best_of(views)),
                    ReportMember::raw("is_enough", views.is_enough ? "true" : "false")},
                   timer.stages());
  }
};

}  // namespace

void add_next_view(CommandLine& line) {
  const auto state = std::make_shared<NextViewCommand>();
  Arguments arguments(
      line, "next-view", "Rank the views from which a camera would see most of what is not known",
      "symscene next-view scene -o views.json --page views.html\n"
      "  symscene next-view result --scene scene --candidates poses.txt --costs times.txt -o "
      "views.json");
  arguments.input(state->input.source.path, "INPUT",
                  "scene folder, depth image, folder with one frame, or cloud, which is segmented "
                  "first; or result folder");
  arguments.output_file(state->shared, "JSON file to write", {".json"});
  state->candidates.add_to(arguments);
  arguments.choice("--policy", state->policy,
                   {to_string(ViewPolicy::symmetry), to_string(ViewPolicy::unknown_voxels),
                    to_string(ViewPolicy::rear_side_voxels)},
                   "by what views are ranked: surface that symmetries infer and leave open, or "
                   "voxels that were never seen (default: symmetry)");
  arguments.file("--page", state->page, "also write a page that shows the views");
  state->input.add_to(arguments, "scene folder of a result: which space was seen to be free");
  arguments.run_stages(state);
}

}  // namespace symscene::app
