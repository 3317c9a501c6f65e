#include "symscene/clutter/clutter_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "symscene/clutter/grasp_trials.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using clutter::size, clutter::table_height;

constexpr double check_interval = 0.25;  // simulated between two checks for rest [s]
constexpr double drop_time = 1.0;        // [s]
constexpr double settle_time = 2.0;      // [s]
constexpr double drop_height = 0.2;      // above the table [m]
constexpr int packed_attempts = 12;
constexpr double packed_clearance = 0.002;  // between a new object and the table [m]

/// The walls of the tray of the benchmark (setup/box, scaled by 1.3), with thicker walls. Its
/// bottom is the table.
std::vector<FixedBox> tray() {
  constexpr double corner = 0.02, edge = 0.26, wall = 0.0039, height = 0.13, outward = 0.02;
  constexpr double low = corner + wall, high = corner + edge - wall;
  constexpr double outer_low = low - outward, outer_high = high + outward;
  return {{{outer_low, outer_low, 0}, {low, outer_high, height}},
          {{high, outer_low, 0}, {outer_high, outer_high, height}},
          {{outer_low, outer_low, 0}, {outer_high, low, height}},
          {{outer_low, high, 0}, {outer_high, outer_high, height}}};
}

Eigen::Isometry3d in_table_frame(const Eigen::Isometry3d& T_world_tool) {
  return Eigen::Translation3d(0, 0, -table_height) * T_world_tool;
}

Eigen::Quaterniond random_rotation(Random& random) {
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i) q[i] = random.normal();
  return Eigen::Quaterniond(q.normalized());
}

double height_of(const ConvexParts& parts) {
  float low = parts.front().col(2).minCoeff(), high = parts.front().col(2).maxCoeff();
  for (const Points& part : parts) {
    low = std::min(low, part.col(2).minCoeff());
    high = std::max(high, part.col(2).maxCoeff());
  }
  return static_cast<double>(high - low);
}

ConvexParts scaled(const ConvexParts& parts, double scale) {
  ConvexParts result = parts;
  for (Points& part : result) part *= static_cast<float>(scale);
  return result;
}

}  // namespace

const char* to_string(ClutterKind kind) { return kind == ClutterKind::packed ? "packed" : "pile"; }

ClutterKind parse_clutter_kind(const std::string& text) {
  for (const ClutterKind kind : {ClutterKind::packed, ClutterKind::pile}) {
    if (text == to_string(kind)) return kind;
  }
  throw InputError("the kind of clutter", "packed or pile", text);
}

ClutterWorld::ClutterWorld(std::span<const ClutterObject> objects, ClutterKind kind, int count,
                           std::uint64_t seed, const GraspWorldOptions& options)
    : objects_(objects) {
  Random random(seed);
  const bool is_pile = kind == ClutterKind::pile;
  for (int i = 0; i < (is_pile ? count : packed_attempts); ++i) {
    const auto object = random.below(static_cast<std::uint32_t>(objects.size()));
    const Eigen::Quaterniond rotation =
        is_pile ? random_rotation(random)
                : Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0.0, 2.0 * std::numbers::pi),
                                                       Eigen::Vector3d::UnitZ()));
    const double low = is_pile ? size / 3.0 : 0.08, high = is_pile ? 2.0 * size / 3.0 : 0.22;
    const double x = random.uniform(low, high), y = random.uniform(low, high);
    const double scale = is_pile ? random.uniform(0.8, 1.0) : random.uniform(0.7, 0.9);
    items_.push_back({object, scale});
    parts_.push_back(scaled(objects[object].parts, scale));
    const double z = is_pile ? drop_height : 0.5 * height_of(parts_.back()) + packed_clearance;
    drawn_.push_back(Eigen::Translation3d(x, y, z) * rotation);
  }
  std::vector<WeighedBody> bodies;
  for (std::size_t i = 0; i < items_.size(); ++i)
    bodies.push_back({&parts_[i], objects[items_[i].object].mass});
  world_.emplace(bodies, panda_parallel_hand(), tray(), options);
  is_pile ? drop_into_tray() : set_upright(count);
}

void ClutterWorld::drop_into_tray() {
  world_->show_fixed(true);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    world_->put(i, drawn_[i]);
    advance_to_rest(drop_time);
  }
  world_->show_fixed(false);
  settle();
}

void ClutterWorld::set_upright(int count) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (present().size() >= static_cast<std::size_t>(count)) return;
    world_->put(i, drawn_[i]);
    if (world_->touches(i))
      world_->take_away(i);
    else
      settle();
  }
}

std::vector<std::size_t> ClutterWorld::present() const { return present_bodies(*world_); }

Eigen::Isometry3d ClutterWorld::pose(std::size_t item) const {
  return Eigen::Translation3d(0, 0, table_height) * world_->pose(item);
}

TriangleMesh ClutterWorld::surface(std::size_t item) const {
  TriangleMesh mesh = object(item).surface;
  mesh.normals.resize(0, 3);
  const Eigen::Isometry3f T = pose(item).cast<float>();
  const auto scale = static_cast<float>(items_[item].scale);
  mesh.vertices =
      ((scale * mesh.vertices) * T.linear().transpose()).rowwise() + T.translation().transpose();
  return mesh;
}

std::vector<TriangleMesh> ClutterWorld::surfaces() const {
  std::vector<TriangleMesh> meshes;
  for (const std::size_t item : present()) meshes.push_back(surface(item));
  return meshes;
}

void ClutterWorld::advance(double seconds) {
  world_->advance(seconds);
  time_ += seconds;
}

void ClutterWorld::advance_to_rest(double seconds) {
  const double end = time_ + seconds;
  do advance(check_interval);
  while (!is_at_rest(*world_) && time_ < end);
}

bool ClutterWorld::take_away_outside() {
  bool any = false;
  for (const std::size_t i : present()) {
    const Eigen::Array3d position = pose(i).translation().array();
    if ((position >= 0.0).all() && (position <= size).all()) continue;
    world_->take_away(i);
    any = true;
  }
  return any;
}

void ClutterWorld::settle() {
  do advance_to_rest(settle_time);
  while (take_away_outside());
}

double ClutterWorld::penetration(const Eigen::Isometry3d& T_world_tool, std::size_t aimed) {
  return hand_penetration(*world_, in_table_frame(T_world_tool), aimed);
}

GraspOutcome ClutterWorld::rehearse(const Eigen::Isometry3d& T_world_tool,
                                    const GraspExecutionOptions& options) {
  return execute_and_undo(*world_, in_table_frame(T_world_tool), options);
}

GraspOutcome ClutterWorld::execute(const Eigen::Isometry3d& T_world_tool,
                                   const GraspExecutionOptions& options) {
  const GraspOutcome outcome = execute_and_remove(*world_, in_table_frame(T_world_tool), options);
  settle();
  return outcome;
}

}  // namespace symscene
