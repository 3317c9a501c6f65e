// `symscene segment` and the page of its result, run as processes.
#include <cmath>

#include "cli/small_scene.hpp"
#include "io/sha256.hpp"

namespace symscene::testing {
namespace {

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

TEST_F(Command, RefusesOptionsWithoutEffectOnTheInput) {
  for (const std::string input : {"scene", "scene/cloud.ply"}) {
    const std::string kind = input == "scene" ? "a scene" : "a cloud";
    for (const std::string option : {"--sensor tof", "--intrinsics 5,5,1,1", "--depth-scale 500"}) {
      const std::string flag = option.substr(0, option.find(' '));
      expect_refusal("segment " + input + " -o new " + option, 1,
                     "expected a depth image, as " + flag + " needs, found " + kind);
    }
  }
  expect_refusal("segment scene -o new --any-up", 2, "found a scene with table_plane.txt");
  for (const char* table : {"--no-table", "--plane 0,0,1,0"}) {
    expect_refusal(std::string("segment scene -o new --any-up ") + table, 2,
                   "--any-up: expected no --");
  }
}

TEST_F(Command, RefusesAnInputThatDoesNotExistNamingAllKinds) {
  expect_refusal("segment nothere.png -o new", 1,
                 "expected a scene folder, a depth image, a folder with one frame, or a cloud "
                 "(.ply, .pcd), found nothing of that name");
}

TEST_F(Command, RefusesAFileOfAnotherKindNamingAllKinds) {
  write(file("cloud.xyz"), "0 0 0\n");
  expect_refusal("segment cloud.xyz -o new", 1, "a cloud (.ply, .pcd), found another file");
}

/// A tube of 8 cm and 12 cm, its coordinates multiplied by `scale`, as cloud.ply.
std::string cloud_of_a_tube(double scale) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 7200\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  for (int k = 0; k < 7200; ++k) {
    const double angle = 0.0523599 * (k % 120);
    text += std::to_string(scale * 0.04 * std::cos(angle)) + " " +
            std::to_string(scale * 0.04 * std::sin(angle)) + " " +
            std::to_string(scale * 0.002 * (k / 120)) + "\n";
  }
  return text;
}

TEST_F(Command, ReadsACloudInMillimetres) {
  write(file("metres.ply"), cloud_of_a_tube(1.0));
  write(file("millimetres.ply"), cloud_of_a_tube(1000.0));
  ASSERT_EQ(run("segment metres.ply -o of_metres --no-table").code, 0);
  ASSERT_EQ(run("segment millimetres.ply -o of_mm --no-table --units mm").code, 0);
  const auto box = [](const std::string& result) {
    const auto objects = nlohmann::json::parse(contents(file(result) / "objects.json"));
    return objects.at("objects").at(0).at("box").at("size_m").at(2).get<double>();
  };
  EXPECT_NEAR(box("of_mm"), box("of_metres"), 0.002);
  expect_refusal("segment scene -o new --units mm", 1, "a cloud (.ply, .pcd), as --units needs");
}

TEST_F(Command, RefusesACloudWhoseUnitIsEvidentlyTheOther) {
  write(file("millimetres.ply"), cloud_of_a_tube(1000.0));
  write(file("metres.ply"), cloud_of_a_tube(1.0));
  for (const char* table : {"", " --no-table"}) {
    expect_refusal(std::string("segment millimetres.ply -o new") + table, 1,
                   "millimetres.ply: expected points less than 0.02 m apart, found 2 m and more in "
                   "a cloud of 108 m (if the unit is the millimetre, give --units mm)");
    expect_refusal(std::string("segment metres.ply -o new --units mm") + table, 1,
                   "metres.ply: expected an extent of at least 15 mm, with --units mm, found 0.108 "
                   "mm (if the unit is the metre, leave out --units mm)");
  }
  expect_refusal("grasp millimetres.ply -o new.json", 1, "give --units mm");
}

TEST_F(Command, DoubtsTheUnitOfADenseCloudAsLargeAsABuilding) {
  // Each point twice, so that their distances tell nothing.
  std::string twice = cloud_of_a_tube(1000.0);
  const std::size_t points = twice.find("end_header\n") + 11;
  twice += twice.substr(points);
  twice.replace(twice.find("7200"), 4, "14400");
  write(file("twice.ply"), twice);
  const Outcome outcome = run("segment twice.ply -o new --no-table");
  EXPECT_NE(outcome.err.find("twice.ply: the cloud is 108 m large: unless it is a building, its "
                             "unit is the millimetre (give --units mm)"),
            std::string::npos)
      << outcome.err;
}

TEST_F(Command, ViewComparesWithTheGroundTruthOfTheScene) {
  ASSERT_EQ(run("view result --scene scene -o compared.html").code, 0);
  EXPECT_NE(contents(file("compared.html")).find("\"truth\":[{\"name\":"), std::string::npos);
  ASSERT_EQ(run("view result -o alone.html").code, 0);
  EXPECT_NE(contents(file("alone.html")).find("\"truth\":null"), std::string::npos);
}

TEST_F(Command, SegmentsToTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2", "8"}) {
    const std::string result = std::string("result") + threads;
    ASSERT_EQ(run("segment scene -o " + result + " --threads " + threads).code, 0);
    EXPECT_EQ(objects_without_times(result), objects_without_times("result"));
    EXPECT_EQ(contents(file(result) / "cloud.ply"), contents(file("result") / "cloud.ply"));
  }
}

TEST_F(Command, SaysWhatMadeTheResult) {
  write(file("coarse.json"), R"({"voxel_size": 0.006, "view": {}})");
  ASSERT_EQ(run("segment scene -o made --reflectional curve --config coarse.json").code, 0);
  const auto objects = nlohmann::json::parse(contents(file("made") / "objects.json"));
  const auto& made = objects.at("made_by");
  EXPECT_EQ(made.at("symscene"), SYMSCENE_VERSION);
  EXPECT_EQ(made.at("command"), "segment");
  EXPECT_EQ(made.at("input"), "scene");
  EXPECT_EQ(made.at("options"),
            nlohmann::json::parse(R"({"voxel_size": 0.006, "planes_of_surfaces": false})"));
  std::map<std::string, std::string> hashes;
  for (const auto& entry : made.at("files")) hashes[entry.at("file")] = entry.at("sha256");
  EXPECT_EQ(hashes.size(), 3U);
  EXPECT_EQ(hashes.at("cloud.ply"), sha256(contents(file("scene") / "cloud.ply")));
  EXPECT_EQ(hashes.count("occupancy.bt"), 1U);
  EXPECT_EQ(hashes.count("table_plane.txt"), 1U);
  for (const auto& object : objects.at("objects")) {
    for (const auto& edge : object.at("box").at("size_m")) EXPECT_GT(edge, 0.0);
    EXPECT_TRUE(object.contains("T_world_object"));
    EXPECT_FALSE(object.contains("mesh"));
    EXPECT_TRUE(fs::exists(file("made") / object.at("cloud").get<std::string>()));
  }
}

TEST_F(Command, ReplacesAnEarlierResult) {
  ASSERT_EQ(run("segment scene -o replaced").code, 0);
  ASSERT_EQ(run("segment scene -o replaced").code, 0);
  EXPECT_EQ(objects_without_times("replaced"), objects_without_times("result"));
}

/// A table of points 5 mm apart with two boxes on it, as cloud.ply.
std::string cloud_of_a_table() {
  std::string points;
  std::size_t count = 0;
  const auto add = [&](double x, double y, double z, const char* normal) {
    for (const double value : {x, y, z}) points += std::to_string(value) + " ";
    points += normal + std::string("\n");
    ++count;
  };
  for (int i = -60; i <= 60; ++i) {
    for (int j = -60; j <= 60; ++j) add(0.005 * i, 0.005 * j, 0.5, "0 0 1");
  }
  for (const double x : {-0.15, 0.1}) {
    for (int i = 0; i <= 16; ++i) {
      for (int j = 0; j <= 16; ++j) {
        const double a = 0.005 * i, b = 0.005 * j;
        add(x + a, b, 0.58, "0 0 1");
        add(x + a, 0.0, 0.5 + b, "0 -1 0");
        add(x + a, 0.08, 0.5 + b, "0 1 0");
        add(x, a, 0.5 + b, "-1 0 0");
        add(x + 0.08, a, 0.5 + b, "1 0 0");
      }
    }
  }
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
         "property float ny\nproperty float nz\nend_header\n" +
         points;
}

TEST_F(Command, TakesTheTableFromTheCloudOfAFolderWithoutTablePlane) {
  fs::create_directory(file("fused"));
  write(file("fused") / "cloud.ply", cloud_of_a_table());
  const Outcome cropped = run("segment fused -o cropped");
  ASSERT_EQ(cropped.code, 0) << cropped.err;
  EXPECT_EQ(cropped.err.find("table_plane.txt"), std::string::npos) << cropped.err;
  EXPECT_NE(cropped.out.find("1.0000,-0.5000: 0."), std::string::npos) << cropped.out;
  const nlohmann::json found = objects_without_times("cropped");
  EXPECT_TRUE(found.contains("table"));
  EXPECT_EQ(found.at("objects").size(), 2U);
  // A given plane is the table of the cloud too.
  const std::string table = found.at("table").dump();
  const Outcome given = run("segment fused -o given --plane=" + table.substr(1, table.size() - 2));
  ASSERT_EQ(given.code, 0) << given.err;
  EXPECT_EQ(objects_without_times("given").at("objects").size(), 2U);
  // A folder that symscene wrote has no table in its cloud, or was made with --no-table.
  write(file("fused") / "scene.json", "{\"version\": 1}\n");
  const Outcome written = run("segment fused -o written");
  EXPECT_NE(written.err.find("table_plane.txt is missing"), std::string::npos) << written.err;
  EXPECT_FALSE(objects_without_times("written").contains("table"));
  expect_refusal("segment fused -o new --any-up", 2, "a scene of objects without a table");
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

TEST_F(Command, ReadsTheVerticesOfAMeshAsACloud) {
  const std::string cloud = contents(file("scene") / "cloud.ply");
  write(file("cloud.ply"), cloud);
  write(file("mesh.ply"), mesh_of_cloud(cloud));
  for (const char* name : {"cloud", "mesh"}) {
    const std::string text(name);
    const Outcome outcome = run("segment " + text + ".ply --no-table -o of_" + text);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  EXPECT_EQ(objects_without_times("of_mesh"), objects_without_times("of_cloud"));
}

TEST_F(Command, SegmentsTheCloudOfAResultOnItsTable) {
  const Outcome outcome = run("segment result -o of_result");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(objects_without_times("of_result").at("table"),
            objects_without_times("result").at("table"));
  EXPECT_EQ(outcome.err.find("table"), std::string::npos) << outcome.err;
}

TEST_F(Command, WarnsOnceOfMissingOccupancy) {
  fs::copy(file("scene"), file("unmapped"));
  fs::remove(file("unmapped") / "occupancy.bt");
  const Outcome outcome = run("segment unmapped -o of_unmapped");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("no occupancy map"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(Command, RefusesMasksOfACloudBeforeTheWork) {
  for (const char* input : {"scene", "scene/cloud.ply"})
    expect_refusal(std::string("segment ") + input + " -o new --masks new_masks", 1,
                   "expected a depth image, as --masks needs");
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

}  // namespace
}  // namespace symscene::testing
