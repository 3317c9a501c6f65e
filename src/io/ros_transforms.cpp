#include "ros_transforms.hpp"

#include <algorithm>

#include "pose_formats.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Poses are not interpolated over longer gaps. [s]
constexpr double largest_transform_gap = 0.1;

/// Chains of more frames are loops. Robots have fewer.
constexpr std::size_t longest_chain = 1000;

constexpr const char* a_transform = "a message tf2_msgs/TFMessage";

Eigen::Isometry3d take_transform(RosCursor& bytes, const std::string& name) {
  Eigen::Vector3d translation;
  for (double& value : translation) value = bytes.number<double>();
  Eigen::Vector4d xyzw;
  for (double& value : xyzw) value = bytes.number<double>();
  const double norm = xyzw.norm();
  if (!translation.allFinite() || !(norm > 0.5 && norm < 2.0)) {
    throw InputError(name, "a finite translation and a unit quaternion", "others");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(xyzw / norm).toRotationMatrix();
  pose.translation() = translation;
  return pose;
}

/// tf of ROS 1 let names of frames begin with a slash.
std::string frame_name(std::string name) {
  if (name.starts_with('/')) name.erase(0, 1);
  return name;
}

}  // namespace

std::vector<RosTransform> parse_ros_transforms(std::string_view bytes, RosFormat format,
                                               const std::string& name) {
  RosCursor rest(bytes, format, name, a_transform);
  constexpr std::size_t smallest = 7 * sizeof(double);
  std::vector<RosTransform> transforms(rest.count(smallest));
  for (RosTransform& transform : transforms) {
    transform.header = rest.header();
    transform.child = rest.text();
    transform.T_parent_child = take_transform(rest, name);
  }
  return transforms;
}

void TransformTree::add(const RosTransform& transform, bool is_static) {
  Edge& edge = edges_[frame_name(transform.child)];
  edge.parent = frame_name(transform.header.frame_id);
  edge.is_static = is_static;
  if (is_static) edge.T_parent_child.clear();
  edge.T_parent_child.push_back({transform.header.time, transform.T_parent_child});
}

void TransformTree::finish() {
  for (auto& [child, edge] : edges_) {
    std::stable_sort(edge.T_parent_child.begin(), edge.T_parent_child.end(),
                     [](const StampedPose& a, const StampedPose& b) { return a.time < b.time; });
  }
}

std::vector<const TransformTree::Edge*> TransformTree::chain(const std::string& frame) const {
  std::vector<const Edge*> chain;
  for (auto edge = edges_.find(frame_name(frame)); edge != edges_.end();
       edge = edges_.find(edge->second.parent)) {
    if (chain.size() == longest_chain) return {};
    chain.push_back(&edge->second);
  }
  return chain;
}

bool TransformTree::moves(const std::string& frame) const {
  const std::vector<const Edge*> edges = chain(frame);
  return std::any_of(edges.begin(), edges.end(), [](const Edge* edge) { return !edge->is_static; });
}

std::optional<Eigen::Isometry3d> TransformTree::pose(const std::string& frame, double time) const {
  const std::vector<const Edge*> edges = chain(frame);
  if (edges.empty()) return std::nullopt;
  Eigen::Isometry3d T_root_frame = Eigen::Isometry3d::Identity();
  for (const Edge* edge : edges) {
    const std::optional<Eigen::Isometry3d> T_parent_child =
        edge->is_static ? edge->T_parent_child.front().T_world_camera
                        : pose_at(edge->T_parent_child, time, largest_transform_gap);
    if (!T_parent_child) return std::nullopt;
    T_root_frame = *T_parent_child * T_root_frame;
  }
  return T_root_frame;
}

}  // namespace symscene
