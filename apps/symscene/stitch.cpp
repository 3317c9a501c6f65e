#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "scene_output.hpp"
#include "sensor_choice.hpp"
#include "session.hpp"
#include "stitch_report.hpp"
#include "sweep_stitching.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/reconstruction/trajectory_error.hpp"

namespace symscene::app {
namespace {

/// All pairs of frames are compared, so that more frames take minutes.
constexpr std::size_t most_frames = 60;

/// The options of all stages, in the groups of a configuration file. All stages share the options
/// of the measurement.
struct StitchOptions {
  StitchingOptions stitching;
  TsdfOptions tsdf;
  OccupancyVolumeOptions occupancy;
  SurfaceExtractionOptions surface;
  SceneBuildingOptions scene;
  SensorEstimationOptions sensor;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    StitchingOptions::visit_fields(self.stitching, visit);
    visit("tsdf", self.tsdf);
    visit("occupancy", self.occupancy);
    visit("surface", self.surface);
    visit("scene", self.scene);
    visit("sensor", self.sensor);
  }

  void validate() const {
    stitching.validate();
    scene.validate();
    sensor.validate();
    reconstruction().validate();
  }

  ReconstructionOptions reconstruction() const {
    ReconstructionOptions options;
    options.measurement = stitching.measurement;
    options.tsdf = tsdf;
    options.occupancy = occupancy;
    options.surface = surface;
    return options;
  }
};

struct Stitch {
  SharedOptions shared;
  StitchOptions options;
  SequenceOptions source;
  std::filesystem::path path;
  TableArguments table_arguments;
  SensorArguments sensor_arguments;
  ReportedSensor sensor;  ///< of the sequence
  std::optional<int> every;

  OptionFields configure() { return configure_options(options, shared.config); }

  static void require_matcher() {
    if (has_feature_matcher()) return;
    throw InputError("this build of symscene",
                     "a feature matcher (install libopencv-features2d-dev and "
                     "libopencv-calib3d-dev, then build again)",
                     "none");
  }

  /// The numbers of the frames to stitch.
  std::vector<std::size_t> choose(const DepthSequence& sequence) const {
    std::vector<std::size_t> colored, chosen;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      if (sequence.has_color(i)) colored.push_back(i);
    }
    if (colored.empty()) {
      throw InputError(path.string(), "frames with colour",
                       fmt::format("{} frames without colour", sequence.size()));
    }
    const auto step = static_cast<std::size_t>(every.value_or(1));
    for (std::size_t k = 0; k < colored.size(); k += step) chosen.push_back(colored[k]);
    if (chosen.size() > most_frames) {
      throw InputError(path.string(),
                       fmt::format("at most {} frames with colour (pass --every {})", most_frames,
                                   (colored.size() + most_frames - 1) / most_frames),
                       fmt::format("{}", chosen.size()));
    }
    return chosen;
  }

  /// The frames that have colour.
  ReadFrames read(const DepthSequence& sequence, Session& session) const {
    ReadFrames read;
    for (const std::size_t i : choose(sequence)) {
      try {
        DepthFrame frame = sequence.read(i);
        if (frame.colors.rows() == 0) continue;
        read.frames.push_back(std::move(frame));
        read.numbers.push_back(i);
      } catch (const InputError& error) {
        session.warn(error.what());
      }
    }
    if (read.frames.size() < 2) {
      throw InputError(path.string(), "at least two frames with colour that can be read",
                       fmt::format("{}", read.frames.size()));
    }
    return read;
  }

  void require_placed(const StitchingResult& stitched) const {
    if (stitched.placed > 0) return;
    std::size_t plain = 0;
    for (const StitchedFrame& frame : stitched.frames) {
      const auto least = static_cast<std::size_t>(options.stitching.pairs.min_inliers);
      plain += frame.features < least ? 1 : 0;
    }
    throw InputError(path.string(), "two frames that show the same textured surface",
                     fmt::format("none among {}, {} of them with too little texture",
                                 stitched.frames.size(), plain));
  }

  static void report_poses(const DepthSequence& sequence, const PlacedFrames& placed,
                           Session& session) {
    const PosesAndTruth known = poses_and_truth(sequence, placed);
    if (known.truth.size() < 3) return;
    const TrajectoryError error = trajectory_error(known.poses, known.truth, 1);
    session.print_line(fmt::format(
        "against the sequence's {} poses: absolute error {:.1f} mm, largest {:.1f} mm; from one "
        "frame to the next {:.1f} mm and {:.2f} degrees",
        error.poses, 1e3 * error.absolute, 1e3 * error.absolute_max, 1e3 * error.relative,
        degrees(error.relative_angle)));
  }

  Reconstruction fuse(const DepthSequence& sequence, const ReadFrames& read,
                      const StitchingResult& stitched, StageTimer& timer) const {
    Reconstruction reconstruction =
        fuse_placed(stitched, read, sequence.camera(), options.reconstruction());
    for (const StageTime& time : reconstruction.times()) {
      if (time.seconds > 0.0) timer.add(time.stage, time.seconds);
    }
    return reconstruction;
  }

  void choose_sensor(const DepthSequence& sequence, ReadFrames& read, Session& session) {
    constexpr bool tracked = false;
    const MeasurementOptions& measured = options.stitching.measurement;
    sensor = sensor_arguments.choose(
        sequence, tracked, {sequence.depth_scale(), measured.min_depth, measured.max_depth},
        options.sensor, session);
    double& noise = options.stitching.measurement.noise;
    noise = sensor.noise.value_or(noise);
    for (DepthFrame& frame : read.frames)
      frame = sensor.prepared(std::move(frame), sequence.camera());
  }

  void run() {
    const OptionFields fields = configure();
    table_arguments.table();  // before the work
    require_matcher();
    require_beside_frames(shared.output, path);
    require_folder(shared.output);
    Session session("stitch", shared);
    StageTimer timer(session.on_begin());
    const auto sequence = timer.time("open", [&] { return open_sequence(path, source); });
    session.warn(sequence->warnings());
    ReadFrames read = timer.time("read", [&] { return this->read(*sequence, session); });
    timer.time("estimate sensor", [&] { choose_sensor(*sequence, read, session); });
    session.on_begin()("stitch");
    const StitchingResult stitched =
        stitch_frames(read.frames, sequence->camera(), options.stitching);
    for (const StageTime& time : stitched.times) timer.add(time.stage, time.seconds);
    for (const std::string& line : stitch_lines(stitched, read.numbers)) session.print_line(line);
    require_placed(stitched);
    const PlacedFrames placed = placed_frames(stitched, read);
    report_poses(*sequence, placed, session);
    session.on_begin()("fuse");
    const Reconstruction reconstruction = fuse(*sequence, read, stitched, timer);
    const SceneOutput output{path, shared.output, table_arguments, options.scene};
    const std::vector<ReportMember> written = output.write(
        reconstruction, options.surface,
        {*sequence, placed,
         describe_run("stitch", fields, stitch_json(stitched, read.numbers), sensor.json)},
        session, timer);
    std::vector<ReportMember> members{
        {"output", shared.output}, {"frames", read.frames.size()}, {"placed", stitched.placed}};
    members.push_back(ReportMember::raw("sensor", sensor.json));
    members.insert(members.end(), written.begin(), written.end());
    session.finish(members, timer.stages());
  }
};

}  // namespace

void add_stitch(CommandLine& line) {
  const auto state = std::make_shared<Stitch>();
  Arguments arguments(
      line, "stitch", "Make a scene of a few colour and depth frames from unknown viewpoints",
      "symscene stitch photos -o scene\n"
      "  symscene stitch tum_fr1_xyz -o desk --intrinsics 517.3,516.5,318.6,255.3 --every 3");
  arguments.input(
      state->path, "FRAMES",
      "sequence with colour, in any layout that reconstruct reads; the order does not matter");
  arguments.output_folder(state->shared, "scene folder to write");
  arguments.sequence_options(state->source);
  arguments.every(state->every, "use every N-th frame with colour");
  state->table_arguments.add_to(
      arguments, "the table plane a,b,c,d with ax + by + cz + d = 0, in the first camera's frame");
  state->sensor_arguments.add_to(arguments);
  arguments.run_stages(state);
}

}  // namespace symscene::app
