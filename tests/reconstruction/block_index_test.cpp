#include "reconstruction/block_index.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>
#include <random>

namespace symscene {
namespace {

TEST(BlockIndex, FindsOnlyInsertedBlocks) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> near(-40, 40);
  BlockIndex index;
  std::map<std::array<int, 3>, std::int32_t> slots;
  for (int k = 0; k < 5000; ++k) {
    const Eigen::Vector3i block(near(random), near(random), near(random));
    const auto [place, is_new] = slots.try_emplace({block.x(), block.y(), block.z()},
                                                   static_cast<std::int32_t>(slots.size()));
    EXPECT_EQ(index.insert(block), place->second);
  }
  EXPECT_EQ(index.size(), slots.size());
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Vector3i block(near(random), near(random), near(random));
    const auto known = slots.find({block.x(), block.y(), block.z()});
    EXPECT_EQ(index.find(block), known == slots.end() ? BlockIndex::none : known->second);
  }
  for (const auto& [block, slot] : slots) {
    EXPECT_EQ(index.blocks()[static_cast<std::size_t>(slot)],
              Eigen::Vector3i(block[0], block[1], block[2]));
  }
}

TEST(BlockIndex, HoldsTheOutermostBlocksOfItsReach) {
  BlockIndex index;
  for (const int x : {-BlockIndex::reach, BlockIndex::reach - 1}) {
    for (const int z : {-BlockIndex::reach, BlockIndex::reach - 1}) {
      const Eigen::Vector3i block(x, 0, z);
      ASSERT_TRUE(BlockIndex::in_reach(block));
      EXPECT_EQ(index.find(block), BlockIndex::none);
      EXPECT_EQ(index.find(block), BlockIndex::none);
      const std::int32_t slot = index.insert(block);
      EXPECT_EQ(index.find(block), slot);
    }
  }
  EXPECT_EQ(index.size(), 4U);
}

TEST(BlockIndex, FindsNothingBeyondItsReach) {
  BlockIndex index;
  index.insert({-BlockIndex::reach, 0, 0});
  index.insert({0, 0, 0});
  for (const int far : {-BlockIndex::reach - 1, BlockIndex::reach, 1 << 20, -(1 << 20),
                        std::numeric_limits<int>::min()}) {
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Vector3i block = Eigen::Vector3i::Zero();
      block[axis] = far;
      EXPECT_FALSE(BlockIndex::in_reach(block));
      EXPECT_EQ(index.find(block), BlockIndex::none) << far;
    }
  }
}

TEST(BlockIndex, GrowsWithTheStoredBlocks) {
  BlockIndex index;
  const std::size_t empty = index.bytes();
  for (int k = 0; k < 32; ++k) index.insert({k, 0, 0});
  EXPECT_LT(index.bytes(), empty + (std::size_t{1} << 18));
}

}  // namespace
}  // namespace symscene
