#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "common.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/io/result.hpp"
#include "symscene/viewer/page.hpp"

namespace symscene::app {
namespace {

struct View {
  SharedOptions shared;
  std::string title;
  std::filesystem::path result;

  PageOptions page_options(const SegmentationResult& input) const {
    PageOptions options;
    options.title = title.empty() ? folder_name(result) : title;
    options.table = input.table;
    return options;
  }

  void run() const {
    require_not_input(shared.output, result);
    Session session("view", shared);
    StageTimer timer(session.on_begin());
    const SegmentationResult input = timer.time("read", [&] { return read_result(result); });
    const std::string page =
        timer.time("render", [&] { return render_page(input, page_options(input)); });
    timer.time("write", [&] { write_file_atomically(shared.output, page); });
    session.say(fmt::format("{}: {} objects, {:.1f} MB", shared.output.string(),
                            input.objects.size(), 1e-6 * static_cast<double>(page.size())));
    session.finish({{"output", shared.output.string()},
                    {"objects", input.objects.size()},
                    {"bytes", page.size()}},
                   timer.stages());
  }
};

}  // namespace

void add_view(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("view", "Write a result as one web page that opens anywhere");
  const auto state = std::make_shared<View>();
  add_input(command, state->result, "RESULT", "result folder");
  add_output(command, state->shared, "page to write")->required();
  command
      .add_option("--title", state->title, "title of the page (default: the name of the folder)")
      ->type_name("T");
  add_reporting(command, state->shared);
  set_example(command, "symscene view result -o page.html --title \"My table\"");
  command.callback([state] { state->run(); });
}

}  // namespace symscene::app
