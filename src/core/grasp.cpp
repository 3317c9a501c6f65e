#include "symscene/core/grasp.hpp"

namespace symscene {
namespace {

constexpr std::array<const char*, grasp_sources> source_names{
    "axis_side", "axis_top", "rim", "mirror_plane", "box_face", "antipodal", "cylinder"};

struct RejectionText {
  const char* name;
  const char* description;
};
constexpr std::array<RejectionText, grasp_rejections> rejection_texts{
    {{"no_surface", "no closed surface"},
     {"no_axis", "no cylinder was fitted to it"},
     {"too_wide", "too wide for the gripper"},
     {"too_thin", "too thin for the gripper"},
     {"no_contact", "the pads touch too little of it"},
     {"friction", "the fingers would slip off"},
     {"weight", "too heavy for the grip"},
     {"torque", "its weight would turn it between the pads"},
     {"table", "the gripper would hit the table"},
     {"own_shape", "the gripper would hit the object on its way"},
     {"other_object", "the gripper would hit another object"},
     {"never_seen", "the gripper would enter space that was never seen"},
     {"outside_space", "outside the mapped space"},
     {"low_quality", "a grasp would likely fail"},
     {"outranked", "better grasps are listed"}}};

}  // namespace

const char* to_string(GraspSource source) {
  return source_names.at(static_cast<std::size_t>(source));
}

const char* to_string(GraspRejection reason) {
  return rejection_texts.at(static_cast<std::size_t>(reason)).name;
}

const char* description(GraspRejection reason) {
  return rejection_texts.at(static_cast<std::size_t>(reason)).description;
}

}  // namespace symscene
