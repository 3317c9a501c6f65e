// grasps.json is read as it was written, and refused in one sentence.
#include "symscene/io/grasps.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

GraspPlan two_grasps() {
  GraspPlan plan;
  Grasp grasp;
  grasp.quality = 0.75;
  grasp.opening = 0.04;
  grasp.source = GraspSource::rim;
  grasp.T_world_tool.linear() = Eigen::AngleAxisd(3.0, Eigen::Vector3d(1, 2, 2) / 3.0).matrix();
  grasp.T_world_tool.translation() = Eigen::Vector3d(0.1, -0.2, 3.0);
  grasp.features.tilt = 0.3;
  plan.grasps = {grasp, grasp};
  plan.grasps[1].object = 1;
  plan.grasps[1].quality = 0.5;
  plan.rejected.push_back({grasp, GraspRejection::table, -0.01, 0.002});
  plan.objects = {{2, 1, {}, {}}, {1, 1, {}, {}}, {0, 0, {}, GraspRejection::no_surface}};
  plan.objects[0].rejected.at(static_cast<std::size_t>(GraspRejection::table)) = 1;
  plan.timings.push_back({"candidates", 0.1});
  return plan;
}

Gripper small_hand() {
  Gripper gripper;
  gripper.name = "hand";
  gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.0, 0.0, 0.06);
  return gripper;
}

nlohmann::json written() {
  return nlohmann::json::parse(format_grasps_json(two_grasps(), small_hand()));
}

std::string grasps_refusal(const std::string& text) {
  return refusal([&] { parse_grasps_json(text, "grasps.json"); });
}

TEST(GraspsReader, ReadsWhatWasWritten) {
  const GraspPlan plan = two_grasps();
  const GraspFile file = parse_grasps_json(format_grasps_json(plan, small_hand()), "grasps.json");
  EXPECT_EQ(file.gripper.name, "hand");
  EXPECT_EQ(file.gripper.T_wrist_tool.translation().z(), 0.06);
  ASSERT_EQ(file.plan.grasps.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Grasp& read = file.plan.grasps[i];
    EXPECT_EQ(read.object, plan.grasps[i].object);
    EXPECT_EQ(read.quality, plan.grasps[i].quality);
    EXPECT_EQ(read.opening, plan.grasps[i].opening);
    EXPECT_EQ(read.source, GraspSource::rim);
    EXPECT_EQ(read.features.tilt, 0.3);
    EXPECT_TRUE(read.T_world_tool.isApprox(plan.grasps[i].T_world_tool, 1e-12));
  }
  ASSERT_EQ(file.plan.objects.size(), 3U);
  EXPECT_EQ(file.plan.objects[0].rejected, plan.objects[0].rejected);
  EXPECT_EQ(file.plan.objects[2].reason, GraspRejection::no_surface);
  ASSERT_EQ(file.plan.rejected.size(), 1U);
  EXPECT_EQ(file.plan.rejected[0].reason, GraspRejection::table);
  EXPECT_EQ(file.plan.rejected[0].value, -0.01);
}

TEST(GraspsReader, NeedsOnlyWhatAnotherPlannerKnows) {
  nlohmann::json json = written();
  for (const char* member : {"rejected", "timings"}) json.erase(member);
  for (auto& grasp : json["grasps"]) {
    grasp.erase("features");
    grasp.erase("T_world_wrist");
  }
  std::swap(json["grasps"][0], json["grasps"][1]);
  const GraspFile file = parse_grasps_json(json.dump(), "grasps.json");
  ASSERT_EQ(file.plan.grasps.size(), 2U);
  EXPECT_EQ(file.plan.grasps[0].quality, 0.75) << "best first";
}

TEST(GraspsReader, RefusesInOneSentenceWithThePlace) {
  const auto refused = [](const auto& change) {
    nlohmann::json json = written();
    change(json);
    return grasps_refusal(json.dump());
  };
  using Json = nlohmann::json;
  const std::vector<std::pair<std::string, std::string>> cases{
      {grasps_refusal("[1]"), "grasps.json"},
      {grasps_refusal("{"), "JSON"},
      {refused([](Json& j) { j["version"] = 2; }), "version: expected 1"},
      {refused([](Json& j) { j.erase("gripper"); }), "a member \"gripper\""},
      {refused([](Json& j) { j["gripper"]["max_opening_m"] = -1; }), "gripper: max_opening_m"},
      {refused([](Json& j) { j["grasps"][1]["object"] = 3; }), "grasps[1].object"},
      {refused([](Json& j) { j["grasps"][0]["object"] = -1; }), "grasps[0].object"},
      {refused([](Json& j) { j["grasps"][0]["quality"] = 1.5; }), "a quality in [0, 1]"},
      {refused([](Json& j) { j["grasps"][0]["opening_m"] = 0.5; }), "grasps[0].opening_m"},
      {refused([](Json& j) { j["grasps"][0]["source"] = "luck"; }), "the source of a grasp"},
      {refused([](Json& j) { j["grasps"][0]["T_world_tool"]["orientation_xyzw"][0] = 7; }),
       "a unit quaternion"},
      {refused([](Json& j) { j["grasps"][0]["T_world_tool"]["position_m"][0] = nullptr; }),
       "position_m[0]"},
      {refused([](Json& j) { j["grasps"][0]["features"].erase("tilt"); }), "\"tilt\""},
      {refused([](Json& j) { j["objects"][1]["id"] = 0; }), "objects[1].id"},
      {refused([](Json& j) { j["rejected"][0]["reason"] = "luck"; }), "rejected[0].reason"}};
  for (const auto& [refusal, sentence] : cases) {
    EXPECT_NE(refusal.find(sentence), std::string::npos) << sentence << " in: " << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
  }
}

}  // namespace
}  // namespace symscene
