#include "symscene/io/result.hpp"

#include <limits>

#include "io/small_result.hpp"

namespace symscene {
namespace {

using namespace io_test;
namespace fs = std::filesystem;

TEST(Result, WritingAndReadingGiveTheSameBits) {
  const TemporaryFolder folder;
  const SegmentationResult result = small_result();
  write_result(folder / "out", result);
  const SegmentationResult again = read_result(folder / "out");
  expect_same(again.cloud, result.cloud);
  ASSERT_EQ(again.objects.size(), 2U);
  const SceneObject& object = again.objects[0];
  EXPECT_EQ(object.points, result.objects[0].points);
  EXPECT_EQ(object.score, result.objects[0].score);
  EXPECT_EQ(object.confidence, 0.25);
  EXPECT_FALSE(again.objects[1].score);
  EXPECT_FALSE(again.objects[1].centroid);
  EXPECT_EQ(object.rotational[0].residual, 0.01);
  EXPECT_EQ(object.rotational[0].axis.direction, result.objects[0].rotational[0].axis.direction);
  EXPECT_EQ(object.reflectional[0].plane.point, result.objects[0].reflectional[0].plane.point);
  EXPECT_EQ(object.centroid, result.objects[0].centroid);
  ASSERT_TRUE(object.box);
  EXPECT_FALSE(again.objects[1].box);
  EXPECT_EQ(object.box->T_world_object.position, result.objects[0].box->T_world_object.position);
  EXPECT_EQ(object.box->T_world_box.orientation.coeffs(),
            result.objects[0].box->T_world_box.orientation.coeffs());
  EXPECT_EQ(object.box->size, result.objects[0].box->size);
  expect_same(again.completed[0], result.completed[0]);
  EXPECT_TRUE(again.completed[1].empty());
  EXPECT_EQ(again.rejected[1].reason, "occlusion");
  EXPECT_EQ(again.rejected[0].points, result.rejected[0].points);
  ASSERT_EQ(again.objects[0].score_effects.size(), 1U);
  EXPECT_EQ(again.objects[0].score_effects[0].feature, "convexity");
  EXPECT_EQ(again.objects[0].score_effects[0].effect, 0.75);
  EXPECT_EQ(again.funnel[0].count, 50U);
  EXPECT_EQ(again.timings[0].stage, "z first");
  EXPECT_EQ(format_objects_json(again), format_objects_json(result));
}

TEST(Result, SurfacesAndSolidsAreReadBackWithTheSameBits) {
  const TemporaryFolder folder;
  SegmentationResult result = small_result();
  result.surfaces = {small_surface(), {}};
  result.objects[0].solid = solid_properties(result.surfaces[0].mesh);
  write_result(folder / "out", result);
  const SegmentationResult again = read_result(folder / "out");
  ASSERT_EQ(again.surfaces.size(), 2U);
  EXPECT_EQ(again.surfaces[0].mesh.vertices, result.surfaces[0].mesh.vertices);
  EXPECT_EQ(again.surfaces[0].mesh.triangles, result.surfaces[0].mesh.triangles);
  EXPECT_EQ(again.surfaces[0].observed, result.surfaces[0].observed);
  EXPECT_EQ(again.surfaces[1].mesh.triangles.rows(), 0);
  EXPECT_FALSE(fs::exists(folder / "out/objects/1.obj"));
  ASSERT_TRUE(again.objects[0].solid);
  EXPECT_EQ(again.objects[0].solid->volume, result.objects[0].solid->volume);
  EXPECT_EQ(again.objects[0].solid->principal_axes, result.objects[0].solid->principal_axes);
  EXPECT_FALSE(again.objects[1].solid);
  EXPECT_EQ(format_objects_json(again), format_objects_json(result));
  write_result(folder / "out", small_result());  // replaces the folder with its surfaces
  EXPECT_FALSE(fs::exists(folder / "out/objects/0.obj"));
}

TEST(Result, ClassesAreReadBackWithTheSameBits) {
  SegmentationResult result = small_result();
  ObjectClass prism{.kind = SymmetryClass::n_fold, .center = {0.1, 0.2, 1.0 / 3.0}, .order = 6};
  prism.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  prism.residual = 0.0007;
  prism.explained = 0.97;
  prism.dimensions = {{"apothem", 0.04, 0.0003}, {"height", 0.12, {}, "an end is hidden"}};
  result.objects[0].symmetry_class = prism;
  const std::string text = format_objects_json(result);
  const SegmentationResult again = parse_objects_json(text, "objects.json", result.cloud.size());
  EXPECT_EQ(format_objects_json(again), text);
  ASSERT_TRUE(again.objects[0].symmetry_class);
  EXPECT_FALSE(again.objects[1].symmetry_class);
  const ObjectClass& found = *again.objects[0].symmetry_class;
  EXPECT_EQ(found.kind, SymmetryClass::n_fold);
  EXPECT_EQ(found.order, 6);
  EXPECT_EQ(found.axes, prism.axes);
  ASSERT_EQ(found.dimensions.size(), 2U);
  EXPECT_EQ(found.dimensions[0].sigma, 0.0003);
  EXPECT_FALSE(found.dimensions[1].sigma);
  EXPECT_EQ(found.dimensions[1].value, 0.12);
}

TEST(Result, RefusesAClassOfAnUnknownName) {
  SegmentationResult result = small_result();
  result.objects[0].symmetry_class = ObjectClass{};
  std::string text = format_objects_json(result);
  text.replace(text.find("\"none\""), 6, "\"cone\"");
  EXPECT_THROW(parse_objects_json(text, "objects.json", result.cloud.size()), InputError);
}

TEST(Result, ASolidWithoutASurfaceNamesNoFile) {
  const TemporaryFolder folder;
  SegmentationResult result = small_result();
  result.objects[0].solid = solid_properties(small_surface().mesh);
  EXPECT_EQ(format_objects_json(result).find("objects/0.obj"), std::string::npos);
  write_result(folder / "out", result);
  const SegmentationResult again = read_result(folder / "out");
  ASSERT_TRUE(again.objects[0].solid);
  EXPECT_EQ(again.objects[0].solid->volume, result.objects[0].solid->volume);
  EXPECT_EQ(again.surfaces[0].mesh.triangles.rows(), 0);
}

TEST(Result, RefusesToReadSurfacesThatAreMissingOrNotNamed) {
  const TemporaryFolder folder;
  SegmentationResult result = small_result();
  result.surfaces = {small_surface(), {}};
  write_result(folder / "out", result);
  fs::rename(folder / "out/objects/0.obj", folder / "out/objects/1.obj");
  EXPECT_NE(refusal([&] { read_result(folder / "out"); }).find("objects/0.obj"), std::string::npos);
  fs::copy_file(folder / "out/objects/1.obj", folder / "out/objects/0.obj");
  EXPECT_EQ(refusal([&] { read_result(folder / "out"); }),
            (folder / "out/objects/1.obj").string() +
                ": expected no file, as objects.json does not name it, found one");
  fs::remove(folder / "out/objects/1.obj");
  EXPECT_EQ(read_result(folder / "out").surfaces[0].mesh.triangles.rows(), 4);
}

TEST(Result, RefusesSurfacesWithCornersThatAreNotThere) {
  const TemporaryFolder folder;
  SegmentationResult result = small_result();
  result.surfaces = {small_surface(), {}};
  result.surfaces[0].mesh.triangles(3, 1) = 4;
  EXPECT_EQ(refusal([&] { write_result(folder / "out", result); }),
            "result to write: expected corners of a surface below 4, the number of its vertices, "
            "found 4");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(Result, RefusesSurfacesThatAreNotOnePerObjectOrLackFlags) {
  const TemporaryFolder folder;
  SegmentationResult result = small_result();
  result.surfaces = {small_surface()};
  EXPECT_THROW(write_result(folder / "out", result), InputError);
  result.surfaces.resize(2);
  result.surfaces[0].observed.clear();
  EXPECT_THROW(write_result(folder / "out", result), InputError);
}

TEST(Result, TheSurroundingsAreReadAndMayBeMissing) {
  const TemporaryFolder folder;
  TriangleMesh surface;
  surface.vertices = random_cloud(3, 7).positions;
  surface.triangles.resize(1, 3);
  surface.triangles << 0, 1, 2;
  StampedPose pose;
  pose.T_world_camera.translation() << 0.25, 0.5, 1.0;
  const Trajectory trajectory{pose};
  write_result(folder / "out", small_result(), {.surface = &surface, .trajectory = &trajectory});
  const Surroundings again = read_result_surroundings(folder / "out");
  EXPECT_EQ(again.surface.vertices, surface.vertices);
  EXPECT_EQ(again.surface.triangles, surface.triangles);
  ASSERT_EQ(again.trajectory.size(), 1U);
  EXPECT_EQ(again.trajectory[0].T_world_camera.translation(), pose.T_world_camera.translation());

  write_result(folder / "out", small_result());
  EXPECT_EQ(read_result_surroundings(folder / "out").surface.vertices.rows(), 0);
  EXPECT_TRUE(read_result_surroundings(folder / "out").trajectory.empty());
}

TEST(Result, CompletedPointsNeedNeitherNormalsNorColors) {
  const TemporaryFolder folder;
  SegmentationResult result = small_result();
  result.completed[0] = random_cloud(7, 2, false, false);
  write_result(folder / "out", result);
  expect_same(read_result(folder / "out").completed[0], result.completed[0]);
}

TEST(Result, FilesOfVersionOneCallResidualsScoresAndHaveNoConfidence) {
  const auto old = parse_objects_json(
      R"({"version":1,"cloud":"cloud.ply","objects":[{"id":0,"points":[0,2],"score":0.9,
          "rotational":[{"point":[0.1,0.2,0.3],"direction":[0,0,1],"score":0.01}],
          "reflectional":[{"point":[0.1,0.2,0.3],"normal":[1,0,0],"score":0.02}],
          "centroid":[1,2,3],"mesh":"objects/0.ply"}]})",
      "old.json", 40);
  ASSERT_EQ(old.objects.size(), 1U);
  const SceneObject& object = old.objects[0];
  EXPECT_EQ(object.score, 0.9);
  EXPECT_EQ(object.confidence, 0.0);
  EXPECT_EQ(object.rotational.at(0).residual, 0.01);
  EXPECT_EQ(object.reflectional.at(0).residual, 0.02);
  EXPECT_EQ(object.centroid, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NE(format_objects_json(old).find(R"("version":3)"), std::string::npos);
  EXPECT_NE(format_objects_json(old).find(R"("residual":0.01)"), std::string::npos);
}

TEST(Result, FilesOfVersionTwoCallTheCloudOfAnObjectItsMesh) {
  const std::string text =
      R"({"version":2,"cloud":"cloud.ply","objects":[{"id":0,"points":[0],"confidence":0.5,
          "rotational":[],"reflectional":[],"mesh":"objects/0.ply"}]})";
  const std::string again = format_objects_json(parse_objects_json(text, "old.json", 40));
  EXPECT_NE(again.find(R"("cloud":"objects/0.ply")"), std::string::npos);
  EXPECT_EQ(again.find("mesh"), std::string::npos);
  std::string other = text;
  other.replace(other.find("objects/0.ply"), 13, "objects/1.ply");
  EXPECT_THROW(parse_objects_json(other, "old.json", 40), InputError);
  other = again;
  other.replace(other.find("objects/0.ply"), 13, "objects/1.ply");
  EXPECT_THROW(parse_objects_json(other, "new.json", 40), InputError);
}

TEST(Result, RefusesABoxWithoutAUnitQuaternionOrWithNegativeEdges) {
  const std::string text = format_objects_json(small_result());
  const auto refused = [&](const std::string& before, const std::string& after) {
    std::string changed = text;
    changed.replace(changed.find(before), before.size(), after);
    return refusal([&] { parse_objects_json(changed, "objects.json", 40); });
  };
  EXPECT_NE(refused(R"("size_m":[0.1)", R"("size_m":[-0.1)").find("objects[0].box.size_m"),
            std::string::npos);
  EXPECT_NE(refused(R"("orientation_xyzw":[)", R"("orientation_xyzw":[3)").find("unit quaternion"),
            std::string::npos);
  EXPECT_NE(refused(R"("T_world_object")", R"("T_world_subject")").find("T_world_object"),
            std::string::npos);
}

TEST(Result, SaysWhatMadeIt) {
  const std::string made_by = R"({"command":"segment","files":[]})";
  const std::string text = format_objects_json(small_result(), true, made_by);
  EXPECT_NE(text.find("\"made_by\":" + made_by), std::string::npos);
  EXPECT_EQ(format_objects_json(parse_objects_json(text, "x", 40)),
            format_objects_json(small_result()));
  EXPECT_THROW(format_objects_json(small_result(), true, "segment"), InputError);
}

TEST(Result, TheTextIsTheSameForTheSameResult) {
  const std::string text = format_objects_json(small_result());
  EXPECT_EQ(text, format_objects_json(small_result()));
  EXPECT_NE(text.find(R"("timings":{"z first":0.25,"a second":0.5})"), std::string::npos);
  EXPECT_NE(text.find(R"("score":0.3333333333333333,)"), std::string::npos);
  SegmentationResult slower = small_result();
  slower.timings[0].seconds = 9.0;
  EXPECT_EQ(format_objects_json(slower, false), format_objects_json(small_result(), false));
}

TEST(Result, WarningsAreReadBackAndAbsentIfThereAreNone) {
  SegmentationResult result = small_result();
  EXPECT_EQ(format_objects_json(result).find("warnings"), std::string::npos);
  EXPECT_TRUE(parse_objects_json(format_objects_json(result), "x", 40).warnings.empty());
  result.warnings = {"no occupancy map", "\"quoted\" µ"};
  const auto again = parse_objects_json(format_objects_json(result), "x", 40);
  EXPECT_EQ(again.warnings, result.warnings);
}

TEST(Result, TimesOfAStageThatRanTwiceAreAdded) {
  SegmentationResult result = small_result();
  result.timings.push_back({"z first", 1.0});
  const auto again = parse_objects_json(format_objects_json(result), "x", 40);
  ASSERT_EQ(again.timings.size(), 2U);
  EXPECT_EQ(again.timings[0].seconds, 1.25);
}

TEST(Result, AnOptionalMemberMayBeNull) {
  const std::string text =
      R"({"version":3,"cloud":"cloud.ply","table":null,"objects":[{"id":0,"points":[0],
          "confidence":0.5,"rotational":[],"reflectional":[],"cloud":null}]})";
  const SegmentationResult result = parse_objects_json(text, "null.json", 40);
  EXPECT_FALSE(result.table);
  EXPECT_EQ(result.objects.size(), 1U);
}

TEST(Result, ARejectionMayHaveNoFiniteValue) {
  SegmentationResult result = small_result();
  result.rejected[0].value = std::numeric_limits<double>::infinity();
  const auto again = parse_objects_json(format_objects_json(result), "x", 40);
  EXPECT_TRUE(std::isnan(again.rejected[0].value));
}

TEST(Result, AnOlderResultIsReplacedCompletely) {
  const TemporaryFolder folder;
  write_result(folder / "out", small_result());
  SegmentationResult smaller = small_result();
  smaller.objects.pop_back();
  smaller.completed.clear();
  write_result(folder / "out", smaller);
  EXPECT_FALSE(fs::exists(folder / "out/objects/1.ply"));
  EXPECT_EQ(read_result(folder / "out").objects.size(), 1U);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
}

TEST(Result, AFailedWriteLeavesTheOldResultUnchanged) {
  const TemporaryFolder folder;
  const SegmentationResult result = small_result();
  write_result(folder / "out", result);
  const auto refuse = [&](auto spoil) {
    SegmentationResult wrong = small_result();
    spoil(wrong);
    EXPECT_THROW(write_result(folder / "out", wrong), InputError);
  };
  refuse([](SegmentationResult& r) { r.objects[0].points.back() = 40; });
  refuse([](SegmentationResult& r) { r.objects[0].points = {5, 5}; });
  refuse([](SegmentationResult& r) { r.objects[0].score = 1.5; });
  refuse([](SegmentationResult& r) {
    r.objects[0].centroid->x() = std::numeric_limits<double>::quiet_NaN();
  });
  refuse([](SegmentationResult& r) { r.completed.pop_back(); });
  refuse([](SegmentationResult& r) { r.cloud.colors.conservativeResize(3, 3); });
  refuse([](SegmentationResult& r) { r.rejected[0].kind = "\xFF"; });
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
  EXPECT_EQ(format_objects_json(read_result(folder / "out")), format_objects_json(result));
}

TEST(Result, AFolderWithOtherFilesIsNotReplaced) {
  const TemporaryFolder folder;
  write_result(folder / "out", small_result());
  for (const char* name : {"notes.txt", "objects/cup.ply", "objects/.ply", "occupancy.bt"}) {
    write_text(folder / "out" / name, "mine");
    EXPECT_THROW(write_result(folder / "out", small_result()), InputError) << name;
    EXPECT_EQ(read_text(folder / "out" / name), "mine");
    fs::remove(folder / "out" / name);
  }
  write_result(folder / "out", small_result());
}

}  // namespace
}  // namespace symscene
