// The YAML description of a robot.
#include "symscene/io/robot.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/nearest_name.hpp"
#include "gripper_json.hpp"
#include "io/atomic_file.hpp"
#include "io/file_names.hpp"
#include "io/pose_json.hpp"
#include "symscene/core/error.hpp"
#include "yaml.hpp"

namespace symscene {

std::string_view baxter_urdf_text();  // models/robots
std::string_view baxter_yaml_text();
std::string_view panda_urdf_text();
std::string_view panda_yaml_text();

namespace {

namespace fs = std::filesystem;

struct IncludedRobot {
  const char* name;
  std::string_view (*urdf)();
  std::string_view (*yaml)();
};
constexpr std::array<IncludedRobot, 2> included{
    {{"baxter", baxter_urdf_text, baxter_yaml_text}, {"panda", panda_urdf_text, panda_yaml_text}}};

const IncludedRobot* find_included(std::string_view name) {
  const auto found = std::find_if(included.begin(), included.end(),
                                  [&](const IncludedRobot& robot) { return name == robot.name; });
  return found == included.end() ? nullptr : &*found;
}

void require_known(const JsonCursor& object, const std::vector<std::string>& known) {
  for (const auto& [name, value] : object.members()) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(object.where(), fmt::format("members {}", fmt::join(known, ", ")),
                       with_nearest_name(name, known));
  }
}

/// Numbers by the name of a joint.
std::map<std::string, double> numbers_of(const std::optional<JsonCursor>& object) {
  std::map<std::string, double> numbers;
  if (!object) return numbers;
  for (const auto& [name, value] : object->members()) numbers[name] = value.number();
  return numbers;
}

Eigen::Isometry3d robot_pose(const std::optional<JsonCursor>& json) {
  if (!json) return Eigen::Isometry3d::Identity();
  require_known(*json, {"position_m", "orientation_xyzw", "rpy_deg"});
  if (!json->find("rpy_deg")) {
    if (!json->find("orientation_xyzw")) json->fail("rpy_deg or orientation_xyzw");
    return pose_of(*json);
  }
  if (json->find("orientation_xyzw")) json->fail("orientation_xyzw or rpy_deg, not both");
  const Eigen::Vector3d rpy = json->at("rpy_deg").vector3();
  Eigen::Isometry3d pose(Eigen::Translation3d{json->at("position_m").vector3()});
  pose.rotate(Eigen::AngleAxisd(radians(rpy.z()), Eigen::Vector3d::UnitZ()));
  pose.rotate(Eigen::AngleAxisd(radians(rpy.y()), Eigen::Vector3d::UnitY()));
  pose.rotate(Eigen::AngleAxisd(radians(rpy.x()), Eigen::Vector3d::UnitX()));
  return pose;
}

/// The description that this one starts from, with its own members in place of those.
Json with_included(Json document, const std::string& file) {
  const JsonCursor root(document, file);
  const auto name = root.find("robot");
  if (!name) return document;
  const IncludedRobot* robot = find_included(name->string());
  if (robot == nullptr)
    throw InputError(name->where(), fmt::format("one of {}", fmt::join(robot_names(), ", ")),
                     with_nearest_name(name->string(), robot_names()));
  Json whole = parse_yaml(robot->yaml(), robot->name);
  for (const auto& [key, value] : document.items()) whole[key] = value;
  whole.erase("robot");
  return whole;
}

/// Reads the parts of a description. Errors of the model's names become errors of the file.
class RobotReader {
 public:
  RobotReader(const JsonCursor& root, const std::string& file, fs::path folder)
      : root_(root), file_(file), folder_(std::move(folder)) {}

  Robot read() {
    require_known(root_, {"robot", "urdf", "base_pose", "arms", "camera", "home",
                          "acceleration_limits", "locked", "ignored_collisions", "obstacles"});
    read_model();
    robot_.T_world_base = robot_pose(root_.find("base_pose"));
    for (const JsonCursor& arm : root_.at("arms").items()) robot_.arms.push_back(arm_of(arm));
    if (robot_.arms.empty()) root_.at("arms").fail("at least one arm");
    read_accelerations();
    read_home();
    read_ignored();
    read_obstacles();
    if (const auto camera = root_.find("camera")) read_camera(*camera);
    robot_.model.validate();
    return std::move(robot_);
  }

 private:
  RobotModel& model() { return robot_.model; }

  void read_model() {
    const LockedJoints locked = numbers_of(root_.find("locked"));
    const std::string urdf = root_.at("urdf").string();
    if (const IncludedRobot* robot = find_included(urdf)) {
      robot_.model = parse_urdf(robot->urdf(), urdf + ".urdf", locked, robot_.warnings);
      return;
    }
    const fs::path path = folder_ / urdf;
    robot_.model = parse_urdf(read_file(path), path.string(), locked, robot_.warnings);
  }

  template <class Call>
  auto naming(const JsonCursor& json, const Call& call) {
    try {
      return call();
    } catch (const InputError& error) {
      throw InputError(json.where(), error.expected(), error.found());
    }
  }

  std::size_t link_of(const JsonCursor& json) {
    return naming(json, [&] { return model().link_index(json.string()); });
  }

  Joint& moving_joint(const JsonCursor& json, const std::string& name) {
    Joint& joint = model().joints[naming(json, [&] { return model().joint_index(name); })];
    if (!joint.position) json.fail("a joint that moves");
    return joint;
  }

  RobotArm arm_of(const JsonCursor& json) {
    require_known(json,
                  {"name", "base_link", "tip_link", "gripper", "wrist_pose", "finger_joints"});
    const std::string name = json.at("name").string();
    for (const RobotArm& other : robot_.arms) {
      if (other.arm.name == name) json.at("name").fail("a name of its own for each arm");
    }
    const std::string& base = model().links[link_of(json.at("base_link"))].name;
    const std::string& tip = model().links[link_of(json.at("tip_link"))].name;
    RobotArm arm;
    arm.arm = naming(json.at("tip_link"), [&] { return make_arm(model(), name, base, tip); });
    if (arm.arm.positions.empty()) json.at("tip_link").fail("an arm with a moving joint");
    arm.T_tip_wrist = robot_pose(json.find("wrist_pose"));
    if (const auto gripper = json.find("gripper")) arm.gripper = gripper_of(gripper->string());
    for (const auto& [joint, share] : numbers_of(json.find("finger_joints")))
      arm.finger_joints.push_back({joint, share});
    return arm;
  }

  /// A name stays; a file is found from where the description is.
  std::string gripper_of(const std::string& gripper) const {
    return is_gripper_file(gripper) ? (folder_ / gripper).string() : gripper;
  }

  void read_accelerations() {
    if (const auto limits = root_.find("acceleration_limits")) {
      for (const auto& [name, value] : limits->members()) {
        const double limit = value.number();
        if (!(limit > 0.0)) value.fail("a limit above 0");
        moving_joint(value, name).limits.acceleration = limit;
      }
    }
    for (const RobotArm& arm : robot_.arms) {
      for (const std::size_t index : arm.arm.joints) {
        const Joint& joint = model().joints[index];
        if (joint.position && !std::isfinite(joint.limits.acceleration))
          throw InputError(file_ + ": acceleration_limits",
                           fmt::format("a limit of joint {}", joint.name), "none");
      }
    }
  }

  void read_home() {
    const JsonCursor home = root_.at("home");
    robot_.home.setConstant(static_cast<Eigen::Index>(model().moving_joints()),
                            std::numeric_limits<double>::quiet_NaN());
    for (const auto& [name, value] : home.members()) {
      const Joint& joint = moving_joint(value, name);
      const double position = value.number();
      if (position < joint.limits.lower || position > joint.limits.upper)
        value.fail(
            fmt::format("a position in [{:g}, {:g}]", joint.limits.lower, joint.limits.upper));
      robot_.home[static_cast<Eigen::Index>(*joint.position)] = position;
    }
    for (const Joint& joint : model().joints) {
      if (joint.position && std::isnan(robot_.home[static_cast<Eigen::Index>(*joint.position)]))
        throw InputError(home.where(), fmt::format("a position of joint {}", joint.name), "none");
    }
  }

  void read_ignored() {
    const auto pairs = root_.find("ignored_collisions");
    if (!pairs) return;
    auto& ignored = model().ignored_pairs;
    for (const JsonCursor& pair : pairs->items()) {
      const std::vector<JsonCursor> names = pair.items(2);
      const std::size_t a = link_of(names[0]), b = link_of(names[1]);
      if (a == b) pair.fail("two links");
      ignored.emplace_back(std::min(a, b), std::max(a, b));
    }
    std::sort(ignored.begin(), ignored.end());
    ignored.erase(std::unique(ignored.begin(), ignored.end()), ignored.end());
  }

  void read_obstacles() {
    const auto obstacles = root_.find("obstacles");
    if (!obstacles) return;
    for (const JsonCursor& json : obstacles->items()) {
      require_known(json, {"begin_m", "end_m", "radius_m"});
      const Capsule capsule{json.at("begin_m").vector3(), json.at("end_m").vector3(),
                            json.at("radius_m").number()};
      if (!(capsule.radius > 0.0)) json.at("radius_m").fail("a radius above 0");
      model().links.front().capsules.push_back(capsule);
    }
  }

  void read_camera(const JsonCursor& json) {
    require_known(json, {"link", "pose"});
    RobotCamera camera;
    camera.link = link_of(json.at("link"));
    camera.T_link_camera = robot_pose(json.find("pose"));
    const std::vector<std::size_t> bodies = rigid_bodies(model());
    for (std::size_t i = 0; i < robot_.arms.size() && !camera.arm; ++i) {
      if (bodies[camera.link] == bodies[robot_.arms[i].arm.tip_link]) camera.arm = i;
    }
    robot_.camera = camera;
  }

  JsonCursor root_;
  const std::string& file_;
  fs::path folder_;
  Robot robot_;
};

}  // namespace

std::vector<std::string> robot_names() {
  std::vector<std::string> names;
  for (const IncludedRobot& robot : included) names.emplace_back(robot.name);
  return names;
}

Robot parse_robot(std::string_view text, const std::string& file, const fs::path& folder) {
  const Json document = with_included(parse_yaml(text, file), file);
  return RobotReader(JsonCursor(document, file), file, folder).read();
}

Robot read_robot(const std::string& name_or_file) {
  if (const IncludedRobot* robot = find_included(name_or_file))
    return parse_robot(robot->yaml(), robot->name, {});
  const fs::path path(name_or_file);
  if (!is_yaml(path))
    throw InputError("robot",
                     fmt::format("one of {}, or a .yaml file", fmt::join(robot_names(), ", ")),
                     with_nearest_name(name_or_file, robot_names()));
  return parse_robot(read_file(path), path.string(), path.parent_path());
}

}  // namespace symscene
