// Measures what calibration finds of simulated cameras and what it is good for: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <chrono>
#include <cstdio>

#include "calibrated_cameras.hpp"
#include "calibration/simulated_boards.hpp"
#include "calibration_sweeps.hpp"
#include "program.hpp"
#include "symscene/core/frame_rectifier.hpp"
#include "symscene/core/thread_limit.hpp"

namespace symscene::bench {
namespace {

struct Arguments {
  std::string part = "all";
  int repeats = 5;
  int sweeps = 10;
  int frames = 120;
  std::filesystem::path pictures;
  std::size_t threads = 0;

  bool wants(const char* name) const { return part == "all" || part == name; }
};

/// The greatest of some values, and their mean.
struct Spread {
  double greatest = 0.0, sum = 0.0;
  int count = 0;

  void add(double value) { greatest = std::max(greatest, value), sum += value, ++count; }
  double mean() const { return sum / count; }
};

void measure_intrinsics(int repeats) {
  const CameraToCalibrate camera = simulated_camera(0.0, 1);
  for (const int images : {15, 30, 50}) {
    Spread focal, center, error, shift, turn;
    for (int i = 0; i < repeats; ++i) {
      const auto seed = static_cast<std::uint64_t>(i) + 1;
      const IntrinsicCalibration found = found_intrinsics(camera, images, 0.1, seed);
      const CameraIntrinsics& K = found.camera.intrinsics;
      focal.add(std::max(std::abs(K.fx / 525.0 - 1.0), std::abs(K.fy / 525.0 - 1.0)));
      center.add(std::max(std::abs(K.cx - 319.5), std::abs(K.cy - 239.5)));
      error.add(found.error);
      const ColorPoseError pose = color_pose_error(images, seed);
      shift.add(pose.shift), turn.add(pose.turn);
    }
    fmt::print(
        "{} images, 0.1 px, mean (worst) of {}: focal length {:.3f} ({:.3f}) %, centre {:.2f} "
        "({:.2f}) px, reprojection {:.3f} ({:.3f}) px; colour to depth {:.2f} ({:.2f}) mm, {:.3f} "
        "({:.3f}) degrees\n",
        images, repeats, 100.0 * focal.mean(), 100.0 * focal.greatest, center.mean(),
        center.greatest, error.mean(), error.greatest, 1e3 * shift.mean(), 1e3 * shift.greatest,
        degrees(turn.mean()), degrees(turn.greatest));
  }
}

void print_walls(const char* name, const CameraToCalibrate& camera, const CameraModel& model) {
  fmt::print("    {:<14}", name);
  for (const double z : {0.5, 1.0, 1.5, 2.0}) {
    const WallErrors errors = wall_errors(camera, model, z);
    fmt::print("  {:.1f} m: {:.3f} %, warp {:.3f} %", z, 100.0 * errors.absolute,
               100.0 * errors.warp);
  }
  fmt::print("\n");
}

void measure_depth(int repeats) {
  for (const double bias : {0.01, 0.02, 0.03}) {
    for (int i = 0; i < repeats; ++i) {
      const auto seed = static_cast<std::uint64_t>(i) + 1;
      const CameraToCalibrate camera = simulated_camera(bias, seed);
      CameraModel model = found_intrinsics(camera, 30, 0.1, seed).camera;
      fmt::print("depth, bias {:.0f} % at 2 m, pattern {}, 10 views, errors of depth:\n",
                 100.0 * bias, seed);
      print_walls("lens only", camera, model);
      model.depth_correction = found_depth(camera, model, 10, false, seed).correction;
      print_walls("wall", camera, model);
      model.depth_correction = found_depth(camera, model, 10, true, seed).correction;
      print_walls("board on wall", camera, model);
      std::fflush(stdout);
    }
  }
}

void measure_time() {
  const CameraToCalibrate camera = simulated_camera(0.02, 1);
  CameraModel model{camera.intrinsics, camera.errors.lens(), {}, {}};
  model.depth_correction = found_depth(camera, model, 5, true, 1).correction;
  const FrameRectifier rectifier(model);
  DepthFrame frame;
  frame.depth.assign(camera.intrinsics.pixels(), 1.0F);
  constexpr int runs = 200;
  double best = 1.0;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    frame = rectifier.rectified(std::move(frame));
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    for (float& z : frame.depth) z = 1.0F + 1e-6F * static_cast<float>(&z - frame.depth.data());
  }
  fmt::print("undistort and correct a VGA frame: {:.2f} ms (best of {})\n", 1e3 * best, runs);
}

int run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.threads);
  if (arguments.wants("time")) measure_time();
  if (arguments.wants("intrinsics")) measure_intrinsics(arguments.repeats);
  if (arguments.wants("depth")) measure_depth(arguments.repeats);
  if (arguments.wants("objects"))
    measure_objects(arguments.sweeps, arguments.frames, arguments.pictures);
  return 0;
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Calibrates simulated depth cameras and shows what that is good for."};
  app.add_option("--part", arguments.part, "one measurement")
      ->check(CLI::IsMember({"all", "time", "intrinsics", "depth", "objects"}));
  app.add_option("--repeats", arguments.repeats, "seeds and patterns of the depth error")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--sweeps", arguments.sweeps, "sweeps with objects")->capture_default_str();
  app.add_option("--frames", arguments.frames, "frames of such a sweep")->capture_default_str();
  app.add_option("--pictures", arguments.pictures, "folder for pictures of the tabletop");
  app.add_option("--threads", arguments.threads, "bound on the threads, 0 for all cores");
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_calibration",
                                       [&] { return symscene::bench::run(arguments); });
}
