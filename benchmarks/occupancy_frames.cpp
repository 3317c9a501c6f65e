#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include <fmt/format.h>
#ifdef SYMSCENE_WITH_OCTOMAP
#include <octomap/OcTree.h>
#endif

#include "stopwatch.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"
#include "symscene/simulation/simulation.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::uint64_t seed = 2000;
  int objects = 6;
  int frames = 20;
  int baseline_frames = 3;  ///< OctoMap takes seconds per frame
  int repeat = 5;
  double max_depth = 3.0;
  double free_margin = 0.006;
};

/// The frames of a simulated scan, as read from a sequence.
struct Scan {
  CameraIntrinsics camera;
  std::vector<DepthFrame> frames;
  std::vector<Eigen::Isometry3d> poses;
  Box box;  ///< around the objects, where labels are compared [m]
};

Scan simulate(const Arguments& arguments) {
  SimulationOptions options;
  options.tabletop.seed = arguments.seed;
  options.tabletop.objects = arguments.objects;
  options.camera.frames = arguments.frames;
  const Tabletop tabletop = arrange_tabletop(options.tabletop);
  Scan scan;
  scan.camera = options.camera.intrinsics();
  for (SensorFrame& frame : capture_frames(tabletop, options)) {
    scan.poses.push_back(frame.T_world_camera);
    scan.frames.push_back({0.0, std::move(frame.depth), {}});
  }
  scan.box.min = {-0.6F, -0.6F, -0.1F};
  scan.box.max = {0.6F, 0.6F, 0.6F};
  return scan;
}

void print_time(const std::string& what, const Seconds& frame) {
  fmt::print("{:<24}{:8.1f} ms per frame, {:8.1f} ms of processor time\n", what, 1e3 * frame.wall,
             1e3 * frame.processor);
}

OccupancyVolumeOptions volume_options(const Arguments& arguments) {
  OccupancyVolumeOptions options;
  options.max_depth = arguments.max_depth;
  options.free_margin = arguments.free_margin;
  return options;
}

OccupancyVolume integrate(const Scan& scan, std::size_t frames, const Arguments& arguments) {
  OccupancyVolume volume(volume_options(arguments));
  for (std::size_t i = 0; i < frames; ++i) {
    volume.integrate(scan.frames[i], scan.camera, scan.poses[i]);
  }
  return volume;
}

/// Time per frame: the median over repeated scans, each into an empty volume.
Seconds time_ours(const Scan& scan, std::size_t threads, const Arguments& arguments) {
  const ThreadLimit limit(threads);
  std::vector<double> wall;
  std::vector<double> processor;
  for (int run = 0; run < arguments.repeat; ++run) {
    const Seconds scan_time = seconds([&] { integrate(scan, scan.frames.size(), arguments); });
    wall.push_back(scan_time.wall);
    processor.push_back(scan_time.processor);
  }
  const auto median_per_frame = [&](std::vector<double>& runs) {
    std::sort(runs.begin(), runs.end());
    return runs[runs.size() / 2] / static_cast<double>(scan.frames.size());
  };
  return {median_per_frame(wall), median_per_frame(processor)};
}

#ifdef SYMSCENE_WITH_OCTOMAP
octomap::Pointcloud world_points(const Scan& scan, std::size_t frame) {
  octomap::Pointcloud points;
  for (Index v = 0; v < scan.camera.height; ++v) {
    for (Index u = 0; u < scan.camera.width; ++u) {
      const double depth = scan.frames[frame].depth[std::size_t{v} * scan.camera.width + u];
      if (!(depth > 0.0)) continue;
      const Eigen::Vector3f p = (scan.poses[frame] * (depth * scan.camera.ray(u, v))).cast<float>();
      points.push_back(p.x(), p.y(), p.z());
    }
  }
  return points;
}

OccupancyMap labels_of(const octomap::OcTree& tree) {
  OccupancyMap map;
  map.resolution = tree.getResolution();
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const octomap::OcTreeKey key = leaf.getIndexKey();
    map.leaves.push_back(
        {{key[0], key[1], key[2]},
         static_cast<std::uint8_t>(octree_depth - static_cast<int>(leaf.getDepth())),
         tree.isNodeOccupied(*leaf) ? VoxelState::occupied : VoxelState::free});
  }
  return map;
}

/// Counts of voxels by OctoMap's label (row) and ours (column).
void print_agreement(const OccupancyMap& theirs, const OccupancyMap& ours, const Box& box) {
  const OccupancyGrid a = rasterize(theirs, box);
  const OccupancyGrid b = rasterize(ours, box);
  std::size_t counts[3][3] = {};
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    ++counts[static_cast<int>(a.states[i])][static_cast<int>(b.states[i])];
    equal += a.states[i] == b.states[i] ? 1 : 0;
  }
  constexpr const char* names[] = {"never seen", "free", "occupied"};
  fmt::print("\n{:<22} | {:>12} | {:>12} | {:>12}\n", "OctoMap \\ ours", names[0], names[1],
             names[2]);
  for (int row = 0; row < 3; ++row) {
    fmt::print("{:<22} | {:>12} | {:>12} | {:>12}\n", names[row], counts[row][0], counts[row][1],
               counts[row][2]);
  }
  fmt::print("equal labels {:.2f} % of {} voxels\n",
             100.0 * static_cast<double>(equal) / static_cast<double>(a.states.size()),
             a.states.size());
}

void compare_with_octomap(const Scan& scan, const Arguments& arguments, const Seconds& one,
                          const Seconds& two) {
  octomap::OcTree tree(volume_options(arguments).resolution);
  const auto frames =
      std::min(scan.frames.size(), static_cast<std::size_t>(arguments.baseline_frames));
  Seconds theirs;
  for (std::size_t i = 0; i < frames; ++i) {
    const octomap::Pointcloud points = world_points(scan, i);
    const Eigen::Vector3f origin = scan.poses[i].translation().cast<float>();
    const Seconds frame = seconds([&] {
      tree.insertPointCloud(points, {origin.x(), origin.y(), origin.z()}, arguments.max_depth);
    });
    theirs.wall += frame.wall / static_cast<double>(frames);
    theirs.processor += frame.processor / static_cast<double>(frames);
  }
  print_time("OctoMap, all pixels", theirs);
  fmt::print(
      "ours on 2 threads is {:.0f} times as fast; on 1 it takes 1/{:.0f} of the processor time\n",
      theirs.wall / two.wall, theirs.processor / one.processor);
  print_agreement(labels_of(tree), integrate(scan, frames, arguments).map(), scan.box);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Occupancy of depth frames: time, memory, and agreement with OctoMap");
  app.add_option("--seed", arguments.seed, "seed of the simulated table")->capture_default_str();
  app.add_option("--objects", arguments.objects, "objects on it")->capture_default_str();
  app.add_option("--frames", arguments.frames, "frames of the scan")->capture_default_str();
  app.add_option("--baseline-frames", arguments.baseline_frames, "frames that OctoMap inserts")
      ->capture_default_str();
  app.add_option("--repeat", arguments.repeat, "scans that are timed")->capture_default_str();
  app.add_option("--max-depth", arguments.max_depth, "largest depth that is used [m]")
      ->capture_default_str();
  app.add_option("--free-margin", arguments.free_margin, "see OccupancyVolumeOptions [m]")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const Scan scan = simulate(arguments);
  const Seconds one = time_ours(scan, 1, arguments);
  const Seconds two = time_ours(scan, 2, arguments);
  const OccupancyVolume volume = integrate(scan, scan.frames.size(), arguments);
  OccupancyMap map;
  const Seconds to_map = seconds([&] { map = volume.map(); });
  fmt::print("{} frames of {} x {}, seed {}, {} objects, up to {} m\n", scan.frames.size(),
             scan.camera.width, scan.camera.height, arguments.seed, arguments.objects,
             arguments.max_depth);
  print_time("ours, 1 thread", one);
  print_time("ours, 2 threads", two);
  fmt::print("ours, memory            {:8.1f} MB; {} leaves in {:.1f} ms\n",
             1e-6 * static_cast<double>(volume.memory()), map.leaves.size(), 1e3 * to_map.wall);
#ifdef SYMSCENE_WITH_OCTOMAP
  if (arguments.baseline_frames > 0) compare_with_octomap(scan, arguments, one, two);
#else
  fmt::print("OctoMap was not found when this was built\n");
#endif
}
