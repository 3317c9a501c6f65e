#include "arm_cell.hpp"

#include <algorithm>

#include "clutter/object_bodies.hpp"

namespace symscene {
namespace {

constexpr double rest_speed = 0.01;  // [m/s]

/// The hand as the benchmarks have it where its shapes are known, else as boxes.
ParallelHand hand_of(const Gripper& gripper) {
  return gripper.name == "panda" ? panda_parallel_hand() : parallel_hand_of(gripper);
}

}  // namespace

ArmCell::ArmCell(const PickTable& table, const Robot& robot, const RobotArm& arm,
                 const Gripper& gripper, const PickBin& bin, const SimulatedPickOptions& options,
                 OnStep on_step)
    : table_(table), bin_(bin), options_(options), on_step_(std::move(on_step)) {
  const std::vector<PlacedObject>& objects = table.tabletop.objects;
  const std::vector<ConvexParts> parts = parts_of_objects(objects, table.parts);
  world_.emplace(bodies_of_objects(objects, parts, table.density), robot, robot.T_world_base,
                 arm.arm, arm.T_tip_tool(gripper), hand_of(gripper), bin.boxes(), options.physics);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    poses_.push_back(objects[i].T_world_object);
    world_->put(i, poses_[i]);
  }
  aim(robot.home, Eigen::VectorXd::Zero(robot.home.size()));
}

void ArmCell::aim(const Eigen::VectorXd& positions, const Eigen::VectorXd& velocities) {
  target_ = positions;
  world_->aim_robot(positions, velocities);
}

void ArmCell::step() {
  world_->advance(options_.execution.control_period);
  time_ += options_.execution.control_period;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (world_->is_there(i)) poses_[i] = world_->pose(i);
  }
  if (on_step_) on_step_(*this);
}

bool ArmCell::follow(const Arm& arm, const TimedPath& path, const std::function<bool()>& stop) {
  const double period = options_.execution.control_period;
  const Eigen::VectorXd from = target_;
  const Eigen::VectorXd offset = arm_positions(arm, from) - path.at(0.0).position;
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(from.size());
  bool reached = true;
  for (const JointState& state : sampled(path, period)) {
    if (state.time == 0.0) continue;
    const double fade = 1.0 - state.time / path.duration();
    aim(with_arm_positions(arm, state.position + fade * offset, from),
        with_arm_positions(arm, state.velocity - offset / path.duration(), still));
    step();
    reached = !stop || !stop();
    if (!reached) break;
  }
  aim(Eigen::VectorXd(target_), still);
  return reached;
}

void ArmCell::wait(double seconds) {
  for (double waited = 0.0; waited < seconds; waited += options_.execution.control_period) step();
}

std::vector<std::size_t> ArmCell::present() const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (world_->is_there(i)) numbers.push_back(i);
  }
  return numbers;
}

Tabletop ArmCell::tabletop() const {
  Tabletop now = table_.tabletop;
  now.objects.clear();
  for (const std::size_t i : present()) {
    now.objects.push_back(object(i));
    now.objects.back().T_world_object = poses_[i];
  }
  return now;
}

Eigen::Vector3d ArmCell::middle_of(std::size_t i) const {
  const Box own = bounding_box(object(i).object.mesh.vertices);
  return poses_[i] * (0.5F * (own.min + own.max)).cast<double>().eval();
}

bool ArmCell::is_off_table(std::size_t i) const {
  const TableOptions& table = table_.tabletop.table;
  const Eigen::Vector3d middle = middle_of(i);
  return std::abs(middle.x()) > 0.5 * table.length || std::abs(middle.y()) > 0.5 * table.width;
}

std::vector<std::size_t> ArmCell::settle() {
  const auto moves = [&] {
    const std::vector<std::size_t> there = present();
    return std::any_of(there.begin(), there.end(),
                       [&](std::size_t i) { return world_->speed(i) > rest_speed; });
  };
  constexpr double interval = 0.1;  // between two looks at the speeds [s]
  wait(interval);
  for (double waited = interval; waited < options_.execution.rest_time && moves();
       waited += interval)
    wait(interval);
  std::vector<std::size_t> gone;
  for (const std::size_t i : present()) {
    if (!is_off_table(i)) continue;
    world_->take_away(i);
    gone.push_back(i);
  }
  return gone;
}

std::vector<std::size_t> ArmCell::empty_bin() {
  std::vector<std::size_t> numbers;
  for (const std::size_t i : present()) {
    if (!bin_.is_above(middle_of(i))) continue;
    world_->take_away(i);
    numbers.push_back(i);
  }
  return numbers;
}

}  // namespace symscene
