#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "commands.hpp"
#include "counted.hpp"
#include "frame_rate.hpp"
#include "frame_reader.hpp"
#include "live_loop.hpp"
#include "live_server.hpp"
#include "made_by.hpp"
#include "session.hpp"
#include "stop_request.hpp"
#include "sweep_arguments.hpp"
#include "symscene/io/result.hpp"
#include "symscene/viewer/live_page.hpp"
#include "workflow/score_models.hpp"

namespace symscene::app {
namespace {

using Clock = LiveLoop::Clock;

/// When each frame of a recording arrives: as it was recorded, or as soon as the one before is
/// done.
class Playback {
 public:
  Playback(const DepthSequence& sequence, bool is_fast)
      : sequence_(sequence), is_fast_(is_fast), start_(Clock::now()) {}

  /// Waits for frame i, unless the command is stopped before. Returns when it arrived.
  Clock::time_point wait_for(std::size_t i, const StopRequest& stop) const {
    if (is_fast_) return Clock::now();
    constexpr std::chrono::milliseconds slice{50};
    constexpr double longest = 1e6;  // the clock holds this much [s]
    const double after = std::clamp(sequence_.time(i) - sequence_.time(0), 0.0, longest);
    const Clock::time_point due =
        start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(after));
    while (Clock::now() < due && !stop.is_made())
      std::this_thread::sleep_until(std::min(due, Clock::now() + slice));
    return due;
  }

 private:
  const DepthSequence& sequence_;
  bool is_fast_;
  Clock::time_point start_;
};

struct Watch {
  SharedOptions shared;
  LiveOptions options;
  SweepArguments sweep;
  bool is_fast = false;
  bool is_unserved = false;
  std::string host = "127.0.0.1";
  std::optional<int> port;
  std::string token;

  OptionFields configure() {
    return configure_options(options, shared.config,
                             [&] { read_score_models(options.pipeline.models); });
  }

  /// Beyond this machine the scene is only served to those who have a token.
  LiveAddress address() const {
    const bool is_plain = std::all_of(token.begin(), token.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '-' || c == '_';
    });
    if (!is_plain) throw InputError("--token", "letters, digits, - and _", "'" + token + "'");
    LiveAddress address{host, port.value_or(0), token};
    if (token.empty() && !address.is_loopback()) address.token = random_token();
    return address;
  }

  std::unique_ptr<LiveServer> serve(Session& session) const {
    if (is_unserved) return nullptr;
    auto server =
        std::make_unique<LiveServer>(address(), render_live_page(folder_name(sweep.path)));
    session.print_line(fmt::format("open {}", server->url()));
    return server;
  }

  void tell(const LiveReport& report, Session& session) const {
    if (shared.json)
      session.print(live_json(report) + "\n");
    else
      session.print_line(live_line(report));
  }

  /// The first fused frame sets the world frame, which must be that of the poses.
  bool may_be_fused(const LiveScene& scene, const std::optional<Eigen::Isometry3d>& pose) const {
    return pose || !sweep.uses_poses() || !scene.cameras().empty();
  }

  void play(const DepthSequence& sequence, const LiveScene& scene, LiveLoop& loop,
            const StopRequest& stop, Session& session) const {
    const Playback playback(sequence, is_fast);
    FrameReader reader(sequence);
    for (std::size_t i = 0; i < sequence.size() && !stop.is_made(); ++i) {
      const Clock::time_point arrived = playback.wait_for(i, stop);
      try {
        const DepthFrame frame = reader.next();
        const auto pose = sweep.given_pose(sequence, i);
        if (!may_be_fused(scene, pose))
          throw InputError(sweep.path.string(), "a pose with the first fused frame",
                           fmt::format("frame {} without one; it is left out", i));
        loop.add(frame, pose, sweep.pose_use(), arrived);
      } catch (const InputError& error) {
        session.warn(error.what());  // the frames after it may be in order
      }
    }
  }

  void write(const LiveReport& last, const LiveScene& scene, const OptionFields& fields,
             Session& session) const {
    if (shared.output.empty()) return;
    LiveOptions defaults;
    ResultExtras extras;
    extras.made_by =
        made_by("watch", sweep.path, changed_options(fields, option_fields(defaults)), session);
    if (!scene.cameras().empty()) extras.trajectory = &scene.cameras();
    write_result(absolute(shared.output), last.update.result, extras);
  }

  void run() {
    const OptionFields fields = configure();
    sweep.table.table();  // before the work
    if (!shared.output.empty()) require_beside_frames(shared.output, sweep.path);
    Session session("watch", shared);
    const auto sequence = sweep.open(session);
    LiveScene scene(sequence->camera(), options);
    scene.use(sweep.choose_sensor(*sequence, options.tracked.reconstruction.measurement,
                                  options.tracked.sensor, session));
    const std::unique_ptr<LiveServer> server = serve(session);
    const StopRequest stop;
    const FrameRate rate(sequence->size());
    std::shared_ptr<const LiveReport> last;  // that has a scene
    std::string problem = "none that can be read";
    LiveLoop loop(scene, sweep.table.told(), [&](std::shared_ptr<const LiveReport> report) {
      if (report->problem.empty())
        last = report;
      else
        problem = report->problem;
      tell(*report, session);
      if (server) server->publish(std::move(report));
    });
    play(*sequence, scene, loop, stop, session);
    loop.finish();
    const double per_second = rate.per_second();
    if (!last && stop.is_made())
      throw InputError(sweep.path.string(), "an update before the command is stopped", "none");
    if (!last) throw InputError(sweep.path.string(), "a frame that shows a surface", problem);
    write(*last, scene, fields, session);
    if (server) {
      server->finish();
      if (!stop.is_made()) session.print_line("the last frame is in; Ctrl-C ends the page");
      if (!stop.is_made()) stop.wait();
    }
    finish(*last, scene, per_second, session);
  }

  void finish(const LiveReport& last, const LiveScene& scene, double per_second,
              Session& session) const {
    std::vector<ReportMember> members{{"frames", scene.frames()},
                                      {"lost", last.lost},
                                      {"updates", last.number},
                                      {"objects", last.update.result.objects.size()}};
    if (!shared.output.empty()) members.insert(members.begin(), {"output", shared.output});
    members.push_back(ReportMember::raw("frames_per_second", fmt::format("{:.4g}", per_second)));
    session.print_line(fmt::format("{} ({} lost), {:.1f} per second; {}",
                                   counted(scene.frames(), "frame"), last.lost, per_second,
                                   counted(last.number, "update")));
    session.finish(members, last.update.result.timings);
  }
};

}  // namespace

void add_watch(CommandLine& line) {
  const auto state = std::make_shared<Watch>();
  Arguments arguments(
      line, "watch", "Find the objects of a scene while its frames arrive, and show them on a page",
      "symscene watch sweep\n"
      "  symscene watch sweep --no-server --fast -o result");
  arguments.input(state->sweep.path, "SEQUENCE",
                  "sequence folder (SymScene, TUM, 7-Scenes, Redwood or ICL-NUIM), or recording of "
                  "ROS, played as it was recorded");
  arguments.optional_output_folder(state->shared, "result folder to write after the last frame");
  arguments.flag("--fast", state->is_fast,
                 "take each frame as soon as the one before is fused, not when it was recorded");
  arguments.flag("--no-server", state->is_unserved, "serve no page; end after the last frame");
  arguments.text("--host", "ADDRESS", state->host,
                 "address of this machine to serve at (default 127.0.0.1: only this machine)");
  arguments.count("--port", state->port, between(0, 65535),
                  "port to serve at (default: a free one)");
  arguments.text("--token", "TOKEN", state->token,
                 "what requests must bring (default: at other addresses than this machine's own a "
                 "random one)");
  state->sweep.add_to(arguments);
  arguments.run_stages(state);
}

}  // namespace symscene::app
