#include "symscene/evaluation/sweep.hpp"

#include <gtest/gtest.h>

#include "evaluation/sweep_settings.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

SettingCounts mask_counts(DetectionCounts detections) {
  SettingCounts counts;
  counts.detections(Metric::masks_90) = detections;
  counts.scenes = 1;
  return counts;
}

/// Precision and recall: 1 and 0.2, 0.8 and 0.4, 0.5 and 0.4, 0.6 and 0.6, 0.3 and 0.6.
Sweep five_settings() {
  Sweep sweep;
  sweep.method = "five";
  sweep.parameters = {"a"};
  sweep.settings = all_settings({{1, 2, 3, 4, 5}});
  sweep.counts = {mask_counts({2, 2, 10}), mask_counts({4, 5, 10}), mask_counts({4, 8, 10}),
                  mask_counts({6, 10, 10}), mask_counts({6, 20, 10})};
  sweep.metrics = {Metric::masks_90};
  return sweep;
}

TEST(BestSetting, HasTheGreatestFAndIsTheFirstOfEquals) {
  Sweep sweep = five_settings();
  EXPECT_EQ(best_setting(sweep, Metric::masks_90), 3U);  // F = 12 / 20
  sweep.counts[1] = sweep.counts[3];
  EXPECT_EQ(best_setting(sweep, Metric::masks_90), 1U);
  EXPECT_FALSE(best_setting(Sweep{}, Metric::masks_90).has_value());
}

TEST(PrecisionRecallCurve, IsTheUpperEnvelopeByRisingRecall) {
  const auto curve = precision_recall_curve(five_settings(), Metric::masks_90);
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_DOUBLE_EQ(curve[0].recall, 0.2);
  EXPECT_DOUBLE_EQ(curve[0].precision, 1.0);
  EXPECT_DOUBLE_EQ(curve[1].recall, 0.4);
  EXPECT_DOUBLE_EQ(curve[1].precision, 0.8);
  EXPECT_DOUBLE_EQ(curve[2].recall, 0.6);
  EXPECT_DOUBLE_EQ(curve[2].precision, 0.6);
}

TEST(Sweep, OfScenesIsTheSumOfTheirCounts) {
  Sweep total;
  total += five_settings();
  total += five_settings();
  EXPECT_EQ(total.method, "five");
  EXPECT_EQ(total.counts[1].detections(Metric::masks_90).correct, 8U);
  EXPECT_EQ(total.counts[1].scenes, 2U);
  EXPECT_DOUBLE_EQ(total.counts[1].detections(Metric::masks_90).precision(), 0.8);
  Sweep other = five_settings();
  other.settings.back().front() = 6;
  EXPECT_THROW(total += other, InputError);
}

TEST(Settings, AreEveryCombinationTheLastParameterFastest) {
  const auto settings = all_settings({{1, 2}, {3, 4}});
  ASSERT_EQ(settings.size(), 4U);
  EXPECT_EQ(settings[1], (std::vector<double>{1, 4}));
  EXPECT_EQ(settings[2], (std::vector<double>{2, 3}));
}

TEST(Settings, AreWrittenWithTheirNames) {
  Sweep sweep;
  sweep.parameters = {"a", "b"};
  sweep.settings = {{0.3, 0.005}};
  EXPECT_EQ(setting_text(sweep, 0), "a=0.3 b=0.005");
}

}  // namespace
}  // namespace symscene
