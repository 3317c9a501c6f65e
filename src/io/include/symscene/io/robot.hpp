#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/robots/robot.hpp"

namespace symscene {

/// Joints of a URDF file that do not move for us, by name, and where they stand. [rad or m]
using LockedJoints = std::map<std::string, double>;

/// Parses a URDF file by urdfdom. Joints follow their parents; children of a link are in the order
/// of their joints' names. Cylinders become capsules, together with spheres of the same radius at
/// their ends; boxes become bounding capsules; meshes are left out with a warning. A joint that
/// mimics a locked one is locked with it. Accelerations are infinite, as URDF has none. `file` is
/// its name in messages. Throws InputError if the text is no valid URDF, the links are no tree, a
/// joint that moves has no limits, is of another kind or mimics one that moves, a number is not
/// finite, `locked` names an unknown joint, or this build has no urdfdom.
RobotModel parse_urdf(std::string_view text, const std::string& file, const LockedJoints& locked,
                      std::vector<std::string>& warnings);

/// The names of the robots that come with SymScene: "baxter" and "panda".
std::vector<std::string> robot_names();

/// Parses the YAML description of a robot (docs/robots.md). Paths in it are relative to `folder`.
/// Throws InputError if a member is missing, unknown or invalid, as parse_urdf(), or if this build
/// has no yaml-cpp.
Robot parse_robot(std::string_view text, const std::string& file,
                  const std::filesystem::path& folder);

/// The robot of that name, or of that .yaml file. Throws as parse_robot().
Robot read_robot(const std::string& name_or_file);

}  // namespace symscene
