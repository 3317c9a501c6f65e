#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/stage_timer.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// A gripper whose approach is within this angle of straight down retreats backwards, others
/// upwards. [rad]
constexpr double backwards_tilt = radians(60.0);

/// What a grasp was derived from.
enum class GraspSource : std::uint8_t {
  axis_side,     ///< across an axis of symmetry, approached from the side
  axis_top,      ///< across an axis, approached along it
  rim,           ///< the wall of an open vessel between the fingers
  mirror_plane,  ///< fingers close along the plane's normal, through the centre of mass
  box_face,      ///< two opposite faces of a box
  antipodal,     ///< two opposite points of the completed surface
  cylinder       ///< bounding cylinder (section 4.6.3)
};
constexpr std::size_t grasp_sources = 7;
/// The name of the enumerator.
const char* to_string(GraspSource source);

/// The properties of a grasp from which its quality is computed.
struct GraspFeatures {
  double cone_margin = 0.0;     ///< friction angle minus the angle between closing direction and
                                ///< mean normal, of the worse pad [rad]
  double cone_share = 0.0;      ///< share of the contact's normals in the cone, of the worse pad
  double contact_area = 0.0;    ///< touched area / finger width², of the worse pad; may exceed 1
  double depth = 0.0;           ///< extent of the contact along the approach, of the worse pad [m]
  double opening_margin = 0.0;  ///< lesser distance of `opening` from the gripper's bounds [m]
  double lever_arm = 0.0;     ///< horizontal distance of the centre of mass from the middle between
                              ///< the contacts [m]
  double torque_ratio = 0.0;  ///< torque of the weight about the closing direction, relative to
                              ///< what the friction of the pads holds
  double clearance = 0.0;     ///< least distance of the open gripper, on its whole way, from the
                              ///< table and other objects; never-seen space is not included [m]
  double own_clearance = 0.0;    ///< the same of the object itself [m]
  double depth_tolerance = 0.0;  ///< error of the measured depth at which an open finger would meet
                                 ///< the object, at most 0.05 [m]
  double observed = 0.0;         ///< share of the contact that was seen, mean of both pads
  double tilt = 0.0;             ///< angle between approach and straight down [rad]

  /// Calls visit(name, value) for every feature.
  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("cone_margin", self.cone_margin);
    visit("cone_share", self.cone_share);
    visit("contact_area", self.contact_area);
    visit("depth", self.depth);
    visit("opening_margin", self.opening_margin);
    visit("lever_arm", self.lever_arm);
    visit("torque_ratio", self.torque_ratio);
    visit("clearance", self.clearance);
    visit("own_clearance", self.own_clearance);
    visit("depth_tolerance", self.depth_tolerance);
    visit("observed", self.observed);
    visit("tilt", self.tilt);
  }
};

/// A pose of the gripper at which it closes on an object.
struct Grasp {
  int object = 0;  ///< index into the objects of the scene
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  double opening = 0.0;  ///< width of the object between the pads [m]
  double quality = 0.0;  ///< estimated probability of success, in [0, 1]
  GraspSource source = GraspSource::antipodal;
  GraspFeatures features = {};
};

/// The bound that a candidate failed.
enum class GraspRejection : std::uint8_t {
  no_surface,     ///< the object has no closed surface, or one without volume
  no_axis,        ///< no axis of symmetry, where grasps need one
  too_wide,       ///< wider than the gripper opens [m]
  too_thin,       ///< thinner than the gripper closes [m]
  no_contact,     ///< a pad touches too little of the object [as contact_area]
  friction,       ///< a contact's normal is outside the friction cone [rad]
  weight,         ///< the weight pulls the object out of the pads [share of what friction holds]
  torque,         ///< the weight turns the object between the pads [share of what friction holds]
  table,          ///< the gripper reaches into the table [m]
  own_shape,      ///< the open gripper meets the object on its way [m]
  other_object,   ///< the gripper meets another object [m]
  never_seen,     ///< the gripper meets space that was never seen [share of the gripper]
  outside_space,  ///< the object lies outside the mapped space [m]
  low_quality,    ///< the quality is too low
  outranked       ///< valid, but a better grasp of the object is near, or there are enough of them
};
constexpr std::size_t grasp_rejections = 15;
/// The name of the enumerator, and a phrase for people.
const char* to_string(GraspRejection reason);
const char* description(GraspRejection reason);

/// A candidate that did not become a grasp. `grasp.quality` is 0 unless it was computed.
struct RejectedGrasp {
  Grasp grasp;
  GraspRejection reason = GraspRejection::no_contact;
  double value = 0.0;  ///< compared with the bound
  double bound = 0.0;
};

/// What became of an object's candidates.
struct ObjectGraspSummary {
  std::size_t candidates = 0;
  std::size_t grasps = 0;
  std::array<std::size_t, grasp_rejections> rejected{};  ///< by reason
  /// Why the object has no grasp: the bound that most candidates failed; none if it has one.
  std::optional<GraspRejection> reason = {};
};

/// The grasps of a scene.
struct GraspPlan {
  std::vector<Grasp> grasps;                ///< in descending order of quality
  std::vector<RejectedGrasp> rejected;      ///< a bounded number per object and reason
  std::vector<ObjectGraspSummary> objects;  ///< one per object of the scene
  std::vector<StageTime> timings;
};

}  // namespace symscene
