#include "symscene/io/gripper.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "gripper_json.hpp"
#include "io/atomic_file.hpp"
#include "io/file_names.hpp"
#include "io/pose_json.hpp"
#include "symscene/core/error.hpp"
#include "yaml.hpp"

namespace symscene {
namespace {

constexpr const char* gripper_to_write = "gripper to write";
constexpr const char* palm_size = "palm_size_m";
constexpr const char* tool_pose = "T_wrist_tool";
constexpr std::array<const char*, 5> required{"name", "kind", "max_opening_m", "finger_depth_m",
                                              palm_size};

/// "max_opening" with unit "m" is the member "max_opening_m".
std::string member_of(const char* field, const char* unit) {
  return *unit == '\0' ? field : fmt::format("{}_{}", field, unit);
}

/// The members that stand for fields of Gripper, by the name of the field.
std::map<std::string, std::string> members_by_field() {
  std::map<std::string, std::string> members{{"palm_size", palm_size}};
  const Gripper gripper;
  Gripper::visit_fields(gripper, [&](const char* field, double, const char* unit, const Range&,
                                     const char*) { members[field] = member_of(field, unit); });
  return members;
}

std::set<std::string> known_members() {
  std::set<std::string> names{"name", "kind", tool_pose};
  for (const auto& [field, member] : members_by_field()) names.insert(member);
  return names;
}

/// The text with the members of the file in place of the fields of Gripper.
std::string naming_members(const std::string& text) {
  const std::map<std::string, std::string> members = members_by_field();
  const auto in_word = [](char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), in_word);
    const auto next = std::find_if(end, text.end(), in_word);
    const auto member = members.find(std::string(at, end));
    result += member == members.end() ? std::string(at, end) : member->second;
    result.append(end, next);
    at = next;
  }
  return result;
}

/// The known member that is `name` with its unit, in quotes; or that there is none.
std::string expected_instead(const std::string& name) {
  const std::map<std::string, std::string> members = members_by_field();
  const auto with_unit = members.find(name);
  return with_unit == members.end() ? "no member of this name"
                                    : fmt::format("\"{}\", with its unit", with_unit->second);
}

void require_members(const JsonCursor& root) {
  const std::set<std::string> known = known_members();
  for (const auto& [name, value] : root.members()) {
    if (!known.contains(name)) value.fail(expected_instead(name));
  }
  for (const char* name : required) root.at(name);
}

void read_numbers(const JsonCursor& root, Gripper& gripper) {
  Gripper::visit_fields(
      gripper, [&](const char* field, double& value, const char* unit, const Range&, const char*) {
        if (const auto member = root.find(member_of(field, unit).c_str())) value = member->number();
      });
  if (root.find("finger_thickness_m") && !root.find("tip_thickness_m"))
    gripper.tip_thickness = gripper.finger_thickness;
}

}  // namespace

Json gripper_json(const Gripper& gripper, const char* what) {
  Json json = {{"name", gripper.name}, {"kind", to_string(gripper.kind)}};
  Gripper::visit_fields(
      gripper, [&](const char* field, double value, const char* unit, const Range&, const char*) {
        json[member_of(field, unit)] = to_json(value, what);
      });
  json[palm_size] = to_json(gripper.palm_size, what);
  json[tool_pose] = pose_json(gripper.T_wrist_tool, what);
  return json;
}

Gripper gripper_of(const JsonCursor& json) {
  require_members(json);
  Gripper gripper;
  gripper.name = json.at("name").string();
  const std::optional<GripperKind> kind = gripper_kind_of(json.at("kind").string());
  if (!kind) json.at("kind").fail("\"parallel\" or \"three_finger\"");
  gripper.kind = *kind;
  read_numbers(json, gripper);
  gripper.palm_size = json.at(palm_size).vector3();
  if (const auto pose = json.find(tool_pose)) gripper.T_wrist_tool = pose_of(*pose);
  try {
    gripper.validate();
  } catch (const InputError& error) {
    throw InputError(json.where() + ": " + naming_members(error.where()),
                     naming_members(error.expected()), error.found());
  }
  return gripper;
}

Gripper parse_gripper(std::string_view text, const std::string& file) {
  const Json document = is_yaml(file) ? parse_yaml(text, file) : parse_json(text, file);
  return gripper_of(JsonCursor(document, file));
}

Gripper read_gripper(const std::filesystem::path& path) {
  return parse_gripper(read_file(path), path.string());
}

std::string format_gripper(const Gripper& gripper) {
  return format_json(gripper_json(gripper, gripper_to_write)) + "\n";
}

}  // namespace symscene
