#include "symscene/physics/parallel_hand.hpp"

#include <array>
#include <span>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr float tool_height = 0.062F;   // of the tool frame in the hand's frame [m]
constexpr float finger_root = 0.0584F;  // of the finger's frame in the hand's frame [m]

/// A hull of points in a frame that lies `height` along z from the frame of the hand.
Points hull(std::span<const std::array<float, 3>> corners, float height) {
  Points points(static_cast<Eigen::Index>(corners.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto& [x, y, z] = corners[static_cast<std::size_t>(i)];
    points.row(i) << x, y, z + height - tool_height;
  }
  return points;
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
  // Corners of the collision meshes, without those that change their hulls by less than 2 mm.
  constexpr std::array<std::array<float, 3>, 22> palm{{
      {-0.0170F, -0.0920F, 0.0640F}, {0.0170F, -0.0920F, 0.0640F},  {0.0170F, 0.0920F, 0.0640F},
      {-0.0170F, 0.0920F, 0.0640F},  {0.0000F, -0.0930F, 0.0660F},  {0.0000F, 0.0930F, 0.0660F},
      {-0.0140F, -0.1002F, 0.0560F}, {0.0140F, -0.1002F, 0.0560F},  {0.0150F, 0.1002F, 0.0550F},
      {-0.0150F, 0.1002F, 0.0550F},  {-0.0316F, -0.0010F, 0.0060F}, {0.0316F, -0.0010F, 0.0060F},
      {-0.0316F, -0.0020F, 0.0010F}, {0.0316F, -0.0020F, 0.0010F},  {0.0000F, -0.1040F, 0.0057F},
      {0.0000F, -0.1037F, -0.0092F}, {-0.0232F, 0.0912F, 0.0045F},  {0.0239F, 0.0905F, 0.0045F},
      {-0.0245F, 0.0767F, -0.0070F}, {0.0245F, 0.0744F, -0.0072F},  {0.0000F, -0.0460F, -0.0259F},
      {0.0000F, -0.0840F, -0.0259F},
  }};
  constexpr std::array<std::array<float, 3>, 16> finger{{
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
  return {{hull(palm, 0.0F)}, {hull(finger, finger_root)}, 0.08, 0.81, 0.1, 20.0, 0.2};
}

}  // namespace symscene
