#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "counted.hpp"
#include "io/atomic_file.hpp"
#include "result_page.hpp"
#include "session.hpp"
#include "symscene/io/result.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {
namespace {

struct View {
  SharedOptions shared;
  std::string title;
  std::filesystem::path result;

  PageOptions page_options(const SegmentationResult& input) const {
    return result_page(input, title.empty() ? folder_name(result) : title,
                       read_result_surroundings(result));
  }

  void run() const {
    require_not_input(shared.output, result);
    Session session("view", shared);
    StageTimer timer(session.on_begin());
    const SegmentationResult input = timer.time("read", [&] { return read_result(result); });
    const std::string page = timer.time("render", [&] {
      const PageOptions options = page_options(input);
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
                      "symscene view result -o page.html --title \"My table\"");
  arguments.input(state->result, "RESULT", "result folder");
  arguments.output_file(state->shared, "page to write");
  arguments.text("--title", "TITLE", state->title,
                 "title of the page (default: name of the result folder)");
  arguments.reporting(state->shared);
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
