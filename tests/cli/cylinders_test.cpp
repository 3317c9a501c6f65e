// `symscene cylinders`, and the pages of grasps, run as processes.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

TEST_F(Command, FitsCylindersToTheClustersOfASceneAndGraspsThem) {
  const Outcome outcome = run("cylinders scene --gripper reflex -o cylinders.json -v --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json document = nlohmann::json::parse(contents(file("cylinders.json")));
  EXPECT_EQ(document.at("version"), 1);
  EXPECT_EQ(document.at("gripper").at("name"), "reflex");
  const nlohmann::json& clusters = document.at("clusters");
  ASSERT_FALSE(clusters.empty());
  std::size_t found = 0;
  for (std::size_t id = 0; id < clusters.size(); ++id) {
    EXPECT_EQ(clusters[id].at("id"), id);
    EXPECT_GT(clusters[id].at("points"), 0);
    EXPECT_NE(clusters[id].contains("cylinder"), clusters[id].contains("reason"));
    if (!clusters[id].contains("cylinder")) continue;
    ++found;
    EXPECT_GT(clusters[id].at("cylinder").at("radius"), 0.0);
    EXPECT_GT(clusters[id].at("cylinder").at("height"), 0.0);
  }
  EXPECT_EQ(document.at("objects").size(), clusters.size());
  for (const nlohmann::json& grasp : document.at("grasps")) {
    const nlohmann::json& cluster = clusters.at(grasp.at("object").get<std::size_t>());
    EXPECT_EQ(grasp.at("source"), "cylinder");
    EXPECT_EQ(grasp.at("opening_m"), 2.0 * cluster.at("cylinder").at("radius").get<double>());
  }
  EXPECT_NE(outcome.err.find(" id  points   radius   height  grasps"), std::string::npos);
  EXPECT_NE(outcome.err.find("axes and cylinders"), std::string::npos);
  const nlohmann::json report = last_line(outcome.out);
  EXPECT_EQ(report.at("clusters"), clusters.size());
  EXPECT_EQ(report.at("cylinders"), found);
  EXPECT_EQ(report.at("grasps"), document.at("grasps").size());
}

TEST_F(Command, FitsTheSameCylindersForAnyNumberOfThreads) {
  for (const char* threads : {"1", "8"}) {
    ASSERT_EQ(
        run(std::string("cylinders scene -o cylinders") + threads + ".json --threads " + threads)
            .code,
        0);
  }
  EXPECT_EQ(contents(file("cylinders1.json")), contents(file("cylinders8.json")));
}

TEST_F(Command, KeepsTheBoundThatTheAxisOfAClusterFails) {
  write(file("strict.json"), R"({"axis": {"max_symmetry_residual": 0.0}})");
  const Outcome outcome =
      run("cylinders scene -o strict_cylinders.json --config strict.json --page strict.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json document = nlohmann::json::parse(contents(file("strict_cylinders.json")));
  for (const nlohmann::json& cluster : document.at("clusters")) {
    EXPECT_EQ(cluster.at("reason"), "symmetry");
    EXPECT_GE(cluster.at("value"), 0.0);
    EXPECT_EQ(cluster.at("bound"), 0.0);
  }
  for (const nlohmann::json& object : document.at("objects"))
    EXPECT_EQ(object.at("reason"), "no_axis");
  EXPECT_TRUE(document.at("grasps").empty());
  // On the page no cluster has a score.
  const std::string html = contents(file("strict.html"));
  const std::string score = "\"score\":";
  std::size_t scores = 0;
  for (std::size_t at = html.find(score); at != std::string::npos; at = html.find(score, at + 1)) {
    EXPECT_EQ(html.substr(at + score.size(), 3), "0.0");
    ++scores;
  }
  EXPECT_EQ(scores, document.at("clusters").size());
  EXPECT_NE(outcome.out.find("the normals do not lie in planes through the axis"),
            std::string::npos);
}

TEST_F(Command, ShowsGraspsOnAPage) {
  ASSERT_EQ(run("cylinders scene -o paged.json --page cylinders.html").code, 0);
  ASSERT_EQ(run("grasp scene -o scene_grasps.json --page scene.html").code, 0);
  ASSERT_EQ(run("grasp result --scene scene -o result_grasps.json --page result.html").code, 0);
  for (const char* page : {"cylinders.html", "scene.html", "result.html"}) {
    const std::string html = contents(file(page));
    EXPECT_NE(html.find(R"("grasps":{"accepted":[)"), std::string::npos) << page;
    EXPECT_NE(html.find(R"("name":"panda")"), std::string::npos) << page;
  }
}

TEST_F(Command, GraspsNothingOnAnEmptyTable) {
  fs::create_directories(file("bare"));
  write(file("bare") / "cloud.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n");
  write(file("bare") / "table_plane.txt", "0 0 1 0\n");
  for (const char* command : {"grasp", "cylinders"}) {
    const Outcome outcome = run(std::string(command) + " bare -o bare.json --page bare.html");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json document = nlohmann::json::parse(contents(file("bare.json")));
    EXPECT_TRUE(document.at("grasps").empty());
    EXPECT_TRUE(document.at("objects").empty());
    EXPECT_GT(fs::file_size(file("bare.html")), 1000U);
  }
}

TEST_F(Command, RefusesPagesAndGrippersThatCannotBe) {
  expect_refusal(
      "cylinders scene -o new.json --gripper hand.txt", 2,
      "expected one of panda, baxter, reflex or a .json or .yaml file, found \"hand.txt\"");
  expect_refusal("cylinders scene -o new.json --gripper nothing.json", 1, "nothing.json");
  expect_refusal("cylinders scene -o scene/cloud.ply", 2, "expected a name that ends in .json");
  expect_refusal("cylinders scene -o scene/new.json", 1, "new.json");
  expect_refusal("cylinders scene -o new.json --page new.json", 1, "new.json");
  expect_refusal("cylinders nowhere -o new.json", 1, "nowhere");
  expect_refusal("grasp result -o new.json --page result/objects.json", 1, "objects.json");
}

}  // namespace
}  // namespace symscene::testing
