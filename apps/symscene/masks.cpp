#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "mask_images.hpp"
#include "session.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {
namespace {

/// The pose of the camera at a time; none if the trajectory has none within a millisecond.
std::optional<Eigen::Isometry3d> pose_at(const Trajectory& trajectory, double time) {
  for (const StampedPose& pose : trajectory) {
    if (std::abs(pose.time - time) < 1e-3) return pose.T_world_camera;
  }
  return std::nullopt;
}

struct Masks {
  SharedOptions shared;
  LabelImageOptions options;
  SequenceOptions source;
  std::filesystem::path result;
  std::filesystem::path frames;
  std::optional<int> every;

  OptionFields configure() { return configure_options(options, shared.config); }

  /// The pose of frame i in the frame of the result: of its trajectory, otherwise of the sequence.
  /// A sequence of one frame without pose is itself the frame of the result.
  static std::optional<Eigen::Isometry3d> pose_of(const Trajectory& trajectory,
                                                  const DepthSequence& sequence, std::size_t i) {
    if (!trajectory.empty()) return pose_at(trajectory, sequence.time(i));
    if (const auto own = sequence.pose(i)) return own;
    if (sequence.size() == 1) return Eigen::Isometry3d::Identity();
    return std::nullopt;
  }

  void run() {
    configure();
    require_not_input(shared.output, result);
    require_not_input(shared.output, frames);
    Session session("masks", shared);
    StageTimer timer(session.on_begin());
    const SegmentationResult objects = timer.time("read", [&] { return read_result(result); });
    const Trajectory trajectory = read_result_surroundings(result).trajectory;
    const auto sequence = open_sequence(frames, source);
    session.warn(sequence->warnings());
    MaskImageWriter writer(absolute(shared.output), objects, options);
    const auto step = static_cast<std::size_t>(every.value_or(1));
    std::size_t unplaced = 0;
    timer.time("label", [&] {
      for (std::size_t i = 0; i < sequence->size(); i += step) {
        const auto pose = pose_of(trajectory, *sequence, i);
        if (!pose) {
          ++unplaced;
          continue;
        }
        session.on_begin()(fmt::format("frame {} of {}", i + 1, sequence->size()));
        writer.add(i, sequence->camera(), sequence->read(i), *pose);
      }
    });
    if (writer.frames() == 0)
      throw InputError(frames.string(), fmt::format("a frame with a pose in {}", result.string()),
                       "none");
    if (unplaced > 0)
      session.warn(
          fmt::format("{}: {} frames have no pose and are left out", frames.string(), unplaced));
    const std::size_t count = writer.frames();
    timer.time("write", [&] { writer.finish(); });
    session.print_line(fmt::format("{}: {} objects in {} frames", shared.output.string(),
                                   objects.objects.size(), count));
    session.finish(
        {{"output", shared.output}, {"objects", objects.objects.size()}, {"frames", count}},
        timer.stages());
  }
};

}  // namespace

void add_masks(CommandLine& line) {
  const auto state = std::make_shared<Masks>();
  Arguments arguments(line, "masks", "Write the objects of a result as label images of its frames",
                      "symscene masks result sweep -o masks");
  arguments.input(state->result, "RESULT", "result folder");
  arguments.input(state->frames, "FRAMES", "sequence from which the scene of the result was made");
  arguments.required_output(state->shared, "masks folder to write");
  arguments.count("--every", state->every, "label every N-th frame (default 1)");
  arguments.sequence_options(state->source);
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
