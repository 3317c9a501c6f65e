#include "contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace symscene {
namespace {

constexpr float give = 0.002F;  // how far pads and objects give way [m]

/// The samples between the open fingers, in the tool frame.
struct Between {
  std::vector<Index> indices;
  std::vector<Eigen::Vector3f> positions;
};

bool is_before_pad(const Gripper& gripper, const Eigen::Vector3f& p, bool positive) {
  const float half_width = static_cast<float>(gripper.finger_width) / 2.0F;
  if (gripper.kind == GripperKind::parallel || !positive) return std::abs(p.x()) <= half_width;
  return std::abs(std::abs(p.x()) - static_cast<float>(gripper.finger_spacing) / 2.0F) <=
         half_width;
}

Between samples_between(const SurfaceSamples& samples, const Eigen::Isometry3d& T_world_tool,
                        const Gripper& gripper) {
  Between between;
  const Eigen::Matrix3f rotation = T_world_tool.linear().transpose().cast<float>();
  const Eigen::Vector3f origin = T_world_tool.translation().cast<float>();
  const auto half_opening = static_cast<float>(gripper.max_opening / 2.0);
  const auto depth = static_cast<float>(gripper.finger_depth);
  const auto half_x = static_cast<float>((gripper.finger_width + gripper.finger_spacing) / 2.0);
  for (Index i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3f p = rotation * (samples.positions.row(i).transpose() - origin);
    if (p.z() < 0.0F || p.z() > depth || std::abs(p.x()) > half_x || std::abs(p.y()) > half_opening)
      continue;
    between.indices.push_back(i);
    between.positions.push_back(p);
  }
  return between;
}

/// The contact of the pad at `side` = ±1 in the direction of y.
std::optional<PadContact> pad_contact(const SurfaceSamples& samples, const Between& between,
                                      const Eigen::Matrix3f& R_world_tool, const Gripper& gripper,
                                      float side) {
  float foremost = -std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& p : between.positions) {
    if (is_before_pad(gripper, p, side > 0.0F)) foremost = std::max(foremost, side * p.y());
  }
  if (!std::isfinite(foremost)) return std::nullopt;
  const auto cone = static_cast<float>(std::cos(std::atan(gripper.friction)));
  PadContact contact;
  Eigen::Vector3f normals = Eigen::Vector3f::Zero();
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float area = 0.0F;
  float in_cone = 0.0F;
  float observed = 0.0F;
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (std::size_t k = 0; k < between.indices.size(); ++k) {
    const Eigen::Vector3f& p = between.positions[k];
    if (!is_before_pad(gripper, p, side > 0.0F) || side * p.y() < foremost - give) continue;
    const Index i = between.indices[k];
    const Eigen::Vector3f normal = R_world_tool.transpose() * samples.normals.row(i).transpose();
    const float facing = side * normal.y();
    if (facing <= 0.0F) continue;
    const float weight = samples.areas[i] * facing;
    area += weight;
    normals += weight * normal;
    centre += weight * p;
    if (facing >= cone) in_cone += weight;
    if (samples.observed[i] != 0) observed += weight;
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  if (!(area > 0.0F)) return std::nullopt;
  contact.y = side * foremost;
  contact.normal = normals.cast<double>().normalized();
  contact.centre = (centre / area).cast<double>();
  contact.area = area;
  contact.cone_share = in_cone / area;
  contact.depth = high - low;
  contact.observed = observed / area;
  return contact;
}

}  // namespace

std::optional<Contacts> find_contacts(const SurfaceSamples& samples,
                                      const Eigen::Isometry3d& T_world_tool,
                                      const Gripper& gripper) {
  const Between between = samples_between(samples, T_world_tool, gripper);
  const Eigen::Matrix3f rotation = T_world_tool.linear().cast<float>();
  const auto positive = pad_contact(samples, between, rotation, gripper, 1.0F);
  const auto negative = pad_contact(samples, between, rotation, gripper, -1.0F);
  if (!positive || !negative) return std::nullopt;
  return Contacts{*positive, *negative};
}

}  // namespace symscene
