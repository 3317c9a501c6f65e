#include "symscene/physics/parallel_hand.hpp"

#include <array>
#include <span>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr float tool_height = 0.062F;   // of the tool frame in the hand's frame [m]
constexpr float finger_root = 0.0584F;  // of the finger's frame in the hand's frame [m]

// Corners of the collision meshes in their own frames [m]. In every direction their hulls
// reach as far as those of the meshes to within 1 mm (palm) and 0.6 mm (fingers).
constexpr std::array<std::array<float, 3>, 60> palm_corners{{
    {-0.0015F, -0.0459F, -0.0259F}, {-0.0009F, -0.0825F, -0.0259F}, {0.0019F, -0.0455F, -0.0257F},
    {-0.0006F, -0.0880F, -0.0250F}, {-0.0032F, -0.0878F, -0.0239F}, {0.0031F, -0.0880F, -0.0240F},
    {0.0000F, -0.0995F, -0.0172F},  {-0.0036F, -0.1012F, -0.0126F}, {0.0036F, -0.1012F, -0.0126F},
    {0.0000F, -0.1037F, -0.0092F},  {-0.0228F, 0.0802F, -0.0069F},  {0.0230F, 0.0779F, -0.0074F},
    {-0.0280F, 0.0418F, -0.0064F},  {0.0280F, 0.0420F, -0.0063F},   {-0.0260F, 0.0758F, -0.0051F},
    {-0.0165F, -0.0822F, -0.0051F}, {0.0245F, 0.0817F, -0.0051F},   {-0.0227F, 0.0854F, -0.0041F},
    {0.0166F, -0.0851F, -0.0039F},  {-0.0245F, 0.0859F, -0.0018F},  {0.0223F, 0.0882F, -0.0019F},
    {-0.0168F, -0.0875F, -0.0012F}, {-0.0316F, -0.0020F, 0.0012F},  {-0.0213F, 0.0909F, 0.0010F},
    {0.0316F, -0.0019F, 0.0012F},   {0.0239F, 0.0904F, 0.0044F},    {-0.0236F, 0.0912F, 0.0046F},
    {-0.0316F, -0.0006F, 0.0060F},  {0.0000F, -0.1040F, 0.0057F},   {0.0170F, -0.0916F, 0.0056F},
    {0.0316F, -0.0006F, 0.0062F},   {0.0213F, 0.0943F, 0.0089F},    {-0.0207F, 0.0947F, 0.0095F},
    {-0.0171F, -0.0955F, 0.0221F},  {-0.0191F, 0.0977F, 0.0246F},   {0.0170F, -0.0968F, 0.0303F},
    {-0.0182F, 0.0995F, 0.0438F},   {0.0193F, 0.0985F, 0.0449F},    {0.0162F, 0.1003F, 0.0459F},
    {-0.0192F, 0.0973F, 0.0506F},   {-0.0175F, -0.0979F, 0.0517F},  {0.0176F, -0.0974F, 0.0520F},
    {0.0156F, 0.1002F, 0.0547F},    {0.0158F, -0.0994F, 0.0550F},   {-0.0146F, 0.1002F, 0.0557F},
    {-0.0140F, -0.1001F, 0.0560F},  {0.0125F, -0.1002F, 0.0569F},   {0.0186F, 0.0946F, 0.0566F},
    {-0.0093F, -0.1000F, 0.0585F},  {0.0099F, 0.1000F, 0.0583F},    {-0.0016F, 0.0975F, 0.0623F},
    {-0.0173F, -0.0907F, 0.0631F},  {-0.0168F, 0.0903F, 0.0643F},   {0.0167F, 0.0901F, 0.0644F},
    {0.0171F, -0.0893F, 0.0636F},   {-0.0126F, 0.0937F, 0.0652F},   {0.0131F, -0.0941F, 0.0647F},
    {0.0157F, -0.0918F, 0.0649F},   {-0.0130F, -0.0925F, 0.0657F},  {0.0135F, 0.0927F, 0.0657F},
}};
constexpr std::array<std::array<float, 3>, 16> finger_corners{{
    {-0.0104F, 0.0025F, 0.0001F},
    {0.0104F, 0.0025F, 0.0001F},
    {0.0104F, 0.0264F, 0.0002F},
    {-0.0104F, 0.0264F, 0.0002F},
    {0.0104F, 0.0253F, 0.0190F},
    {-0.0104F, 0.0253F, 0.0190F},
    {-0.0087F, 0.0000F, 0.0362F},
    {0.0087F, 0.0000F, 0.0362F},
    {-0.0087F, 0.0000F, 0.0505F},
    {0.0087F, 0.0000F, 0.0505F},
    {-0.0087F, 0.0140F, 0.0508F},
    {0.0087F, 0.0140F, 0.0508F},
    {-0.0055F, 0.0000F, 0.0537F},
    {0.0058F, 0.0000F, 0.0537F},
    {-0.0055F, 0.0143F, 0.0537F},
    {0.0058F, 0.0143F, 0.0537F},
}};

/// A hull of points in a frame that lies `height` along z from the frame of the hand.
Points hull(std::span<const std::array<float, 3>> corners, float height) {
  Points points(static_cast<Eigen::Index>(corners.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto& [x, y, z] = corners[static_cast<std::size_t>(i)];
    points.row(i) << x, y, z + height - tool_height;
  }
  return points;
}

Points corners_of(const Eigen::AlignedBox3d& box) {
  Points corners(8, 3);
  for (int k = 0; k < 8; ++k)
    corners.row(k) =
        box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)).cast<float>().transpose();
  return corners;
}

/// The finger at +y of a closed hand: its pad lies in the plane y = 0.
Points finger_of(const Gripper& gripper) {
  const Eigen::Vector3d half(0.5 * gripper.finger_width, 0, 0);
  const Eigen::Vector3d far(half.x(), gripper.finger_thickness, gripper.finger_depth);
  Points corners = corners_of({Eigen::Vector3d(-half), far});
  for (Eigen::Index k = 0; k < corners.rows(); ++k) {
    if (corners(k, 2) > 0.0F && corners(k, 1) > 0.0F)
      corners(k, 1) = static_cast<float>(gripper.tip_thickness);
  }
  return corners;
}

}  // namespace

void ParallelHand::validate() const {
  require_option(!palm.empty(), "palm", "at least one part", 0.0);
  require_option(!finger.empty(), "finger", "at least one part", 0.0);
  require_option(max_opening > 0.0, "max_opening", "more than 0", max_opening);
  require_option(palm_mass > 0.0, "palm_mass", "more than 0", palm_mass);
  require_option(finger_mass > 0.0, "finger_mass", "more than 0", finger_mass);
  require_option(force > 0.0, "force", "more than 0", force);
  require_option(speed > 0.0, "speed", "more than 0", speed);
}

ParallelHand panda_parallel_hand() {
  return {
      {hull(palm_corners, 0.0F)}, {hull(finger_corners, finger_root)}, 0.08, 0.81, 0.1, 20.0, 0.2};
}

ParallelHand parallel_hand_of(const Gripper& gripper) {
  gripper.validate();
  if (gripper.kind != GripperKind::parallel)
    throw InputError("the gripper", "two fingers that close along one line",
                     to_string(gripper.kind));
  const Eigen::Vector3d half = 0.5 * gripper.palm_size;
  const Eigen::AlignedBox3d palm(Eigen::Vector3d(-half.x(), -half.y(), -gripper.palm_size.z()),
                                 Eigen::Vector3d(half.x(), half.y(), 0.0));
  return {
      {corners_of(palm)}, {finger_of(gripper)}, gripper.max_opening, 0.8, 0.1, gripper.force, 0.2};
}

}  // namespace symscene
