#include "proposals/proposal_context.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include "index_range.hpp"

namespace symscene {
namespace {

std::vector<ProposalContext> contexts_of(const std::vector<PointIndices>& sets,
                                         const std::vector<double>& estimates) {
  std::vector<const PointIndices*> pointers;
  for (const PointIndices& set : sets) pointers.push_back(&set);
  return proposal_contexts(SharedCounts(pointers), estimates);
}

TEST(SharedCounts, AreCountedForEveryPair) {
  const PointIndices a = testing::index_range(0, 60), b = testing::index_range(60, 100),
                     c = testing::index_range(50, 80), none;
  const SharedCounts shared(std::array{&a, &b, &c, &none});
  EXPECT_EQ(shared.count(), 4U);
  EXPECT_EQ(shared.size(2), 30.0);
  EXPECT_EQ(shared.shared(0, 0), 60.0);
  EXPECT_EQ(shared.shared(0, 1), 0.0);
  EXPECT_EQ(shared.shared(0, 2), 10.0);
  EXPECT_EQ(shared.shared(2, 1), 20.0);
  EXPECT_EQ(shared.shared(3, 0), 0.0);
  EXPECT_TRUE(shared.are_disjoint(0, 1));
  EXPECT_FALSE(shared.are_disjoint(0, 2));
  EXPECT_TRUE(shared.conflict(0, 2));
  EXPECT_FALSE(shared.conflict(0, 1));
  EXPECT_FALSE(shared.contains(0, 2));
}

TEST(ProposalContext, OfAWholeItsPartsAndAConflict) {
  // A whole, two parts that split it, and a proposal that conflicts with both.
  const auto contexts = contexts_of({testing::index_range(0, 100), testing::index_range(0, 60),
                                     testing::index_range(60, 100), testing::index_range(50, 80)},
                                    {0.5, 0.8, 0.6, 0.3});
  const ProposalContext& whole = contexts[0];
  EXPECT_EQ(whole.estimate, 0.5);
  EXPECT_EQ(whole.whole, 0.0);
  EXPECT_EQ(whole.whole_share, 0.0);
  EXPECT_EQ(whole.part, 0.8);
  EXPECT_EQ(whole.rival, 0.0);
  EXPECT_EQ(whole.rest, 0.0);
  EXPECT_EQ(whole.split, 0.6);
  EXPECT_DOUBLE_EQ(whole.covered, 1.0);                          // the third shares too much
  EXPECT_DOUBLE_EQ(whole.covered_score, 0.8 * 0.6 + 0.6 * 0.4);  // estimate times share
  EXPECT_EQ(whole.pieces, 2.0);
  EXPECT_EQ(whole.wholes, 0.0);
  EXPECT_DOUBLE_EQ(whole.parts, std::log(4.0));
  const ProposalContext& part = contexts[1];
  EXPECT_EQ(part.whole, 0.5);
  EXPECT_DOUBLE_EQ(part.whole_share, 0.6);
  EXPECT_EQ(part.rest, 0.6);
  EXPECT_EQ(part.rival, 0.3);
  EXPECT_EQ(part.part, 0.0);
  EXPECT_EQ(part.split, 0.0);
  EXPECT_EQ(part.covered, 0.0);
  EXPECT_DOUBLE_EQ(part.wholes, std::log(2.0));
  EXPECT_EQ(contexts[3].rival, 0.8);
}

TEST(ProposalContext, OfNearlyEqualOrDisjointProposalsIsNone) {
  const auto contexts = contexts_of(
      {testing::index_range(0, 100), testing::index_range(0, 99), testing::index_range(200, 300)},
      {0.9, 0.8, 0.7});
  for (const ProposalContext& context : contexts) {
    EXPECT_EQ(context.whole, 0.0);
    EXPECT_EQ(context.part, 0.0);
    EXPECT_EQ(context.rival, 0.0);
  }
}

TEST(ProposalContext, OfNoProposals) { EXPECT_TRUE(contexts_of({}, {}).empty()); }

}  // namespace
}  // namespace symscene
