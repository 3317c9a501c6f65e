// `symscene plan` from outside: grasps, scenes and results in, trajectories out.
#include <map>
#include <sstream>

#include "cli/json_schema.hpp"
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

class PlanCommand : public Command {
 protected:
  static nlohmann::json json_of(const std::string& name) {
    return nlohmann::json::parse(contents(file(name)));
  }
  /// Grasps of the small scene.
  static void write_grasps() {
    if (fs::exists(file("grasps.json"))) return;
    ASSERT_EQ(run("grasp result --scene scene -o grasps.json").code, 0);
  }
  static double seconds(const nlohmann::json& time) {
    return time.at("sec").get<double>() + 1e-9 * time.at("nanosec").get<double>();
  }
};

#ifndef SYMSCENE_HAS_ROBOTS

TEST_F(PlanCommand, SaysWhichPackagesItNeeds) {
  expect_refusal("plan result -o trajectory.json", 1, "-dev");
}

#else

TEST_F(PlanCommand, WritesATrajectoryFromHomeToRest) {
  write_grasps();
  const Outcome outcome = run("plan grasps.json --result result -o trajectory.json -v");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  EXPECT_NE(outcome.out.find("not reached"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("grasp positions"), std::string::npos) << outcome.out;
  const auto json = json_of("trajectory.json");
  const auto& message = json.at("joint_trajectory");
  EXPECT_EQ(message.at("joint_names").at(6), "panda_joint7");
  const auto& points = message.at("points");
  ASSERT_GT(points.size(), 10U);
  EXPECT_EQ(points.front().at("positions").at(3), -2.356194);
  EXPECT_EQ(seconds(points.front().at("time_from_start")), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_GT(seconds(points[i].at("time_from_start")),
              seconds(points[i - 1].at("time_from_start")));
  EXPECT_EQ(points.back().at("velocities"), nlohmann::json(std::vector<double>(7, 0.0)));
  const auto& taken = json.at("grasp");
  const auto grasp = json_of("grasps.json").at("grasps").at(taken.at("index").get<std::size_t>());
  EXPECT_EQ(grasp.at("object"), taken.at("object"));
  EXPECT_EQ(json.at("gripper").back().at("opening_m"), grasp.at("opening_m"));
}

TEST_F(PlanCommand, ConformsToItsSchemaWithAllGraspsJudged) {
  write_grasps();
  auto few = json_of("grasps.json");
  while (few["grasps"].size() > 3) few["grasps"].erase(few["grasps"].size() - 1);
  write(file("few.json"), few.dump());
  const std::string all = "plan few.json --result result --all --json -o all.json";
  const Outcome outcome = run(all);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(JsonSchema("trajectory.schema.json").violation(json_of("all.json")), "");
  const auto report = last_line(outcome.out);
  EXPECT_EQ(report.at("reached").get<int>() + report.at("not_reached").get<int>(),
            report.at("grasps").get<int>());
  EXPECT_EQ(report.at("not_reached"), json_of("all.json").at("not_reached").size());
  ASSERT_EQ(run(all + " --ros 1").code, 0);
  EXPECT_EQ(JsonSchema("trajectory.schema.json").violation(json_of("all.json")), "");
}

TEST_F(PlanCommand, PlansTheGraspsOfAnObjectAndWritesThemForMoveIt) {
  const Outcome outcome =
      run("plan result --scene scene --object 0 --moveit moveit.json"
          " --grasping-msgs objects.json -o object.json");
  ASSERT_TRUE(outcome.code == 0 || fs::exists(file("moveit.json"))) << outcome.err;
  const auto json = json_of("moveit.json");
  for (const auto& grasp : json.at("grasps")) {
    EXPECT_EQ(grasp.at("grasp_pose").at("header").at("frame_id"), "panda_link0");
    EXPECT_EQ(grasp.at("allowed_touch_objects").at(0), "object_0");
    EXPECT_EQ(grasp.at("grasp_posture").at("joint_names"),
              nlohmann::json({"panda_finger_joint1", "panda_finger_joint2"}));
  }
  const auto& objects = json.at("collision_objects");
  EXPECT_EQ(objects.back().at("id"), "table");
  EXPECT_LT(fs::file_size(file("moveit.json")), 1'000'000U);
  EXPECT_EQ(json_of("objects.json").at("objects").at(0).at("grasps"), json.at("grasps"));
  EXPECT_EQ(json.contains("robot_trajectory"), outcome.code == 0);
  EXPECT_EQ(objects.size(), objects_without_times("result").at("objects").size() + 1);
  ASSERT_EQ(run("plan result --scene scene --object 0 --moveit moveit.yaml -o object.json").code,
            outcome.code);
  EXPECT_NE(contents(file("moveit.yaml")).find("\"collision_objects\":"), std::string::npos);
}

TEST_F(PlanCommand, WritesTheSamePointsAsCsv) {
  write_grasps();
  ASSERT_EQ(run("plan grasps.json --result result -o trajectory.json").code, 0);
  ASSERT_EQ(run("plan grasps.json --result result -o trajectory.csv").code, 0);
  std::istringstream lines(contents(file("trajectory.csv")));
  std::size_t count = 0;
  std::string line, first, header;
  std::getline(lines, header);
  EXPECT_TRUE(header.starts_with("time_s,part,panda_joint1_position")) << header;
  for (; std::getline(lines, line); ++count) {
    if (count == 0) first = line;
  }
  EXPECT_EQ(count, json_of("trajectory.json").at("joint_trajectory").at("points").size());
  EXPECT_TRUE(first.starts_with("0,to_pre_grasp,0,")) << first;
}

TEST_F(PlanCommand, StartsWhereTheJointsAreAndNamesTimesAsRos1) {
  write_grasps();
  const Outcome outcome =
      run("plan grasps.json --result result --start panda_joint1=0.3,panda_joint7=0.5 --ros 1"
          " -o started.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto point = json_of("started.json").at("joint_trajectory").at("points").at(0);
  EXPECT_EQ(point.at("positions").at(0), 0.3);
  EXPECT_EQ(point.at("positions").at(1), -0.785398);
  EXPECT_EQ(point.at("positions").at(6), 0.5);
  EXPECT_EQ(point.at("time_from_start").at("secs"), 0);
}

/// Of a page, without a browser: numbers of solids, and states of grasps.
nlohmann::json payload_of(const std::string& page) {
  const std::string begin = R"(id="payload">)";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

TEST_F(PlanCommand, DrawsTheMotionTheGraspsAndTheReachOnAPage) {
  write_grasps();
  const Outcome outcome =
      run("plan grasps.json --result result -o trajectory.json --page plan.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json payload = payload_of(contents(file("plan.html")));
  const nlohmann::json grasps = json_of("grasps.json");
  ASSERT_EQ(payload.at("plan").at("grasps").size(), grasps.at("grasps").size());
  std::map<std::string, std::size_t> states;
  for (const auto& grasp : payload.at("plan").at("grasps"))
    ++states[grasp.at("state").get<std::string>()];
  EXPECT_EQ(states["chosen"], 1U);
  EXPECT_EQ(states["not_reached"], json_of("trajectory.json").at("not_reached").size());
  EXPECT_FALSE(payload.at("plan").at("reach").is_null());
  EXPECT_EQ(payload.at("events").size(), 4U);
  std::map<std::string, std::size_t> kinds;
  for (const auto& solid : payload.at("solids")) {
    ++kinds[solid.at("kind").get<std::string>()];
    EXPECT_FALSE(solid.at("surface").is_null()) << solid.at("name");
  }
  EXPECT_GE(kinds["robot"], 7U) << "links of the arm";
  EXPECT_EQ(kinds["hand"], 3U) << "palm and fingers";
}

TEST_F(PlanCommand, ShowsOnAPageWhyNothingIsReached) {
  write_grasps();
  const Outcome outcome =
      run("plan grasps.json --result result --base 5,0,0,180 -o far.json --page far.html");
  EXPECT_EQ(outcome.code, 1);
  const nlohmann::json payload = payload_of(contents(file("far.html")));
  for (const auto& grasp : payload.at("plan").at("grasps"))
    EXPECT_EQ(grasp.at("reason"), "it is farther away than the arm is long");
  EXPECT_FALSE(fs::exists(file("far.json")));
  fs::remove(file("far.html"));
}

TEST_F(PlanCommand, SaysWhyNothingIsReached) {
  write_grasps();
  const auto before = snapshot();
  const Outcome outcome = run("plan grasps.json --result result --base 5,0,0,180 -o far.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("farther away than the arm is long"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.err.find("a grasp that the arm reaches"), std::string::npos) << outcome.err;
  EXPECT_EQ(snapshot(), before);
}

TEST_F(PlanCommand, WarnsThatTheSceneIsInAnotherFrame) {
  write_grasps();
  // On its side, as in the frame of a camera.
  const Outcome outcome =
      run("plan grasps.json --result result --base 5,0,0,0.70710678,0,0,0.70710678 -o far.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("leans 90 degrees"), std::string::npos) << outcome.err;
}

TEST_F(PlanCommand, RefusesARobotThatLeansUnlessItsWholePoseIsGiven) {
  write_grasps();
  write(file("leaning.yaml"),
        "robot: panda\nbase_pose: {position_m: [-0.5, 0, 0], rpy_deg: [0, 30, 0]}\n");
  const Outcome outcome = run("plan grasps.json --result result --robot leaning.yaml -o new.json");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("leans 30 degrees"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(file("new.json")));
  fs::remove(file("leaning.yaml"));
}

TEST_F(PlanCommand, RefusesInputsThatItCannotUse) {
  write_grasps();
  expect_refusal("plan grasps.json -o new.json", 1, "--scene or --result");
  expect_refusal("plan nowhere -o new.json", 1, "nowhere");
  expect_refusal("plan result --robot pand -o new.json", 2, "--robot: expected one of");
  expect_refusal("plan result --robot pand -o new.json", 2, "did you mean");
  expect_refusal("plan result --result result -o new.json", 2, "a grasps.json as input");
  expect_refusal("plan grasps.json --result result --gripper panda -o new.json", 2, "--gripper");
  expect_refusal("plan grasps.json --result result -o grasps.json", 1, "outside the input");
  expect_refusal("plan grasps.json --result result --robot pandda -o new.json", 2, "panda");
  expect_refusal("plan grasps.json --result result --arm left -o new.json", 2, "left");
  expect_refusal("plan grasps.json --result result --base 1,2,3 -o new.json", 2, "x,y,z,yaw");
  expect_refusal("plan grasps.json --result result --base 0,0,0,1,1,1,1 -o new.json", 2,
                 "a unit quaternion");
  expect_refusal("plan grasps.json --result result --start 1,2 -o new.json", 2, "7 numbers");
  expect_refusal("plan grasps.json --result result --start panda_joint1=9 -o new.json", 2,
                 "panda_joint1");
  expect_refusal("plan grasps.json --result result --start panda_joint9=0 -o new.json", 2,
                 "panda_joint");
  expect_refusal("plan grasps.json --result result --moveit m.txt -o new.json", 2, ".yaml");
  expect_refusal("plan grasps.json --result result --finger-joints a -o new.json", 2, "--moveit");
  EXPECT_NE(run("plan grasps.json --result result --object 99 -o new.json").err.find("--object"),
            std::string::npos);
  auto json = json_of("grasps.json");
  json["objects"].push_back({{"id", json["objects"].size()}, {"candidates", 0}, {"grasps", 0}});
  write(file("others.json"), json.dump());
  EXPECT_NE(run("plan others.json --result result -o new.json").err.find("others.json: objects"),
            std::string::npos);
  write(file("broken.json"), "{\"version\": 1}");
  EXPECT_NE(run("plan broken.json --result result -o new.json").err.find("\"gripper\""),
            std::string::npos);
  EXPECT_FALSE(fs::exists(file("new.json")));
}

#endif

}  // namespace
}  // namespace symscene::testing
