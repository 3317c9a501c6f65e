#include "symscene/io/gripper.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/io_support.hpp"
#include "symscene/io/grasps.hpp"

namespace symscene {
namespace {

using namespace io_test;

constexpr const char* smallest = R"({"name": "clamp", "kind": "parallel", "max_opening_m": 0.06,
  "finger_depth_m": 0.04, "palm_size_m": [0.05, 0.1, 0.08]})";

std::string gripper_refusal(const std::string& text) {
  return refusal([&] { parse_gripper(text, "hand.json"); });
}

TEST(GripperFile, NeedsOnlyWhatHasNoDefault) {
  const Gripper gripper = parse_gripper(smallest, "hand.json");
  EXPECT_EQ(gripper.name, "clamp");
  EXPECT_EQ(gripper.max_opening, 0.06);
  EXPECT_EQ(gripper.palm_size, Eigen::Vector3d(0.05, 0.1, 0.08));
  EXPECT_EQ(gripper.force, Gripper{}.force);
}

TEST(GripperFile, MakesFingersThatTaperOnlyToAGivenTip) {
  const Gripper even =
      parse_gripper(replaced(smallest, "0.06", "0.06, \"finger_thickness_m\": 0.005"), "hand.json");
  EXPECT_EQ(even.tip_thickness, 0.005);
  const Gripper tapered = parse_gripper(
      replaced(smallest, "0.06", "0.06, \"finger_thickness_m\": 0.03, \"tip_thickness_m\": 0.01"),
      "hand.json");
  EXPECT_EQ(tapered.tip_thickness, 0.01);
  EXPECT_EQ(parse_gripper(smallest, "hand.json").tip_thickness, Gripper{}.tip_thickness);
}

TEST(GripperFile, IsReadAsItWasWritten) {
  Gripper gripper;
  gripper.name = "three";
  gripper.kind = GripperKind::three_finger;
  gripper.finger_spacing = 0.05;
  gripper.friction = 0.7;
  gripper.T_wrist_tool.linear() = Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitY()).matrix();
  gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.01, 0.0, 0.1);
  const std::string text = format_gripper(gripper);
  const Gripper read = parse_gripper(text, "hand.json");
  EXPECT_EQ(read.kind, gripper.kind);
  EXPECT_EQ(read.finger_spacing, gripper.finger_spacing);
  EXPECT_EQ(read.friction, gripper.friction);
  EXPECT_TRUE(read.T_wrist_tool.isApprox(gripper.T_wrist_tool, 1e-12));
  EXPECT_EQ(parse_gripper(text, "hand.json").palm_size, gripper.palm_size);
}

TEST(GripperFile, OfYamlHasTheMembersOfJson) {
  const std::string yaml = R"(name: clamp
kind: parallel
max_opening_m: 0.06  # between the pads
finger_depth_m: 0.04
palm_size_m: [0.05, 0.1, 0.08]
)";
#ifdef SYMSCENE_HAS_ROBOTS
  const Gripper gripper = parse_gripper(yaml, "hand.yaml");
  EXPECT_EQ(format_gripper(gripper), format_gripper(parse_gripper(smallest, "hand.json")));
  EXPECT_THROW(parse_gripper(replaced(yaml, "_m: 0.06", "_mm: 60"), "hand.yml"), InputError);
#else
  EXPECT_THROW(parse_gripper(yaml, "hand.yaml"), InputError);
#endif
  EXPECT_THROW(parse_gripper(yaml, "hand.json"), InputError);
}

TEST(GripperFile, RefusesWhatItDoesNotKnowInOneSentence) {
  for (const auto& [text, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"{", "hand.json"},
           {replaced(smallest, "max_opening_m", "max_opening_mm"), "max_opening_mm"},
           {replaced(smallest, "\"parallel\"", "\"claw\""), "hand.json: kind"},
           {replaced(smallest, "0.06", "\"wide\""), "max_opening_m"},
           {replaced(smallest, "0.06", "-0.06"), "hand.json: max_opening_m: expected"},
           {replaced(smallest, "\"name\": \"clamp\", ", ""), "name"},
           {replaced(smallest, "0.06", "0.06, \"min_opening_m\": 0.07"),
            "max_opening_m: expected more than min_opening_m, found"},
           {replaced(smallest, "0.05", "-0.05"), "hand.json: palm_size_m: expected"},
           {replaced(smallest, "max_opening_m", "max_opening"),
            "\"max_opening\": expected \"max_opening_m\", with its unit, found 0.06"},
           {replaced(smallest, "0.06", "0.06, \"force_N\": 0"), "force_N: expected"},
           {replaced(smallest, "0.06", "60"), "max_opening_m: expected"},
           {replaced(smallest, "0.06",
                     "0.06, \"T_wrist_tool\": {\"position_m\": [0, 0, 62],"
                     "\"orientation_xyzw\": [0, 0, 0, 1]}"),
            "T_wrist_tool: expected an origin within 2 m"},
           {replaced(smallest, "0.06",
                     "0.06, \"T_wrist_tool\": {\"position_m\": [0, 0, 0],"
                     "\"orientation_xyzw\": [0, 0, 0, 1], \"frame\": \"wrist\"}"),
            "expected no member of this name"},
           {replaced(smallest, "parallel", "three_finger"),
            "finger_spacing_m: expected at least finger_width_m, so"}}) {
    const std::string refusal = gripper_refusal(text);
    EXPECT_NE(refusal.find(sentence), std::string::npos) << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
  }
}

GraspPlan small_plan() {
  GraspPlan plan;
  Grasp grasp;
  grasp.quality = 0.75;
  grasp.opening = 0.04;
  grasp.source = GraspSource::mirror_plane;
  grasp.T_world_tool.linear() = Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitX()).matrix();
  grasp.T_world_tool.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  plan.grasps.push_back(grasp);
  plan.rejected.push_back({grasp, GraspRejection::table, -0.01, 0.002});
  plan.objects.resize(2);
  plan.objects[0] = {2, 1, {}, {}};
  plan.objects[0].rejected.at(static_cast<std::size_t>(GraspRejection::table)) = 1;
  plan.objects[1].reason = GraspRejection::no_surface;
  plan.timings.push_back({"candidates", 0.1});
  return plan;
}

TEST(GraspsFile, HasThePosesOfToolAndWrist) {
  Gripper gripper;
  gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.0, 0.0, 0.062);
  const auto json = nlohmann::json::parse(format_grasps_json(small_plan(), gripper));
  const auto& grasp = json.at("grasps").at(0);
  const auto position = [&](const char* pose) {
    const auto values = grasp.at(pose).at("position_m").get<std::vector<double>>();
    return Eigen::Vector3d(values[0], values[1], values[2]);
  };
  const Eigen::Vector3d tool = position("T_world_tool");
  EXPECT_EQ(tool, Eigen::Vector3d(0.1, 0.2, 0.3));
  const Eigen::Vector3d approach =
      Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(position("T_world_wrist").isApprox(tool - 0.062 * approach, 1e-9));
  EXPECT_EQ(grasp.at("source"), "mirror_plane");
  EXPECT_TRUE(grasp.at("features").contains("cone_margin"));
}

TEST(GraspsFile, SaysWhyAnObjectHasNoGrasp) {
  const auto json = nlohmann::json::parse(format_grasps_json(small_plan(), Gripper{}));
  EXPECT_EQ(json.at("objects").at(1).at("reason"), "no_surface");
  EXPECT_FALSE(json.at("objects").at(0).contains("reason"));
  EXPECT_EQ(json.at("objects").at(0).at("rejected").at("table"), 1);
  EXPECT_EQ(json.at("rejected").at(0).at("value"), -0.01);
}

TEST(GraspsFile, WithoutTimesHasTheSameBytesForEqualPlans) {
  GraspPlan slower = small_plan();
  slower.timings[0].seconds = 2.0;
  EXPECT_EQ(format_grasps_json(small_plan(), Gripper{}, false),
            format_grasps_json(slower, Gripper{}, false));
}

}  // namespace
}  // namespace symscene
