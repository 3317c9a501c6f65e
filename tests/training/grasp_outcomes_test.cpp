#include "training/grasp_outcomes.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"

namespace symscene::bench {
namespace {

std::filesystem::path written(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  std::ofstream(file) << text;
  return file;
}

/// The columns of a file of attempts: the round, all features and the outcome.
std::string header() {
  std::string text = "round,source";
  const GraspFeatures none;
  GraspFeatures::visit_fields(none,
                              [&](const char* name, double) { text += "," + std::string(name); });
  return text + ",success\n";
}

std::string row(int round, double value, bool success) {
  std::string text = std::to_string(round) + ",rim";
  const GraspFeatures none;
  GraspFeatures::visit_fields(none,
                              [&](const char*, double) { text += "," + std::to_string(value); });
  return text + (success ? ",1\n" : ",0\n");
}

TEST(GraspOutcomes, AreReadByTheNamesOfTheColumns) {
  const auto file = written("a.csv", header() + row(4, 0.25, true) + row(4, 0.5, false));
  const std::vector<GraspSample> samples = read_grasp_samples({file});
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_TRUE(samples[0].success);
  EXPECT_FALSE(samples[1].success);
  EXPECT_EQ(samples[0].grasp.source, GraspSource::rim);
  EXPECT_EQ(samples[0].grasp.features.tilt, 0.25);
  EXPECT_EQ(samples[1].grasp.features.cone_margin, 0.5);
}

TEST(GraspOutcomes, RoundsOfDifferentFilesAreDifferentGroups) {
  const auto a = written("b.csv", header() + row(0, 0, true) + row(0, 0, true) + row(1, 0, true));
  const auto b = written("c.csv", header() + row(0, 0, true));
  const std::vector<GraspSample> samples = read_grasp_samples({a, b});
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_EQ(samples[0].group, samples[1].group);
  EXPECT_NE(samples[0].group, samples[2].group);
  EXPECT_NE(samples[0].group, samples[3].group);
}

TEST(GraspOutcomes, FilesThatAreNotAttemptsAreRefused) {
  EXPECT_THROW(read_grasp_samples({written("d.csv", "")}), InputError);
  EXPECT_THROW(read_grasp_samples({written("e.csv", "round,success\n1,1\n")}), InputError);
  EXPECT_THROW(read_grasp_samples({written("f.csv", header() + "1,2,3\n")}), InputError);
  std::string unknown = row(0, 0, true);
  unknown.replace(unknown.find("rim"), 3, "toe");
  EXPECT_THROW(read_grasp_samples({written("g.csv", header() + unknown)}), InputError);
}

}  // namespace
}  // namespace symscene::bench
