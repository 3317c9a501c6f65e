#pragma once

#include <optional>

#include "hand_shape.hpp"
#include "target.hpp"

namespace symscene {

/// Where a pad meets the object first, in the tool frame.
struct PadContact {
  double y = 0.0;                                    ///< of the foremost point [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< mean of the touched surface, a unit vector
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the touched surface [m]
  double area = 0.0;                                 ///< touched area, seen along y [m²]
  double cone_share = 0.0;  ///< share of that area whose normal lies in the friction cone
  double depth = 0.0;       ///< extent of that area along the approach [m]
  double observed = 0.0;    ///< share of that area that was seen
};

/// The contacts of the fingers at +y and −y that close on the object.
struct Contacts {
  PadContact positive;
  PadContact negative;

  double opening() const { return positive.y - negative.y; }
  Eigen::Vector3d middle() const { return 0.5 * (positive.centre + negative.centre); }
};

/// The contacts of an open gripper that closes at this pose; none if a pad meets nothing, or one
/// finger of a pair nothing within `give` of what the other meets. A pad
/// touches what faces it within `give` behind the first point that it meets, as pads and objects
/// give way. [m]
std::optional<Contacts> find_contacts(const SurfaceSamples& samples,
                                      const Eigen::Isometry3d& T_world_tool, const Gripper& gripper,
                                      double give);

}  // namespace symscene
