#include "contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tool_points.hpp"

namespace symscene {
namespace {

/// A sample between the open fingers, in the tool frame.
struct Between {
  Eigen::Vector3f position;
  Eigen::Index index;
};

/// Appends those of the samples from `begin` to `end` that lie between the fingers.
void append_between(const SurfaceSamples& samples, Eigen::Index begin, Eigen::Index end,
                    const Eigen::Isometry3f& T_tool_world, const HandBox& space,
                    std::vector<Between>& between) {
  for (; begin < end; begin += ToolPoints::capacity) {
    const ToolPoints points(samples.positions, begin, end, T_tool_world);
    const ToolPoints::Values distances = points.distance_from_faces(space);
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      if (distances[i] <= 0.0F) between.push_back({points[i], begin + i});
    }
  }
}

std::vector<Between> samples_between(const SurfaceSamples& samples,
                                     const Eigen::Isometry3f& T_tool_world, const HandBox& space) {
  const PointBlocks& blocks = samples.blocks;
  std::vector<Between> between;
  between.reserve(512);
  for (Eigen::Index begin = 0; begin < blocks.size(); begin += ToolPoints::capacity) {
    const ToolPoints centres(blocks.centres, begin, blocks.size(), T_tool_world);
    const ToolPoints::Values distances = centres.distance_from_faces(space);
    for (Eigen::Index i = 0; i < centres.size(); ++i) {
      const Eigen::Index block = begin + i;
      if (distances[i] > blocks.radii[block]) continue;
      append_between(samples, blocks.begin(block), blocks.end(block), T_tool_world, space, between);
    }
  }
  return between;
}

/// The extent along x of the fingers of one side.
struct Pad {
  float side;  ///< 1 at +y, −1 at −y
  float half_width;
  float half_spacing;  ///< of two fingers on this side; 0 for one

  bool faces(const Eigen::Vector3f& p) const {
    return std::abs(std::abs(p.x()) - half_spacing) <= half_width;
  }
};

Pad pad_of(const Gripper& gripper, float side) {
  const bool two = gripper.kind == GripperKind::three_finger && side > 0.0F;
  const auto half_width = static_cast<float>(gripper.finger_width / 2.0);
  const auto half_spacing = static_cast<float>(gripper.finger_spacing / 2.0);
  return {side, half_width, two ? half_spacing : 0.0F};
}

/// Sums over the touched samples.
class TouchedArea {
 public:
  TouchedArea(const Eigen::Matrix3f& R_tool_world, const Pad& pad, double friction)
      : R_tool_world_(R_tool_world),
        side_(pad.side),
        cone_(static_cast<float>(1.0 / std::sqrt(1.0 + friction * friction))) {}

  void add(const Eigen::Vector3f& position, const Eigen::Vector3f& normal_world, float sample_area,
           bool observed) {
    const float facing = side_ * R_tool_world_.row(1).dot(normal_world);
    if (facing <= 0.0F) return;
    const Eigen::Vector3f normal = R_tool_world_ * normal_world;
    const float weight = sample_area * facing;
    area_ += weight;
    normals_ += weight * normal;
    positions_ += weight * position;
    if (facing >= cone_) in_cone_ += weight;
    if (observed) observed_ += weight;
    low_ = std::min(low_, position.z());
    high_ = std::max(high_, position.z());
  }

  std::optional<PadContact> contact(float foremost) const {
    if (!(area_ > 0.0F)) return std::nullopt;
    return PadContact{side_ * foremost,
                      normals_.normalized().cast<double>(),
                      (positions_ / area_).cast<double>(),
                      area_,
                      in_cone_ / area_,
                      high_ - low_,
                      observed_ / area_};
  }

 private:
  Eigen::Matrix3f R_tool_world_;
  float side_;
  float cone_;  ///< least cosine between closing direction and normal
  float area_ = 0.0F;
  float in_cone_ = 0.0F;
  float observed_ = 0.0F;
  float low_ = std::numeric_limits<float>::infinity();
  float high_ = -std::numeric_limits<float>::infinity();
  Eigen::Vector3f normals_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f positions_ = Eigen::Vector3f::Zero();
};

std::optional<PadContact> pad_contact(const SurfaceSamples& samples,
                                      const std::vector<Between>& between, const Pad& pad,
                                      TouchedArea touched, float give) {
  constexpr float nothing = -std::numeric_limits<float>::infinity();
  std::array<float, 2> first{nothing, nothing};  // met by the finger at −x, and at +x
  for (const Between& sample : between) {
    float& y = first.at(sample.position.x() > 0.0F ? 1 : 0);
    if (pad.side * sample.position.y() > y && pad.faces(sample.position))
      y = pad.side * sample.position.y();
  }
  const float foremost = std::max(first[0], first[1]);
  // The fingers of a pair close by the same distance: both must touch.
  const bool is_pair = pad.half_spacing > 0.0F;
  if (is_pair && !(std::min(first[0], first[1]) >= foremost - give)) return std::nullopt;
  for (const auto& [position, i] : between) {
    if (pad.side * position.y() < foremost - give || !pad.faces(position)) continue;
    touched.add(position, samples.normals.row(i).transpose(), samples.areas[i],
                samples.observed[static_cast<std::size_t>(i)] != 0);
  }
  return touched.contact(foremost);
}

}  // namespace

std::optional<Contacts> find_contacts(const SurfaceSamples& samples,
                                      const Eigen::Isometry3d& T_world_tool, const Gripper& gripper,
                                      double give) {
  const Eigen::Isometry3f T_tool_world = T_world_tool.inverse().cast<float>();
  const std::vector<Between> between =
      samples_between(samples, T_tool_world, space_between(gripper, gripper.max_opening));
  const auto contact = [&](float side) {
    const Pad pad = pad_of(gripper, side);
    return pad_contact(samples, between, pad, {T_tool_world.linear(), pad, gripper.friction},
                       static_cast<float>(give));
  };
  const auto positive = contact(1.0F);
  if (!positive) return std::nullopt;
  const auto negative = contact(-1.0F);
  if (!negative) return std::nullopt;
  return Contacts{*positive, *negative};
}

}  // namespace symscene
