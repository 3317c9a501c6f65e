#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "counted.hpp"
#include "frame_pose.hpp"
#include "mask_images.hpp"
#include "session.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {
namespace {

/// Object points in the images, and those of them that the depth contradicts.
struct SeenThrough {
  std::size_t points = 0;
  std::size_t contradicted = 0;  ///< the camera measured something far behind them
};

/// Counts the points of a result's objects in a frame. Depth that lies far behind a point shows
/// that the point is not there; depth before it is an occluder.
void count_seen_through(const SegmentationResult& result, const CameraIntrinsics& camera,
                        const DepthFrame& frame, const Eigen::Isometry3d& T_scene_camera,
                        SeenThrough& counts) {
  constexpr double least = 0.02, share_of_depth = 0.05;  // [m]
  const Eigen::Isometry3d T_camera_scene = T_scene_camera.inverse();
  for (const SceneObject& object : result.objects) {
    for (const Index i : object.points) {
      const Eigen::Vector3d p = T_camera_scene * result.cloud.position(i).cast<double>();
      if (p.z() <= 0.0) continue;
      const Eigen::Vector2d pixel = camera.project(p);
      const double u = std::round(pixel.x()), v = std::round(pixel.y());
      if (u < 0.0 || v < 0.0 || u >= camera.width || v >= camera.height) continue;
      const double measured =
          frame.depth[static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width) +
                      static_cast<std::size_t>(u)];
      if (!(measured > 0.0)) continue;
      ++counts.points;
      counts.contradicted += measured > p.z() + least + share_of_depth * p.z() ? 1 : 0;
    }
  }
}

struct Masks {
  SharedOptions shared;
  LabelImageOptions options;
  SequenceOptions source;
  std::filesystem::path result;
  std::filesystem::path frames;
  std::optional<int> every;

  OptionFields configure() { return configure_options(options, shared.config); }

  /// Frames of another scene see through most of the objects.
  void require_own_frames(const SeenThrough& counts) const {
    constexpr double most = 0.5;
    const double share = static_cast<double>(counts.contradicted) /
                         std::max(1.0, static_cast<double>(counts.points));
    if (share <= most) return;
    throw InputError(frames.string(), fmt::format("the frames of {}", result.string()),
                     fmt::format("depth behind {:.0f} % of its objects' points", 100.0 * share));
  }

  void run() {
    configure();
    require_not_input(shared.output, result);
    require_beside_frames(shared.output, frames);
    Session session("masks", shared);
    StageTimer timer(session.on_begin());
    const SegmentationResult objects = timer.time("read", [&] { return read_result(result); });
    const Trajectory trajectory = read_result_surroundings(result).trajectory;
    const auto sequence = open_sequence(frames, source);
    session.warn(sequence->warnings());
    MaskImageWriter writer(absolute(shared.output), objects, options);
    const auto step = static_cast<std::size_t>(every.value_or(1));
    std::size_t unplaced = 0;
    SeenThrough seen_through;
    timer.time("label", [&] {
      for (std::size_t i = 0; i < sequence->size(); i += step) {
        const auto pose = frame_pose(trajectory, *sequence, i);
        if (!pose) {
          ++unplaced;
          continue;
        }
        session.on_begin()(fmt::format("frame {} of {}", i + 1, sequence->size()));
        const DepthFrame frame = sequence->read(i);
        count_seen_through(objects, sequence->camera(), frame, *pose, seen_through);
        writer.add(i, sequence->camera(), frame, *pose);
      }
    });
    if (writer.frames() == 0)
      throw InputError(frames.string(), fmt::format("a frame with a pose in {}", result.string()),
                       "none");
    require_own_frames(seen_through);
    if (unplaced > 0)
      session.warn(fmt::format("{}: {} without a pose left out", frames.string(),
                               counted(unplaced, "frame")));
    const std::size_t count = writer.frames();
    timer.time("write", [&] { writer.finish(); });
    session.print_line(fmt::format("{}: {} in {}", shared.output.string(),
                                   counted(objects.objects.size(), "object"),
                                   counted(count, "frame")));
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
  arguments.output_folder(state->shared, "masks folder to write");
  arguments.every(state->every, "label every N-th frame (default 1)");
  arguments.sequence_options(state->source);
  arguments.run_stages(state);
}

}  // namespace symscene::app
