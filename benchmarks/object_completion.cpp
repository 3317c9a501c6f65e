// Closed surfaces of objects against their true meshes: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "core/median.hpp"
#include "core/rigid_motion.hpp"
#include "core/surface_sampling.hpp"
#include "core/voxel_sampling.hpp"
#include "program.hpp"
#include "simulated_sweeps.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/dataset/swept_scene.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::bench {
namespace {

constexpr double spacing = 0.005;            // at which surfaces are compared as points [m]
constexpr std::size_t true_samples = 40000;  // of a true mesh
constexpr std::size_t mesh_samples = 40000;  // of a closed surface, before it is thinned
constexpr double min_overlap = 0.75;         // of a mask whose object is compared

constexpr double max_path_error = 0.01;  // of a sweep that is used [m]

struct Arguments {
  SweepArguments sweeps{.sweeps = 8, .frames = 60, .min_objects = 2, .max_objects = 10};
  bool exact = false;
  std::filesystem::path cache;
  bool list = false;
};

/// A scene, its ground truth, and the mesh of each true object in the scene's frame.
struct MeshedScene {
  Scene scene;
  SceneTruth truth;
  std::vector<TriangleMesh> meshes;
};

void place_meshes(MeshedScene& meshed) {
  for (std::size_t k = 0; k < meshed.meshes.size(); ++k)
    meshed.meshes[k] = transformed(meshed.meshes[k], *meshed.truth.objects[k].T_world_mesh);
}

MeshedScene make_scene(const Arguments& arguments, const std::vector<ObjectModel>& models, int i) {
  const SweepOptions options = arguments.sweeps.options(i);
  const Tabletop tabletop = table_of(options, models);
  SweptSceneOptions making;
  making.poses = arguments.exact ? "exact" : "tracked";
  SweptScene swept = reconstruct_sweep(tabletop, options, making);
  if (swept.trajectory.absolute > max_path_error) swept = {};  // not what completion is about
  MeshedScene meshed{std::move(swept.scene), std::move(swept.truth), {}};
  const std::vector<std::string> names = mesh_names(tabletop);
  for (const TrueObject& object : meshed.truth.objects) {
    const auto at = std::find(names.begin(), names.end(), object.mesh) - names.begin();
    meshed.meshes.push_back(tabletop.objects[static_cast<std::size_t>(at)].object.mesh);
  }
  return meshed;
}

/// A sweep's scene, made or read from the cache. The meshes are placed.
MeshedScene scene_of(const Arguments& arguments, const std::vector<ObjectModel>& models, int i) {
  const std::filesystem::path folder =
      arguments.cache /
      fmt::format("{}{}", models.empty() ? "seed" : "dropped", arguments.sweeps.seed_of(i));
  MeshedScene meshed;
  if (!arguments.cache.empty() && std::filesystem::exists(folder / "scene" / "truth.json")) {
    meshed.scene = read_scene(folder / "scene");
    meshed.truth = read_truth(folder / "scene" / "truth.json", meshed.scene.cloud.size());
    meshed.meshes = read_truth_meshes(folder, meshed.truth);
  } else {
    meshed = make_scene(arguments, models, i);
    if (meshed.scene.cloud.empty()) return {};
    if (!arguments.cache.empty()) {
      std::filesystem::create_directories(folder / "meshes");
      for (std::size_t k = 0; k < meshed.meshes.size(); ++k)
        write_mesh(folder / "meshes" / (meshed.truth.objects[k].mesh + ".ply"), meshed.meshes[k]);
      write_scene(folder / "scene", meshed.scene, {.truth_json = format_truth(meshed.truth)});
    }
  }
  place_meshes(meshed);
  return meshed;
}

/// Mean distance of points from their nearest of `cells`. [m]
double mean_distance(const Points& points, const CellList& cells) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3f query = points.row(i).transpose();
    for (const float radius : {0.01F, 0.04F, 1.0F}) {
      const auto [index, squared] = cells.nearest(query, radius);
      if (index == CellList::none) continue;
      sum += std::sqrt(double{squared});
      break;
    }
  }
  return sum / static_cast<double>(std::max<Eigen::Index>(1, points.rows()));
}

/// The mean of both directed mean distances between point sets. [m]
double chamfer_distance(const Points& found, const Points& truth) {
  return 0.5 * (mean_distance(found, CellList(truth, 0.01F)) +
                mean_distance(truth, CellList(found, 0.01F)));
}

/// An object, observed only and completed.
struct Comparison {
  std::string name, kind;
  double chamfer_observed = 0.0, chamfer_closed = 0.0;  ///< [m]
  double volume_observed = 0.0, volume_closed = 0.0;    ///< relative errors
  double signed_volume = 0.0;                           ///< of the closed surface

  bool improves() const { return chamfer_closed < chamfer_observed; }
  bool worsens() const { return chamfer_closed > 1.1 * chamfer_observed; }
};

const char* kind_of(const SceneObject& object) {
  return !object.rotational.empty() ? "axis" : !object.reflectional.empty() ? "plane" : "none";
}

/// The volume of the observed points alone, closed by their convex hull. [m³]
double observed_volume(const PointCloud& observed) {
  const PointCloud nothing;
  const std::vector<ObjectAxis> no_axes;
  const std::vector<ObjectPlane> no_planes;
  const std::optional<Plane> no_table;
  const DistanceField unknown =
      unknown_distance_field(bounding_box(observed.positions), 0.005F, std::nullopt);
  return solid_properties(
             object_surface({observed, nothing, no_axes, no_planes}, {unknown, no_table}).mesh)
      .volume;
}

Comparison compare(const SegmentationResult& result, std::size_t id, const TrueObject& truth,
                   const TriangleMesh& mesh) {
  const SceneObject& object = result.objects[id];
  const PointCloud observed = select(result.cloud, object.points);
  const Points target =
      voxel_downsample(sample_surface(mesh, true_samples), 0.5 * spacing).positions;
  Comparison compared{truth.name, kind_of(object)};
  compared.chamfer_observed = chamfer_distance(observed.positions, target);
  const TriangleMesh& closed = result.surfaces[id].mesh;
  if (closed.triangles.rows() != 0) {
    compared.chamfer_closed = chamfer_distance(
        voxel_downsample(sample_surface(closed, mesh_samples), spacing).positions, target);
  } else {
    compared.chamfer_closed = 1.0;
  }
  const double true_volume = solid_properties(mesh).volume;
  const double volume = object.solid ? object.solid->volume : 0.0;
  compared.signed_volume = volume / true_volume - 1.0;
  compared.volume_closed = std::abs(compared.signed_volume);
  compared.volume_observed = std::abs(observed_volume(observed) / true_volume - 1.0);
  return compared;
}

std::vector<Comparison> compare_scene(const MeshedScene& meshed) {
  if (meshed.scene.cloud.empty()) return {};
  const SegmentationResult result = segment_scene(meshed.scene);
  const std::vector<PointIndices> masks =
      transfer_masks(meshed.scene.cloud, meshed.truth, result.cloud);
  std::vector<Comparison> compared;
  for (std::size_t k = 0; k < masks.size(); ++k) {
    for (std::size_t id = 0; id < result.objects.size(); ++id) {
      if (intersection_over_union(masks[k], result.objects[id].points) <= min_overlap) continue;
      compared.push_back(compare(result, id, meshed.truth.objects[k], meshed.meshes[k]));
    }
  }
  return compared;
}

template <class Value>
double median_over(const std::vector<Comparison>& compared, Value Comparison::*field) {
  std::vector<double> values;
  for (const Comparison& object : compared) values.push_back(object.*field);
  return median(std::move(values)).value_or(0.0);
}

std::string summary_row(const std::string& name, const std::vector<Comparison>& compared) {
  if (compared.empty()) return "";
  double observed = 0.0, closed = 0.0;
  std::size_t improved = 0, worse = 0;
  for (const Comparison& object : compared) {
    observed += object.chamfer_observed;
    closed += object.chamfer_closed;
    improved += object.improves() ? 1 : 0;
    worse += object.worsens() ? 1 : 0;
  }
  const auto count = static_cast<double>(compared.size());
  return fmt::format(
      "{:12} {:4} | {:5.2f} -> {:5.2f} | {:5.2f} -> {:5.2f} | {:4.0f} % | {:3} | {:5.1f} -> "
      "{:5.1f} %\n",
      name, compared.size(), 1e3 * observed / count, 1e3 * closed / count,
      1e3 * median_over(compared, &Comparison::chamfer_observed),
      1e3 * median_over(compared, &Comparison::chamfer_closed),
      100.0 * static_cast<double>(improved) / count, worse,
      100.0 * median_over(compared, &Comparison::volume_observed),
      100.0 * median_over(compared, &Comparison::volume_closed));
}

void print_tables(const std::vector<Comparison>& compared) {
  std::map<std::string, std::vector<Comparison>> kinds, names;
  for (const Comparison& object : compared) {
    kinds[object.kind].push_back(object);
    names[object.name].push_back(object);
  }
  fmt::print("\nmm; Chamfer distance, observed -> closed\n");
  fmt::print("{:12} {:>4} | {:14} | {:14} | {:6} | {} | {}\n", "", "n", "mean", "median", "better",
             "worse by 10 %", "median volume error");
  for (const auto& [kind, group] : kinds) fmt::print("{}", summary_row(kind, group));
  fmt::print("{}\n", summary_row("all", compared));
  for (const auto& [name, group] : names) fmt::print("{}", summary_row(name.substr(0, 12), group));
}

void run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.sweeps.threads);
  const ModelFolder folder = arguments.sweeps.models();
  std::vector<Comparison> all;
  for (int i = 0; i < arguments.sweeps.sweeps; ++i) {
    for (const Comparison& object : compare_scene(scene_of(arguments, folder.models, i))) {
      all.push_back(object);
      if (!arguments.list) continue;
      fmt::print("{:3} {:28} {:5} {:6.2f} -> {:6.2f} mm  volume {:6.1f} -> {:+6.1f} %{}\n", i,
                 object.name, object.kind, 1e3 * object.chamfer_observed,
                 1e3 * object.chamfer_closed, 100.0 * object.volume_observed,
                 100.0 * object.signed_volume, object.worsens() ? "  worse" : "");
      std::fflush(stdout);
    }
  }
  print_tables(all);
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Closed surfaces of the objects of simulated sweeps against their true meshes."};
  arguments.sweeps.add_to(app);
  app.add_flag("--exact", arguments.exact, "exact poses, for frames too far apart for tracking");
  app.add_option("--cache", arguments.cache, "folder that keeps the scenes; one per setting");
  app.add_flag("--list", arguments.list, "print a line per object");
  CLI11_PARSE(app, argc, argv);
  arguments.sweeps.complete();
  return symscene::bench::exit_code_of("symscene_bench_completion", [&] {
    symscene::bench::run(arguments);
    return 0;
  });
}
