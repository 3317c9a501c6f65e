// The symscene command, run as a process: output, files and exit codes.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

/// A small scene and its result, shared by all tests.
class Command : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    workspace_ = std::make_unique<Workspace>();
    write(*workspace_ / "small.json", R"({
      "tabletop": {"objects": 2},
      "camera": {"frames": 8}  // few
    })");
    const Outcome simulated = run("simulate -o scene --config small.json");
    ASSERT_EQ(simulated.code, 0) << simulated.err;
    const Outcome segmented = run("segment scene -o result");
    ASSERT_EQ(segmented.code, 0) << segmented.err;
    ASSERT_FALSE(objects_without_times("result").at("objects").empty());
  }
  static void TearDownTestSuite() { workspace_.reset(); }

  static Outcome run(const std::string& arguments, const fs::path& output = {}) {
    return workspace_->run(arguments, output);
  }
  static fs::path file(const std::string& name) { return *workspace_ / name; }

  /// Every file under the workspace and its bytes.
  static std::map<std::string, std::string> snapshot() {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(workspace_->folder())) {
      files[entry.path().string()] = entry.is_regular_file() ? contents(entry.path()) : "";
    }
    return files;
  }

  /// One sentence on standard error, nothing on standard output, nothing changed on disk.
  static void expect_refusal(const std::string& arguments, int code, const std::string& sentence) {
    const auto before = snapshot();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("symscene")) << outcome.err;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << arguments << "\n" << outcome.err;
    EXPECT_EQ(snapshot(), before) << arguments;
  }

  /// The last line of the output, as JSON.
  static nlohmann::json last_line(const std::string& out) {
    const std::size_t end = out.find_last_not_of('\n');
    const std::size_t newline = out.rfind('\n', end);
    return nlohmann::json::parse(out.substr(newline == std::string::npos ? 0 : newline + 1));
  }

  /// objects.json without the times.
  static nlohmann::json objects_without_times(const std::string& result) {
    nlohmann::json objects = nlohmann::json::parse(contents(file(result) / "objects.json"));
    objects.erase("timings");
    return objects;
  }

 private:
  static std::unique_ptr<Workspace> workspace_;
};

std::unique_ptr<Workspace> Command::workspace_;

TEST_F(Command, HelpsWithAnExampleForEverySubcommand) {
  EXPECT_NE(run("--help").out.find("segment"), std::string::npos);
  for (const char* command : {"simulate", "dataset", "reconstruct", "stitch", "segment", "symmetry",
                              "evaluate", "masks", "view", "info", "options"}) {
    const Outcome help = run(std::string(command) + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_EQ(help.err, "") << command;
    EXPECT_NE(help.out.find(std::string("Usage: symscene ") + command), std::string::npos);
    EXPECT_NE(help.out.find(std::string("Example:\n  symscene ") + command), std::string::npos);
  }
}

TEST_F(Command, PrintsItsVersion) {
  EXPECT_EQ(run("--version").out, "symscene " SYMSCENE_VERSION "\n");
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
  expect_refusal("simulate -o new --objects 1000", 1, "found 1000");
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

TEST_F(Command, ChoosesWhatProposesReflectionPlanes) {
  write(file("curves.json"), R"({"planes_of_surfaces": false, "planes_of_curves": true})");
  const std::vector<std::tuple<std::string, bool, bool>> expected{
      {"", true, true},
      {"--config curves.json", false, true},
      {"--reflectional curve", false, true},
      {"--reflectional surface --config curves.json", true, false},
      {"--reflectional both", true, true}};
  for (const auto& [flags, surfaces, curves] : expected) {
    const Outcome printed = run("segment --dump-config " + flags);
    ASSERT_EQ(printed.code, 0) << printed.err;
    const auto values = nlohmann::json::parse(printed.out, nullptr, true, true);
    EXPECT_EQ(values.at("planes_of_surfaces"), surfaces) << flags;
    EXPECT_EQ(values.at("planes_of_curves"), curves) << flags;
  }
  EXPECT_NE(run("segment scene -o planes --reflectional edges").code, 0);
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
  expect_refusal("simulate --sequence -o x --symmetries nothing.json", 1, "--meshes");
}

TEST_F(Command, SegmentsToTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2", "8"}) {
    const std::string result = std::string("result") + threads;
    ASSERT_EQ(run("segment scene -o " + result + " --threads " + threads).code, 0);
    EXPECT_EQ(objects_without_times(result), objects_without_times("result"));
    EXPECT_EQ(contents(file(result) / "cloud.ply"), contents(file("result") / "cloud.ply"));
  }
}

TEST_F(Command, ReplacesAnEarlierResult) {
  ASSERT_EQ(run("segment scene -o replaced").code, 0);
  ASSERT_EQ(run("segment scene -o replaced").code, 0);
  EXPECT_EQ(objects_without_times("replaced"), objects_without_times("result"));
}

TEST_F(Command, WritesASelfContainedPage) {
  ASSERT_EQ(run("view result -o page.html --title 'Mugs & bowls'").code, 0);
  const std::string page = contents(file("page.html"));
  EXPECT_NE(page.find("Mugs &amp; bowls"), std::string::npos);
  EXPECT_EQ(page.find("<script src="), std::string::npos);
  ASSERT_EQ(run("segment scene -o paged --page beside.html").code, 0);
  EXPECT_GT(fs::file_size(file("beside.html")), 1000U);
}

/// A mesh of the points of a binary cloud.ply, with a triangle for every three consecutive points.
std::string mesh_of_cloud(std::string ply) {
  const std::size_t count = std::stoul(ply.substr(ply.find("vertex ") + 7));
  const std::string faces =
      "element face " + std::to_string(count - 2) + "\nproperty list uchar uint vertex_indices\n";
  ply.insert(ply.find("end_header\n"), faces);
  for (std::size_t i = 0; i + 2 < count; ++i) {
    ply += '\3';
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      for (int shift = 0; shift < 32; shift += 8) ply += static_cast<char>(corner >> shift & 0xFF);
    }
  }
  return ply;
}

TEST_F(Command, ShowsTheSurfaceOfAReconstructionWithItsResult) {
  fs::copy(file("scene"), file("scanned"));
  write(file("scanned") / "mesh.ply", mesh_of_cloud(contents(file("scanned") / "cloud.ply")));
  write(file("scanned") / "poses.txt", "0 0.1 0.2 0.3 0 0 0 1\n1 0.2 0.2 0.3 0 0 0 1\n");
  const Outcome segmented = run("segment scanned -o shown --page shown.html");
  EXPECT_EQ(segmented.code, 0);
  EXPECT_EQ(segmented.err, "");
  EXPECT_EQ(objects_without_times("shown"), objects_without_times("result"));
  EXPECT_TRUE(fs::exists(file("shown") / "surface.ply"));
  EXPECT_TRUE(fs::exists(file("shown") / "poses.txt"));
  ASSERT_EQ(run("view shown -o viewed.html").code, 0);
  for (const char* page : {"shown.html", "viewed.html"}) {
    EXPECT_NE(contents(file(page)).find(R"("surface":{"colors")"), std::string::npos) << page;
    EXPECT_NE(contents(file(page)).find(R"("frames":2)"), std::string::npos) << page;
  }
  // A result does not keep a surface that the scene no longer has.
  ASSERT_EQ(run("segment scene -o shown").code, 0);
  EXPECT_FALSE(fs::exists(file("shown") / "surface.ply"));
}

TEST_F(Command, WarnsAboutASurfaceThatItCannotShow) {
  fs::copy(file("scene"), file("odd"));
  const std::string elsewhere =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n"
      "50 0 0\n51 0 0\n50 1 0\n3 0 1 2\n";
  const std::map<std::string, std::string> meshes = {
      {elsewhere, "the cloud lies on"}, {"no mesh", "PLY"}, {elsewhere.substr(0, 170), "mesh.ply"}};
  write(file("odd") / "poses.txt", "no pose\n");
  for (const auto& [mesh, sentence] : meshes) {
    write(file("odd") / "mesh.ply", mesh);
    const Outcome segmented = run("segment odd -o odd_result --page odd.html");
    EXPECT_EQ(segmented.code, 0);
    EXPECT_NE(segmented.err.find(sentence), std::string::npos) << segmented.err;
    EXPECT_NE(segmented.err.find("poses.txt"), std::string::npos) << segmented.err;
    EXPECT_EQ(std::count(segmented.err.begin(), segmented.err.end(), '\n'), 2) << segmented.err;
    EXPECT_FALSE(fs::exists(file("odd_result") / "surface.ply"));
  }
}

TEST_F(Command, RefusesAResultWithAnInvalidSurface) {
  fs::copy(file("result"), file("broken"), fs::copy_options::recursive);
  write(file("broken") / "surface.ply", "no mesh");
  expect_refusal("view broken -o broken.html", 1, "surface.ply");
}

TEST_F(Command, DescribesAScene) {
  const Outcome described = run("info scene --json");
  ASSERT_EQ(described.code, 0) << described.err;
  for (const char* label : {"points", "box", "spacing", "occupancy", "table", "ground truth"})
    EXPECT_NE(described.out.find(std::string("\n") + label), std::string::npos) << label;
  const auto line = last_line(described.out);
  EXPECT_EQ(line.at("kind"), "scene");
  EXPECT_GT(line.at("points"), 1000);
  EXPECT_EQ(line.at("true_objects"), 2);
  EXPECT_GT(line.at("occupancy").at("free"), line.at("occupancy").at("occupied"));
  EXPECT_EQ(run("info scene --quiet").out, "");
}

TEST_F(Command, DescribesAResult) {
  const auto objects = objects_without_times("result").at("objects");
  const auto line = last_line(run("info result --json").out);
  EXPECT_EQ(line.at("kind"), "result");
  EXPECT_EQ(line.at("objects"), objects.size());
  EXPECT_EQ(line.at("mask_sizes").at(0), objects.at(0).at("points").size());
}

TEST_F(Command, DescribesAModel) {
  EXPECT_EQ(last_line(run("info scene/cloud.ply --json").out).at("kind"), "cloud");
  EXPECT_EQ(last_line(run("info scene/occupancy.bt --json").out).at("kind"), "occupancy");
  write(file("one.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(last_line(run("info one.obj --json").out).at("mesh").at("triangles"), 1);
}

/// A PNG of 4×2 pixels of 16-bit grey: 1000 to 1006, and one 0.
const std::string depth_png(
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\004\000\000"
    "\000\002\020\000\000\000\000\012\123\376\374\000\000\000\033\111\104\101\124\170\234\143"
    "\140\176\301\374\222\371\025\363\153\006\346\067\314\157\231\337\061\060\000\000\076\063"
    "\006\203\107\104\141\004\000\000\000\000\111\105\116\104\256\102\140\202",
    84);

TEST_F(Command, DescribesASequenceAndItsUnreadableFrames) {
  fs::create_directories(file("sequence") / "depth");
  write(file("sequence") / "depth/000000.png", depth_png);
  write(file("sequence") / "depth/000001.png", depth_png.substr(0, 50));
  write(file("sequence") / "poses.txt", "1 0 0 0 0 0 0 1\n1.5 0 3 4 0 0 0 1\n");
  expect_refusal("info sequence", 1, "pass --intrinsics fx,fy,cx,cy, found none");
  expect_refusal("info sequence --intrinsics 1,2,3", 2, "expected fx,fy,cx,cy");
  expect_refusal("info sequence --depth-scale 0", 2, "expected a number above 0, found 0");
  const Outcome described = run("info sequence --json --intrinsics 5,5,1.5,0.5");
  ASSERT_EQ(described.code, 0) << described.err;
  EXPECT_NE(described.out.find("sequence/depth/000001.png: expected a whole PNG image"),
            std::string::npos)
      << described.out;
  const auto line = last_line(described.out);
  EXPECT_EQ(line.at("layout"), "sequence");
  EXPECT_EQ(line.at("frames"), 2);
  EXPECT_EQ(line.at("rate"), 2.0);
  EXPECT_EQ(line.at("camera").at("width"), 4);
  EXPECT_EQ(line.at("depth").at("median"), 1.003);
  EXPECT_EQ(line.at("depth").at("measured"), 0.875);
  EXPECT_EQ(line.at("path_length"), 5.0);
  EXPECT_EQ(line.at("unreadable").size(), 1U);
}

TEST_F(Command, StitchesFramesToTheSameBytesForAnyNumberOfThreads) {
  write(file("arc.json"), R"({"camera": {"arc": 0.5, "radius": 0.7}})");
  ASSERT_EQ(run("simulate --sequence -o arc --frames 6 --seed 1 --config arc.json").code, 0);
  const Outcome one = run("stitch arc -o stitched1 --threads 1 --json");
  if (one.err.find("feature matcher") != std::string::npos) GTEST_SKIP() << one.err;
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(last_line(one.out).at("placed"), 6) << one.out;
  EXPECT_NE(one.out.find("6 placed; "), std::string::npos) << one.out;
  ASSERT_EQ(run("stitch arc -o stitched2 --threads 2").code, 0);
  for (const char* name : {"cloud.ply", "occupancy.bt", "mesh.ply", "poses.txt"}) {
    EXPECT_EQ(contents(file("stitched1") / name), contents(file("stitched2") / name)) << name;
  }
}

TEST_F(Command, RefusesFramesThatItCannotStitch) {
  const std::string given = " -o new --intrinsics 5,5,1.5,0.5";
  fs::create_directories(file("depths") / "depth");
  write(file("depths") / "depth/000000.png", depth_png);
  const Outcome depths = run("stitch depths" + given);
  if (depths.err.find("feature matcher") != std::string::npos) GTEST_SKIP() << depths.err;
  expect_refusal("stitch depths" + given, 1, "found 1 frames without colour");
  expect_refusal("stitch nowhere -o new", 1, "symscene stitch: nowhere");
  fs::create_directories(file("many") / "depth");
  fs::create_directories(file("many") / "color");
  for (int i = 0; i < 130; ++i) {
    const std::string name = std::to_string(1000000 + i).substr(1) + ".png";
    write(file("many") / "depth" / name, depth_png);
    write(file("many") / "color" / name, depth_png);
  }
  expect_refusal("stitch many" + given, 1, "at most 60 frames with colour (pass --every 3)");
  write(file("apart.json"), R"({"camera": {"width": 160, "height": 120, "focal_length": 130}})");
  ASSERT_EQ(run("simulate --sequence -o apart --frames 2 --seed 1 --config apart.json").code, 0);
  expect_refusal("stitch apart -o new --quiet", 1, "two frames that show the same textured");
  EXPECT_FALSE(fs::exists(file("new")));
}

TEST_F(Command, RefusesToDescribeAnythingElse) {
  fs::create_directories(file("something"));
  expect_refusal("info something", 1, "found another folder");
  expect_refusal("info nowhere", 1, "found no such file or folder");
}

TEST_F(Command, ReportsAFullDisk) {
  const Outcome outcome = run("segment --dump-config", "/dev/full");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("standard output"), std::string::npos);
}

}  // namespace
}  // namespace symscene::testing
