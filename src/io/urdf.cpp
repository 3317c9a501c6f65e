// A URDF file as a tree of links.
#include "symscene/core/error.hpp"
#include "symscene/io/robot.hpp"

#ifdef SYMSCENE_HAS_URDF
#include <limits>
#include <mutex>
#include <numbers>

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <urdf_parser/urdf_parser.h>

#include "collision_capsules.hpp"
#include "core/nearest_name.hpp"
#include "urdf_tree.hpp"
#include "xml_nesting.hpp"
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_URDF

RobotModel parse_urdf(std::string_view /*text*/, const std::string& file,
                      const LockedJoints& /*locked*/, std::vector<std::string>& /*warnings*/) {
  throw InputError(file, "a build with a reader of URDF (install liburdfdom-dev and build again)",
                   "one without");
}

#else

namespace {

/// Keeps the first error that urdfdom logs, and prints nothing.
class FirstError : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/,
           int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && text_.empty()) text_ = text;
  }
  std::string text() const { return text_.empty() ? "another text" : text_; }

 private:
  std::string text_;
};

/// urdfdom's reader of XML calls itself for each element inside another.
constexpr int max_nesting = 100;

urdf::ModelInterfaceSharedPtr parsed(const std::string& text, const std::string& file) {
  if (const int depth = nesting_depth(text); depth > max_nesting)
    throw InputError(file, fmt::format("at most {} elements inside one another", max_nesting),
                     std::to_string(depth));
  require_trees(text, file);
  // The handler of messages is global to the process.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  FirstError errors;
  console_bridge::OutputHandler* before = console_bridge::getOutputHandler();
  console_bridge::useOutputHandler(&errors);
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception&) {
    model = nullptr;
  }
  console_bridge::useOutputHandler(before);
  if (!model || !model->getRoot()) throw InputError(file, "a robot in URDF", errors.text());
  return model;
}

Eigen::Vector3d vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d pose_of(const urdf::Pose& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = vector_of(pose.position);
  const urdf::Rotation& r = pose.rotation;
  T.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  return T;
}

class UrdfReader {
 public:
  UrdfReader(std::string file, const urdf::ModelInterface& urdf, const LockedJoints& locked,
             std::vector<std::string>& warnings)
      : file_(std::move(file)), urdf_(urdf), locked_(locked), warnings_(warnings) {}

  RobotModel read() {
    require_known_locks();
    model_.name = urdf_.getName();
    add_link(*urdf_.getRoot());
    if (!meshes_.empty())
      warnings_.push_back(
          fmt::format("{}: meshes are not read; these links have no collision shape: {}", file_,
                      fmt::join(meshes_, ", ")));
    try {
      model_.validate();
    } catch (const InputError& error) {
      throw InputError(file_ + ": " + error.where(), error.expected(), error.found());
    }
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(const urdf::Joint& joint, const char* expected,
                         const std::string& found) const {
    throw InputError(fmt::format("{}: joint {}", file_, joint.name), expected, found);
  }

  void require_known_locks() const {
    std::vector<std::string> names;
    for (const auto& [name, joint] : urdf_.joints_) names.push_back(name);
    for (const auto& [name, position] : locked_) {
      if (!urdf_.joints_.contains(name))
        throw InputError(file_, "locked joints of the robot", with_nearest_name(name, names));
    }
  }

  void add_link(const urdf::Link& link) {
    const std::size_t index = model_.links.size();
    model_.links.push_back({link.name, capsules_of(link)});
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      model_.joints.push_back(joint_of(*joint, index));
      add_link(*urdf_.getLink(joint->child_link_name));
    }
  }

  std::vector<Capsule> capsules_of(const urdf::Link& link) {
    std::vector<CollisionShape> shapes;
    bool has_mesh = false;
    for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
      const urdf::Geometry* geometry = collision->geometry.get();
      const Eigen::Isometry3d T = pose_of(collision->origin);
      if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry))
        shapes.push_back({CollisionKind::sphere, T, {sphere->radius, 0.0, 0.0}});
      else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry))
        shapes.push_back({CollisionKind::cylinder, T, {cylinder->radius, cylinder->length, 0.0}});
      else if (const auto* box = dynamic_cast<const urdf::Box*>(geometry))
        shapes.push_back({CollisionKind::box, T, vector_of(box->dim)});
      else
        has_mesh = true;
    }
    if (has_mesh && shapes.empty()) meshes_.push_back(link.name);
    return collision_capsules(shapes);
  }

  /// Where the joint stands if it does not move.
  std::optional<double> locked_at(const urdf::Joint& joint) const {
    if (const auto found = locked_.find(joint.name); found != locked_.end()) return found->second;
    if (!joint.mimic) return std::nullopt;
    const auto followed = locked_.find(joint.mimic->joint_name);
    if (followed == locked_.end())
      fail(joint, "a joint that moves by itself, or one that follows a locked joint",
           fmt::format("one that mimics {}", joint.mimic->joint_name));
    return joint.mimic->multiplier * followed->second + joint.mimic->offset;
  }

  Joint joint_of(const urdf::Joint& source, std::size_t parent) {
    Joint joint;
    joint.name = source.name;
    joint.parent = parent;
    joint.child = model_.links.size();
    joint.T_parent_joint = pose_of(source.parent_to_joint_origin_transform);
    joint.kind = kind_of(source);
    if (joint.kind == JointKind::fixed) return joint;
    joint.axis = vector_of(source.axis);
    if (!(joint.axis.norm() > 1e-9)) fail(source, "an axis", "none");
    joint.axis.normalize();
    if (const auto position = locked_at(source)) return locked(joint, *position);
    joint.position = moving_++;
    joint.limits = limits_of(source);
    return joint;
  }

  static Joint locked(Joint joint, double position) {
    if (joint.kind == JointKind::prismatic)
      joint.T_parent_joint.translate(position * joint.axis);
    else
      joint.T_parent_joint.rotate(Eigen::AngleAxisd(position, joint.axis));
    joint.kind = JointKind::fixed;
    return joint;
  }

  JointKind kind_of(const urdf::Joint& joint) const {
    switch (joint.type) {
      case urdf::Joint::FIXED:
        return JointKind::fixed;
      case urdf::Joint::REVOLUTE:
        return JointKind::revolute;
      case urdf::Joint::CONTINUOUS:
        return JointKind::continuous;
      case urdf::Joint::PRISMATIC:
        return JointKind::prismatic;
      default:
        fail(joint, "type fixed, revolute, continuous or prismatic", "another type");
    }
  }

  JointLimits limits_of(const urdf::Joint& joint) const {
    constexpr double pi = std::numbers::pi;
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const bool continuous = joint.type == urdf::Joint::CONTINUOUS;
    if (!joint.limits) fail(joint, "limits", "none");
    JointLimits limits{joint.limits->lower, joint.limits->upper, joint.limits->velocity, unlimited};
    if (continuous) {
      limits.lower = -pi;
      limits.upper = pi;
    }
    if (!(limits.lower < limits.upper) || !std::isfinite(limits.upper - limits.lower))
      fail(joint, "a lower limit below the upper one",
           fmt::format("{:g} and {:g}", limits.lower, limits.upper));
    if (!(limits.velocity > 0.0) || !std::isfinite(limits.velocity))
      fail(joint, "a limit of velocity above 0", fmt::format("{:g}", limits.velocity));
    return limits;
  }

  std::string file_;
  const urdf::ModelInterface& urdf_;
  const LockedJoints& locked_;
  std::vector<std::string>& warnings_;
  RobotModel model_;
  std::size_t moving_ = 0;
  std::vector<std::string> meshes_;
};

}  // namespace

RobotModel parse_urdf(std::string_view text, const std::string& file, const LockedJoints& locked,
                      std::vector<std::string>& warnings) {
  const urdf::ModelInterfaceSharedPtr model = parsed(std::string(text), file);
  return UrdfReader(file, *model, locked, warnings).read();
}

#endif

}  // namespace symscene
