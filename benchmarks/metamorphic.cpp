// Which objects stay found where a scene is changed in a way that changes no object: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>

#include "core/random.hpp"
#include "moved_occupancy.hpp"
#include "program.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/simulation/simulation.hpp"

namespace symscene::bench {
namespace {

constexpr double min_overlap = 0.75;  // IoU with which an object stays found
constexpr double wanted = 0.95;       // share of objects
constexpr float same_place = 0.012F;  // from a point of the scene to one of the result [m]

struct Arguments {
  std::vector<std::filesystem::path> scenes;
  int simulated = 0;
  std::uint64_t seed = 1;
  std::size_t threads = 0;
};

/// A change of a scene.
struct Change {
  std::string name;
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  bool shuffled = false;
  double spacing = 0.0;  ///< voxel_size of the pipeline; 0: as it is [m]
};

std::vector<Change> changes() {
  std::vector<Change> all;
  const auto add = [&](const std::string& name, const Eigen::Affine3d& motion) {
    all.push_back({name, motion});
  };
  const Eigen::Affine3d here = Eigen::Affine3d::Identity();
  add("shift 0.7 mm", here * Eigen::Translation3d(0.0007, 0.0007, 0.0007));
  add("shift 2.5 mm", here * Eigen::Translation3d(0.0025, 0.0, 0.0));
  for (const double angle : {10.0, 30.0, 45.0, 90.0, 137.0})
    add(fmt::format("turn {:.0f} deg", angle),
        here * Eigen::AngleAxisd(radians(angle), Eigen::Vector3d::UnitZ()));
  add("turn any axis",
      here * Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.36, -0.48, 0.8).normalized()));
  add("mirror", here * Eigen::Scaling(-1.0, 1.0, 1.0));
  all.push_back({"order", here, true});
  // Occupancy reaches 163.8 m from the origin, and segmentation refuses what lies farther.
  add("+100 m", here * Eigen::Translation3d(100.0, 0.0, 0.0));
  for (const double spacing : {0.002, 0.003, 0.004, 0.006, 0.008})
    all.push_back({fmt::format("spacing {:.0f} mm", 1e3 * spacing), here, false, spacing});
  return all;
}

Plane moved(const Plane& plane, const Eigen::Affine3d& motion) {
  const Eigen::Vector3d normal = motion.linear() * plane.normal;  // turns and mirrors keep lengths
  return {normal, plane.offset - normal.dot(motion.translation())};
}

PointCloud shuffled(const PointCloud& cloud) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(cloud.size()));
  std::iota(order.begin(), order.end(), 0);
  Random random(1);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  PointCloud result = cloud;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto to = static_cast<Eigen::Index>(i);
    result.positions.row(to) = cloud.positions.row(order[i]);
    if (cloud.has_normals()) result.normals.row(to) = cloud.normals.row(order[i]);
    if (cloud.has_colors()) result.colors.row(to) = cloud.colors.row(order[i]);
  }
  return result;
}

Scene changed(const Scene& scene, const Change& change) {
  constexpr double margin = 0.3;
  Scene result = scene;
  result.cloud.positions = moved_points(scene.cloud.positions, change.motion);
  if (scene.cloud.has_normals()) {
    const Eigen::Affine3d turn(change.motion.linear());
    result.cloud.normals = moved_points(scene.cloud.normals, turn);
  }
  if (scene.table) result.table = moved(*scene.table, change.motion);
  if (scene.occupancy && !change.motion.isApprox(Eigen::Affine3d::Identity()))
    result.occupancy =
        moved_occupancy(*scene.occupancy, change.motion, result.cloud.positions, margin);
  if (change.shuffled) result.cloud = shuffled(result.cloud);
  return result;
}

/// Masks of the objects found in a changed scene, as indices into the cloud of the unchanged one.
std::vector<PointIndices> found_objects(const Scene& scene, const Change& change) {
  PipelineOptions options;
  if (change.spacing > 0.0) options.voxel_size = change.spacing;
  const SegmentationResult result = segment_scene(changed(scene, change), options);
  std::vector<std::size_t> owner(static_cast<std::size_t>(result.cloud.size()),
                                 result.objects.size());
  for (std::size_t k = 0; k < result.objects.size(); ++k)
    for (const Index point : result.objects[k].points) owner[point] = k;
  const CellList nearby(moved_points(result.cloud.positions, change.motion.inverse()), same_place);
  std::vector<PointIndices> masks(result.objects.size());
  for (Index i = 0; i < scene.cloud.size(); ++i) {
    const Index nearest = nearby.nearest(scene.cloud.position(i), same_place).first;
    if (nearest < owner.size() && owner[nearest] < masks.size()) masks[owner[nearest]].push_back(i);
  }
  return masks;
}

struct Share {
  std::size_t kept = 0, of = 0;

  Share& operator+=(const Share& other) {
    kept += other.kept;
    of += other.of;
    return *this;
  }
};

Share share_kept(const std::vector<PointIndices>& before, const std::vector<PointIndices>& after) {
  const auto is_kept = [&](const PointIndices& mask) {
    return std::any_of(after.begin(), after.end(), [&](const PointIndices& other) {
      return intersection_over_union(mask, other) > min_overlap;
    });
  };
  const auto kept = std::count_if(before.begin(), before.end(), is_kept);
  return {static_cast<std::size_t>(kept), before.size()};
}

/// Shares by change, with occupancy and without.
using Table = std::vector<std::array<Share, 2>>;

void add_scene(const std::string& name, Scene scene, Table& table) {
  const std::vector<Change> all = changes();
  for (const bool with_occupancy : {true, false}) {
    if (!with_occupancy) scene.occupancy.reset();
    if (with_occupancy && !scene.occupancy) continue;
    const std::vector<PointIndices> before = found_objects(scene, {"as it is"});
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Share share = share_kept(before, found_objects(scene, all[k]));
      table[k][with_occupancy ? 0 : 1] += share;
      fmt::print(stderr, "{} {} {}: {} of {}\n", name, with_occupancy ? "with" : "without",
                 all[k].name, share.kept, share.of);
    }
  }
}

std::string cell(const Share& share) {
  if (share.of == 0) return "-";
  const double kept = static_cast<double>(share.kept) / static_cast<double>(share.of);
  return fmt::format("{} of {} ({:.0f} %){}", share.kept, share.of, 100.0 * kept,
                     kept < wanted ? " *" : "");
}

int run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.threads);
  const std::vector<Change> all = changes();
  Table table(all.size());
  for (const auto& path : arguments.scenes)
    add_scene(path.filename().string(), read_scene(path), table);
  for (int i = 0; i < arguments.simulated; ++i) {
    SimulationOptions options;
    options.tabletop.seed = arguments.seed + static_cast<std::uint64_t>(i);
    options.tabletop.objects = 6;
    add_scene(fmt::format("seed {}", options.tabletop.seed), simulate_tabletop(options).scene,
              table);
  }
  fmt::print("{:16} {:24} {:24}\n", "change", "with occupancy", "without");
  for (std::size_t k = 0; k < all.size(); ++k)
    fmt::print("{:16} {:24} {:24}\n", all[k].name, cell(table[k][0]), cell(table[k][1]));
  fmt::print("* below {:.0f} %\n", 100.0 * wanted);
  return 0;
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Tells which objects stay found where a scene is moved, mirrored or resampled."};
  app.add_option("scenes", arguments.scenes, "scene folders")->check(CLI::ExistingDirectory);
  app.add_option("--simulated", arguments.simulated, "number of simulated scenes of 6 objects")
      ->check(CLI::Range(0, 1000));
  app.add_option("--seed", arguments.seed, "seed of the first of them")->capture_default_str();
  app.add_option("--threads", arguments.threads, "bound on the threads, 0 for all cores");
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_metamorphic",
                                       [&] { return symscene::bench::run(arguments); });
}
