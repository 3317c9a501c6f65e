#pragma once

#include <optional>

#include "target.hpp"

namespace symscene {

/// Where a pad meets the object first, in the tool frame.
struct PadContact {
  double y = 0.0;                                    ///< of the foremost point [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< mean of the touched surface, a unit vector
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the touched surface [m]
  double area = 0.0;                                 ///< touched area [m²]
  double cone_share = 0.0;  ///< share of that area whose normal lies in the friction cone
  double depth = 0.0;       ///< extent of that area along the approach [m]
  double observed = 0.0;    ///< share of that area that was seen
};

/// The contacts of the fingers at +y and −y that close on the object. A pad touches what lies
/// within a small distance behind the first point that it meets, as pads and objects give way.
struct Contacts {
  PadContact positive;
  PadContact negative;
  double opening() const { return positive.y - negative.y; }
};

/// The contacts of a gripper that closes at this pose; none if a pad meets nothing.
std::optional<Contacts> find_contacts(const SurfaceSamples& samples,
                                      const Eigen::Isometry3d& T_world_tool,
                                      const Gripper& gripper);

}  // namespace symscene
