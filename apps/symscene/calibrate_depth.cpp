#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "calibrate.hpp"
#include "core/median.hpp"
#include "io/atomic_file.hpp"
#include "session.hpp"
#include "symscene/io/camera_file.hpp"
#include "symscene/io/sequence.hpp"
#include "thinned_sequence.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// The options in the groups of a configuration file.
struct CalibrateDepthOptions {
  DepthCorrectionOptions correction;
  WallFitOptions wall;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("correction", self.correction);
    visit("wall", self.wall);
  }
  void validate() const { check_fields(*this); }
};

struct CalibrateDepth {
  SharedOptions shared;
  CalibrateDepthOptions options;
  SequenceOptions source;
  fs::path path;
  fs::path page;
  bool wall = false;
  std::optional<int> every;
  BoardArguments board_arguments;

  OptionFields configure() { return configure_options(options, shared.config); }

  bool has_board() const { return board_arguments.are_given(); }

  /// Distance of the board by its corners over the depth measured at them, median; none without
  /// depth.
  static std::optional<double> distance_ratio(const std::vector<Eigen::Vector2d>& corners,
                                              const Plane& plane, const DepthFrame& frame,
                                              const CameraIntrinsics& camera) {
    std::vector<double> ratios;
    for (const Eigen::Vector2d& p : corners) {
      const auto u =
          static_cast<std::size_t>(std::lround(std::clamp(p.x(), 0.0, camera.width - 1.0)));
      const auto v =
          static_cast<std::size_t>(std::lround(std::clamp(p.y(), 0.0, camera.height - 1.0)));
      const double z = frame.depth[v * camera.width + u];
      if (z > 0.0) ratios.push_back(-plane.offset / plane.normal.dot(camera.ray(p.x(), p.y())) / z);
    }
    return median(std::move(ratios));
  }

  /// No depth camera is off by a tenth; a mistaken size of the squares often is.
  static void require_square(std::vector<double> ratios, const Board& board) {
    constexpr double largest_error = 0.1;
    const std::optional<double> ratio = median(std::move(ratios));
    if (!ratio || std::abs(*ratio - 1.0) <= largest_error) return;
    throw InputError("--square",
                     fmt::format("squares of about {:.1f} mm, with which the board is where the "
                                 "depth images show it",
                                 1e3 * board.square / *ratio),
                     fmt::format("{:.1f} mm", 1e3 * board.square));
  }

  /// The plane of the board that the colours of a frame show.
  static std::optional<Plane> board_plane(const DepthFrame& frame, const CameraModel& rectified,
                                          const BoardTarget& target, std::vector<double>& ratios) {
    if (frame.colors.rows() == 0) return std::nullopt;
    const CameraIntrinsics& camera = rectified.intrinsics;
    const CharucoView view = target.find(grey_values(frame.colors), camera.width, camera.height);
    if (!view.is_found()) return std::nullopt;
    const auto T_camera_board = board_pose(view.image, rectified, target.board);
    if (!T_camera_board) return std::nullopt;
    const Eigen::Vector3d normal = T_camera_board->linear().col(2);
    const Plane plane{normal, -normal.dot(T_camera_board->translation())};
    if (const auto ratio = distance_ratio(view.image.corners, plane, frame, camera))
      ratios.push_back(*ratio);
    return plane;
  }

  DepthCalibration by_walls(const DepthSequence& sequence, const CameraModel& rectified,
                            Session& session) const {
    const std::optional<BoardTarget> target =
        has_board() ? std::optional(board_arguments.target()) : std::nullopt;
    WallCalibrator calibrator(sequence.camera(), options.correction, options.wall);
    std::vector<double> ratios;
    std::size_t without_board = 0;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      session.on_begin()(fmt::format("frame {} of {}", i + 1, sequence.size()));
      const DepthFrame frame = sequence.read(i);
      std::optional<Plane> plane;
      if (target) {
        plane = board_plane(frame, rectified, *target, ratios);
        if (!plane) {
          ++without_board;
          continue;
        }
      }
      calibrator.add(frame.depth, plane);
    }
    if (without_board > 0)
      session.warn(
          fmt::format("the board is not found in {} of {} frames", without_board, sequence.size()));
    if (target) require_square(std::move(ratios), target->board);
    session.on_begin()("fit correction");
    return calibrator.calibrate();
  }

  static void print(const DepthCalibration& found, const char* way, Session& session) {
    const DepthCorrection& grid = found.correction;
    const auto measured = std::count(grid.measured.begin(), grid.measured.end(), 1);
    const auto used = std::count_if(found.views.begin(), found.views.end(),
                                    [](const DepthViewReport& view) { return view.used; });
    const auto [least, greatest] = std::minmax_element(grid.factors.begin(), grid.factors.end());
    session.print_line(fmt::format(
        "{} of {} images: error {:.2f} % of the depth before, {:.2f} % after; factors {:.4f} to "
        "{:.4f} from {:.2f} to {:.2f} m; {} of {} factors measured, the others continue their "
        "neighbours",
        used, found.views.size(), 100.0 * found.error_before, 100.0 * found.error_after, *least,
        *greatest, grid.range(0), grid.range(grid.ranges - 1), measured, grid.cells()));
    session.print_line(fmt::format("by {}", way));
    session.warn(found.warnings);
  }

  void run() {
    configure();
    if (!wall && !has_board())
      throw InputError("symscene calibrate depth",
                       "--wall, or --board and --square: what the images show", "none of them");
    if (has_board()) board_arguments.target().require_finder();
    require_not_input(shared.output, path);
    // Depth is measured anew.
    if (source.camera) source.camera->depth_correction.reset();
    Session session("calibrate depth", shared);
    StageTimer timer(session.on_begin());
    const auto sequence = timer.time("open", [&] {
      return every_nth(open_sequence(path, source), static_cast<std::size_t>(every.value_or(1)));
    });
    session.warn(sequence->warnings());
    CameraModel camera = source.camera.value_or(CameraModel{sequence->camera(), {}, {}, {}});
    const CameraModel rectified{sequence->camera(), {}, {}, {}};
    const DepthCalibration found =
        timer.time("calibrate", [&] { return by_walls(*sequence, rectified, session); });
    print(found,
          has_board() ? "the board's pose: depth is true"
                      : "flat walls: depth is even, its scale is that of the camera",
          session);
    camera.depth_correction = found.correction;
    timer.time("write", [&] {
      write_file_atomically(shared.output, format_camera_model(camera));
      if (!page.empty()) write_file_atomically(page, depth_page(found));
    });
    session.finish({{"output", shared.output}, {"frames", sequence->size()}}, timer.stages());
  }
};

}  // namespace

void add_calibrate_depth(CommandLine& line) {
  const auto state = std::make_shared<CalibrateDepth>();
  Arguments arguments(
      line, "depth", "Find the systematic error of depth by pixel and range",
      "symscene calibrate depth walls --wall --intrinsics camera.yaml -o camera2.yaml\n"
      "  symscene calibrate depth walls --board 8x6 --square 0.0245 --intrinsics camera.yaml "
      "-o camera2.yaml");
  arguments.input(state->path, "SEQUENCE",
                  "depth images of a flat wall from the nearest to the farthest distance of use, a "
                  "sequence in any layout that reconstruct reads; with --board also infrared or "
                  "registered colour images");
  arguments.output_file(state->shared, "camera.yaml to write");
  arguments.sequence_options(state->source);
  arguments.every(state->every, "use every N-th frame (default 1)");
  arguments.flag("--wall", state->wall,
                 "the images show a flat wall or board at several distances; what is not on it is "
                 "left out");
  state->board_arguments.add_to(arguments);
  arguments.file("--page", state->page, "page to write: maps of the correction");
  arguments.run_stages(state);
}

}  // namespace symscene::app
