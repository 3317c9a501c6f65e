#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "core/naming.hpp"
#include "counted.hpp"
#include "ground_truth.hpp"
#include "io/atomic_file.hpp"
#include "page_sweep.hpp"
#include "result_page.hpp"
#include "sequence_only.hpp"
#include "session.hpp"
#include "symscene/io/result.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {
namespace {

struct View {
  SharedOptions shared;
  std::string title;
  std::filesystem::path result;
  std::filesystem::path scene;
  std::filesystem::path frames;
  SequenceOptions source;

  std::vector<PageFrame> sweep(const Trajectory& trajectory, Session& session) const {
    if (frames.empty()) {
      require_no_camera(source, "--sequence, whose camera it tells");
      return {};
    }
    const auto sequence = open_sequence(frames, source);
    session.warn(sequence->warnings());
    return page_sweep(*sequence, trajectory, frames);
  }

  std::vector<PageTruth> truth(const PointCloud& cloud, Session& session) const {
    if (scene.empty()) return {};
    std::vector<PageTruth> known = page_truth(scene, cloud);
    if (known.empty())
      session.warn(scene.string() +
                   ": no scene with a truth.json that this build reads; it is left out");
    return known;
  }

  PageOptions page_options(const SegmentationResult& input, Session& session) const {
    Surroundings around = read_result_surroundings(result);
    std::vector<PageFrame> played = sweep(around.trajectory, session);
    PageOptions options =
        result_page(input, title.empty() ? folder_name(result) : title, std::move(around));
    options.sweep = std::move(played);
    options.truth = truth(input.cloud, session);
    return options;
  }

  void run() const {
    require_apart({shared.output}, {result, scene, frames});
    Session session("view", shared);
    StageTimer timer(session.on_begin());
    const SegmentationResult input = timer.time("read", [&] { return read_result(result); });
    const std::string page = timer.time("render", [&] {
      const PageOptions options = page_options(input, session);
      return naming(result, [&] { return render_page(input, options); });
    });
    timer.time("write", [&] { write_file_atomically(shared.output, page); });
    session.print_line(fmt::format("{}: {}, {:.1f} MB", shared.output.string(),
                                   counted(input.objects.size(), "object"),
                                   1e-6 * static_cast<double>(page.size())));
    session.finish(
        {{"output", shared.output}, {"objects", input.objects.size()}, {"bytes", page.size()}},
        timer.stages());
  }
};

}  // namespace

void add_view(CommandLine& line) {
  const auto state = std::make_shared<View>();
  Arguments arguments(line, "view", "Write a result as one self-contained web page",
                      "symscene view result -o page.html --title \"My table\"\n"
                      "  symscene view result --sequence sweep --scene scene -o page.html");
  arguments.input(state->result, "RESULT", "result folder");
  arguments.output_file(state->shared, "page to write");
  arguments.text("--title", "TITLE", state->title,
                 "title of the page (default: name of the result folder)");
  arguments.folder("--sequence", state->frames,
                   "play the camera's sweep with its depth images: the sequence of the result");
  arguments.folder("--scene", state->scene,
                   "compare with the ground truth of the result's scene (truth.json)");
  arguments.sequence_options(state->source);
  arguments.reporting(state->shared);
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
