#include "symscene/ground_truth/truth_file.hpp"

#include "io/io_support.hpp"
#include "symscene/io/mesh.hpp"

namespace symscene {
namespace {

using namespace io_test;

namespace fs = std::filesystem;

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = Points::Zero(4, 3);
  mesh.vertices.bottomRows(3).setIdentity();
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return mesh;
}

SceneTruth small_truth() {
  SceneTruth truth;
  truth.table = {Eigen::Vector3d(0.0, 0.6, 0.8), 0.1};
  TrueObject object;
  object.name = "can \"A\"";
  object.points = {0, 3, 17};
  object.rotational = {{{Eigen::Vector3d(0.1, 1.0 / 3.0, 3), Eigen::Vector3d(0, 0, 1)}, false}};
  object.reflectional = {{{Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 0, 0)}, true}};
  object.sphere = true;
  object.centroid = {1e-9, 2.0 / 3.0, -5.0};
  truth.objects = {object, TrueObject{}};
  return truth;
}

TEST(Truth, WritingAndReadingGiveTheSameBits) {
  const SceneTruth truth = small_truth();
  const std::string text = format_truth(truth);
  const SceneTruth again = parse_truth(text, "x", 18);
  ASSERT_EQ(again.objects.size(), 2U);
  const TrueObject& object = again.objects[0];
  EXPECT_EQ(again.table.normal, truth.table.normal);
  EXPECT_EQ(object.name, truth.objects[0].name);
  EXPECT_EQ(object.points, truth.objects[0].points);
  EXPECT_EQ(object.rotational[0].axis.point, truth.objects[0].rotational[0].axis.point);
  EXPECT_FALSE(object.rotational[0].strict);
  EXPECT_TRUE(object.reflectional[0].strict);
  EXPECT_TRUE(object.sphere);
  EXPECT_EQ(object.centroid, truth.objects[0].centroid);
  EXPECT_EQ(format_truth(again), text);
}

TEST(Truth, AMeshWithItsPoseReplacesPoints) {
  const SceneTruth truth = parse_truth(
      R"({"table": [0,0,2,-1], "objects": [{"mesh": "can.ply", "centroid": [0,0,0],
          "pose": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]],
          "rot": [{"p":[0,0,0],"d":[0,0,5]}]}]})",
      "x");
  EXPECT_EQ(truth.table.offset, -0.5);
  ASSERT_EQ(truth.objects.size(), 1U);
  EXPECT_EQ(truth.objects[0].name, "can.ply");
  EXPECT_TRUE(truth.objects[0].points.empty());
  EXPECT_EQ(truth.objects[0].rotational[0].axis.direction, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(truth.objects[0].rotational[0].strict);
}

TEST(Truth, AMeshAndItsPoseAreKeptWithAndWithoutPoints) {
  SceneTruth truth;
  TrueObject object;
  object.name = "mug";
  object.mesh = "mug_2";
  object.T_world_mesh = Eigen::Translation3d(0.1, 1.0 / 3.0, 2) *
                        Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized());
  truth.objects = {object, object};
  truth.objects[1].points = {2, 5};
  const std::string text = format_truth(truth);
  const SceneTruth again = parse_truth(text, "x", 6);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(again.objects[k].name, "mug");
    EXPECT_EQ(again.objects[k].mesh, "mug_2");
    EXPECT_EQ(again.objects[k].T_world_mesh->matrix(), object.T_world_mesh->matrix());
    EXPECT_EQ(again.objects[k].points, truth.objects[k].points);
  }
  EXPECT_EQ(format_truth(again), text);
}

TEST(Truth, MeshesAreReadFromTheFolderBesideIt) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "meshes");
  write_mesh(folder / "meshes/mug.ply", tetrahedron());
  SceneTruth truth;
  truth.objects.resize(2);
  truth.objects[0].mesh = truth.objects[1].mesh = "mug";
  EXPECT_EQ(read_truth_meshes(folder / ".", truth).size(), 2U);
  for (const char* name : {"", "cup", "../meshes/mug", "/mug"}) {
    truth.objects[1].mesh = name;
    EXPECT_THROW(read_truth_meshes(folder / ".", truth), InputError) << name;
  }
}

TEST(Truth, SymmetriesOfModelsAreReadByName) {
  const TemporaryFolder folder;
  write_text(folder / "s.json",
             R"({"mug": {"diag": 0.1, "centroid": [1,2,3], "rot": [], "sphere": false,
                 "refl": [{"err": 0.01, "n": [0,2,0], "p": [0,0,1], "strict": false}]},
                 "ball": {"centroid": [0,0,0], "sphere": true}})");
  const std::vector<TrueObject> models = read_model_symmetries(folder / "s.json");
  ASSERT_EQ(models.size(), 2U);
  EXPECT_EQ(models[0].name, "mug");
  EXPECT_EQ(models[0].reflectional.at(0).plane.normal, Eigen::Vector3d::UnitY());
  EXPECT_FALSE(models[0].reflectional[0].strict);
  EXPECT_TRUE(models[1].sphere);
  write_text(folder / "s.json", R"({"mug": {"centroid": [1,2]}})");
  EXPECT_NE(refusal([&] { read_model_symmetries(folder / "s.json"); }).find("\"mug\".centroid"),
            std::string::npos);
}

std::string with_object(const std::string& object) {
  return R"({"table": [0,0,1,0], "objects": [{"centroid": [0,0,0], )" + object + "}]}";
}

TEST(Truth, RefusalsNameFileAndPath) {
  const auto message = [](const std::string& text) {
    return refusal([&] { parse_truth(text, "truth.json", 10); });
  };
  EXPECT_EQ(message("{"), "truth.json: expected JSON, found a mistake at byte 2");
  EXPECT_EQ(message("[]"), "truth.json: expected an object, found an array of 0");
  EXPECT_EQ(message(R"({"table": [0, 1, 2]})"),
            "truth.json: table: expected an array of 4, found an array of 3");
  EXPECT_EQ(message(R"({"table": [0, 0, 0, 1]})"),
            "truth.json: table: expected a direction, found a vector without length");
  EXPECT_EQ(message(with_object(R"("points": [3, 10])")),
            "truth.json: objects[0].points[1]: expected an index below 10, the size of the cloud, "
            "found 10");
  EXPECT_EQ(message(with_object(R"("points": [3, 3])")),
            "truth.json: objects[0].points[1]: expected ascending indices, found 3");
  EXPECT_EQ(message(with_object(R"("points": [-1])")),
            "truth.json: objects[0].points[0]: expected the index of a point, found -1");
  EXPECT_EQ(message(with_object(R"("name": "x")")),
            "truth.json: objects[0]: expected \"points\", or \"mesh\" and \"pose\", found an "
            "object");
  EXPECT_EQ(
      message(with_object(R"("mesh": "x", "pose": [[1,0,0,0],[0,2,0,0],[0,0,1,0],[0,0,0,1]])")),
      "truth.json: objects[0].pose: expected a rotation and translation as a 4x4 matrix, "
      "found an array of 4");
  EXPECT_EQ(message(with_object(R"("points": [], "sphere": 1)")),
            "truth.json: objects[0].sphere: expected true or false, found 1");
}

TEST(Truth, NumbersThatAreNotFiniteAreNotWritten) {
  SceneTruth truth = small_truth();
  truth.objects[0].centroid.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(format_truth(truth), InputError);
}

TEST(Truth, DamagedFilesAreReadOrRefused) {
  const std::string text = format_truth(small_truth());
  // Only the line's end can be missed.
  EXPECT_EQ(damage(text, [](std::string_view b) { parse_truth(b, "x", 18); }), 1);
}

TEST(Truth, ObjectsOfTooManyMembersAreRefusedQuickly) {
  std::string text = "{";
  for (int i = 0; i < 200000; ++i) text += "\"" + std::to_string(i) + "\":0,";
  EXPECT_EQ(refusal([&] { parse_truth(text + "\"a\":0}", "truth.json"); }),
            "truth.json: expected JSON objects of at most 1000 members, found more");
}

TEST(Truth, DeepNestingIsRefused) {
  EXPECT_THROW(parse_truth(std::string(100000, '['), "x"), InputError);
  EXPECT_THROW(parse_truth(std::string(100000, '[') + std::string(100000, ']'), "x"), InputError);
}

}  // namespace
}  // namespace symscene
