#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"

namespace symscene {

enum class GripperKind : std::uint8_t {
  parallel,     ///< two fingers that close along y
  three_finger  ///< two fingers at +y, `finger_spacing` apart along x, against one at −y
};

/// "parallel" or "three_finger".
const char* to_string(GripperKind kind);
/// The kind of that name; none for another text.
std::optional<GripperKind> gripper_kind_of(std::string_view name);

/// A gripper as boxes in its tool frame. The origin of that frame lies midway between the open
/// fingers, where they leave the palm; z points to the finger tips and is the direction of
/// approach; the fingers close along y; x = y × z. The tips are at z = finger_depth.
struct Gripper {
  std::string name;
  GripperKind kind = GripperKind::parallel;
  double min_opening = 0.0;
  double max_opening = 0.08;
  double finger_depth = 0.05;
  double finger_width = 0.02;
  double finger_thickness = 0.02;
  double tip_thickness = 0.01;
  double finger_spacing = 0.0;
  double approach_distance = 0.05;
  double retreat_distance = 0.1;
  double force = 20.0;
  double friction = 0.8;
  /// Edges of a box that is centred in x and y and whose +z face lies at z = 0. [m]
  Eigen::Vector3d palm_size{0.06, 0.2, 0.1};
  Eigen::Isometry3d T_wrist_tool = Eigen::Isometry3d::Identity();

  /// The numbers that a gripper file holds, each as NAME_UNIT.
  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_opening", self.min_opening, "m", between(0.0, 1.0),
          "least clear width between the finger pads");
    visit("max_opening", self.max_opening, "m", above_up_to(0.0, 1.0),
          "greatest clear width between the finger pads");
    visit("finger_depth", self.finger_depth, "m", above_up_to(0.0, 1.0),
          "length of the fingers from the palm to the tips");
    visit("finger_width", self.finger_width, "m", above_up_to(0.0, 0.5),
          "extent of a finger along x");
    visit("finger_thickness", self.finger_thickness, "m", above_up_to(0.0, 0.5),
          "extent of a finger along y at the palm");
    visit("tip_thickness", self.tip_thickness, "m", above_up_to(0.0, 0.5),
          "extent of a finger along y at its tip; fingers taper linearly");
    visit("finger_spacing", self.finger_spacing, "m", between(0.0, 0.5),
          "distance along x of the centres of the two fingers at +y; 0 of a parallel gripper");
    visit("approach_distance", self.approach_distance, "m", between(0.0, 1.0),
          "straight way along z that ends at the grasp");
    visit("retreat_distance", self.retreat_distance, "m", between(0.0, 1.0),
          "straight way from the grasp after closing");
    visit("force", self.force, "N", above_up_to(0.0, 1e4), "force of a finger on the object");
    visit("friction", self.friction, "", above_up_to(0.0, 5.0),
          "coefficient of friction between finger pad and object");
  }
  /// Throws InputError if a field is out of its range or fields contradict each other.
  void validate() const;
};

/// Axes of the tool frame of a gripper that approaches along `approach` and closes along `closing`,
/// unit vectors at a right angle.
Eigen::Matrix3d tool_axes(const Eigen::Vector3d& closing, const Eigen::Vector3d& approach);

}  // namespace symscene
