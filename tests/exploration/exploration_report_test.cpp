#include "symscene/exploration/exploration_report.hpp"

#include <gtest/gtest.h>

#include "exploration/exploration_measures.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// An exploration whose completed share is `share` after each of two views.
Exploration flat(int scene, ExplorationPolicy policy, double share) {
  ExplorationStep step;
  step.completed = share;
  step.observed = 0.5 * share;
  return {"packed", scene, policy, {step, step}};
}

double mean_of(const std::vector<double>& values, std::span<const std::size_t> scenes) {
  double sum = 0.0;
  for (const std::size_t scene : scenes) sum += values[scene];
  return sum / static_cast<double>(scenes.size());
}

Estimate estimated_mean(const std::vector<double>& values) {
  return estimate([&](std::span<const std::size_t> scenes) { return mean_of(values, scenes); },
                  values.size());
}

TEST(Estimate, OfEqualValuesHasNoWidth) {
  const Estimate e = estimated_mean(std::vector<double>(7, 0.25));
  EXPECT_EQ(e.value, 0.25);
  EXPECT_EQ(e.low, 0.25);
  EXPECT_EQ(e.high, 0.25);
}

TEST(Estimate, EnclosesTheMeanAndNarrowsWithScenes) {
  std::vector<double> few{-1.0, 1.0, -1.0, 1.0}, many;
  for (int k = 0; k < 25; ++k) many.insert(many.end(), few.begin(), few.end());
  const Estimate a = estimated_mean(few), b = estimated_mean(many);
  EXPECT_LT(a.low, a.value);
  EXPECT_GT(a.high, a.value);
  EXPECT_LT(b.high - b.low, 0.5 * (a.high - a.low));
}

TEST(ExplorationMeasures, AddCountsOfScenesBeforeTheyDivide) {
  std::vector<Exploration> all{flat(0, ExplorationPolicy::symmetry, 0.5),
                               flat(1, ExplorationPolicy::symmetry, 0.5)};
  all[0].steps[1].axes = {1, 1, 1};
  all[1].steps[1].axes = {0, 0, 3};
  all[0].steps[1].planes = {2, 2, 4};
  all[1].steps[1].planes = {4, 9, 4};
  const std::string report = format_exploration_report(all);
  EXPECT_NE(report.find("recall of axes, %      1     2  mean\n"
                        "symmetry           100.0  25.0  62.5\n"),
            std::string::npos)
      << report;
  EXPECT_NE(report.find("symmetry             100.0  75.0  87.5\n"), std::string::npos) << report;
}

TEST(ExplorationReport, TellsTheDifferenceOfTheReference) {
  std::vector<Exploration> all;
  for (int scene = 0; scene < 4; ++scene) {
    all.push_back(flat(scene, ExplorationPolicy::symmetry, 0.9));
    all.push_back(flat(scene, ExplorationPolicy::random, 0.6));
  }
  const std::string report = format_exploration_report(all);
  EXPECT_NE(report.find("4 scenes"), std::string::npos);
  EXPECT_NE(report.find("+30.0 (+30.0 to +30.0)  +50.0 (+50.0 to +50.0)"), std::string::npos)
      << report;
}

TEST(ExplorationReport, LeavesOutScenesThatAPolicyDidNotFinish) {
  std::vector<Exploration> all{
      flat(0, ExplorationPolicy::symmetry, 0.9), flat(0, ExplorationPolicy::random, 0.6),
      flat(1, ExplorationPolicy::symmetry, 0.9), flat(1, ExplorationPolicy::random, 0.6)};
  all[3].steps.pop_back();
  EXPECT_NE(format_exploration_report(all).find("1 scenes"), std::string::npos);
  EXPECT_EQ(format_exploration_report({}), "no scene\n");
}

TEST(ExplorationReport, ComparesTheFixedArcWithHalfOfItsViews) {
  std::vector<Exploration> all;
  for (int scene = 0; scene < 3; ++scene) {
    all.push_back(flat(scene, ExplorationPolicy::symmetry, 0.8));
    all.push_back(flat(scene, ExplorationPolicy::fixed_arc, 0.0));
    all[all.size() - 1].steps[1].completed = 0.5;
    all[all.size() - 2].steps[1].completed = 1.0;  // after the views that count here
  }
  const std::string report = format_exploration_report(all);
  EXPECT_NE(report.find("symmetry after 1 views minus fixed-arc after 2"), std::string::npos);
  EXPECT_NE(report.find("+30.0 (+30.0 to +30.0)  +60.0 (+60.0 to +60.0)"), std::string::npos)
      << report;
}

TEST(ExplorationReport, KeepsKindsOfScenesApartAndComparesWhatAllPoliciesExplored) {
  std::vector<Exploration> all{
      flat(0, ExplorationPolicy::symmetry, 0.9), flat(0, ExplorationPolicy::random, 0.6),
      flat(1, ExplorationPolicy::symmetry, 0.9), flat(0, ExplorationPolicy::symmetry, 0.3)};
  all[3].kind = "table";
  const std::string report = format_exploration_report(all);
  EXPECT_NE(report.find("1 scenes, packed"), std::string::npos) << report;
  EXPECT_NE(report.find("1 scenes, table"), std::string::npos) << report;
}

TEST(ExplorationReportPage, HasACurveWithABandPerPolicyAndMeasure) {
  std::vector<Exploration> all{flat(0, ExplorationPolicy::symmetry, 0.9),
                               flat(0, ExplorationPolicy::random, 0.6)};
  const std::string page = format_exploration_report_page(all, "<seed> 1 & 2");
  const auto count = [&](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = page.find(part); at != std::string::npos; at = page.find(part, at + 1))
      ++found;
    return found;
  };
  EXPECT_EQ(count("<figure>"), 5U);
  EXPECT_EQ(count("<polyline class=\"curve"), 10U);
  EXPECT_EQ(count("<polygon class=\"band"), 10U);
  EXPECT_EQ(count("&lt;seed&gt; 1 &amp; 2"), 1U);
  EXPECT_EQ(count("<td>+30.0 (+30.0 to +30.0)</td>"), 1U);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
}

TEST(ExplorationReportPage, IsTheSameAgain) {
  const std::vector<Exploration> all{flat(0, ExplorationPolicy::symmetry, 0.9),
                                     flat(1, ExplorationPolicy::symmetry, 0.6)};
  EXPECT_EQ(format_exploration_report_page(all, ""), format_exploration_report_page(all, ""));
}

TEST(ExplorationsCsv, IsReadAsItWasWritten) {
  std::vector<Exploration> all{flat(3, ExplorationPolicy::oracle, 0.5),
                               flat(3, ExplorationPolicy::fixed_arc, 0.25)};
  all[1].kind = "table";
  all[0].steps[0].masks = {1, 2, 3};
  all[0].steps[0].axes = {4, 5, 6};
  all[0].steps[1].planes = {7, 8, 9};
  all[0].steps[1].grasped = true;
  all[1].steps[1].grasped = false;
  all[1].steps[1].decision_seconds = 0.125;
  const std::string csv = format_explorations_csv(all);
  const std::vector<Exploration> again = parse_explorations_csv(csv, "steps.csv");
  EXPECT_EQ(format_explorations_csv(again), csv);
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(again[1].kind, "table");
  EXPECT_EQ(again[0].steps[1].grasped, true);
}

TEST(ExplorationsCsv, RefusesOtherTables) {
  const std::string csv =
      format_explorations_csv(std::vector<Exploration>{flat(3, ExplorationPolicy::oracle, 0.5)});
  const std::string header = csv.substr(0, csv.find('\n') + 1);
  const std::string first =
      csv.substr(header.size(), csv.find('\n', header.size()) + 1 - header.size());
  EXPECT_THROW(parse_explorations_csv("", "steps.csv"), InputError);
  EXPECT_THROW(parse_explorations_csv(header, "steps.csv"), InputError);
  EXPECT_THROW(parse_explorations_csv("a,b\n" + first, "steps.csv"), InputError);
  EXPECT_THROW(parse_explorations_csv(header + "packed,1\n", "steps.csv"), InputError);
  EXPECT_THROW(parse_explorations_csv(header + "\n", "steps.csv"), InputError);
  const std::string second = csv.substr(header.size() + first.size());
  EXPECT_THROW(parse_explorations_csv(header + second, "steps.csv"), InputError);
  EXPECT_THROW(parse_explorations_csv(header + first + second + second, "steps.csv"), InputError);
  std::string no_number = header + first;
  no_number.replace(no_number.find(",0.25"), 5, ",x.25");
  EXPECT_THROW(parse_explorations_csv(no_number, "steps.csv"), InputError);
}

TEST(ExplorationReport, WritesALinePerView) {
  const std::vector<Exploration> one{flat(7, ExplorationPolicy::oracle, 0.5)};
  const std::string csv = format_explorations_csv(one);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(csv.find("packed,7,oracle,2,0,0.2500,0.5000,0,0,0,0,0,0,0,0,0,,0.0000"),
            std::string::npos)
      << csv;
}

}  // namespace
}  // namespace symscene
