// Results that are damaged or contradict themselves.
#include "io/small_result.hpp"

namespace symscene {
namespace {

using namespace io_test;
namespace fs = std::filesystem;

TEST(Result, InconsistentFilesAreRefused) {
  const TemporaryFolder folder;
  write_result(folder / "out", small_result());
  fs::copy_file(folder / "out/objects/1.ply", folder / "out/objects/0.ply",
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(refusal([&] { read_result(folder / "out"); }),
            (folder / "out/objects/0.ply").string() + ": expected 3 observed points, found 2");
  fs::copy_file(folder / "out/cloud.ply", folder / "out/objects/0.ply",
                fs::copy_options::overwrite_existing);
  EXPECT_THROW(read_result(folder / "out"), InputError);
  EXPECT_EQ(refusal([&] { read_result(folder / "none"); }),
            (folder / "none").string() +
                ": expected a result folder, which holds cloud.ply and objects.json, found nothing "
                "of that name");
}

TEST(Result, MembersThatAreGivenTwiceAreRefused) {
  const std::string twice = replaced(format_objects_json(small_result()), "{", "{\"version\": 1,");
  EXPECT_EQ(refusal([&] { parse_objects_json(twice, "objects.json", 40); }),
            "objects.json: expected each member of a JSON object once, found \"version\" twice");
}

TEST(Result, RefusalsNameFileAndPath) {
  const std::string text = format_objects_json(small_result());
  const auto message = [&](const std::string& from, const std::string& to) {
    const std::string changed = replaced(text, from, to);
    return refusal([&] { parse_objects_json(changed, "objects.json", 40); });
  };
  EXPECT_EQ(message("\"version\":3", "\"version\":4"),
            "objects.json: version: expected at most 3, found 4");
  EXPECT_EQ(message("\"residual\":0.01", "\"score\":0.01"),
            "objects.json: objects[0].rotational[0]: expected a member \"residual\", found none");
  EXPECT_EQ(message("[0,5,39]", "[0,5,40]"),
            "objects.json: objects[0].points[2]: expected an index below 40, the size of the "
            "cloud, found 40");
  EXPECT_EQ(message("\"score\":0.3333333333333333", "\"score\":1.5"),
            "objects.json: objects[0].score: expected a score in [0, 1], found 1.5");
  EXPECT_EQ(message("\"id\":1", "\"id\":7"), "objects.json: objects[1].id: expected 1, found 7");
  EXPECT_EQ(message("[0.6,0.0,0.8]", "[0,0,0]"),
            "objects.json: objects[0].rotational[0].direction: expected a direction, found a "
            "vector without length");
  EXPECT_EQ(message("objects/0.ply", "../../etc/passwd"),
            "objects.json: objects[0].cloud: expected objects/0.ply, found \"../../etc/passwd\"");
  EXPECT_EQ(message("\"funnel\":[", "\"funnel\":[{},"),
            "objects.json: funnel[0]: expected a member \"step\", found none");
}

TEST(Result, DamagedFilesAreReadOrRefused) {
  const std::string text = format_objects_json(small_result());
  EXPECT_EQ(damage(text, [](std::string_view b) { parse_objects_json(b, "x", 40); }), 1);
}

}  // namespace
}  // namespace symscene
