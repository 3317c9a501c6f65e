#include "look_taker.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "core/twist.hpp"

namespace symscene {
namespace {

/// Those of the sensor's noise are the numbers of the images.
constexpr std::uint64_t first_pose_stream = std::uint64_t{1} << 40;

}  // namespace

CameraMoment LookTaker::moment(const ArmCell& cell) const {
  const RobotState state = cell.state();
  const RobotCamera& camera = *robot_.camera;
  return {cell.time(),
          robot_.T_world_base * link_poses(robot_.model, state.positions)[camera.link] *
              camera.T_link_camera,
          solids_.poses(state)};
}

std::vector<CameraMoment> LookTaker::move(ArmCell& cell, ContactWatch& watch) const {
  const Arm& arm = robot_.arms[*robot_.camera->arm].arm;
  const auto watched = [&] {
    watch.note(true);
    return false;
  };
  cell.follow(arm, motion_->there, watched);
  const double begin = cell.time();
  const double interval = motion_->sweep.duration() / std::max(1, options_.look.frames - 1);
  std::vector<CameraMoment> moments{moment(cell)};
  cell.follow(arm, motion_->sweep, [&] {
    if (cell.time() - begin >= interval * static_cast<double>(moments.size()))
      moments.push_back(moment(cell));
    return watched();
  });
  moments.resize(std::min(moments.size(), static_cast<std::size_t>(options_.look.frames)));
  cell.follow(arm, motion_->back, watched);
  return moments;
}

std::vector<CameraMoment> LookTaker::fly(const ArmCell& cell) const {
  const Eigen::Vector3d base = robot_.T_world_base.translation();
  std::vector<CameraMoment> moments;
  for (const Eigen::Isometry3d& pose : flying_look(options_.look, std::atan2(base.y(), base.x()))) {
    const double time = cell.time() + static_cast<double>(moments.size()) / options_.record_rate;
    moments.push_back({time, pose, solids_.poses(cell.state())});
  }
  return moments;
}

/// As a robot knows it by its joints.
Eigen::Isometry3d LookTaker::pose_by_arm(const Eigen::Isometry3d& truth,
                                         std::uint64_t image) const {
  Random random(options_.seed, first_pose_stream + image);
  Vector6d error;
  for (double& value : error) value = random.normal();
  error.head<3>() *= options_.look.rotation_deviation;
  error.tail<3>() *= options_.look.pose_deviation;
  return truth * motion(error);
}

TakenLook LookTaker::take(ArmCell& cell, TablePerception& perception) {
  const Tabletop tabletop = cell.tabletop();
  const LookRenderer renderer(tabletop, solids_, bin_, options_);
  ContactWatch watch(cell);
  const std::vector<CameraMoment> moments = motion_ ? move(cell, watch) : fly(cell);
  constexpr std::size_t at_once = 8;  // bounds the memory for images
  double covered = 0.0;
  for (std::size_t begin = 0; begin < moments.size(); begin += at_once) {
    std::vector<LookImage> images(std::min(at_once, moments.size() - begin));
    parallel_for_each(images.size(), [&](std::size_t i) {
      images[i] = renderer.render(moments[begin + i], images_ + begin + i);
    });
    for (std::size_t i = 0; i < images.size(); ++i) {
      covered += images[i].robot_share;
      const Eigen::Isometry3d& truth = moments[begin + i].T_table_camera;
      perception.add(images[i].frame, pose_by_arm(truth, images_ + begin + i), truth);
    }
  }
  images_ += moments.size();
  return {covered / static_cast<double>(moments.size()), watch.touched()};
}

}  // namespace symscene
