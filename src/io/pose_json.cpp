#include "io/pose_json.hpp"

#include <cmath>

namespace symscene {
namespace {

constexpr const char* position_name = "position_m";
constexpr const char* orientation_name = "orientation_xyzw";

}  // namespace

Eigen::Quaterniond orientation_of(const Eigen::Isometry3d& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return q;
}

Json pose_json(const ObjectPose& pose, const char* what) {
  Json orientation = Json::array();
  for (const int k : {0, 1, 2, 3})  // x, y, z, w
    orientation.push_back(to_json(pose.orientation.coeffs()[k], what));
  return {{position_name, to_json(pose.position, what)},
          {orientation_name, std::move(orientation)}};
}

Json pose_json(const Eigen::Isometry3d& pose, const char* what) {
  return pose_json(ObjectPose{pose.translation(), orientation_of(pose)}, what);
}

ObjectPose object_pose_of(const JsonCursor& json) {
  ObjectPose pose;
  pose.position = json.at(position_name).vector3();
  const JsonCursor orientation = json.at(orientation_name);
  const std::vector<JsonCursor> items = orientation.items(4);
  for (int k = 0; k < 4; ++k)
    pose.orientation.coeffs()[k] = items[static_cast<std::size_t>(k)].number();
  if (!(std::abs(pose.orientation.norm() - 1.0) < 1e-3))
    orientation.fail("a unit quaternion x, y, z, w");
  return pose;
}

Eigen::Isometry3d pose_of(const JsonCursor& json) {
  for (const auto& [name, value] : json.members()) {
    if (name != position_name && name != orientation_name) value.fail("no member of this name");
  }
  const ObjectPose read = object_pose_of(json);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = read.position;
  pose.linear() = read.orientation.normalized().toRotationMatrix();
  return pose;
}

}  // namespace symscene
