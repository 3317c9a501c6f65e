// `symscene symmetry` from outside: its formats, and models that it cannot read.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

/// A box of 100 × 160 × 230 about the origin, in millimetres.
std::string box_obj() {
  std::string text;
  for (const char* x : {"-50", "50"}) {
    for (const char* y : {"-80", "80"}) {
      for (const char* z : {"-115", "115"})
        text += std::string("v ") + x + " " + y + " " + z + "\n";
    }
  }
  return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
}

class SymmetryCommand : public ::testing::Test {
 protected:
  SymmetryCommand() {
    fs::create_directory(workspace_ / "models");
    for (const char* name : {"obj_000003.obj", "obj_000007.obj"})
      write(workspace_ / "models" / name, box_obj());
  }
  Outcome run(const std::string& line) const { return workspace_.run("symmetry " + line); }

  Workspace workspace_;
};

TEST_F(SymmetryCommand, DescribesTheGroupOfAModel) {
  const Outcome outcome = run("models/obj_000003.obj --units mm");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& model = json.at("models").at(0);
  EXPECT_EQ(model.at("name"), "obj_000003");
  EXPECT_NEAR(model.at("diameter").get<double>(), 297.4, 0.3);
  EXPECT_EQ(model.at("planes").size(), 3U);
  EXPECT_EQ(model.at("axes").size(), 3U);
  EXPECT_EQ(model.at("rotations").size(), 3U);
  for (const auto& plane : model.at("planes"))
    EXPECT_LT(plane.at("residual_mm").get<double>(), 1.0);
}

TEST_F(SymmetryCommand, WritesModelsInfoOfAFolder) {
  const Outcome outcome = run("models --units mm --format bop -o models_info.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto json = nlohmann::json::parse(contents(workspace_ / "models_info.json"));
  ASSERT_EQ(json.size(), 2U);
  const auto& entry = json.at("7");
  EXPECT_NEAR(entry.at("diameter").get<double>(), 297.4, 0.3);
  EXPECT_NEAR(entry.at("min_z").get<double>(), -115.0, 1e-3);
  EXPECT_NEAR(entry.at("size_y").get<double>(), 160.0, 1e-3);
  ASSERT_EQ(entry.at("symmetries_discrete").size(), 3U);
  for (const auto& matrix : entry.at("symmetries_discrete")) {
    ASSERT_EQ(matrix.size(), 16U);
    // Half turns about the middle, the origin.
    EXPECT_NEAR(matrix[0].get<double>() + matrix[5].get<double>() + matrix[10].get<double>(), -1.0,
                1e-6);
    EXPECT_NEAR(matrix[3].get<double>(), 0.0, 1.0);
    EXPECT_EQ(matrix[15], 1.0);
  }
  EXPECT_FALSE(entry.contains("symmetries_continuous"));
}

TEST_F(SymmetryCommand, WarnsOfModelsInAnotherUnitThanSaid) {
  const Outcome outcome = run("models --format bop -o models_info.json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("obj_000003 (2.97e+05 mm)"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--units"), std::string::npos) << outcome.err;
}

TEST_F(SymmetryCommand, NumbersModelsWithOtherNamesAndSaysSoOnce) {
  fs::rename(workspace_ / "models/obj_000003.obj", workspace_ / "models/box.obj");
  const Outcome outcome = run("models --units mm --format bop");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err,
            "symscene symmetry: warning: models are numbered in order, as not all names are like "
            "obj_000001: 1 is box, 2 is obj_000007\n");
  EXPECT_TRUE(nlohmann::json::parse(outcome.out).contains("2"));
}

TEST_F(SymmetryCommand, WritesYaml) {
  const Outcome outcome = run("models/obj_000003.obj --format yaml");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind("version: 2\nmodels:\n  - name: \"obj_000003\"\n    diameter: ", 0),
            0U)
      << outcome.out;
  EXPECT_NE(outcome.out.find("\n    axes:\n      - point: ["), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\n        order: 2\n"), std::string::npos);
}

/// Of a motion by rows.
Eigen::Matrix4d matrix_of(const nlohmann::json& rows) {
  Eigen::Matrix4d matrix;
  for (int k = 0; k < 16; ++k) matrix(k / 4, k % 4) = rows.at(static_cast<std::size_t>(k));
  return matrix;
}

TEST_F(SymmetryCommand, DiscreteSymmetriesOfModelsInfoAreAGroupOfProperRotations) {
  const Outcome outcome = run("models --units mm --format bop");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<Eigen::Matrix4d> group{Eigen::Matrix4d::Identity()};
  for (const auto& rows : nlohmann::json::parse(outcome.out).at("3").at("symmetries_discrete"))
    group.push_back(matrix_of(rows));
  for (const Eigen::Matrix4d& a : group) {
    EXPECT_NEAR((a.topLeftCorner<3, 3>().determinant()), 1.0, 1e-9);
    for (const Eigen::Matrix4d& b : group) {
      EXPECT_TRUE(std::any_of(group.begin(), group.end(),
                              [&](const Eigen::Matrix4d& c) { return (a * b).isApprox(c, 1e-9); }));
    }
  }
}

TEST_F(SymmetryCommand, SearchesPartialScansByScores) {
  const Outcome outcome = run("models/obj_000003.obj --partial");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_FALSE(json.at("models").at(0).at("planes").empty());
  EXPECT_TRUE(json.at("models").at(0).at("planes").at(0).contains("residual"));
  EXPECT_EQ(run("models/obj_000003.obj --partial --format bop").code, 2);
}

TEST_F(SymmetryCommand, WritesAPageForReview) {
  const Outcome outcome = run("models --units mm --review review.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "review.html\n");
  const std::string page = contents(workspace_ / "review.html");
  EXPECT_NE(page.find("\"name\":\"obj_000007\""), std::string::npos);
  EXPECT_EQ(page.find("@@SYMSCENE"), std::string::npos);
}

TEST_F(SymmetryCommand, LeavesOutWhatAReviewRejects) {
  const Outcome before = run("models/obj_000003.obj --units mm");
  ASSERT_EQ(before.code, 0) << before.err;
  const auto model = nlohmann::json::parse(before.out).at("models").at(0);
  auto symmetries = nlohmann::json::array();
  for (const auto& axis : model.at("axes"))
    symmetries.push_back({{"kind", "axis"},
                          {"point", axis.at("point")},
                          {"direction", axis.at("direction")},
                          {"order", axis.at("order")},
                          {"choice", "accepted"}});
  symmetries[0]["choice"] = "rejected";
  // A choice of an axis of another order is none of these.
  symmetries.insert(symmetries.begin(), symmetries[1]);
  symmetries[0]["order"] = 4;
  symmetries[0]["choice"] = "rejected";
  const nlohmann::json choices = {
      {"version", 1}, {"models", {{{"name", "obj_000003"}, {"symmetries", symmetries}}}}};
  write(workspace_ / "choices.json", choices.dump());
  const Outcome after = run("models --units mm --reviewed choices.json --format bop");
  ASSERT_EQ(after.code, 0) << after.err;
  EXPECT_NE(after.err.find("obj_000007 was not reviewed"), std::string::npos) << after.err;
  EXPECT_NE(after.err.find("3 of 6 symmetries were not reviewed"), std::string::npos) << after.err;
  EXPECT_NE(after.err.find("is left out too"), std::string::npos) << after.err;
  const auto info = nlohmann::json::parse(after.out);
  EXPECT_EQ(info.at("3").at("symmetries_discrete").size(), 1U);
  EXPECT_EQ(info.at("7").at("symmetries_discrete").size(), 3U);
}

TEST_F(SymmetryCommand, RefusesWhatIsNoReview) {
  write(workspace_ / "old.json", R"({"version": 0, "models": []})");
  write(workspace_ / "word.json", R"({"version": 1, "models": [{"name": "a", "symmetries": [
      {"kind": "axis", "point": [0, 0, 0], "direction": [0, 0, 1], "choice": "maybe"}]}]})");
  write(workspace_ / "kind.json", R"({"version": 1, "models": [{"name": "a", "symmetries": [
      {"kind": "cube", "point": [0, 0, 0], "direction": [0, 0, 1], "choice": "accepted"}]}]})");
  write(workspace_ / "order.json", R"({"version": 1, "models": [{"name": "a", "symmetries": [
      {"kind": "axis", "order": "two", "point": [0, 0, 0], "direction": [0, 0, 1],
       "choice": "accepted"}]}]})");
  write(workspace_ / "twice.json", R"({"version": 1, "models": [
      {"name": "a", "symmetries": []}, {"name": "a", "symmetries": []}]})");
  const std::vector<std::pair<const char*, int>> cases = {{"--reviewed old.json", 1},
                                                          {"--reviewed word.json", 1},
                                                          {"--reviewed no.json", 1},
                                                          {"--reviewed kind.json", 1},
                                                          {"--reviewed twice.json", 1},
                                                          {"--reviewed order.json", 1},
                                                          {"--review page.html -o page.html", 1},
                                                          {"--reviewed old.json --partial", 2},
                                                          {"--review page.html --partial", 2},
                                                          {"--review page.html --format bop", 2},
                                                          {"--review models/obj_000003.obj", 1}};
  for (const auto& [options, code] : cases) {
    const Outcome outcome = run(std::string("models/obj_000003.obj ") + options);
    EXPECT_EQ(outcome.code, code) << options;
    EXPECT_NE(outcome.err.find("symscene symmetry: "), std::string::npos) << outcome.err;
  }
}

TEST_F(SymmetryCommand, RefusesWhatIsNoModel) {
  write(workspace_ / "no.obj", "v 0 0 0\n");
  for (const char* line : {"no.obj", "nowhere", "models/obj_000003.obj -o models/obj_000003.obj"}) {
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, 1) << line;
    EXPECT_NE(outcome.err.find("symscene symmetry: "), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace symscene::testing
