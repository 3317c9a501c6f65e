// `symscene next-view` from outside: scenes, results, candidates, costs and what it refuses.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

class NextViewCommand : public Command {
 protected:
  static void SetUpTestSuite() {
    Command::SetUpTestSuite();
    write(file("camera.txt"), "640 480 525 525 319.5 239.5\n");
    write(file("poses.txt"),
          "0 0.6 0 0.5 0.2705981 0.6532815 -0.6532815 -0.2705981\n"
          "1 0 0 0.8 1 0 0 0\n");
  }
  static nlohmann::json views_of(const std::string& name) {
    return nlohmann::json::parse(contents(file(name)));
  }
};

TEST_F(NextViewCommand, RanksTheViewsOfAHalfSphere) {
  const Outcome outcome = run("next-view scene --camera camera.txt -o views.json -v");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = views_of("views.json");
  EXPECT_EQ(json.at("policy"), "symmetry");
  ASSERT_EQ(json.at("views").size(), 34U);
  double last = std::numeric_limits<double>::infinity();
  for (const auto& view : json.at("views")) {
    EXPECT_LE(view.at("gain").get<double>(), last);
    last = view.at("gain").get<double>();
    const double parts = view.at("inferred").get<double>() + view.at("disputed").get<double>() +
                         view.at("unknown").get<double>() - view.at("cost").get<double>();
    EXPECT_NEAR(last, parts, 1e-12);
  }
  EXPECT_GT(json.at("views").at(0).at("gain"), 0.0);
}

TEST_F(NextViewCommand, OfAResultWithItsSceneIsThatOfTheScene) {
  ASSERT_EQ(run("next-view scene --camera camera.txt -o of_scene.json").code, 0);
  const Outcome outcome =
      run("next-view result --scene scene --camera camera.txt -o of_result.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(views_of("of_scene.json").at("views").size(),
            views_of("of_result.json").at("views").size());
  EXPECT_GT(views_of("of_result.json").at("views").at(0).at("unknown"), 0.0);
}

TEST_F(NextViewCommand, TakesPosesAndCosts) {
  write(file("costs.txt"), "inf 2\n");
  const Outcome outcome = run(
      "next-view scene --camera camera.txt --candidates poses.txt --costs costs.txt -o few.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = views_of("few.json");
  ASSERT_EQ(json.at("views").size(), 1U) << "one cannot be reached";
  EXPECT_EQ(json.at("views").at(0).at("candidate"), 1);
  EXPECT_EQ(json.at("views").at(0).at("T_world_camera").at("position_m").at(2), 0.8);
}

TEST_F(NextViewCommand, CountsVoxels) {
  const Outcome outcome =
      run("next-view scene --camera camera.txt --policy rear-side-voxels -o voxels.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(views_of("voxels.json").at("gain_unit"), "voxels");
}

TEST_F(NextViewCommand, WritesAPage) {
  ASSERT_EQ(run("next-view scene --camera camera.txt -o shown.json --page views.html").code, 0);
  EXPECT_NE(contents(file("views.html")).find("\"half_size\""), std::string::npos);
}

TEST_F(NextViewCommand, RefusesWhatItCannotUse) {
  write(file("one.txt"), "3\n");
  write(file("words.txt"), "near far\n");
  write(file("none.txt"), "# no pose\n");
  write(file("no_size.txt"), "0 0 525 525 319.5 239.5\n");
  const std::string scene = "next-view scene -o v.json";
  expect_refusal(scene, 2, "--camera");
  expect_refusal(scene + " --camera no_size.txt", 1, "no_size.txt");
  expect_refusal(scene + " --camera camera.txt --candidates none.txt", 1, "at least one pose");
  expect_refusal(scene + " --camera camera.txt --costs one.txt", 1, "34 numbers");
  expect_refusal(scene + " --camera camera.txt --costs words.txt", 1, "\"near\"");
  fs::copy(file("camera.txt"), file("camera"));
  expect_refusal("next-view scene --camera camera -o camera", 1, "outside the input");
  expect_refusal("next-view scene --camera camera.txt -o views.yaml", 2, "ends in .json");
  expect_refusal(scene + " --camera camera.txt --candidates poses.txt --page poses.txt", 1,
                 "outside the input");
  expect_refusal("next-view scene --camera camera.txt -o scene/views.json", 1, "outside the input");
}

TEST_F(NextViewCommand, NeedsOccupancyToCountVoxels) {
  const Outcome outcome =
      run("next-view result --camera camera.txt --policy unknown-voxels -o v.json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("occupancy"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace symscene::testing
