#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "commands.hpp"
#include "core/naming.hpp"
#include "frame_log.hpp"
#include "frame_rate.hpp"
#include "frame_reader.hpp"
#include "scene_output.hpp"
#include "session.hpp"
#include "sweep_arguments.hpp"
#include "sweep_stitching.hpp"
#include "symscene/reconstruction/trajectory_error.hpp"
#include "symscene/workflow/reconstructed_scene.hpp"

namespace symscene::app {
namespace {

/// The options of all stages, in the groups of a configuration file.
struct ReconstructOptions {
  ReconstructionOptions reconstruction;
  HandOverOptions hand_over;
  SweepStitchingOptions stitching;
  ViewPointOptions view;
  SceneBuildingOptions scene;
  SensorEstimationOptions sensor;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    ReconstructionOptions::visit_fields(self.reconstruction, visit);
    visit("hand_over", self.hand_over);
    visit("stitching", self.stitching);
    visit("view", self.view);
    visit("scene", self.scene);
    visit("sensor", self.sensor);
  }
  void validate() const {
    reconstruction.validate();
    hand_over.validate();
    stitching.validate();
    view.validate();
    scene.validate();
    sensor.validate();
  }
};

constexpr int max_unreadable_warnings = 5;

struct Reconstruct {
  SharedOptions shared;
  ReconstructOptions options;
  SweepArguments sweep;
  ReportedSensor sensor;  ///< of the sequence

  OptionFields configure() { return configure_options(options, shared.config); }

  PlacedSequence track(const DepthSequence& sequence, Session& session, StageTimer& timer) const {
    FrameReader reader(sequence);
    PlacedSequence tracked{
        Reconstruction(sequence.camera(), options.reconstruction), {}, FrameLog(sweep.step())};
    auto& [reconstruction, placed, log] = tracked;
    const FrameRate rate(sequence.size());
    double waited = 0.0;
    int unreadable = 0;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      session.on_begin()(rate.progress(i));
      const auto start = std::chrono::steady_clock::now();
      std::optional<DepthFrame> frame;
      try {
        frame = sensor.prepared(reader.next(), sequence.camera());
      } catch (const InputError& error) {
        log.add_unreadable(i);
        if (++unreadable <= max_unreadable_warnings) session.warn(error.what());
      }
      waited += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (!frame) continue;
      const std::optional<Eigen::Isometry3d> pose = sweep.given_pose(sequence, i);
      if (!pose && sweep.uses_poses() && reconstruction.empty()) {
        // The first fused frame sets the world frame, which must be that of the poses.
        log.add_lost(i, "no earlier frame has a pose");
        continue;
      }
      const FrameReport report = reconstruction.add(*frame, pose, sweep.pose_use());
      log.add(i, report);
      if (!report.fused) continue;
      placed.trajectory.push_back({sequence.time(i), report.tracking.T_world_camera});
      placed.frames.push_back(i);
    }
    timer.add("read (waiting)", waited);
    for (const StageTime& time : reconstruction.times()) timer.add(time.stage, time.seconds);
    return tracked;
  }

  void report_trajectory(const DepthSequence& sequence, const PlacedFrames& placed,
                         Session& session) const {
    if (sweep.poses == "exact") return;
    const PosesAndTruth known = poses_and_truth(sequence, placed);
    if (known.truth.size() < 3) return;
    const TrajectoryError error = trajectory_error(known.poses, known.truth);
    session.print_line(fmt::format(
        "against the sequence's {} poses ({:.2f} m): absolute error {:.1f} mm, relative {:.1f} mm "
        "and {:.2f} degrees over {} frames, drift {:.1f} mm",
        error.poses, error.length, 1e3 * error.absolute, 1e3 * error.relative,
        degrees(error.relative_angle), error.interval, 1e3 * error.drift));
  }

  SceneOutput output() const { return {sweep.path, shared.output, sweep.table, options.scene}; }

  /// A sequence of one frame: the frame's own pixels are the surface.
  void run_on_view(const DepthSequence& sequence, const OptionFields& fields, Session& session,
                   StageTimer& timer) const {
    const DepthFrame frame =
        timer.time("read", [&] { return sensor.prepared(sequence.read(0), sequence.camera()); });
    const Eigen::Isometry3d pose =
        sweep.given_pose(sequence, 0).value_or(Eigen::Isometry3d::Identity());
    const PlacedFrames placed{{{frame.time, pose}}, {0}};
    session.on_begin()("find table");
    const auto [view, surface] = naming(sweep.path, [&] {
      return reconstructed_view({frame, sequence.camera(), pose}, sweep.table.told(),
                                {options.view, options.reconstruction.occupancy, options.scene});
    });
    for (const StageTime& time : view.stages) timer.add(time.stage, time.seconds);
    std::vector<ReportMember> members{{"output", shared.output}, {"frames", 1}, {"fused", 1}};
    members.push_back(ReportMember::raw("sensor", sensor.json));
    const std::vector<ReportMember> written = output().write(
        {view.built, view.occupancy, surface},
        {sequence, placed, describe_run("reconstruct", fields, "", sensor.json)}, session, timer);
    members.insert(members.end(), written.begin(), written.end());
    session.finish(members, timer.stages());
  }

  /// The frames as tracked or, where they are too far apart for that, as stitched.
  PlacedSequence place(const DepthSequence& sequence, Session& session, StageTimer& timer) const {
    PlacedSequence tracked = track(sequence, session, timer);
    if (sweep.uses_poses()) return tracked;
    const std::string reason = reason_to_stitch(sequence, tracked, options.hand_over);
    if (reason.empty()) return tracked;
    session.on_begin()("stitch");
    const double min_placed =
        options.hand_over.min_placed * static_cast<double>(tracked.log.fused());
    auto stitched =
        stitch_sequence(sequence, sweep.step(), min_placed, options.stitching.with(measurement()),
                        options.reconstruction, timer);
    PlacedSequence& chosen = stitched ? *stitched : tracked;
    chosen.log.warn(stitched ? fmt::format("{}: they were placed by stitching, {} of {}", reason,
                                           stitched->log.fused(), sequence.size())
                             : fmt::format("{}, and stitching places far fewer of them", reason));
    session.warn(chosen.log.warnings());
    return std::move(chosen);
  }

  const MeasurementOptions& measurement() const { return options.reconstruction.measurement; }

  void run_on_frames(const DepthSequence& sequence, const OptionFields& fields, Session& session,
                     StageTimer& timer) const {
    const FrameRate rate(sequence.size());
    const auto [reconstruction, placed, log] = place(sequence, session, timer);
    const double per_second = rate.per_second();
    session.print_line(rate.summary());
    for (const std::string& line : log.lines()) session.print_line(line);
    if (placed.frames.empty())
      throw InputError(sweep.path.string(), "a frame that can be fused", log.first_run());
    report_trajectory(sequence, placed, session);
    const std::vector<ReportMember> written = output().write(
        reconstruction, options.reconstruction.surface,
        {sequence, placed, describe_run("reconstruct", fields, log.json(), sensor.json)}, session,
        timer);
    std::vector<ReportMember> members{
        {"output", shared.output}, {"frames", sequence.size()}, {"fused", log.fused()}};
    members.push_back(ReportMember::raw("frames_per_second", fmt::format("{:.4g}", per_second)));
    members.push_back(ReportMember::raw("log", log.json()));
    members.push_back(ReportMember::raw("sensor", sensor.json));
    members.insert(members.end(), written.begin(), written.end());
    session.finish(members, timer.stages());
  }

  void choose_sensor(const DepthSequence& sequence, Session& session) {
    sensor = sweep.choose_sensor(sequence, measurement(), options.sensor, session);
    double& tracking_noise = options.reconstruction.measurement.noise;
    tracking_noise = sensor.tracking_noise.value_or(tracking_noise);
    options.view.noise = sensor.noise.value_or(options.view.noise);
  }

  void run() {
    const OptionFields fields = configure();
    sweep.table.table();  // before the work
    require_beside_frames(shared.output, sweep.path);
    require_folder(shared.output);
    Session session("reconstruct", shared);
    StageTimer timer(session.on_begin());
    const auto sequence = timer.time("open", [&] { return sweep.open(session); });
    timer.time("estimate sensor", [&] { choose_sensor(*sequence, session); });
    if (sequence->size() == 1) {
      run_on_view(*sequence, fields, session, timer);
    } else {
      run_on_frames(*sequence, fields, session, timer);
    }
  }
};

}  // namespace

void add_reconstruct(CommandLine& line) {
  const auto state = std::make_shared<Reconstruct>();
  Arguments arguments(
      line, "reconstruct", "Turn a depth sequence into a scene: track, fuse, find the table",
      "symscene reconstruct sweep -o scene\n"
      "  symscene reconstruct tum_fr1_xyz -o desk --intrinsics 517.3,516.5,318.6,255.3");
  arguments.input(state->sweep.path, "SEQUENCE",
                  "sequence folder (SymScene, TUM, 7-Scenes, Redwood or ICL-NUIM), or recording of "
                  "ROS");
  arguments.output_folder(state->shared, "scene folder to write");
  state->sweep.add_to(arguments);
  arguments.run_stages(state);
}

}  // namespace symscene::app
