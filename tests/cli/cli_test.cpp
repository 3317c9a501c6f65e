// The symscene command, run as a process: output, files and exit codes.
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

TEST_F(Command, HelpsWithAnExampleForEverySubcommand) {
  EXPECT_NE(run("--help").out.find("segment"), std::string::npos);
  for (const char* command : {"simulate", "dataset", "reconstruct", "stitch", "segment", "symmetry",
                              "evaluate", "masks", "cylinders", "view", "info", "options"}) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_EQ(help.err, "") << command;
    EXPECT_NE(help.out.find(std::string("Usage: symscene ") + command), std::string::npos);
    EXPECT_NE(help.out.find(std::string("Example:\n  symscene ") + command), std::string::npos);
  }
}

TEST_F(Command, PrintsItsVersion) {
  const std::string text = run("--version").out;
  EXPECT_TRUE(text.starts_with("symscene " SYMSCENE_VERSION "\n")) << text;
  EXPECT_NE(text.find("\nwith\n  evaluation\n  simulation\n"), std::string::npos) << text;
}

TEST_F(Command, RefusesAWrongCommandLineInOneSentence) {
  expect_refusal("", 2, "subcommand");
  expect_refusal("frobnicate", 2, "--help");
  expect_refusal("segment", 2, "symscene segment --help");
  expect_refusal("segment scene", 2, "--output");
  expect_refusal("segment scene -o new --seed 1", 2, "--seed");
  expect_refusal("segment scene -o new --repeat 0", 2, "--repeat");
  expect_refusal("segment scene -o new --threads -1", 2, "--threads");
  expect_refusal("view result -o page.html --threads 2", 2, "--threads");
  expect_refusal("simulate -o new --objects many", 2, "--objects");
  expect_refusal("simulate -o new --seed -4", 2, "--seed");
}

TEST_F(Command, RefusesBadInputInOneSentence) {
  write(file("empty.ply"), "");
  write(file("text.ply"), "not a\nply file\n");
  fs::create_directories(file("folder"));
  expect_refusal("segment nowhere -o new", 1, "symscene segment: nowhere: expected");
  expect_refusal("segment folder -o new", 1, "symscene segment: folder");
  expect_refusal("segment text.ply -o new", 1, "symscene segment: text.ply");
  expect_refusal("view scene -o page.html", 1, "symscene view: scene");
  expect_refusal("view result -o nowhere/page.html", 1, "nowhere");
  expect_refusal("symmetry empty.ply", 1, "symscene symmetry: empty.ply");
  expect_refusal("symmetry text.ply", 1, "symscene symmetry: text.ply");
  expect_refusal("symmetry nowhere.obj", 1, "symscene symmetry: nowhere.obj");
  expect_refusal("simulate -o new --objects 1000", 2,
                 "--objects: expected a whole number in [1, 20], found 1000");
}

TEST_F(Command, RefusesBadOptionsOfStagesInOneSentence) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"", "expected JSON"},
      {"{\n\"voxel_size\" 1}", "line 2"},
      {"[]", "expected options in braces"},
      {R"({"voxel_sise": 0.01})", "did you mean \"voxel_size\"?"},
      {R"({"completely different": 1})", "completely different"},
      {R"({"voxel_size": "5 mm"})", "expected a number for \"voxel_size\", found \"5 mm\""},
      {R"({"voxel_size": -1})",
       "bad.json: expected a number in [0.0001, 1] m for \"voxel_size\", found -1"},
      {R"({"object_symmetry": {"min_axis_probability": 7}})",
       "bad.json: expected a number in [0, 1] for \"object_symmetry.min_axis_probability\", found "
       "7"},
      {R"({"normals": 3})", "expected a group of options in braces for \"normals\", found 3"},
      {R"({"voxel_size": 1e999})", "out of range"},
  };
  for (const auto& [config, sentence] : cases) {
    write(file("bad.json"), config);
    expect_refusal("segment scene -o new --config bad.json", 1, sentence);
  }
  expect_refusal("segment scene -o new --config nowhere.json", 1, "nowhere.json");
}

/// The text of an embedded model without its trees, which estimates one probability for all.
std::string constant_model(const std::string& name, const std::string& log_odds) {
  const std::string text = contents(fs::path(SYMSCENE_SOURCE_DIR) / "models" / (name + ".txt"));
  return text.substr(0, text.find("base ")) + "base " + log_odds + "\ntrees 0\n";
}

TEST_F(Command, ChoosesObjectsByTheModelsThatAConfigurationNames) {
  write(file("alone.txt"), constant_model("object_alone", "-20"));
  write(file("among.txt"), constant_model("object_among_others", "-20"));
  write(file("models.json"), R"({"models": {"object_alone": "alone.txt",
      "object_among_others": "among.txt"}})");
  ASSERT_EQ(run("segment scene -o none --config models.json").code, 0);
  EXPECT_TRUE(objects_without_times("none").at("objects").empty());
  EXPECT_FALSE(objects_without_times("result").at("objects").empty());
}

TEST_F(Command, RefusesModelsThatDoNotFit) {
  write(file("alone.txt"), constant_model("object_alone", "-20"));
  write(file("cut.txt"), constant_model("axis", "0").substr(0, 60));
  const std::vector<std::pair<const char*, const char*>> cases = {
      {R"({"models": {"axis": "nowhere.txt"}})", "nowhere.txt"},
      {R"({"models": {"axis": "bad.json"}})", "bad.json: line 1: expected a line"},
      {R"({"models": {"axis": "cut.txt"}})", "cut.txt"},
      {R"({"models": {"axis": "alone.txt"}})", "expected the model axis, found \"object_alone\""},
      {R"({"models": {"object_alone": "alone.txt"}})", "object_among_others"},
      {R"({"models": {"axis": 3}})", "expected a text in quotes for \"models.axis\", found 3"},
  };
  for (const auto& [config, sentence] : cases) {
    write(file("bad.json"), config);
    expect_refusal("segment scene -o new --config bad.json", 1, sentence);
  }
}

TEST_F(Command, NeverWritesOverItsInput) {
  expect_refusal("segment scene -o scene", 1, "outside the input");
  expect_refusal("segment scene -o scene/../scene/result", 1, "outside the input");
  expect_refusal("view result -o result/objects.json", 1, "outside the input");
  expect_refusal("symmetry scene/cloud.ply -o ./scene/cloud.ply", 1, "outside the input");
  expect_refusal("segment scene -o new --page new/page.html", 1, "outside the input");
  expect_refusal("segment scene -o new/result --masks new", 1, "new/result: expected");
}

TEST_F(Command, NeverReplacesFoldersWithOtherFiles) {
  fs::create_directories(file("mine"));
  write(file("mine") / "thesis.txt", "text");
  expect_refusal("segment scene -o mine", 1, "mine");
  expect_refusal("simulate -o mine --config small.json", 1, "mine");
}

TEST_F(Command, PrintsOneMachineReadableLineAtTheEnd) {
  const auto simulated = last_line(run("simulate -o again --config small.json --json").out);
  EXPECT_EQ(simulated.at("command"), "simulate");
  const auto segmented = last_line(run("segment scene -o again2 --json -v --repeat 2").out);
  EXPECT_EQ(segmented.at("command"), "segment");
  EXPECT_EQ(segmented.at("objects"), objects_without_times("again2").at("objects").size());
  EXPECT_FALSE(segmented.at("timings").empty());
  const auto viewed = last_line(run("view result -o json.html --json").out);
  EXPECT_EQ(viewed.at("bytes"), fs::file_size(file("json.html")));
}

TEST_F(Command, PrintsOnlyWarningsWithQuiet) {
  for (const char* line :
       {"simulate -o quiet --config small.json --quiet", "segment scene -o quiet2 --quiet",
        "view result -o quiet.html --quiet"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 0) << line;
    EXPECT_EQ(outcome.out, "") << line;
  }
}

TEST_F(Command, ReadsBackTheOptionsThatItPrints) {
  for (const char* command : {"simulate", "simulate --sequence", "dataset", "reconstruct", "stitch",
                              "segment", "symmetry", "evaluate"}) {
    const std::string dump = std::string(command) + " --dump-config";
    const Outcome printed = run(dump);
    ASSERT_EQ(printed.code, 0) << printed.err;
    EXPECT_GT(printed.out.size(), 100U);
    write(file("dump.json"), printed.out);
    EXPECT_EQ(run(dump + " --config dump.json").out, printed.out);
  }
}

TEST_F(Command, FlagsOverrideTheConfigurationFile) {
  const Outcome printed = run("simulate --config small.json --objects 5 --seed 9 --dump-config");
  const auto values = nlohmann::json::parse(printed.out, nullptr, true, true);
  EXPECT_EQ(values.at("tabletop").at("objects"), 5);
  EXPECT_EQ(values.at("tabletop").at("seed"), 9);
  EXPECT_EQ(values.at("camera").at("frames"), 8);
}

TEST_F(Command, SimulatesTheSameBytesForTheSameSeed) {
  ASSERT_EQ(run("simulate -o twin --config small.json --threads 1").code, 0);
  ASSERT_EQ(run("simulate -o other --config small.json --seed 2").code, 0);
  for (const char* name : {"cloud.ply", "occupancy.bt", "table_plane.txt", "truth.json"}) {
    EXPECT_EQ(contents(file("twin") / name), contents(file("scene") / name)) << name;
  }
  EXPECT_NE(contents(file("other") / "cloud.ply"), contents(file("scene") / "cloud.ply"));
}

TEST_F(Command, WritesASweepWithItsGroundTruthAndMeshes) {
  write(file("sweep.json"), R"({"camera": {"width": 160, "height": 120, "focal_length": 131}})");
  const Outcome outcome =
      run("simulate --sequence -o sweep --objects 2 --frames 4 --config sweep.json --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(last_line(outcome.out).at("frames"), 4);
  for (const char* name :
       {"depth/000003.png", "color/000003.png", "intrinsics.txt", "poses.txt", "sequence.json"}) {
    EXPECT_TRUE(fs::exists(file("sweep") / name)) << name;
  }
  const auto truth = nlohmann::json::parse(contents(file("sweep/truth.json")));
  ASSERT_EQ(truth.at("objects").size(), 2U);
  for (const auto& object : truth.at("objects")) {
    const std::string mesh = object.at("mesh");
    EXPECT_TRUE(fs::exists(file("sweep/meshes") / (mesh + ".ply"))) << mesh;
  }
  const auto before = contents(file("sweep/depth/000002.png"));
  ASSERT_EQ(run("simulate --sequence -o sweep --objects 2 --frames 4 --config sweep.json "
                "--threads 1")
                .code,
            0);
  EXPECT_EQ(contents(file("sweep/depth/000002.png")), before);
}

TEST_F(Command, RefusesFoldersWithoutMeshes) {
  fs::create_directories(file("no_meshes"));
  expect_refusal("simulate --sequence -o x --meshes no_meshes", 1, "a folder of meshes");
  expect_refusal("simulate --sequence -o x --meshes nowhere", 1, "a folder of meshes");
  expect_refusal("simulate --sequence -o x --symmetries nothing.json", 2, "--meshes");
}

TEST_F(Command, ReportsAFullDisk) {
  const Outcome outcome = run("segment --dump-config", "/dev/full");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("standard output"), std::string::npos);
}

}  // namespace
}  // namespace symscene::testing
