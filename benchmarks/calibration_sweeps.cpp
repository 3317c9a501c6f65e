#include "calibration_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "calibrated_cameras.hpp"
#include "calibration/simulated_boards.hpp"
#include "io/atomic_file.hpp"
#include "scene_evaluation.hpp"
#include "simulated_sweeps.hpp"
#include "symscene/dataset/swept_scene.hpp"
#include "symscene/io/image.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "tables.hpp"

namespace symscene::bench {
namespace {

/// The camera with errors after calibration with 30 images of a board and 10 of a board on a wall.
CameraModel calibrated(const CameraToCalibrate& camera) {
  CameraModel model = found_intrinsics(camera, 30, 0.1, 1).camera;
  model.depth_correction = found_depth(camera, model, 10, true, 1).correction;
  return model;
}

/// Heights of the surface over the table, about the plane that fits best.
struct TableSurface {
  std::vector<Eigen::Vector3d> points;  ///< x and y on the table, z above the plane [m]
  double deviation = 0.0;               ///< root mean square height [m]
};

TableSurface table_surface(const SweptScene& scene, const Tabletop& tabletop) {
  const Eigen::Isometry3d T_table_scene = (scene.T_scene_world * tabletop.T_world_table).inverse();
  constexpr double reach = 0.025, half_width = 0.45;
  const SceneTruth truth = transformed(tabletop_truth(tabletop), scene.T_scene_world);
  TableSurface table;
  for (Eigen::Index i = 0; i < scene.surface.vertices.rows(); ++i) {
    const Eigen::Vector3d p =
        T_table_scene * scene.surface.vertices.row(i).transpose().cast<double>();
    const double up =
        (T_table_scene.linear() * scene.surface.normals.row(i).transpose().cast<double>()).z();
    if (std::abs(p.z()) > reach || up < 0.9 || p.head<2>().cwiseAbs().maxCoeff() > half_width)
      continue;
    table.points.push_back(p);
  }
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : table.points) {
    const Eigen::Vector3d row(p.x(), p.y(), 1.0);
    A += row * row.transpose(), b += row * p.z();
  }
  const Eigen::Vector3d fit = A.ldlt().solve(b);
  double squares = 0.0;
  for (Eigen::Vector3d& p : table.points) {
    p.z() -= fit.dot(Eigen::Vector3d(p.x(), p.y(), 1.0));
    squares += p.z() * p.z();
  }
  table.deviation =
      std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, table.points.size())));
  return table;
}

/// Blue is below the plane, red above, full colour at 5 mm; black is not table. One panel per
/// table.
void write_picture(const std::filesystem::path& file, const std::vector<TableSurface>& tables) {
  constexpr Index size = 160, gap = 10;
  constexpr double half_width = 0.45, full = 0.005;
  const Index width = static_cast<Index>(tables.size()) * (size + gap) - gap;
  ColorImage image{{width, size}, Colors::Constant(width * size, 3, 255)};
  for (std::size_t panel = 0; panel < tables.size(); ++panel) {
    std::vector<double> sums(std::size_t{size} * size), counts(sums.size());
    for (const Eigen::Vector3d& p : tables[panel].points) {
      const auto at = [&](double x) {
        const double share = (x + half_width) / (2.0 * half_width);
        return std::min<std::size_t>(size - 1, static_cast<std::size_t>(share * size));
      };
      const std::size_t pixel = at(-p.y()) * size + at(p.x());
      sums[pixel] += p.z(), counts[pixel] += 1.0;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double share =
          counts[i] == 0.0 ? 0.0 : std::clamp(sums[i] / counts[i] / full, -1.0, 1.0);
      const auto fade = static_cast<std::uint8_t>(255.0 * (1.0 - std::abs(share)));
      const std::uint8_t most = counts[i] == 0.0 ? 0 : 255, rest = counts[i] == 0.0 ? 0 : fade;
      const std::size_t row = i / size * width + panel * (size + gap) + i % size;
      image.pixels.row(static_cast<Eigen::Index>(row)) << (share > 0.0 ? most : rest), rest,
          (share > 0.0 ? rest : most);
    }
  }
  write_file_atomically(file, format_png(image));
}

}  // namespace

ColorPoseError color_pose_error(int images, std::uint64_t seed) {
  using namespace calibration_test;
  CameraModel color = true_camera();
  color.intrinsics.fx = color.intrinsics.fy = 610.0;
  Eigen::Isometry3d truth(Eigen::AngleAxisd(0.02, Eigen::Vector3d(1, 2, 0.5).normalized()));
  truth.translation() << 0.025, 0.001, -0.002;
  std::vector<BoardImage> first, second;
  Random random(seed);
  for (int i = 0; i < images; ++i) {
    const Eigen::Isometry3d pose = random_board_pose(true_camera(), the_board(), random);
    first.push_back(board_image(true_camera(), the_board(), pose, 0.1, random.seed()));
    second.push_back(board_image(color, the_board(), truth.inverse() * pose, 0.1, random.seed()));
  }
  const CameraModel depth_found = calibrate_intrinsics(first, 640, 480, the_board()).camera;
  const CameraModel color_found = calibrate_intrinsics(second, 640, 480, the_board()).camera;
  const ColorPose found =
      calibrate_color_pose(first, second, depth_found, color_found, the_board());
  return {
      (found.T_depth_color.translation() - truth.translation()).norm(),
      std::abs(
          Eigen::AngleAxisd(found.T_depth_color.linear().transpose() * truth.linear()).angle())};
}

void measure_objects(int sweeps, int frames, const std::filesystem::path& pictures) {
  const CameraToCalibrate camera = simulated_camera(0.02, 1);
  const CameraModel model = calibrated(camera);
  SweepArguments arguments{.sweeps = sweeps, .frames = frames, .min_objects = 4, .max_objects = 12};
  struct Variant {
    const char* name;
    bool errs;
    const CameraModel* calibration;
    SceneScore score = {};
    double squares = 0.0;
  };
  Variant variants[] = {
      {"no errors", false, nullptr}, {"default", true, nullptr}, {"calibrated", true, &model}};
  fmt::print("{}", scene_header());
  for (int i = 0; i < sweeps; ++i) {
    std::vector<TableSurface> tables;
    for (Variant& variant : variants) {
      SweepOptions options = arguments.options(i);
      if (variant.errs) options.errors = camera.errors;
      const Tabletop tabletop = table_of(options, {});
      const SweptScene scene = reconstruct_sweep(tabletop, options, {}, variant.calibration);
      const SegmentationResult result = segment_scene(scene.scene, PipelineOptions{});
      const SceneScore score = evaluate(scene.scene, scene.truth, result);
      variant.score += score;
      const TableSurface table = table_surface(scene, tabletop);
      variant.squares += table.deviation * table.deviation;
      fmt::print("{}    {} of {} frames; path {:.1f} mm; table uneven by {:.2f} mm\n",
                 scene_row(fmt::format("{} {}", variant.name, i), score), scene.fused, frames,
                 1e3 * scene.trajectory.absolute, 1e3 * table.deviation);
      std::fflush(stdout);
      tables.push_back(table);
    }
    if (i == 0 && !pictures.empty()) write_picture(pictures / "calibration.png", tables);
  }
  for (const Variant& variant : variants)
    fmt::print("{}    table uneven by {:.2f} mm\n", scene_row(variant.name, variant.score),
               1e3 * std::sqrt(variant.squares / sweeps));
}

}  // namespace symscene::bench
