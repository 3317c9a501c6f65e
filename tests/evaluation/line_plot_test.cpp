#include "evaluation/line_plot.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

ShareSeries flat_series(double share) {
  return {"a & b", 2, {share, share}, {share, share}, {share, share}, "note"};
}

TEST(ShareFigure, DrawsALineAndABandPerSeriesAndEscapesNames) {
  const std::vector<ShareSeries> series{flat_series(0.5), flat_series(0.7)};
  const std::string svg = share_figure("x < y", "views", series);
  EXPECT_NE(svg.find("<figcaption>x &lt; y</figcaption>"), std::string::npos);
  EXPECT_NE(svg.find("a &amp; b<small>note</small>"), std::string::npos);
  const std::size_t line = svg.find("<polyline class=\"curve c2\"");
  ASSERT_NE(line, std::string::npos);
  EXPECT_NE(svg.find("<polyline class=\"curve c2\"", line + 1), std::string::npos);
  EXPECT_NE(svg.find("<polygon class=\"band c2\""), std::string::npos);
}

TEST(ShareFigure, BeginsAtTenthsBelowAllShares) {
  const std::string high = share_figure("", "views", std::vector{flat_series(0.83)});
  EXPECT_NE(high.find(">80 %<"), std::string::npos);
  EXPECT_EQ(high.find(">70 %<"), std::string::npos);
  const std::string low = share_figure("", "views", std::vector{flat_series(0.0)});
  EXPECT_NE(low.find(">0 %<"), std::string::npos);
}

}  // namespace
}  // namespace symscene
