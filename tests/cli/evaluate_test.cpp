// symscene evaluate, run as a process: the report of a small dataset, and invalid datasets.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace symscene::testing {
namespace {

/// Two small scenes, one directly in the dataset and one beside its result, and their report.
class EvaluateCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    workspace_ = std::make_unique<Workspace>();
    write(file("small.json"), R"({"tabletop": {"objects": 2}, "camera": {"frames": 6}})");
    for (const char* line :
         {"simulate -o data/first --config small.json",
          "simulate -o data/second/scene --config small.json --seed 2",
          "segment data/second/scene -o data/second/result", "evaluate data -o report --json"}) {
      const Outcome outcome = run(line);
      ASSERT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
      report_ = outcome.err + outcome.out;
    }
  }
  static void TearDownTestSuite() { workspace_.reset(); }

  static Outcome run(const std::string& arguments) { return workspace_->run(arguments); }
  static fs::path file(const std::string& name) { return *workspace_ / name; }
  static const std::string& report() { return report_; }

  static nlohmann::json truth_of_first() {
    return nlohmann::json::parse(contents(file("data/first/truth.json")));
  }

  static void expect_refusal(const std::string& arguments, const std::string& sentence) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, sentence.starts_with("--") ? 2 : 1) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(file("new"))) << arguments;
  }

  /// The first scene with another ground truth.
  static void spoil(const nlohmann::json& truth) {
    fs::remove_all(file("spoilt"));
    fs::create_directories(file("spoilt"));
    fs::copy(file("data/first"), file("spoilt/one"));
    write(file("spoilt/one/truth.json"), truth.dump());
  }

 private:
  static std::unique_ptr<Workspace> workspace_;
  static std::string report_;
};

std::unique_ptr<Workspace> EvaluateCommand::workspace_;
std::string EvaluateCommand::report_;

TEST_F(EvaluateCommand, WritesTheReportAndPrintsItsHeadlineAndTheMissedObjects) {
  for (const char* name :
       {"report.html", "report.json", "curves.csv", "objects.csv", "scenes.csv", "pixels.csv"})
    EXPECT_GT(fs::file_size(file("report") / name), 50U) << name;
  const auto json = nlohmann::json::parse(contents(file("report/report.json")));
  EXPECT_EQ(json.at("scenes").at(0).at("name"), "first");
  EXPECT_EQ(json.at("scenes").at(1).at("name"), "second/scene");
  for (const char* text : {"masks .9", "Rot + Refl", "Refl only", "not proposed", "total"})
    EXPECT_NE(report().find(text), std::string::npos) << text;
  const auto line = nlohmann::json::parse(report().substr(report().rfind("{\"command\"")));
  EXPECT_EQ(line.at("scenes"), 2);
  EXPECT_EQ(line.at("headline"), json.at("headline"));
}

TEST_F(EvaluateCommand, ReportsTheSameWithOneThread) {
  ASSERT_EQ(run("evaluate data -o single --threads 1 --quiet").out, "");
  for (const char* name : {"curves.csv", "objects.csv"})
    EXPECT_EQ(contents(file("single") / name), contents(file("report") / name));
}

TEST_F(EvaluateCommand, ComparesWithAnEarlierReport) {
  write(file("tight.json"), R"({"reflectional_segmentation": {"bounds": {"min_size": 100000}}})");
  const Outcome outcome =
      run("evaluate data -o tight --fast --baselines none --config tight.json --compare "
          "report/report.json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("difference"), std::string::npos);
  EXPECT_EQ(outcome.out.find("Refl only"), std::string::npos);
  expect_refusal("evaluate data -o new --compare tight.json", "tight.json");
}

TEST_F(EvaluateCommand, RefusesInvalidDatasetsInOneSentence) {
  fs::create_directories(file("empty"));
  expect_refusal("evaluate empty -o new", "empty");
  expect_refusal("evaluate nowhere -o new", "nowhere");
  expect_refusal("evaluate small.json -o new", "small.json");
  expect_refusal("evaluate data -o data/report", "outside the input");
  expect_refusal("evaluate data -o new --baselines guesswork", "--baselines: expected");
}

TEST_F(EvaluateCommand, NamesTheWayFromASequenceToAScene) {
  fs::create_directories(file("sweep"));
  for (const char* name : {"sequence.json", "truth.json"}) write(file("sweep") / name, "{}");
  expect_refusal("evaluate sweep -o new", "symscene reconstruct sweep -o scenes/sweep");
}

TEST_F(EvaluateCommand, RefusesMissingOrContradictoryGroundTruth) {
  spoil({});
  fs::remove(file("spoilt/one/truth.json"));
  expect_refusal("evaluate spoilt -o new", "spoilt");
  nlohmann::json truth = truth_of_first();
  truth.at("objects").at(0).at("points").push_back(10'000'000);
  spoil(truth);
  expect_refusal("evaluate spoilt -o new", "spoilt/one/truth.json");
  truth = truth_of_first();
  truth.at("objects").push_back(truth.at("objects").at(0));
  spoil(truth);
  expect_refusal("evaluate spoilt -o new", "share no point");
}

TEST_F(EvaluateCommand, NeverReplacesFoldersWithOtherFiles) {
  fs::create_directories(file("mine"));
  write(file("mine/thesis.txt"), "text");
  EXPECT_EQ(run("evaluate data -o mine --fast --baselines none").code, 1);
  EXPECT_EQ(contents(file("mine/thesis.txt")), "text");
}

}  // namespace
}  // namespace symscene::testing
