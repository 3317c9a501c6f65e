#include "symscene/clutter/clutter_views.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clutter/view_rendering.hpp"
#include "core/looking_at.hpp"
#include "core/random.hpp"

namespace symscene {
namespace {

constexpr double near = 0.1, far = 2.0;  // range of the sensor [m]
constexpr double distance = 0.6;         // of the camera from its target [m]
constexpr double table_edge = 1.2;       // [m]
const Eigen::Vector3d target(0.15, 0.15, 0.10);

TriangleMesh table_mesh() {
  constexpr auto middle = static_cast<float>(0.5 * clutter::size);
  constexpr auto half = static_cast<float>(0.5 * table_edge);
  constexpr auto z = static_cast<float>(clutter::table_height);
  TriangleMesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << middle - half, middle - half, z, middle + half, middle - half, z, middle + half,
      middle + half, z, middle - half, middle + half, z;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  return mesh;
}

/// A camera at an angle `theta` from the vertical that looks at the target, held upright.
Eigen::Isometry3d camera_pose(double theta, double phi) {
  const Eigen::Vector3d outward(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                std::cos(theta));
  return looking_along(target + distance * outward, -outward);
}

/// A sample of the gamma distribution of this shape, at least 1, with mean 1 (Marsaglia and Tsang
/// 2000).
double random_scale(double shape, Random& random) {
  const double d = shape - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
  for (;;) {
    const double x = random.normal();
    const double v = std::pow(1.0 + c * x, 3.0);
    if (v <= 0.0) continue;
    if (std::log(1.0 - random.uniform()) < 0.5 * x * x + d - d * v + d * std::log(v))
      return d * v / shape;
  }
}

/// Normally distributed values on a coarse grid, enlarged bilinearly so that the centres of its
/// cells are kept.
class Grain {
 public:
  Grain(const CameraIntrinsics& camera, int spacing, double sigma, Random& random)
      : spacing_(spacing),
        values_(std::max<Eigen::Index>(1, camera.height / static_cast<Index>(spacing)),
                std::max<Eigen::Index>(1, camera.width / static_cast<Index>(spacing))) {
    for (Eigen::Index row = 0; row < values_.rows(); ++row) {
      for (Eigen::Index column = 0; column < values_.cols(); ++column)
        values_(row, column) = sigma * random.normal();
    }
  }

  double at(Index u, Index v) const {
    const auto [column, x] = cell(u, values_.cols());
    const auto [row, y] = cell(v, values_.rows());
    const Eigen::Index right = std::min(column + 1, values_.cols() - 1);
    const Eigen::Index below = std::min(row + 1, values_.rows() - 1);
    return (1 - y) * ((1 - x) * values_(row, column) + x * values_(row, right)) +
           y * ((1 - x) * values_(below, column) + x * values_(below, right));
  }

 private:
  struct Cell {
    Eigen::Index index;
    double share;  ///< of the next cell
  };
  Cell cell(Index pixel, Eigen::Index cells) const {
    const double place =
        std::clamp((pixel + 0.5) / spacing_ - 0.5, 0.0, static_cast<double>(cells - 1));
    const auto index = static_cast<Eigen::Index>(place);
    return {index, place - static_cast<double>(index)};
  }

  int spacing_;
  Eigen::MatrixXd values_;
};

std::size_t pixels_of(const SensorFrame& frame, Index mesh) {
  return static_cast<std::size_t>(std::count(frame.objects.begin(), frame.objects.end(), mesh));
}

}  // namespace

DepthRenderer table_renderer(std::vector<TriangleMesh> objects) {
  objects.push_back(table_mesh());
  return DepthRenderer(objects);
}

ClutterView noisy_view(const DepthRenderer& renderer, const Eigen::Isometry3d& T_world_camera,
                       const ClutterNoiseOptions& options, const Random& noise) {
  const CameraIntrinsics camera = clutter_camera();
  std::vector<float> depth = renderer.render(camera, T_world_camera).depth;
  for (float& pixel : depth) {
    if (pixel < static_cast<float>(near) || pixel > static_cast<float>(far)) pixel = 0.0F;
  }
  return {{0.0, with_clutter_noise(depth, camera, options, noise), {}}, T_world_camera};
}

CameraIntrinsics clutter_camera() { return {640, 480, 540.0, 540.0, 320.0, 240.0}; }

CameraIntrinsics small_clutter_camera() { return {160, 120, 135.0, 135.0, 79.625, 59.625}; }

std::vector<Eigen::Isometry3d> clutter_view_poses(int views) {
  if (views == 1) return {camera_pose(radians(60.0), radians(-90.0))};
  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < views; ++k)
    poses.push_back(camera_pose(radians(30.0), 2.0 * std::numbers::pi * k / views));
  return poses;
}

std::vector<float> with_clutter_noise(const std::vector<float>& depth,
                                      const CameraIntrinsics& camera,
                                      const ClutterNoiseOptions& options, Random random) {
  options.validate();
  std::vector<float> noisy = depth;
  if (!options.enabled) return noisy;
  const double scale = random_scale(options.scale_shape, random);
  const double grain = random.chance(options.grain_probability) ? options.grain : 0.0;
  const Grain grid(camera, options.grain_pixels, grain, random);
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      float& pixel = noisy[std::size_t{v} * camera.width + u];
      if (pixel > 0.0F)
        pixel = static_cast<float>(scale * static_cast<double>(pixel) + grid.at(u, v));
    }
  }
  return noisy;
}

ClutterView clutter_view(const ClutterWorld& world, const Eigen::Isometry3d& T_world_camera,
                         const ClutterNoiseOptions& options, const Random& noise) {
  return noisy_view(table_renderer(world.surfaces()), T_world_camera, options, noise);
}

std::vector<ClutterView> clutter_views(const ClutterWorld& world, int views,
                                       const ClutterNoiseOptions& options, std::uint64_t seed) {
  const DepthRenderer renderer = table_renderer(world.surfaces());
  std::vector<ClutterView> result;
  for (const Eigen::Isometry3d& pose : clutter_view_poses(views))
    result.push_back(noisy_view(renderer, pose, options, Random(seed, result.size())));
  return result;
}

std::vector<double> clutter_occlusion(const ClutterWorld& world, int views) {
  const CameraIntrinsics camera = small_clutter_camera();
  const Eigen::Isometry3d pose = clutter_view_poses(views).front();
  const std::vector<TriangleMesh> meshes = world.surfaces();
  if (meshes.empty()) return {};
  const SensorFrame together = DepthRenderer(meshes).render(camera, pose);
  std::vector<double> occlusion;
  for (Index k = 0; k < meshes.size(); ++k) {
    const SensorFrame alone = DepthRenderer(std::span(&meshes[k], 1)).render(camera, pose);
    const auto whole = static_cast<double>(std::max<std::size_t>(1, pixels_of(alone, 0)));
    occlusion.push_back(1.0 - static_cast<double>(pixels_of(together, k)) / whole);
  }
  return occlusion;
}

}  // namespace symscene
