#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene {

/// The text of grasps.json (docs/formats.md, docs/grasps.schema.json): the plan and the gripper for
/// which it was made. Each grasp has two poses, of the tool frame and of the wrist. Equal plans
/// give equal bytes; without timings (`with_timings` false), runs on equal input do. Throws
/// InputError if a number is not finite.
std::string format_grasps_json(const GraspPlan& plan, const Gripper& gripper,
                               bool with_timings = true);

/// grasps.json as it was read: grasps, and the gripper for which they were made.
struct GraspFile {
  Gripper gripper;
  GraspPlan plan;
};

/// Parses the text of grasps.json. Poses are those of the tool frame; T_world_wrist is not read.
/// `features`, `rejected` and `timings` may be absent: another planner may have made the file.
/// Grasps are sorted by descending quality. Throws InputError, which names file and member, if a
/// member is missing or invalid, or a grasp is of an object that is not listed.
GraspFile parse_grasps_json(std::string_view text, const std::string& name);

/// Reads it from a file. Throws as parse_grasps_json(), and if the file cannot be read.
GraspFile read_grasps(const std::filesystem::path& path);

}  // namespace symscene
