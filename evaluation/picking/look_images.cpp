#include "look_images.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "core/twist.hpp"

namespace symscene {
namespace {

/// Those of the sensor's noise are the numbers of the images.
constexpr std::uint64_t first_pose_stream = std::uint64_t{1} << 40;

}  // namespace

CameraMoment LookImages::moment(const ArmCell& cell) const {
  const RobotCamera& camera = *robot_.camera;
  return moment(cell, robot_.T_world_base *
                          link_poses(robot_.model, cell.state().positions)[camera.link] *
                          camera.T_link_camera);
}

/// As a robot knows it by its joints.
Eigen::Isometry3d LookImages::pose_by_arm(const Eigen::Isometry3d& truth,
                                          std::uint64_t image) const {
  Random random(options_.seed, first_pose_stream + image);
  Vector6d error;
  for (double& value : error) value = random.normal();
  error.head<3>() *= options_.look.rotation_deviation;
  error.tail<3>() *= options_.look.pose_deviation;
  return truth * motion(error);
}

double LookImages::add(const ArmCell& cell, std::span<const CameraMoment> moments,
                       TablePerception& perception) {
  const Tabletop tabletop = cell.tabletop();
  const LookRenderer renderer(tabletop, solids_, bin_, options_);
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
  return covered;
}

}  // namespace symscene
