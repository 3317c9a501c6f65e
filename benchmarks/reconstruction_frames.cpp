#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "core/median.hpp"
#include "reconstruction/model_view.hpp"
#include "stopwatch.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/simulation/sweep.hpp"
#ifdef SYMSCENE_WITH_OPEN3D
#include "voxel_block_grid.hpp"
#endif

namespace {

using namespace symscene;

struct Arguments {
  std::uint64_t seed = 2000;
  int objects = 6;
  int frames = 60;
  int baseline_frames = 20;  ///< Open3D takes a fraction of a second per frame
  int repeat = 3;
  std::vector<std::size_t> threads = {1, 2};
  std::vector<int> block_resolutions = {8, 16};
  double voxel_size = 0.0031;
};

/// The depth frames of a hand-held camera, with and without sensor noise.
struct Sweep {
  CameraIntrinsics camera;
  std::vector<DepthFrame> frames;
  std::vector<DepthFrame> exact;
  std::vector<Eigen::Isometry3d> poses;
};

Sweep simulate(const Arguments& arguments) {
  SweepOptions options;
  options.tabletop.seed = arguments.seed;
  options.tabletop.objects = arguments.objects;
  // The camera speed of a full sweep.
  options.camera.arc *= static_cast<double>(arguments.frames) / options.camera.frames;
  options.camera.frames = arguments.frames;
  const Tabletop tabletop = arrange_tabletop(options.tabletop);
  Sweep sweep;
  sweep.camera = options.camera.intrinsics();
  capture_sweep(tabletop, options, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
    sweep.frames.push_back({frame.time, frame.depth, {}});
    sweep.poses.push_back(pose);
  });
  options.sensor.enabled = false;
  capture_sweep(tabletop, options, [&](const DepthFrame& frame, const Eigen::Isometry3d&) {
    sweep.exact.push_back({frame.time, frame.depth, {}});
  });
  return sweep;
}

ReconstructionOptions reconstruction_options(const Arguments& arguments) {
  ReconstructionOptions options;
  options.tsdf.voxel_size = arguments.voxel_size;
  options.tsdf.truncation = std::max(options.tsdf.truncation, 4 * arguments.voxel_size);
  options.tsdf.max_truncation = std::max(options.tsdf.max_truncation, options.tsdf.truncation);
  return options;
}

/// The frames that both fuse.
std::size_t shared_frames(const Sweep& sweep, const Arguments& arguments) {
  return std::min(sweep.frames.size(), static_cast<std::size_t>(arguments.baseline_frames));
}

/// Times of the frames of all repeats.
using Times = std::vector<Seconds>;

/// Times of tracked frames, all but the first.
struct TrackingTimes {
  Times whole;
  Times without_space;  ///< without the map of free and occupied space
  std::map<std::string, std::vector<double>> stages;
  std::size_t lost = 0;
  double drift = 0.0;  ///< of the camera at the end [m]
};

/// Times of frames with known poses.
struct FusionTimes {
  Times prepare;
  Times integrate;
  Times fuse;  ///< both
  Times view;
  std::vector<std::vector<float>> views;  ///< depths of the first repeat [m]
  std::size_t bytes = 0;
};

/// The times with one number of threads.
struct Measurements {
  TrackingTimes tracking;
  FusionTimes ours;
  std::map<int, FusionTimes> baselines;  ///< by block resolution
};

double add_stage_times(const std::vector<StageTime>& before, const std::vector<StageTime>& after,
                       TrackingTimes& times) {
  for (std::size_t i = 0; i < after.size(); ++i) {
    times.stages[after[i].stage].push_back(after[i].seconds - before[i].seconds);
  }
  return times.stages["map space"].back();
}

void time_tracking(const Sweep& sweep, const ReconstructionOptions& options, TrackingTimes& times) {
  Reconstruction reconstruction(sweep.camera, options);
  OccupancyVolume space(options.occupancy);  // a second one, to time its share of processor time
  Eigen::Isometry3d pose = sweep.poses.front();
  reconstruction.add(sweep.frames.front(), pose);
  space.integrate(sweep.frames.front(), sweep.camera, pose);
  for (std::size_t i = 1; i < sweep.frames.size(); ++i) {
    const std::vector<StageTime> before = reconstruction.times();
    FrameReport report;
    const Seconds whole = seconds([&] { report = reconstruction.add(sweep.frames[i]); });
    if (!report.fused) {
      ++times.lost;
      continue;
    }
    pose = report.tracking.T_world_camera;
    const Seconds apart = seconds([&] { space.integrate(sweep.frames[i], sweep.camera, pose); });
    const double space_wall = add_stage_times(before, reconstruction.times(), times);
    times.whole.push_back(whole);
    times.without_space.push_back(whole - Seconds{space_wall, apart.processor});
  }
  times.drift = (pose.translation() - sweep.poses.back().translation()).norm();
}

std::vector<float> depth_of(const SurfaceImage& image) {
  std::vector<float> depth;
  depth.reserve(image.pixels.size());
  for (const SurfacePixel& pixel : image.pixels) depth.push_back(pixel.depth);
  return depth;
}

void time_fusion(const Sweep& sweep, std::size_t frames, const ReconstructionOptions& options,
                 FusionTimes& times) {
  TsdfVolume volume(options.tsdf, options.measurement);
  const bool is_first = times.views.empty();
  for (std::size_t i = 0; i < frames; ++i) {
    Measurement measurement;
    const Seconds prepare = seconds([&] {
      measurement = prepare_measurement(sweep.frames[i], sweep.camera, options.measurement);
    });
    const Seconds integrate = seconds([&] { volume.integrate(measurement, sweep.poses[i]); });
    ModelView view;
    times.view.push_back(
        seconds([&] { view = cast_model_view(volume, sweep.camera, sweep.poses[i]); }));
    times.prepare.push_back(prepare);
    times.integrate.push_back(integrate);
    times.fuse.push_back(prepare + integrate);
    if (is_first) times.views.push_back(depth_of(view.image));
  }
  times.bytes = volume.bytes();
}

#ifdef SYMSCENE_WITH_OPEN3D
void time_baseline(const Sweep& sweep, std::size_t frames, const ReconstructionOptions& options,
                   int block_resolution, FusionTimes& times) {
  VoxelBlockGrid grid({.voxel_size = options.tsdf.voxel_size,
                       .block_resolution = block_resolution,
                       .truncation = options.tsdf.truncation,
                       .min_depth = options.measurement.min_depth,
                       .max_depth = options.measurement.max_depth});
  const bool is_first = times.views.empty();
  for (std::size_t i = 0; i < frames; ++i) {
    grid.set_frame(sweep.frames[i], sweep.camera, sweep.poses[i]);
    times.fuse.push_back(seconds([&] { grid.integrate(); }));
    times.view.push_back(seconds([&] { grid.cast_view(); }));
    if (is_first) times.views.push_back(grid.view_depth());
  }
  times.bytes = grid.bytes();
}
#endif

void measure(const Sweep& sweep, std::size_t threads, const Arguments& arguments,
             Measurements& measurements) {
  const ThreadLimit limit(threads);
  const ReconstructionOptions options = reconstruction_options(arguments);
  const std::size_t frames = shared_frames(sweep, arguments);
  time_tracking(sweep, options, measurements.tracking);
  time_fusion(sweep, frames, options, measurements.ours);
#ifdef SYMSCENE_WITH_OPEN3D
  VoxelBlockGrid::limit_threads(threads);
  for (const int resolution : arguments.block_resolutions) {
    time_baseline(sweep, frames, options, resolution, measurements.baselines[resolution]);
  }
#endif
}

/// Medians, and the 10th percentile of the wall time, which is close to the wall time on an idle
/// machine.
struct Summary {
  double wall = 0.0;
  double quiet = 0.0;
  double processor = 0.0;
};

Summary summary(const Times& times) {
  std::vector<double> wall, processor;
  for (const Seconds& time : times) {
    wall.push_back(time.wall);
    processor.push_back(time.processor);
  }
  return {quantile(wall, 0.5).value_or(0.0), quantile(wall, 0.1).value_or(0.0),
          quantile(processor, 0.5).value_or(0.0)};
}

Times sums(const Times& a, const Times& b) {
  Times both;
  for (std::size_t i = 0; i < a.size(); ++i) both.push_back(a[i] + b[i]);
  return both;
}

void print_row(const std::string& what, const Times& times, bool with_rate = false) {
  const Summary time = summary(times);
  const std::string rate =
      fmt::format("   {:.1f} frames a second, quiet {:.1f}", 1.0 / time.wall, 1.0 / time.quiet);
  fmt::print("  {:<36}{:>10.2f}{:>10.2f}{:>12.2f}{}\n", what, 1e3 * time.wall, 1e3 * time.quiet,
             1e3 * time.processor, with_rate ? rate : "");
}

void print_tracking(const TrackingTimes& times) {
  print_row("tracked frame", times.whole, true);
  for (const char* stage : {"prepare", "track", "fuse", "map space", "predict view"}) {
    const auto found = times.stages.find(stage);
    if (found == times.stages.end()) continue;
    fmt::print("    {:<34}{:>10.2f}{:>10.2f}\n", stage,
               1e3 * quantile(found->second, 0.5).value_or(0.0),
               1e3 * quantile(found->second, 0.1).value_or(0.0));
  }
  print_row("tracked frame without \"map space\"", times.without_space, true);
  fmt::print("    {} frames lost; {:.1f} mm off after the last\n", times.lost, 1e3 * times.drift);
}

void print_fusion(const FusionTimes& times) {
  print_row("prepare, poses given", times.prepare);
  print_row("integrate, poses given", times.integrate);
  print_row("both", times.fuse);
  print_row("view of the image's size", times.view);
}

/// The speed-up by each of the clocks.
void print_ratio(const std::string& what, const Times& theirs, const Times& ours) {
  const Summary a = summary(theirs), b = summary(ours);
  fmt::print("    {:<34}{:>9.1f}x{:>9.1f}x{:>11.1f}x\n", what, a.wall / b.wall, a.quiet / b.quiet,
             a.processor / b.processor);
}

void print_baseline(int resolution, const FusionTimes& theirs, const FusionTimes& ours) {
  print_row(fmt::format("Open3D, blocks of {}: integrate", resolution), theirs.fuse);
  print_row(fmt::format("Open3D, blocks of {}: view", resolution), theirs.view);
  print_ratio("integration alone", theirs.fuse, ours.integrate);
  print_ratio("with prepare", theirs.fuse, ours.fuse);
  print_ratio("view", theirs.view, ours.view);
  print_ratio("with prepare, and view", sums(theirs.fuse, theirs.view), sums(ours.fuse, ours.view));
}

void print_times(std::size_t threads, const Measurements& measurements) {
  fmt::print("\n{:<38}{:>10}{:>10}{:>12}\n",
             fmt::format("{} thread{} [ms a frame]", threads, threads == 1 ? "" : "s"), "wall",
             "quiet", "processor");
  print_tracking(measurements.tracking);
  print_fusion(measurements.ours);
  for (const auto& [resolution, theirs] : measurements.baselines) {
    print_baseline(resolution, theirs, measurements.ours);
  }
}

/// The difference of two depth images over the pixels that both have.
struct Agreement {
  double median_difference = 0.0;  ///< [m]
  double covered = 0.0;  ///< share of the pixels of the second image that the first has too
};

Agreement agreement(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<double> differences;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(b[i] > 0.0F)) continue;
    ++seen;
    if (a[i] > 0.0F) differences.push_back(std::abs(a[i] - b[i]));
  }
  const auto both = static_cast<double>(differences.size());
  return {quantile(std::move(differences), 0.5).value_or(0.0),
          both / static_cast<double>(std::max<std::size_t>(seen, 1))};
}

/// Medians over the views of all frames.
template <class ImageOf>
void print_agreement(const std::string& what, const FusionTimes& times, const ImageOf& image_of) {
  std::vector<double> difference, covered;
  for (std::size_t i = 0; i < times.views.size(); ++i) {
    const Agreement frame = agreement(times.views[i], image_of(i));
    difference.push_back(frame.median_difference);
    covered.push_back(frame.covered);
  }
  fmt::print("  {:<36}{:>10.2f}{:>10.1f}\n", what,
             1e3 * quantile(std::move(difference), 0.5).value_or(0.0),
             100 * quantile(std::move(covered), 0.5).value_or(0.0));
}

/// Checks that all views agree.
void print_views(const Sweep& sweep, const Measurements& measurements) {
  const auto exact = [&](std::size_t i) { return sweep.exact[i].depth; };
  const auto ours = [&](std::size_t i) { return measurements.ours.views[i]; };
  fmt::print("\n{:<38}{:>10}{:>10}\n", "views: depth difference, coverage", "[mm]", "[%]");
  print_agreement("ours and exact depth", measurements.ours, exact);
  for (const auto& [resolution, theirs] : measurements.baselines) {
    print_agreement(fmt::format("Open3D, blocks of {}, and exact depth", resolution), theirs,
                    exact);
    print_agreement(fmt::format("Open3D, blocks of {}, and ours", resolution), theirs, ours);
  }
  fmt::print("\nmemory after {} frames: ours {:.0f} MB", measurements.ours.views.size(),
             1e-6 * static_cast<double>(measurements.ours.bytes));
  for (const auto& [resolution, theirs] : measurements.baselines) {
    fmt::print(", Open3D with blocks of {} {:.0f} MB", resolution,
               1e-6 * static_cast<double>(theirs.bytes));
  }
  fmt::print("\n");
}

void add_options(CLI::App& app, Arguments& arguments) {
  const auto add = [&](const char* name, auto& value, const char* description) {
    return app.add_option(name, value, description)->capture_default_str();
  };
  add("--seed", arguments.seed, "seed of the simulated table");
  add("--objects", arguments.objects, "objects on it");
  add("--frames", arguments.frames, "frames of the sweep")->check(CLI::Range(2, 1000));
  add("--baseline-frames", arguments.baseline_frames,
      "frames that are fused with their poses, by both")
      ->check(CLI::Range(1, 1000));
  add("--repeat", arguments.repeat, "sweeps that are timed, each from an empty volume")
      ->check(CLI::Range(1, 1000));
  add("--threads", arguments.threads, "numbers of threads")->check(CLI::Range(1, 1024));
  add("--block-resolution", arguments.block_resolutions, "voxels along an edge of Open3D's blocks")
      ->check(CLI::Range(1, 64));
  add("--voxel-size", arguments.voxel_size, "edge of a voxel [m]");
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Track, fuse and view depth frames: time a frame, and times as fast as Open3D");
  add_options(app, arguments);
  CLI11_PARSE(app, argc, argv);
  const Sweep sweep = simulate(arguments);
  std::map<std::size_t, Measurements> measurements;
  for (int run = 0; run < arguments.repeat; ++run) {
    for (const std::size_t threads : arguments.threads) {
      measure(sweep, threads, arguments, measurements[threads]);
    }
  }
  const TsdfOptions tsdf = reconstruction_options(arguments).tsdf;
  fmt::print("{} frames of {} x {}, seed {}, {} objects, voxels of {} mm, truncation {} mm\n",
             sweep.frames.size(), sweep.camera.width, sweep.camera.height, arguments.seed,
             arguments.objects, 1e3 * tsdf.voxel_size, 1e3 * tsdf.truncation);
  for (const auto& [threads, measured] : measurements) print_times(threads, measured);
  print_views(sweep, measurements.begin()->second);
#ifndef SYMSCENE_WITH_OPEN3D
  fmt::print("Open3D was not found when this was built\n");
#endif
}
