#include "look_taker.hpp"

#include "sweep_look.hpp"
#include "view_look.hpp"

namespace symscene {
namespace {

std::vector<Eigen::Isometry3d> poses_of(const std::vector<ViewStation>& stations) {
  std::vector<Eigen::Isometry3d> poses;
  for (const ViewStation& station : stations) poses.push_back(station.T_table_camera);
  return poses;
}

/// An arm that goes from station to station.
class StationTravel {
 public:
  StationTravel(ArmCell& cell, const CameraArm& arm, const std::vector<ViewStation>& stations)
      : cell_(cell), arm_(arm), stations_(stations), watch_(cell) {}

  /// The time of each way at the joints' greatest speeds, as if nothing stood in between. [s]
  std::vector<double> costs() const {
    std::vector<double> seconds;
    for (const ViewStation& station : stations_)
      seconds.push_back(
          ((station.positions - at_).cwiseAbs().array() / arm_.limits().velocity.array())
              .maxCoeff());
    return seconds;
  }

  bool go(const Eigen::VectorXd& positions) {
    const FreeMotion way = plan_free_motion(arm_.planner(), at_, {positions});
    if (!way.path) return false;
    follow(*way.path);
    came_by_.push_back(way.waypoints);
    at_ = positions;
    return true;
  }

  /// Home by a way of its own, else by those that led here.
  void go_home() {
    if (came_by_.empty() || go(arm_.home())) return;
    for (auto way = came_by_.rbegin(); way != came_by_.rend(); ++way)
      follow(timed_motion(arm_.planner(), {way->rbegin(), way->rend()}));
  }

  const std::string& touched() const { return watch_.touched(); }

 private:
  void follow(const TimedPath& path) { follow_watched(cell_, arm_.arm(), path, watch_); }

  ArmCell& cell_;
  const CameraArm& arm_;
  const std::vector<ViewStation>& stations_;
  ContactWatch watch_;
  Eigen::VectorXd at_ = arm_.home();
  std::vector<std::vector<Eigen::VectorXd>> came_by_;
};

}  // namespace

LookTaker::LookTaker(const Robot& robot, const RobotSolids& solids, const Gripper& gripper,
                     const PickBin& bin, const TriangleMesh& bin_mesh,
                     const SimulatedPickOptions& options)
    : options_(options),
      azimuth_(azimuth_of_base(robot)),
      images_(robot, solids, bin_mesh, options) {
  if (robot.camera && robot.camera->arm)
    arm_.emplace(robot, gripper, bin, options.look, options.pick);
}

std::string LookTaker::plan() {
  if (!arm_) return {};
  if (options_.views == LookViews::next) return plan_views();
  PlannedLook planned = plan_look(*arm_, options_.look);
  sweep_ = std::move(planned.motion);
  return planned.obstacle;
}

std::string LookTaker::plan_views() {
  if (std::string blocked = arm_->blocked_home(); !blocked.empty()) return blocked;
  stations_ = view_stations(*arm_, options_.look);
  return stations_.size() < 2 ? too_few_views : "";
}

TakenLook LookTaker::take(ArmCell& cell, TablePerception& perception) {
  const bool next = options_.views == LookViews::next;
  if (!arm_) return next ? fly_to_views(cell, perception) : fly(cell, perception);
  if (next) return move_to_views(cell, perception);
  return sweep_look(cell, arm_->arm(), *sweep_, options_.look.frames, images_, perception);
}

TakenLook LookTaker::fly(ArmCell& cell, TablePerception& perception) {
  std::vector<CameraMoment> moments;
  for (const Eigen::Isometry3d& pose : flying_look(options_.look, azimuth_)) {
    const double after = static_cast<double>(moments.size()) / options_.record_rate;
    moments.push_back(images_.moment(cell, pose));
    moments.back().time += after;
  }
  return {images_.add(cell, moments, perception) / static_cast<double>(moments.size()), {}};
}

TakenLook LookTaker::fly_to_views(ArmCell& cell, TablePerception& perception) {
  const std::vector<Eigen::Isometry3d> views = flying_views(options_.look, azimuth_);
  const CameraTravel travel{[&] { return std::vector<double>(views.size(), 0.0); },
                            [&](std::size_t i) { return images_.moment(cell, views[i]); }};
  return look_from_views(views, travel, cell, options_, images_, perception);
}

TakenLook LookTaker::move_to_views(ArmCell& cell, TablePerception& perception) {
  StationTravel arm(cell, *arm_, stations_);
  const CameraTravel travel{[&] { return arm.costs(); },
                            [&](std::size_t i) -> std::optional<CameraMoment> {
                              if (!arm.go(stations_[i].positions)) return std::nullopt;
                              return images_.moment(cell);
                            }};
  TakenLook look =
      look_from_views(poses_of(stations_), travel, cell, options_, images_, perception);
  arm.go_home();
  look.touched = arm.touched();
  return look;
}

}  // namespace symscene
