// The JSON files that the command writes conform to the schemas in docs/.
#include "cli/json_schema.hpp"
#include "cli/small_scene.hpp"

namespace symscene::testing {
namespace {

class Schema : public Command {
 protected:
  static nlohmann::json json_of(const std::string& name) {
    return nlohmann::json::parse(contents(file(name)));
  }
  static std::string violation(const std::string& schema, const nlohmann::json& value) {
    return JsonSchema(schema).violation(value);
  }
};

TEST_F(Schema, DescribesTheObjectsOfAResult) {
  EXPECT_EQ(violation("objects.schema.json", json_of("result/objects.json")), "");
}

TEST_F(Schema, DescribesGrasps) {
  ASSERT_EQ(run("grasp result -o grasps.json --gripper reflex").code, 0);
  EXPECT_EQ(violation("grasps.schema.json", json_of("grasps.json")), "");
}

TEST_F(Schema, DescribesCylinders) {
  ASSERT_EQ(run("cylinders scene -o cylinders.json --gripper reflex").code, 0);
  EXPECT_EQ(violation("cylinders.schema.json", json_of("cylinders.json")), "");
  // Clusters without an axis as well.
  write(file("strict.json"), R"({"axis": {"max_symmetry_residual": 0.0}})");
  ASSERT_EQ(run("cylinders scene -o cylinders.json --config strict.json").code, 0);
  EXPECT_EQ(violation("cylinders.schema.json", json_of("cylinders.json")), "");
}

TEST_F(Schema, DescribesViews) {
  write(file("camera.txt"), "640 480 525 525 319.5 239.5\n");
  for (const char* policy : {"symmetry", "unknown-voxels"}) {
    ASSERT_EQ(
        run("next-view scene --camera camera.txt -o views.json --policy " + std::string(policy))
            .code,
        0);
    EXPECT_EQ(violation("views.schema.json", json_of("views.json")), "");
  }
}

TEST_F(Schema, FindsWhatDoesNotConform) {
  ASSERT_EQ(run("cylinders scene -o cylinders.json --gripper reflex").code, 0);
  const auto found = [&](const auto& change) {
    nlohmann::json json = json_of("cylinders.json");
    change(json);
    return violation("cylinders.schema.json", json);
  };
  EXPECT_EQ(found([](auto& json) { json.erase("clusters"); }), "$: required \"clusters\"");
  EXPECT_EQ(found([](auto& json) { json["clusters"][0].erase("points"); }),
            "$.clusters[0]: required \"points\"");
  EXPECT_NE(found([](auto& json) { json["clusters"][0]["colour"] = 1; }), "");
  EXPECT_NE(found([](auto& json) { json["clusters"][0]["points"] = 2.5; }), "");
  EXPECT_NE(found([](auto& json) { json["objects"][0]["rejected"]["unlucky"] = 1; }), "");
  EXPECT_NE(found([](auto& json) { json["gripper"]["max_opening_m"] = nullptr; }), "");
  EXPECT_NE(found([](auto& json) {
              json["clusters"][0]["reason"] = "symmetry";
              json["clusters"][0]["value"] = json["clusters"][0]["bound"] = 0.0;
              json["clusters"][0]["cylinder"] = {};
            }),
            "");
}

}  // namespace
}  // namespace symscene::testing
