#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "counted.hpp"
#include "io/atomic_file.hpp"
#include "sequence_only.hpp"
#include "session.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/mcap.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {
namespace {

/// An MCAP file of a result or of a sequence.
struct Export {
  SharedOptions shared;
  SequenceOptions source;
  std::filesystem::path input;
  std::string compression = "none";

  McapCompression mcap_compression() const { return mcap_compression_of(compression); }

  /// The file, and what it holds.
  std::pair<std::string, std::string> content(Session& session) const {
    if (std::filesystem::exists(input / "objects.json")) {
      require_no_camera(source, "a sequence, not a result");
      const SegmentationResult result = read_result(input);
      return {format_result_mcap(result, mcap_compression()),
              counted(result.objects.size(), "object")};
    }
    if (!is_sequence(input)) {
      throw InputError(input.string(), "a result folder or a sequence of depth images",
                       std::filesystem::exists(input) ? "neither" : "nothing of that name");
    }
    const auto sequence = open_sequence(input, source);
    session.warn(sequence->warnings());
    return {format_sequence_mcap(*sequence, mcap_compression()),
            counted(sequence->size(), "frame")};
  }

  void run() const {
    require_not_input(shared.output, input);
    Session session("export", shared);
    StageTimer timer(session.on_begin());
    const auto [file, held] = timer.time("read", [&] { return content(session); });
    timer.time("write", [&, &bytes = file] { write_file_atomically(shared.output, bytes); });
    session.print_line(fmt::format("{}: {}, {:.1f} MB", shared.output.string(), held,
                                   1e-6 * static_cast<double>(file.size())));
    session.finish({{"output", shared.output}, {"bytes", file.size()}}, timer.stages());
  }
};

}  // namespace

void add_export(CommandLine& line) {
  const auto state = std::make_shared<Export>();
  Arguments arguments(line, "export",
                      "Write a result for Foxglove and Lichtblick, or a sequence as a recording of "
                      "ROS 2, as MCAP",
                      "symscene export result -o result.mcap");
  arguments.input(state->input, "INPUT", "result folder, or sequence of depth images");
  arguments.output_file(state->shared, "file to write, .mcap", {".mcap"});
  arguments.choice("--compression", state->compression, {"none", "lz4", "zstd"},
                   "compression of the file's chunks (default: none)");
  arguments.sequence_options(state->source);
  arguments.reporting(state->shared);
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
