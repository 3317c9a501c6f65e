// `symscene grasp` from outside: scenes, results, grippers and what it refuses.
#include <Eigen/Core>
#include <sstream>

#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

class GraspCommand : public Command {
 protected:
  static nlohmann::json json_of(const std::string& name) {
    return nlohmann::json::parse(contents(file(name)));
  }
  static void copy(const std::string& from, const std::string& to) {
    fs::copy(file(from), file(to), fs::copy_options::recursive);
  }
  /// A scene folder with the top and one side of a box of these edges on the table z = 0. [m]
  static void write_box_scene(const std::string& name, double width, double height) {
    constexpr double step = 0.004;
    std::string points;
    int count = 0;
    for (double u = 0.0; u <= width; u += step) {
      for (double v = 0.0; v <= std::max(width, height); v += step) {
        if (v <= width) points += line(u, v, height) + "0 0 1\n";
        if (v <= height) points += line(u, 0.0, v) + "0 -1 0\n";
        count += (v <= width ? 1 : 0) + (v <= height ? 1 : 0);
      }
    }
    std::string header = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n";
    for (const char* property : {"x", "y", "z", "nx", "ny", "nz"})
      header += std::string("property float ") + property + "\n";
    fs::create_directories(file(name));
    write(file(name) / "cloud.ply", header + "end_header\n" + points);
    write(file(name) / "table_plane.txt", "0 0 1 0\n");
  }

 private:
  static std::string line(double x, double y, double z) {
    return std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + " ";
  }
};

TEST_F(GraspCommand, FindsTheGraspsOfAScene) {
  const Outcome outcome = run("grasp scene -o grasps.json -v");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("objects have a grasp"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("candidates"), std::string::npos) << outcome.out;
  const auto json = json_of("grasps.json");
  EXPECT_EQ(json.at("version"), 1);
  EXPECT_EQ(json.at("gripper").at("name"), "panda");
  EXPECT_EQ(json.at("objects").size(), objects_without_times("result").at("objects").size());
  for (const auto& object : json.at("objects"))
    EXPECT_EQ(object.contains("reason"), object.at("grasps") == 0);
}

TEST_F(GraspCommand, OfAResultWithItsSceneIsThatOfTheScene) {
  ASSERT_EQ(run("grasp scene -o of_scene.json").code, 0);
  const Outcome outcome = run("grasp result --scene scene -o of_result.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto a = json_of("of_scene.json");
  const auto b = json_of("of_result.json");
  ASSERT_EQ(a.at("objects").size(), b.at("objects").size());
  for (std::size_t i = 0; i < a.at("objects").size(); ++i)
    EXPECT_EQ(a.at("objects").at(i).at("candidates"), b.at("objects").at(i).at("candidates"));
}

TEST_F(GraspCommand, WarnsThatAResultDoesNotTellWhatWasNeverSeen) {
  const Outcome outcome = run("grasp result -o grasps.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("never seen counts as free"), std::string::npos) << outcome.err;
}

TEST_F(GraspCommand, WarnsThatASceneDoesNotTellWhatWasNeverSeen) {
  copy("scene", "unmapped");
  fs::remove(file("unmapped") / "occupancy.bt");
  const Outcome outcome = run("grasp result --scene unmapped -o grasps.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("unmapped: no occupancy"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("never seen counts as free"), std::string::npos) << outcome.err;
}

TEST_F(GraspCommand, TellsOnceWhatMissingOccupancyMeansForObjectsAndForTheGripper) {
  copy("scene", "unseen");
  fs::remove(file("unseen") / "occupancy.bt");
  const Outcome outcome = run("grasp unseen -o grasps.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::size_t warning = outcome.err.find("no occupancy");
  EXPECT_NE(outcome.err.find("as free for the gripper"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("no occupancy", warning + 1), std::string::npos) << outcome.err;
}

TEST_F(GraspCommand, NamesAReasonForAnObjectThatIsTooLarge) {
  write_box_scene("large", 0.2, 0.15);
  for (const char* command : {"grasp", "cylinders"}) {
    const Outcome outcome = run(std::string(command) + " large -o large.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = json_of("large.json");
    EXPECT_TRUE(json.at("grasps").empty());
    ASSERT_EQ(json.at("objects").size(), 1);
    EXPECT_EQ(json.at("objects").at(0).at("reason"),
              std::string(command) == "grasp" ? "too_wide" : "no_axis");
  }
}

TEST_F(GraspCommand, OfABareTableAreNone) {
  write_box_scene("flat", 0.8, 0.0);
  fs::remove(file("flat") / "table_plane.txt");
  const Outcome outcome = run("grasp flat -o flat.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(json_of("flat.json").at("objects").empty());
  EXPECT_NE(outcome.err.find("the table is bare"), std::string::npos) << outcome.err;
}

TEST_F(GraspCommand, TakesAFaceThatIsTooSmallForATableAsAnObject) {
  write_box_scene("face", 0.2, 0.0);
  fs::remove(file("face") / "table_plane.txt");
  ASSERT_EQ(run("grasp face -o face.json").code, 0);
  EXPECT_EQ(json_of("face.json").at("objects").size(), 1U);
}

TEST_F(GraspCommand, TakesAResultOfAnEarlierVersion) {
  copy("result", "earlier");
  auto json = json_of("earlier/objects.json");
  json["version"] = 1;
  for (auto& object : json["objects"]) {
    for (const char* member : {"class", "surface", "solid"}) object.erase(member);
    for (const char* kind : {"rotational", "reflectional"}) {
      for (auto& symmetry : object[kind]) symmetry["score"] = symmetry["residual"];
    }
  }
  write(file("earlier") / "objects.json", json.dump());
  for (std::size_t id = 0; id < json["objects"].size(); ++id)
    fs::remove(file("earlier") / "objects" / (std::to_string(id) + ".obj"));
  const Outcome outcome = run("grasp earlier -o grasps.json --page grasps.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("no closed surfaces"), std::string::npos) << outcome.err;
  for (const auto& object : json_of("grasps.json").at("objects"))
    EXPECT_EQ(object.at("reason"), "no_surface");
  EXPECT_NE(contents(file("grasps.html")).find("<title>earlier: grasps"), std::string::npos);
}

TEST_F(GraspCommand, RefusesAResultInMillimetres) {
  copy("result", "millimetres");
  const fs::path surface = file("millimetres") / "objects" / "0.obj";
  std::istringstream lines(contents(surface));
  std::ostringstream scaled;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.starts_with("v ") ? line.substr(2) : "");
    Eigen::Vector3d vertex;
    if (words >> vertex.x() >> vertex.y() >> vertex.z())
      scaled << "v " << 1000.0 * vertex.transpose() << "\n";
    else
      scaled << line << "\n";
  }
  write(surface, scaled.str());
  expect_refusal("grasp millimetres --scene scene -o new.json", 1, "are the units metres?");
}

TEST_F(GraspCommand, RefusesASolidOfNegativeVolume) {
  copy("result", "negative");
  auto json = json_of("negative/objects.json");
  json["objects"][0]["solid"]["volume"] = -1.0;
  write(file("negative") / "objects.json", json.dump());
  expect_refusal("grasp negative --scene scene -o new.json", 1, "objects[0].solid.volume");
}

TEST_F(GraspCommand, TakesTheGripperOfAFile) {
  write(file("hand.json"), R"({"name": "clamp", "kind": "parallel", "max_opening_m": 0.001,
    "finger_depth_m": 0.04, "palm_size_m": [0.05, 0.1, 0.08]})");
  const Outcome outcome = run("grasp result --gripper hand.json -o grasps.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = json_of("grasps.json");
  EXPECT_EQ(json.at("gripper").at("name"), "clamp");
  EXPECT_TRUE(json.at("grasps").empty());
  for (const auto& object : json.at("objects")) EXPECT_EQ(object.at("reason"), "too_wide");
}

TEST_F(GraspCommand, RefusesGrippersThatItCannotUse) {
  expect_refusal("grasp result -o new.json --gripper claw", 2, "panda, baxter, reflex");
  expect_refusal("grasp result -o new.json --gripper nowhere.json", 1, "nowhere.json");
  write(file("odd.json"), R"({"name": "odd", "kind": "parallel", "max_opening_m": 0.05,
    "min_opening_m": 0.06, "finger_depth_m": 0.04, "palm_size_m": [0.05, 0.1, 0.08]})");
  expect_refusal("grasp result -o new.json --gripper odd.json", 1, "more than min_opening_m");
}

TEST_F(GraspCommand, RefusesInputsThatItCannotUse) {
  expect_refusal("grasp nowhere -o new.json", 1, "nowhere");
  expect_refusal("grasp scene --scene scene -o new.json", 2, "a result folder as input");
  expect_refusal("grasp result --plane 0,0,1,0 -o new.json", 2, "found a result");
  expect_refusal("grasp result --no-table -o new.json", 2, "--no-table");
  expect_refusal("grasp result --depth-scale 1000 -o new.json", 1, "--depth-scale");
  expect_refusal("grasp result -o result/grasps.json", 1, "outside the input");
}

}  // namespace
}  // namespace symscene::testing
