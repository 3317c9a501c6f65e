#include <algorithm>
#include <future>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "frame_log.hpp"
#include "session.hpp"
#include "symscene/evaluation/trajectory_measures.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/io/truth.hpp"
#include "symscene/pipeline/scene_building.hpp"
#include "symscene/simulation/truth_transfer.hpp"

namespace symscene::app {
namespace {

/// All stages' options, as a configuration file names them.
struct ReconstructOptions {
  ReconstructionOptions reconstruction;
  SceneBuildingOptions scene;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    ReconstructionOptions::visit_fields(self.reconstruction, visit);
    visit("scene", self.scene);
  }
};

/// Reads a sequence's frames one ahead of the one that is worked on.
class FrameReader {
 public:
  explicit FrameReader(const DepthSequence& sequence) : sequence_(sequence) { start(); }

  /// The next frame. Throws what reading it threw; the one after it follows all the same.
  DepthFrame next() {
    std::future<DepthFrame> current = std::move(ahead_);
    start();
    return current.get();
  }

 private:
  void start() {
    if (next_ == sequence_.size()) return;
    ahead_ = std::async(std::launch::async, [this, i = next_] { return sequence_.read(i); });
    ++next_;
  }

  const DepthSequence& sequence_;
  std::size_t next_ = 0;
  std::future<DepthFrame> ahead_;
};

std::string plane_numbers(const Plane& plane) {
  return fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}", plane.normal.x(), plane.normal.y(),
                     plane.normal.z(), plane.offset);
}

struct Reconstruct {
  SharedOptions shared;
  ReconstructOptions options;
  SequenceOptions source;
  std::filesystem::path path;
  std::string poses;
  std::string plane;
  bool any_up = false;

  OptionFields configure() {
    OptionFields fields = option_fields(options);
    if (!shared.config.empty()) read_config(shared.config, fields);
    options.reconstruction.validate();
    options.scene.validate();
    return fields;
  }

  std::optional<Plane> given_plane() const {
    if (plane.empty()) return {};
    std::string words = plane;
    std::replace(words.begin(), words.end(), ',', ' ');
    return parse_table_plane(words, "--plane");
  }

  std::optional<Eigen::Isometry3d> given_pose(const DepthSequence& sequence, std::size_t i) const {
    return poses.empty() ? std::nullopt : sequence.pose(i);
  }

  void require_poses(const DepthSequence& sequence) const {
    if (poses.empty()) return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < sequence.size(); ++i) count += sequence.pose(i).has_value() ? 1 : 0;
    if (count == 0) throw InputError(path.string(), "poses, as --poses asks", "frames without any");
  }

  /// Frames that could be placed, by their numbers in the sequence.
  struct Path {
    Trajectory trajectory;
    std::vector<std::size_t> frames;
  };

  Path add_frames(const DepthSequence& sequence, Reconstruction& reconstruction, FrameLog& log,
                  Session& session, StageTimer& timer) const {
    const PoseUse use = poses == "exact" ? PoseUse::exact : PoseUse::start;
    FrameReader reader(sequence);
    Path placed;
    double waited = 0.0;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      session.on_begin()(fmt::format("frame {} of {}", i + 1, sequence.size()));
      const auto start = std::chrono::steady_clock::now();
      std::optional<DepthFrame> frame;
      try {
        frame = reader.next();
      } catch (const InputError& error) {
        log.add_unreadable(i);
        session.warn(error.what());
      }
      waited += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (!frame) continue;
      const FrameReport report = reconstruction.add(*frame, given_pose(sequence, i), use);
      log.add(i, report);
      if (!report.fused) continue;
      placed.trajectory.push_back({sequence.time(i), report.tracking.T_world_camera});
      placed.frames.push_back(i);
    }
    timer.add("read (waiting)", waited);
    for (const StageTime& time : reconstruction.times()) timer.add(time.stage, time.seconds);
    return placed;
  }

  void report_table(const TableScene& table, Session& session) const {
    if (table.planes.supports.empty()) {
      std::vector<std::string> found;
      for (const SupportPlane& other : table.planes.others) {
        found.push_back(fmt::format("{} ({:.2f} m^2)", plane_numbers(other.plane), other.area));
      }
      throw InputError(
          path.string(), "a table that something stands on (or --plane a,b,c,d)",
          found.empty() ? "no plane" : fmt::format("only the planes {}", fmt::join(found, "; ")));
    }
    const auto& supports = table.planes.supports;
    session.say(fmt::format("table {}: {:.2f} m^2, rough to {:.1f} mm",
                            plane_numbers(supports.front().plane), supports.front().area,
                            1e3 * supports.front().residual));
    for (std::size_t k = 1; k < supports.size(); ++k) {
      session.warn(fmt::format("another plane carries things too: --plane {} ({:.2f} m^2)",
                               plane_numbers(supports[k].plane), supports[k].area));
    }
  }

  /// The truth of a simulated sequence in the frame and on the points of the scene.
  std::optional<SceneTruth> scene_truth(const DepthSequence& sequence, const Path& placed,
                                        const PointCloud& cloud) const {
    if (!std::filesystem::exists(path / "truth.json")) return {};
    std::vector<Eigen::Isometry3d> tracked, truth;
    for (std::size_t k = 0; k < placed.frames.size(); ++k) {
      const auto pose = sequence.pose(placed.frames[k]);
      if (!pose) continue;
      tracked.push_back(placed.trajectory[k].T_world_camera);
      truth.push_back(*pose);
    }
    const SceneTruth known = read_truth(path / "truth.json");
    return transfer_truth(known, read_truth_meshes(path, known), cloud,
                          align_poses(tracked, truth));
  }

  void report_trajectory(const DepthSequence& sequence, const Path& placed,
                         Session& session) const {
    if (poses == "exact") return;
    std::vector<Eigen::Isometry3d> tracked, truth;
    for (std::size_t k = 0; k < placed.frames.size(); ++k) {
      const auto pose = sequence.pose(placed.frames[k]);
      if (!pose) continue;
      tracked.push_back(placed.trajectory[k].T_world_camera);
      truth.push_back(*pose);
    }
    if (truth.size() < 3) return;
    const TrajectoryError error = trajectory_error(tracked, truth);
    session.say(fmt::format(
        "against the sequence's {} poses ({:.2f} m): absolute error {:.1f} mm, relative {:.1f} mm "
        "and {:.2f} degrees over 30 frames, drift {:.1f} mm",
        error.poses, error.length, 1e3 * error.absolute, 1e3 * error.relative,
        degrees(error.relative_angle), 1e3 * error.drift));
  }

  void run() {
    const OptionFields fields = configure();
    const std::optional<Plane> table = given_plane();
    require_not_input(shared.output, path);
    Session session("reconstruct", shared);
    StageTimer timer(session.on_begin());
    const auto sequence = timer.time("open", [&] { return open_sequence(path, source); });
    require_poses(*sequence);
    Reconstruction reconstruction(sequence->camera(), options.reconstruction);
    FrameLog log;
    const Path placed = add_frames(*sequence, reconstruction, log, session, timer);
    for (const std::string& line : log.lines()) session.say(line);
    if (placed.frames.empty())
      throw InputError(path.string(), "a frame that shows something", log.first_run());
    report_trajectory(*sequence, placed, session);
    const TriangleMesh surface =
        timer.time("extract surface", [&] { return reconstruction.surface(); });
    const BuiltScene built = timer.time("find table", [&] {
      return naming(path, [&] {
        return build_scene(surface, reconstruction.occupancy(), table,
                           any_up ? std::nullopt : upward(placed.trajectory), options.scene);
      });
    });
    report_table(built.table, session);
    timer.time("write", [&] {
      const std::optional<SceneTruth> truth = scene_truth(*sequence, placed, built.scene.cloud);
      write_scene(absolute(shared.output), built.scene,
                  {.scene_json = describe_run("reconstruct", fields, log.json()),
                   .truth = truth ? &*truth : nullptr,
                   .mesh = &surface,
                   .trajectory = &placed.trajectory,
                   .log_odds = &built.log_odds});
    });
    const auto memory = static_cast<std::uint64_t>(reconstruction.volume().bytes() +
                                                   reconstruction.occupancy().memory());
    session.say(fmt::format("{}: {} points of objects, {} mesh vertices, model of {:.0f} MB",
                            shared.output.string(), built.scene.cloud.size(),
                            surface.vertices.rows(), 1e-6 * static_cast<double>(memory)));
    session.finish({{"output", shared.output},
                    {"frames", sequence->size()},
                    {"fused", log.fused()},
                    {"points", built.scene.cloud.size()},
                    {"vertices", static_cast<std::uint64_t>(surface.vertices.rows())},
                    {"model_bytes", memory}},
                   timer.stages());
  }
};

}  // namespace

void add_reconstruct(CLI::App& app) {
  const auto state = std::make_shared<Reconstruct>();
  Arguments arguments(
      app, "reconstruct", "Turn a depth sequence into a scene: track, fuse, find the table",
      "symscene reconstruct sweep -o scene\n"
      "  symscene reconstruct tum_fr1_xyz -o desk --intrinsics 517.3,516.5,318.6,255.3");
  arguments.input(state->path, "SEQUENCE",
                  "sequence folder, TUM, 7-Scenes, Redwood or ICL-NUIM folder, or ROS 1 bag");
  arguments.required_output(state->shared, "scene folder to write");
  arguments.sequence_options(state->source);
  arguments.choice("--poses", state->poses, {"exact", "start"},
                   "use the sequence's poses as they are, or to start tracking from");
  arguments.text("--plane", state->plane, "the table, as a,b,c,d of ax + by + cz + d = 0");
  arguments.flag("--any-up", state->any_up,
                 "the camera was not held upright: the table may face anywhere");
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
