#include "robot_description.hpp"

#include <fmt/format.h>

namespace symscene {
namespace {

// Of links without capsules, which would have no mass: light, as they are parts of other links.
constexpr const char* light =
    "<inertial pos=\"0 0 0\" mass=\"0.05\" diaginertia=\"1e-5 1e-5 1e-5\"/>";

std::string describe_capsule(const Capsule& capsule) {
  constexpr double shortest = 1e-6;  // of a segment that is not a point [m]
  constexpr const char* contact = "condim=\"3\" contype=\"0\" conaffinity=\"1\"";
  const Eigen::Vector3d &a = capsule.begin, &b = capsule.end;
  if ((b - a).norm() < shortest)
    return fmt::format("<geom type=\"sphere\" pos=\"{} {} {}\" size=\"{}\" {}/>", a.x(), a.y(),
                       a.z(), capsule.radius, contact);
  return fmt::format("<geom type=\"capsule\" fromto=\"{} {} {} {} {} {}\" size=\"{}\" {}/>", a.x(),
                     a.y(), a.z(), b.x(), b.y(), b.z(), capsule.radius, contact);
}

/// A robot while it is written.
struct Description {
  const RobotModel& model;
  double armature;
  std::size_t mount;
  const std::string& mounted;

  std::string joint(std::size_t j) const {
    const Joint& joint = model.joints[j];
    if (!joint.position) return {};
    const char* type = joint.kind == JointKind::prismatic ? "slide" : "hinge";
    return fmt::format(
        "<joint name=\"{}\" type=\"{}\" axis=\"{} {} {}\" armature=\"{}\" limited=\"false\"/>",
        mjcf_joint(j), type, joint.axis.x(), joint.axis.y(), joint.axis.z(), armature);
  }

  std::string content(std::size_t link) const {
    const std::vector<Capsule>& capsules = model.links[link].capsules;
    std::string text = capsules.empty() ? light : "";
    for (const Capsule& capsule : capsules) text += describe_capsule(capsule);
    if (link == mount) text += mounted;
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      if (model.joints[j].parent == link)
        text += body(model.joints[j].child, model.joints[j].T_parent_joint, joint(j));
    }
    return text;
  }

  std::string body(std::size_t link, const Eigen::Isometry3d& pose,
                   const std::string& joint) const {
    return fmt::format("<body name=\"{}\" {}>{}{}</body>\n", mjcf_link(link), describe_pose(pose),
                       joint, content(link));
  }
};

}  // namespace

std::string describe_pose(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  return fmt::format("pos=\"{} {} {}\" quat=\"{} {} {} {}\"", p.x(), p.y(), p.z(), q.w(), q.x(),
                     q.y(), q.z());
}

std::string mjcf_link(std::size_t link) { return fmt::format("link{}", link); }

std::string mjcf_joint(std::size_t joint) { return fmt::format("joint{}", joint); }

std::string describe_robot(const RobotModel& model, const Eigen::Isometry3d& T_table_base,
                           double armature, std::size_t mount, const std::string& mounted) {
  return Description{model, armature, mount, mounted}.body(0, T_table_base, {});
}

}  // namespace symscene
