#include "core/process_pool.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <numeric>
#include <stdexcept>

namespace symscene {
namespace {

std::map<std::size_t, ItemOutcome> outcomes(std::size_t processes, std::size_t items,
                                            const ProcessPool::Work& work,
                                            std::optional<std::chrono::milliseconds> limit = {}) {
  std::vector<std::size_t> numbers(items);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::map<std::size_t, ItemOutcome> result;
  ProcessPool pool(processes, work, limit);
  pool.run(numbers, [&](const ItemOutcome& outcome) {
    EXPECT_EQ(result.count(outcome.item), 0U);
    result[outcome.item] = outcome;
  });
  EXPECT_EQ(result.size(), items);
  return result;
}

TEST(ProcessPool, DoesEveryItemWhateverTheNumberOfProcesses) {
  for (const std::size_t processes : {1U, 2U, 5U}) {
    for (const auto& [item, outcome] :
         outcomes(processes, 12, [](std::size_t i) { return std::to_string(i * i); })) {
      EXPECT_TRUE(outcome.done);
      EXPECT_EQ(outcome.text, std::to_string(item * item));
    }
  }
}

TEST(ProcessPool, DoesNothingWithoutItemsOrProcesses) {
  EXPECT_TRUE(outcomes(2, 0, [](std::size_t) { return ""; }).empty());
  EXPECT_FALSE(outcomes(0, 1, [](std::size_t) { return ""; }).at(0).done);
}

TEST(ProcessPool, ContinuesAfterAFailedItemOrKilledProcess) {
  const auto all = outcomes(2, 6, [](std::size_t i) -> std::string {
    if (i == 1) throw std::runtime_error("the table is bare");
    if (i == 2) raise(SIGKILL);
    if (i == 3) _exit(7);
    return "well";
  });
  EXPECT_EQ(all.at(1).text, "the table is bare");
  EXPECT_NE(all.at(2).text.find("signal 9"), std::string::npos) << all.at(2).text;
  EXPECT_NE(all.at(3).text.find("code 7"), std::string::npos) << all.at(3).text;
  for (const auto& [item, outcome] : all) EXPECT_EQ(outcome.done, item < 1 || item > 3) << item;
}

TEST(ProcessPool, OutlivesItsWorkers) {
  // The parent of an item's process is the worker.
  const auto some = outcomes(2, 6, [](std::size_t i) -> std::string {
    if (i == 0) {
      kill(getppid(), SIGKILL);
      pause();
    }
    return "well";
  });
  for (const auto& [item, outcome] : some) EXPECT_EQ(outcome.done, item != 0) << outcome.text;
  for (const auto& [item, outcome] : outcomes(1, 3, [](std::size_t) -> std::string {
         kill(getppid(), SIGKILL);
         pause();
         return "";
       })) {
    EXPECT_FALSE(outcome.done);
  }
}

TEST(ProcessPool, GivesUpItemsWhoseProcessesAreStopped) {
  const auto all = outcomes(
      3, 6,
      [](std::size_t i) -> std::string {
        if (i == 0) raise(SIGSTOP);
        if (i == 1) kill(getppid(), SIGSTOP), pause();
        return "well";
      },
      std::chrono::milliseconds(300));
  for (const auto& [item, outcome] : all) EXPECT_EQ(outcome.done, item > 1) << outcome.text;
  EXPECT_NE(all.at(0).text.find("0.3 s"), std::string::npos) << all.at(0).text;
}

}  // namespace
}  // namespace symscene
