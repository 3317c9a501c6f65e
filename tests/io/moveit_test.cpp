// Messages of MoveIt by the names and types of their fields, and what they say.
#include "symscene/io/moveit.hpp"

#include <algorithm>

#include <functional>
#include <numbers>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/yaml.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/grasping_msgs.hpp"

namespace symscene {
namespace {

/// The fields of a message: numbers, texts, messages, and lists of one kind.
using Check = std::function<std::string(const Json&)>;

Check is(const char* what, bool (*holds)(const Json&)) {
  return
      [=](const Json& json) { return holds(json) ? "" : std::string(what) + ": " + json.dump(); };
}
const Check number = is("number", [](const Json& j) { return j.is_number(); });
const Check whole = is("whole number", [](const Json& j) { return j.is_number_integer(); });
const Check text = is("text", [](const Json& j) { return j.is_string(); });

Check list(const Check& item) {
  return [=](const Json& json) -> std::string {
    if (!json.is_array()) return "list: " + json.dump();
    for (const Json& value : json) {
      if (const std::string found = item(value); !found.empty()) return found;
    }
    return "";
  };
}

/// Exactly these fields: ROS refuses others.
Check message(const std::vector<std::pair<std::string, Check>>& fields) {
  return [=](const Json& json) -> std::string {
    if (!json.is_object() || json.size() != fields.size()) return "fields: " + json.dump();
    for (const auto& [name, check] : fields) {
      if (!json.contains(name)) return "no " + name;
      if (const std::string found = check(json.at(name)); !found.empty()) return name + "." + found;
    }
    return "";
  };
}

const Check time_message = message({{"sec", whole}, {"nanosec", whole}});
const Check header = message({{"stamp", time_message}, {"frame_id", text}});
const Check vector3 = message({{"x", number}, {"y", number}, {"z", number}});
const Check quaternion = message({{"x", number}, {"y", number}, {"z", number}, {"w", number}});
const Check pose = message({{"position", vector3}, {"orientation", quaternion}});
const Check point = message({{"positions", list(number)},
                             {"velocities", list(number)},
                             {"accelerations", list(number)},
                             {"effort", list(number)},
                             {"time_from_start", time_message}});
const Check posture =
    message({{"header", header}, {"joint_names", list(text)}, {"points", list(point)}});
const Check translation =
    message({{"direction", message({{"header", header}, {"vector", vector3}})},
             {"desired_distance", number},
             {"min_distance", number}});
const Check grasp_message = message({{"id", text},
                                     {"pre_grasp_posture", posture},
                                     {"grasp_posture", posture},
                                     {"grasp_pose", message({{"header", header}, {"pose", pose}})},
                                     {"grasp_quality", number},
                                     {"pre_grasp_approach", translation},
                                     {"post_grasp_retreat", translation},
                                     {"post_place_retreat", translation},
                                     {"max_contact_force", number},
                                     {"allowed_touch_objects", list(text)}});
const Check mesh = message(
    {{"triangles", list(message({{"vertex_indices", list(whole)}}))}, {"vertices", list(vector3)}});
const Check mesh_object =
    message({{"header", header}, {"id", text}, {"meshes", list(mesh)}, {"mesh_poses", list(pose)}});
const Check box_object =
    message({{"header", header},
             {"id", text},
             {"primitives", list(message({{"type", whole}, {"dimensions", list(number)}}))},
             {"primitive_poses", list(pose)}});

const Check robot_trajectory =
    message({{"joint_trajectory", posture},
             {"multi_dof_joint_trajectory",
              message({{"header", header},
                       {"joint_names", list(text)},
                       {"points", list(is("nothing", [](const Json&) { return false; }))}})}});

/// Some of these fields: those that are left out have their default.
Check part_of_message(const std::vector<std::pair<std::string, Check>>& fields) {
  return [=](const Json& json) -> std::string {
    for (const auto& [name, value] : json.items()) {
      const auto field =
          std::find_if(fields.begin(), fields.end(),
                       [&key = name](const auto& each) { return each.first == key; });
      if (field == fields.end()) return "field " + name;
      if (const std::string found = field->second(value); !found.empty()) return name + "." + found;
    }
    return "";
  };
}
const Check grasping_object =
    part_of_message({{"header", header},
                     {"name", text},
                     {"support_surface", text},
                     {"properties", list(message({{"name", text}, {"value", text}}))},
                     {"primitives", list(message({{"type", whole}, {"dimensions", list(number)}}))},
                     {"primitive_poses", list(pose)},
                     {"meshes", list(mesh)},
                     {"mesh_poses", list(pose)},
                     {"surface", message({{"coef", list(number)}})}});
const Check graspable_objects = message(
    {{"objects", list(message({{"object", grasping_object}, {"grasps", list(grasp_message)}}))},
     {"support_surfaces", list(grasping_object)}});

struct MoveItTest : ::testing::Test {
  Gripper gripper;
  std::vector<Grasp> grasps{Grasp{}};
  std::vector<TriangleMesh> surfaces{TriangleMesh{}, TriangleMesh{}};
  Eigen::Isometry3d T_base_world{Eigen::Translation3d(0.5, 0.0, 0.1)};

  MoveItTest() {
    gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.0, 0.0, 0.06);
    grasps[0].object = 1;
    grasps[0].opening = 0.04;
    grasps[0].quality = 0.8;
    grasps[0].T_world_tool =  // straight down
        Eigen::Translation3d(0.1, 0.2, 0.3) *
        Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
    surfaces[1].vertices.resize(4, 3);
    surfaces[1].vertices << 0, 0, 0, 0.125F, 0, 0, 0, 0.25F, 0, 0, 0, 1e-5F;
    surfaces[1].triangles.resize(4, 3);
    surfaces[1].triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  }
  MoveItScene scene() const {
    return {"base_link",
            T_base_world,
            grasps,
            gripper,
            gripper.T_wrist_tool.inverse(),
            surfaces,
            Plane{},
            {{"left", 0.5}, {"right", -0.5}}};
  }
};

Eigen::Vector3d vector_of(const Json& json) {
  return {json.at("x").get<double>(), json.at("y").get<double>(), json.at("z").get<double>()};
}

TEST_F(MoveItTest, HasTheFieldsOfTheMessages) {
  const Json json = Json::parse(format_moveit_json(scene()));
  ASSERT_EQ(json.at("grasps").size(), 1U);
  EXPECT_EQ(grasp_message(json.at("grasps")[0]), "");
  ASSERT_EQ(json.at("collision_objects").size(), 2U) << "the empty surface is left out";
  EXPECT_EQ(mesh_object(json.at("collision_objects")[0]), "");
  EXPECT_EQ(box_object(json.at("collision_objects")[1]), "");
}

TEST_F(MoveItTest, GivesThePoseOfTheWristInTheFrame) {
  const Json grasp = Json::parse(format_moveit_json(scene())).at("grasps")[0];
  EXPECT_EQ(grasp.at("grasp_pose").at("header").at("frame_id"), "base_link");
  const Json& at = grasp.at("grasp_pose").at("pose");
  EXPECT_TRUE(vector_of(at.at("position")).isApprox(Eigen::Vector3d(0.6, 0.2, 0.46), 1e-9));
  const auto direction = [&](const char* way) {
    return vector_of(grasp.at(way).at("direction").at("vector"));
  };
  EXPECT_TRUE(direction("pre_grasp_approach").isApprox(-Eigen::Vector3d::UnitZ(), 1e-9));
  EXPECT_TRUE(direction("post_grasp_retreat").isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
  EXPECT_EQ(grasp.at("pre_grasp_approach").at("desired_distance"), gripper.approach_distance);
  EXPECT_EQ(grasp.at("pre_grasp_posture").at("points")[0].at("positions"), Json({0.04, -0.04}));
  EXPECT_EQ(grasp.at("grasp_posture").at("points")[0].at("positions"), Json({0.02, -0.02}));
  EXPECT_EQ(grasp.at("allowed_touch_objects"), Json::array({"object_1"}));
}

TEST_F(MoveItTest, RetreatsTheWayThatTheHandCameWhereNoTableTellsWhatIsUp) {
  grasps[0].T_world_tool = Eigen::Isometry3d::Identity();  // along z, as a camera looks
  MoveItScene without = scene();
  without.table.reset();
  const Json grasp = Json::parse(format_moveit_json(without)).at("grasps")[0];
  const Json& retreat = grasp.at("post_grasp_retreat").at("direction").at("vector");
  EXPECT_TRUE(vector_of(retreat).isApprox(-Eigen::Vector3d::UnitZ(), 1e-9));
}

TEST_F(MoveItTest, PutsObjectsIntoTheFrameAndTheTableBelowThem) {
  const Json objects = Json::parse(format_moveit_json(scene())).at("collision_objects");
  EXPECT_EQ(objects[0].at("id"), "object_1");
  const Json& vertices = objects[0].at("meshes")[0].at("vertices");
  EXPECT_TRUE(vector_of(vertices[1]).isApprox(Eigen::Vector3d(0.625, 0.0, 0.1), 1e-9));
  EXPECT_EQ(objects[0].at("meshes")[0].at("triangles")[1].at("vertex_indices"), Json({0, 1, 3}));
  const Json& box = objects[1].at("primitives")[0];
  EXPECT_EQ(box.at("type"), 1);
  const double top = objects[1].at("primitive_poses")[0].at("position").at("z").get<double>() +
                     0.5 * box.at("dimensions")[2].get<double>();
  EXPECT_NEAR(top, 0.1, 1e-12);
  EXPECT_GT(box.at("dimensions")[0].get<double>(), 0.125 + 2.0 * gripper.finger_depth);
}

TEST_F(MoveItTest, LeavesThePosturesEmptyWithoutJoints) {
  MoveItScene without = scene();
  without.finger_joints.clear();
  const Json grasp = Json::parse(format_moveit_json(without)).at("grasps")[0];
  EXPECT_TRUE(grasp.at("grasp_posture").at("points").empty());
}

TEST_F(MoveItTest, HoldsTheTrajectoryAsRobotTrajectory) {
  EXPECT_FALSE(Json::parse(format_moveit_json(scene())).contains("robot_trajectory"));
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const JointTrajectory trajectory{{"joint"}, {{0.0, one, 0.0 * one, one}, {0.5, one, one, one}}};
  MoveItScene moving = scene();
  moving.trajectory = &trajectory;
  const Json json = Json::parse(format_moveit_json(moving)).at("robot_trajectory");
  EXPECT_EQ(robot_trajectory(json), "");
  EXPECT_EQ(json.at("joint_trajectory").at("joint_names"), Json::array({"joint"}));
  EXPECT_EQ(json.at("joint_trajectory").at("points")[1].at("time_from_start").at("nanosec"),
            500'000'000);
}

TEST_F(MoveItTest, GroupsGraspsByObjectAsGraspingMsgs) {
  const std::vector<std::string> classes{"", "box"};
  const Json json = Json::parse(format_graspable_objects_json(scene(), classes));
  EXPECT_EQ(graspable_objects(json), "");
  ASSERT_EQ(json.at("objects").size(), 2U);
  EXPECT_TRUE(json.at("objects")[0].at("grasps").empty());
  const Json& graspable = json.at("objects")[1];
  EXPECT_EQ(graspable.at("grasps"), Json::parse(format_moveit_json(scene())).at("grasps"));
  EXPECT_EQ(graspable.at("object").at("properties")[0].at("value"), "box");
  EXPECT_EQ(graspable.at("object").at("support_surface"),
            json.at("support_surfaces")[0].at("name"));
}

/// z = 0 of the world is 0.1 m above the frame's origin.
TEST_F(MoveItTest, GivesTheTablesPlaneInTheFrame) {
  const Json json = Json::parse(format_graspable_objects_json(scene()));
  const Json& coef = json.at("support_surfaces")[0].at("surface").at("coef");
  const std::vector<double> expected{0.0, 0.0, 1.0, -0.1};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(coef[k].get<double>(), expected[k], 1e-12);
}

TEST_F(MoveItTest, NamesTimesAsRos1Does) {
  const Json json = Json::parse(format_moveit_json(scene(), RosVersion::ros1));
  EXPECT_EQ(json.at("grasps")[0].at("grasp_pose").at("header").at("stamp"),
            Json({{"secs", 0}, {"nsecs", 0}}));
}

TEST_F(MoveItTest, WritesNumbersThatYaml11TakesForNumbers) {
  grasps[0].quality = 1e-5;
  const std::string yaml = format_moveit_yaml(scene());
  EXPECT_NE(yaml.find("1.0e-05"), std::string::npos);
  EXPECT_FALSE(std::regex_search(yaml, std::regex("[ -][0-9]+e")));
}

TEST_F(MoveItTest, SaysTheSameAsYaml) {
  try {
    parse_yaml("a: 1", "yaml");
  } catch (const InputError&) {
    GTEST_SKIP() << "a build without a reader of YAML";
  }
  grasps[0].quality = 1e-5;
  EXPECT_EQ(parse_yaml(format_moveit_yaml(scene()), "yaml"),
            Json::parse(format_moveit_json(scene())));
  EXPECT_EQ(parse_yaml(format_graspable_objects_yaml(scene()), "yaml"),
            Json::parse(format_graspable_objects_json(scene())));
}

}  // namespace
}  // namespace symscene
