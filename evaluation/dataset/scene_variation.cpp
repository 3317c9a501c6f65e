#include "symscene/dataset/scene_variation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.hpp"
#include "symscene/core/error.hpp"
#include "varied_scene.hpp"

namespace symscene {
namespace {

constexpr std::uint64_t variation_stream = std::uint64_t{1}
                                           << 42U;  // distinct from the streams of the simulation

double log_uniform(double low, double high, Random& random) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

int log_uniform_count(int low, int high, Random& random) {
  return std::clamp(static_cast<int>(log_uniform(low, high + 1.0, random)), low, high);
}

struct CommonCamera {
  int width = 0;
  int height = 0;
  double focal_length = 0.0;
};

/// Kinect v1 and Xtion; colour of a RealSense D400; Kinect v2; depth of a RealSense D435.
constexpr std::array<CommonCamera, 4> common_cameras{
    {{640, 480, 525.0}, {640, 480, 615.0}, {512, 424, 365.0}, {848, 480, 425.0}}};

void draw_camera(CameraArcOptions& camera, Random& random) {
  const CommonCamera& drawn =
      common_cameras[random.below(static_cast<std::uint32_t>(common_cameras.size()))];
  camera.width = drawn.width;
  camera.height = drawn.height;
  camera.focal_length = drawn.focal_length;
}

void draw_sensor(const SceneVariationOptions& options, ScenePlan& plan, std::uint64_t seed,
                 Random& random) {
  SensorNoiseOptions& sensor = plan.sweep.sensor;
  const double choice = random.uniform();
  const SimulatedSensor model = choice < options.stereo ? SimulatedSensor::stereo
                                : choice < options.stereo + options.tof
                                    ? SimulatedSensor::time_of_flight
                                    : SimulatedSensor::structured_light;
  sensor.model = to_string(model);
  plan.noise = log_uniform(options.min_noise, options.max_noise, random);
  sensor.axial *= plan.noise;
  sensor.stereo.disparity_noise *= plan.noise;
  sensor.tof.deviation *= plan.noise;
  sensor.stereo.material_seed = seed;
  const double interval = random.uniform(3.0, 6.0);
  if (random.chance(options.missing_lines)) sensor.missing_lines = interval;
}

/// Single views and few frames have exact poses, as they are too far apart to be tracked.
void draw_views(const SceneVariationOptions& options, ScenePlan& plan, Random& random) {
  CameraArcOptions& camera = plan.sweep.camera;
  const double choice = random.uniform();
  const bool is_single = choice < options.single_views;
  const bool is_few = !is_single && choice < options.single_views + options.few_views;
  if (is_single || is_few) {
    camera.frames =
        is_single ? 1 : log_uniform_count(options.min_few_frames, options.max_few_frames, random);
    plan.making.poses = "exact";
  } else {
    camera.frames =
        log_uniform_count(options.min_tracked_frames, options.max_tracked_frames, random);
    camera.arc = std::min(camera.arc, options.tracked_step * camera.frames);
  }
  camera.radius = log_uniform(options.min_distance, options.max_distance, random);
  camera.min_elevation = random.uniform(options.min_elevation, options.max_elevation);
  camera.max_elevation =
      std::min(options.max_elevation, camera.min_elevation + random.uniform(0.0, 0.3));
}

void draw_table(const SceneVariationOptions& options, TableOptions& table, Random& random) {
  const double choice = random.uniform();
  const bool is_endless = choice < options.endless_tables;
  const bool is_small = !is_endless && choice < options.endless_tables + options.small_tables;
  const double least = is_endless ? 8.0 : is_small ? 0.4 : 0.9;
  const double most = is_endless ? 8.0 : is_small ? 0.9 : 2.4;
  table.length = random.uniform(least, most);
  table.width = random.uniform(least, most);
  const double height = random.uniform(0.4, 1.0);
  const double behind = random.uniform(0.0, 1.5);
  if (is_endless || !random.chance(options.rooms)) return;
  table.height = height;
  table.wall_distance = 0.5 * table.length + behind;
}

/// The deviation of a depth at the distance of the objects. [m]
double deviation_at(const SweepOptions& sweep, double z) {
  const SensorNoiseOptions& sensor = sweep.sensor;
  switch (parse_simulated_sensor(sensor.model)) {
    case SimulatedSensor::stereo:
      return sensor.stereo.disparity_noise * z * z /
             (sweep.camera.focal_length * sensor.stereo.baseline);
    case SimulatedSensor::time_of_flight:
      return sensor.tof.deviation;
    case SimulatedSensor::structured_light:
      break;
  }
  return sensor.axial * z * z;
}

/// Distance from its true surface up to which a measured point is on it, at distance z. [m]
double greatest_error_at(const SweepOptions& sweep, double z) {
  constexpr double by_multipath = 0.03;  // [m], where an object meets the table
  const SensorNoiseOptions& sensor = sweep.sensor;
  const bool multipath = parse_simulated_sensor(sensor.model) == SimulatedSensor::time_of_flight &&
                         sensor.tof.multipath > 0.0;
  return 3.0 * deviation_at(sweep, z) + (multipath ? by_multipath : 0.0);
}

/// Radius of the ball about the point that the camera looks at, and of the disc on the table about
/// its middle, that hold all objects. [m]
struct ObjectExtent {
  double ball = 0.0;
  double disc = 0.0;
};

ObjectExtent extent_of(const Tabletop& tabletop, double target_height) {
  ObjectExtent extent;
  const Eigen::Isometry3d T_table_world = tabletop.T_world_table.inverse();
  for (const PlacedObject& placed : tabletop.objects) {
    const Eigen::Isometry3d T_table_object = T_table_world * placed.T_world_object;
    const auto& vertices = placed.object.mesh.vertices;
    for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
      const Eigen::Vector3d p = T_table_object * vertices.row(i).transpose().cast<double>();
      extent.disc = std::max(extent.disc, p.head<2>().norm());
      extent.ball = std::max(extent.ball, (p - Eigen::Vector3d(0, 0, target_height)).norm());
    }
  }
  return extent;
}

}  // namespace

void SceneVariationOptions::validate() const {
  check_fields(*this);
  require_option(max_noise >= min_noise, "max_noise", "at least min_noise", max_noise);
  require_option(max_distance >= min_distance, "max_distance", "at least min_distance",
                 max_distance);
  require_option(max_elevation >= min_elevation, "max_elevation", "at least min_elevation",
                 max_elevation);
  require_option(max_few_frames >= min_few_frames, "max_few_frames", "at least min_few_frames",
                 max_few_frames);
  require_option(max_tracked_frames >= min_tracked_frames, "max_tracked_frames",
                 "at least min_tracked_frames", max_tracked_frames);
  require_option(stereo + tof <= 1.0, "tof", "at most 1 together with stereo", tof);
  require_option(single_views + few_views <= 1.0, "few_views",
                 "at most 1 together with single_views", few_views);
  require_option(small_tables + endless_tables <= 1.0, "endless_tables",
                 "at most 1 together with small_tables", endless_tables);
}

ScenePlan vary_scene(const SceneVariationOptions& options, ScenePlan plan, std::uint64_t seed) {
  options.validate();
  if (!options.enabled) return plan;
  Random random(seed, variation_stream);
  draw_sensor(options, plan, seed, random);
  if (options.cameras) draw_camera(plan.sweep.camera, random);
  draw_views(options, plan, random);
  draw_table(options, plan.sweep.tabletop.table, random);
  plan.with_occupancy = !random.chance(options.no_occupancy);
  return plan;
}

void fit_to_objects(const SceneVariationOptions& options, Tabletop& tabletop, ScenePlan& plan) {
  if (!options.enabled) return;
  constexpr double border = 0.03;
  TableOptions& table = plan.sweep.tabletop.table;
  CameraArcOptions& camera = plan.sweep.camera;
  const ObjectExtent extent = extent_of(tabletop, camera.target_height);
  table.length = std::max(table.length, 2.0 * (extent.disc + border));
  table.width = std::max(table.width, 2.0 * (extent.disc + border));
  if (table.wall_distance > 0.0)
    table.wall_distance = std::max(table.wall_distance, 0.5 * table.length);
  tabletop.table = table;
  camera.radius = std::max(camera.radius, extent.ball + options.clearance);
  // Points of a noisy surface belong to the object that they were measured on.
  TruthTransferOptions& truth = plan.making.truth;
  truth.tolerance = std::max(truth.tolerance, greatest_error_at(plan.sweep, camera.radius));
}

}  // namespace symscene
