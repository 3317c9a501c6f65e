#include "symscene/evaluation/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "evaluation/paired_comparison.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

const std::string nasty = "<b>\"mug\" & co, \xC3\xA9</b>";
const ReportInfo info{nasty, "2020-01-02", "0.0", nasty};

SettingCounts masks(DetectionCounts detections) {
  SettingCounts counts;
  counts.detections(Metric::masks_90) = detections;
  counts.overlap_sum = 0.5 * static_cast<double>(detections.ground_truth);
  counts.scenes = 1;
  return counts;
}

Sweep two_settings(const std::string& method) {
  Sweep sweep;
  sweep.method = method;
  sweep.parameters = {"k"};
  sweep.settings = {{0.5}, {1.0}};
  sweep.counts = {masks({1, 4, 2}), masks({1, 1, 2})};
  sweep.metrics = {Metric::masks_90};
  return sweep;
}

ObjectOutcome outcome(const std::string& kind, Outcome type, const std::string& reason) {
  ObjectOutcome outcome;
  outcome.kind = kind;
  outcome.points = 10;
  outcome.best_overlap = type == Outcome::found ? 0.95 : 0.25;
  outcome.outcome = type;
  outcome.reason = reason;
  return outcome;
}

SceneEvaluation scene(const std::string& name) {
  SceneEvaluation scene;
  scene.name = name;
  scene.subset = "boxes";
  scene.segmentation = {two_settings("ours"), two_settings(nasty)};
  scene.segmentation.front().at_default = masks({1, 2, 2});
  scene.objects = {outcome("can", Outcome::found, ""),
                   outcome(nasty, Outcome::rejected, "overlap")};
  scene.timings = {
      {"rotational detection", 0.5}, {"reflectional segmentation", 1.0}, {"choice", 2}};
  scene.returned = 2;
  return scene;
}

Evaluation two_scenes() {
  Evaluation evaluation;
  evaluation.add(scene("first"));
  evaluation.add(scene("second, \"again\""));
  return evaluation;
}

/// The lines of RFC 4180, by field.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
      lines.back().back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      lines.back().emplace_back();
    } else if (c == '\n' && !quoted) {
      lines.push_back({""});
    } else {
      lines.back().back() += c;
    }
  }
  lines.pop_back();
  return lines;
}

/// The first mistake of a document's elements; empty if all are closed in order.
std::string first_mistake(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t i = page.find('<'); i != std::string::npos; i = page.find('<', i + 1)) {
    const std::size_t end = page.find('>', i);
    if (end == std::string::npos) return "an element without end";
    const std::string tag = page.substr(i + 1, end - i - 1);
    if (tag.starts_with("!DOCTYPE") || tag.ends_with("/")) continue;
    if (tag.find('<') != std::string::npos) return "an element in " + tag;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (!name.starts_with("/")) {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return "the end " + name;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "no end of " + open.back();
}

TEST(Evaluation, SumsScenesObjectsAndSubsets) {
  const Evaluation evaluation = two_scenes();
  EXPECT_EQ(evaluation.segmentation.at(0).counts.at(1).detections(Metric::masks_90).ground_truth,
            4U);
  EXPECT_EQ(evaluation.subsets.at("boxes").size(), 2U);
  EXPECT_EQ(evaluation.outcomes.objects, 4U);
  EXPECT_EQ(evaluation.outcomes.count(Outcome::rejected), 2U);
  EXPECT_EQ(evaluation.kinds.at("can").count(Outcome::found), 2U);
  EXPECT_DOUBLE_EQ(evaluation.outcomes.mean_overlap(), 0.6);
}

TEST(Evaluation, RefusesASceneWithOtherMethods) {
  Evaluation evaluation = two_scenes();
  SceneEvaluation other = scene("third");
  other.segmentation.pop_back();
  EXPECT_THROW(evaluation.add(other), InputError);
}

TEST(Runtimes, AreMeansByNumberOfObjects) {
  Evaluation evaluation = two_scenes();
  SceneEvaluation full = scene("full");
  full.objects.resize(11, outcome("can", Outcome::found, ""));
  full.timings.front().seconds = 4.0;
  evaluation.add(full);
  const auto classes = runtimes(evaluation);
  EXPECT_EQ(classes.at(0).scenes, 2U);
  EXPECT_DOUBLE_EQ(classes[0].rotational, 0.5);
  EXPECT_DOUBLE_EQ(classes[0].reflectional, 1.0);
  EXPECT_DOUBLE_EQ(classes[0].other, 2.0);
  EXPECT_EQ(classes.at(1).scenes, 0U);
  EXPECT_DOUBLE_EQ(classes.at(2).total(), 7.0);
}

TEST(Headline, HasTheDefaultAndTheBestOfEveryMethod) {
  const auto rows = headline(two_scenes().segmentation);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].setting, "default");
  EXPECT_DOUBLE_EQ(rows[0].f[0].value(), 0.5);
  EXPECT_EQ(rows[1].setting, "best of 2");
  EXPECT_DOUBLE_EQ(rows[1].f[0].value(), 2.0 / 3.0);
  EXPECT_FALSE(rows[1].f[1].has_value());
  EXPECT_DOUBLE_EQ(rows[1].mean_overlap, 0.5);
  EXPECT_EQ(rows[2].method, nasty);
}

TEST(ReportCsv, ReadsBackFieldByField) {
  const Evaluation evaluation = two_scenes();
  for (const std::string& csv :
       {curves_csv(evaluation), objects_csv(evaluation), scenes_csv(evaluation)}) {
    const auto lines = parse_csv(csv);
    ASSERT_GT(lines.size(), 2U);
    for (const auto& line : lines) EXPECT_EQ(line.size(), lines.front().size()) << csv;
  }
  const auto objects = parse_csv(objects_csv(evaluation));
  EXPECT_EQ(objects.size(), 5U);
  EXPECT_EQ(objects.at(4).at(0), "second, \"again\"");
  EXPECT_EQ(objects.at(4).at(3), nasty);
  EXPECT_EQ(objects.at(4).at(8), "rejected");
  // Two methods with two settings, one of them with a default; in all and in the one subset.
  EXPECT_EQ(parse_csv(curves_csv(evaluation)).size(), 11U);
}

TEST(ReportJson, ReadsBack) {
  const auto json = nlohmann::json::parse(report_json(two_scenes(), info));
  EXPECT_EQ(json.at("dataset"), nasty);
  EXPECT_EQ(json.at("scenes").size(), 2U);
  EXPECT_EQ(json.at("segmentation").at(0).at("settings").at(1).at("masks_90").at("found"), 2);
  EXPECT_DOUBLE_EQ(json.at("segmentation").at(0).at("best").at("masks_90").at("f"), 2.0 / 3.0);
  EXPECT_EQ(json.at("missed_objects").at("all").at("rejected").at("reasons").at("overlap"), 2);
  EXPECT_EQ(json.at("headline").size(), 3U);
  // No mask beside another one.
  EXPECT_FALSE(json.at("headline").at(0).at("numbers").contains("boundary_f"));
}

TEST(ReportDifference, ListsTheChangeOfEachNumber) {
  const std::string now = report_json(two_scenes(), info);
  Evaluation better;
  SceneEvaluation improved = scene("first");
  improved.segmentation.front().at_default = masks({2, 2, 2});
  better.add(improved);
  const std::string text = report_difference(report_json(better, info), now, "then.json");
  EXPECT_NE(text.find("ours default"), std::string::npos);
  EXPECT_NE(text.find("+50.0"), std::string::npos) << text;
  EXPECT_THROW(report_difference(now, "{}", "then.json"), InputError);
  EXPECT_THROW(report_difference(now, "no JSON", "then.json"), InputError);
}

TEST(ReportDifference, RefusesAReportOfAnotherVersionNamingIt) {
  const std::string now = report_json(two_scenes(), info);
  auto earlier = nlohmann::json::parse(now);
  earlier["version"] = 1;
  try {
    report_difference(now, earlier.dump(), "then.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "then.json");
    EXPECT_NE(error.found().find("version 1"), std::string::npos) << error.what();
  }
}

TEST(ReportPage, IsWellFormedAndEscapesNames) {
  const std::string page = report_page(two_scenes(), info);
  EXPECT_EQ(first_mistake(page), "");
  EXPECT_EQ(page.find("<b>\"mug\""), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&quot;mug&quot; &amp; co"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
  EXPECT_NE(page.find("class=\"star"), std::string::npos);
}

TEST(ReportPage, WithoutScenesIsWellFormed) {
  EXPECT_EQ(first_mistake(report_page(Evaluation{}, info)), "");
  EXPECT_FALSE(missed_object_text(Evaluation{}).empty());
}

TEST(ReportPage, HasNoSectionWithoutContent) {
  Evaluation evaluation = two_scenes();
  const std::string page = report_page(evaluation, info);
  EXPECT_EQ(page.find("<h2>Symmetries"), std::string::npos) << "the ground truth has none";
  EXPECT_EQ(page.find("<h2>Worst failures"), std::string::npos) << "there is no picture";
  EXPECT_NE(page.find("<h2>Kinds of objects"), std::string::npos);
  EXPECT_EQ(page.find(">axes<"), std::string::npos) << "a column of dashes";
  SceneEvaluation one_kind = scene("third");
  one_kind.objects = {outcome("can", Outcome::found, "")};
  Evaluation other;
  other.add(one_kind);
  EXPECT_EQ(report_page(other, info).find("<h2>Kinds of objects"), std::string::npos);
}

TEST(ReportPage, ShowsTheMissedObjectsThatLeastWasFoundOf) {
  SceneEvaluation failed = scene("first");
  ObjectOutcome& missed = failed.objects.back();
  missed.picture = "PNG";
  missed.instead = "object 3";
  Evaluation evaluation;
  for (int k = 0; k < 12; ++k) {
    missed.best_overlap = 0.05 * k;
    evaluation.add(failed);
  }
  const std::string page = report_page(evaluation, info);
  EXPECT_EQ(first_mistake(page), "");
  EXPECT_NE(page.find("data:image/png;base64,UE5H"), std::string::npos);
  EXPECT_NE(page.find("best IoU 0.45. Instead: object 3."), std::string::npos);
  EXPECT_EQ(page.find("best IoU 0.50"), std::string::npos) << "ten of twelve are shown";
}

TEST(Evaluation, CountsNumberedLabelsAsOneKind) {
  SceneEvaluation labeled = scene("first");
  labeled.objects = {outcome("object 1", Outcome::found, ""),
                     outcome("object 15", Outcome::found, ""),
                     outcome("029_plate", Outcome::found, ""), outcome("7", Outcome::found, "")};
  Evaluation evaluation;
  evaluation.add(labeled);
  EXPECT_EQ(evaluation.kinds.size(), 3U);
  EXPECT_EQ(evaluation.kinds.at("object").objects, 2U);
}

/// Scenes in which "ours" finds `ours` and the other method `other` of two objects.
Evaluation compared(const std::vector<std::pair<std::size_t, std::size_t>>& found) {
  Evaluation evaluation;
  for (const auto& [ours, other] : found) {
    SceneEvaluation each = scene("s");
    each.segmentation.front().at_default = masks({ours, 2, 2});
    each.segmentation.back().counts = {masks({other, 2, 2}), masks({0, 2, 2})};
    evaluation.add(each);
  }
  return evaluation;
}

TEST(MethodDifferences, HaveAnIntervalAroundTheDifference) {
  const auto [method, setting, f, difference, low, high] =
      paired_differences(compared({{2, 1}, {1, 1}, {2, 2}, {2, 0}})).at(0);
  EXPECT_EQ(method, nasty);
  EXPECT_EQ(setting, "best: k=0.5");
  EXPECT_DOUBLE_EQ(f, 0.5);
  EXPECT_DOUBLE_EQ(difference, 7.0 / 8.0 - 0.5);
  EXPECT_LT(low, difference);
  EXPECT_GT(high, difference);
}

TEST(MethodDifferences, OfTheSameResultsAreZeroWhateverTheScenes) {
  const MethodDifference same = paired_differences(compared({{2, 2}, {0, 0}, {1, 1}})).at(0);
  EXPECT_EQ(same.difference, 0.0);
  EXPECT_EQ(same.low, 0.0);
  EXPECT_EQ(same.high, 0.0);
}

TEST(MethodDifferences, NeedTwoScenes) {
  EXPECT_TRUE(paired_differences(compared({{2, 1}})).empty());
}

TEST(HeadlineText, AlignsItsColumns) {
  const std::string text = headline_text({two_settings("ours")});
  EXPECT_NE(text.find("\nours    best of 2"), std::string::npos) << text;
}

TEST(HeadlineText, HasADashForTheBoundaryFWithoutBoundaries) {
  const auto dashes = [](const Sweep& sweep) {
    const std::string text = headline_text({sweep}), dash = "–";
    int count = 0;
    for (std::size_t at = text.find(dash); at != std::string::npos; at = text.find(dash, at + 1))
      ++count;
    return count;
  };
  const Sweep without = two_settings("ours");
  Sweep with = without;
  for (SettingCounts& counts : with.counts) counts.points.with_boundary = 1.0;
  EXPECT_EQ(dashes(without), dashes(with) + 1);
}

TEST(Report, HasNoScoreWhereThereWasNothingToFind) {
  Sweep sweep = two_settings("ours");
  sweep.counts = {masks({0, 3, 0}), masks({0, 0, 0})};
  sweep.at_default = masks({0, 0, 0});
  for (const HeadlineRow& row : headline({sweep}))
    EXPECT_FALSE(row.f[static_cast<std::size_t>(Metric::masks_90)]);
  Evaluation evaluation;
  SceneEvaluation bare = scene("bare");
  bare.segmentation = {sweep};
  bare.objects.clear();
  evaluation.add(bare);
  const nlohmann::json report = nlohmann::json::parse(report_json(evaluation, info));
  EXPECT_NE(report.dump().find(R"("f":null)"), std::string::npos);
  EXPECT_EQ(report.dump().find(R"("f":1.0)"), std::string::npos);
  for (const std::vector<std::string>& line : parse_csv(curves_csv(evaluation))) {
    if (line.at(0) != "ours") continue;
    EXPECT_NE(line.back(), "1.000000");
  }
}

TEST(MissedObjectText, HasNoTableOfReasonsIfNoneIsMissed) {
  EXPECT_NE(missed_object_text(two_scenes()).find("missed because"), std::string::npos);
  Evaluation all_found;
  SceneEvaluation first = scene("first");
  first.objects = {outcome("can", Outcome::found, "")};
  all_found.add(first);
  EXPECT_EQ(missed_object_text(all_found).find("missed because"), std::string::npos);
}

}  // namespace
}  // namespace symscene
