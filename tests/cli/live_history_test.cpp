#include "live_history.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace symscene::app {
namespace {

using std::chrono::milliseconds;

std::shared_ptr<const LiveReport> numbered(std::size_t number, Index points = 1) {
  LiveReport report;
  report.number = number;
  report.update.result.cloud.positions.setZero(static_cast<Eigen::Index>(points), 3);
  return std::make_shared<const LiveReport>(std::move(report));
}

TEST(LiveHistory, KeepsTheLastUpdatesAndFindsThemByNumber) {
  LiveHistory history;
  EXPECT_EQ(history.find(1), nullptr);
  for (std::size_t k = 1; k <= LiveHistory::max_updates + 5; ++k) history.add(numbered(k));
  EXPECT_EQ(history.find(5), nullptr);
  ASSERT_NE(history.find(6), nullptr);
  EXPECT_EQ(history.find(6)->number, 6U);
  EXPECT_EQ(history.find(LiveHistory::max_updates + 6), nullptr);
  EXPECT_EQ(history.wait(0, false, milliseconds(0)).oldest, 6U);
}

TEST(LiveHistory, KeepsNoMorePointsThanItsBoundButAlwaysTheNewest) {
  LiveHistory history;
  constexpr auto half = static_cast<Index>(LiveHistory::max_points / 2);
  history.add(numbered(1, half));
  history.add(numbered(2, half));
  EXPECT_NE(history.find(1), nullptr);
  history.add(numbered(3, 2 * half + 1));
  EXPECT_EQ(history.find(2), nullptr);
  EXPECT_NE(history.find(3), nullptr);
}

TEST(LiveHistory, AReaderWaitsForWhatIsNewToIt) {
  LiveHistory history;
  history.add(numbered(1));
  EXPECT_EQ(history.wait(1, false, milliseconds(1)).newest, nullptr);
  std::thread writer([&] {
    std::this_thread::sleep_for(milliseconds(20));
    history.add(numbered(2));
  });
  const LiveHistory::News news = history.wait(1, false, milliseconds(60000));
  writer.join();
  ASSERT_NE(news.newest, nullptr);
  EXPECT_EQ(news.newest->number, 2U);
  EXPECT_FALSE(news.is_finished);
}

TEST(LiveHistory, TheEndWakesReadersThatDoNotKnowIt) {
  LiveHistory history;
  std::thread writer([&] { history.finish(); });
  EXPECT_TRUE(history.wait(0, false, milliseconds(60000)).is_finished);
  writer.join();
  EXPECT_FALSE(history.wait(0, true, milliseconds(1)).is_closed);
  history.close();
  EXPECT_TRUE(history.wait(0, true, milliseconds(60000)).is_closed);
}

}  // namespace
}  // namespace symscene::app
