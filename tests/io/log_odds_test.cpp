#include "io/octomap_log_odds.hpp"

#include <limits>

#ifdef SYMSCENE_WITH_OCTOMAP
#include <octomap/OcTree.h>
#endif

#include "core/octree.hpp"
#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

const std::string first = "# Octomap OcTree file\n";

void expect_same_leaves(const LogOddsMap& a, const LogOddsMap& b) {
  EXPECT_EQ(a.resolution, b.resolution);
  ASSERT_EQ(a.leaves.size(), b.leaves.size());
  for (std::size_t i = 0; i < a.leaves.size(); ++i) {
    ASSERT_EQ(a.leaves[i].key, b.leaves[i].key) << "leaf " << i;
    ASSERT_EQ(a.leaves[i].level, b.leaves[i].level) << "leaf " << i;
    ASSERT_EQ(a.leaves[i].log_odds, b.leaves[i].log_odds) << "leaf " << i;
  }
}

/// Splits cubes at random, depth first; two of three unsplit cubes are leaves.
void grow(std::mt19937& random, const LogOddsLeaf& cube, LogOddsMap& map) {
  if (cube.level > 0 && (cube.level == 16 || (random() % 8 < 3 && map.leaves.size() < 3000))) {
    for (unsigned child = 0; child < 8; ++child) {
      LogOddsLeaf part{cube.key, static_cast<std::uint8_t>(cube.level - 1), 0.0F};
      for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned half = ((child >> axis) & 1U) << part.level;
        part.key[axis] = static_cast<std::uint16_t>(part.key[axis] + half);
      }
      grow(random, part, map);
    }
  } else if (random() % 3 != 0) {
    const float log_odds = static_cast<float>(random() % 110) * 0.05F - 2.0F;
    map.leaves.push_back({cube.key, cube.level, log_odds});
  }
}

LogOddsMap random_log_odds(unsigned seed) {
  std::mt19937 random(seed);
  LogOddsMap map;
  map.resolution = 0.001 * (1 + seed);
  grow(random, {{}, 16, 0.0F}, map);
  return map;
}

TEST(LogOddsFile, LeavesAreReadInDepthFirstOrder) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const LogOddsMap map = random_log_odds(seed);
    expect_same_leaves(parse_log_odds(format_log_odds(map), "x"), map);
  }
}

TEST(LogOddsFile, TheOrderOfTheLeavesDoesNotChangeTheFile) {
  LogOddsMap map = random_log_odds(3);
  const std::string bytes = format_log_odds(map);
  std::mt19937 random(1);
  std::shuffle(map.leaves.begin(), map.leaves.end(), random);
  EXPECT_EQ(format_log_odds(map), bytes);
}

TEST(LogOddsFile, AnEmptyMapIsReadBackEmpty) {
  LogOddsMap map;
  map.resolution = 0.02;
  const LogOddsMap again = parse_log_odds(format_log_odds(map), "x");
  EXPECT_TRUE(again.leaves.empty());
  EXPECT_EQ(again.resolution, 0.02);
}

TEST(LogOddsFile, DamagedFilesAreReadOrRefused) {
  const std::string bytes = format_log_odds(random_log_odds(5));
  EXPECT_EQ(damage(
                bytes, [](std::string_view b) { parse_log_odds(b, "x"); }, 500, 1000),
            0);
}

TEST(LogOddsFile, RefusalsNameFileExpectedAndFound) {
  EXPECT_EQ(refusal([] { parse_log_odds("# Octomap OcTree binary file\n", "a.bt"); }),
            "a.bt: expected an OctoMap file (.ot), found \"# Octomap OcTree binary file\"");
  const std::string header = first + "id OcTree\nsize 1\nres 1\ndata\n";
  EXPECT_EQ(refusal([&] { parse_log_odds(header + std::string("\0\0\xC0\x7F\0", 5), "a.ot"); }),
            "a.ot: expected finite log-odds, found nan");
  std::string deep = header;
  for (int level = 0; level < 1000; ++level) deep += std::string("\0\0\0\0\x01", 5);
  EXPECT_EQ(refusal([&] { parse_log_odds(deep, "a.ot"); }),
            "a.ot: expected a tree of depth 16, found a voxel with children");
}

TEST(LogOddsFile, InvalidMapsAreNotWritten) {
  LogOddsMap map;
  map.leaves = {{{8, 8, 8}, 3, 0.5F}, {{9, 10, 15}, 0, 0.5F}};
  EXPECT_THROW(format_log_odds(map), InputError);
  map.leaves = {{{4, 8, 8}, 3, 0.5F}};
  EXPECT_THROW(format_log_odds(map), InputError);
  map.leaves = {{{8, 8, 8}, 3, std::numeric_limits<float>::quiet_NaN()}};
  EXPECT_THROW(format_log_odds(map), InputError);
}

TEST(LogOddsMap, LabelsJoinCubesOfEqualState) {
  LogOddsMap map;
  for (unsigned child = 0; child < 8; ++child) {
    map.leaves.push_back({octree_key(64 + child), 0, child % 2 == 0 ? -0.4F : -0.8F});
  }
  map.leaves.push_back({octree_key(72), 0, 0.0F});
  const OccupancyMap states = labels(map);
  ASSERT_EQ(states.leaves.size(), 2U);
  EXPECT_EQ(states.leaves[0].level, 1);
  EXPECT_EQ(states.leaves[0].state, VoxelState::free);
  EXPECT_EQ(states.leaves[1].state, VoxelState::occupied);
}

#ifdef SYMSCENE_WITH_OCTOMAP
TEST(LogOddsFile, OctoMapReadsTheSameLeavesAndGreatestChildren) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const LogOddsMap map = random_log_odds(seed);
    std::istringstream stream(format_log_odds(map));
    const std::unique_ptr<octomap::AbstractOcTree> tree(octomap::AbstractOcTree::read(stream));
    auto* octree = dynamic_cast<octomap::OcTree*>(tree.get());
    ASSERT_NE(octree, nullptr);
    ASSERT_EQ(octree->getNumLeafNodes(), map.leaves.size());
    std::size_t i = 0;
    for (auto leaf = octree->begin_leafs(); leaf != octree->end_leafs(); ++leaf, ++i) {
      ASSERT_EQ(leaf->getLogOdds(), map.leaves[i].log_odds);
      ASSERT_EQ(16 - static_cast<int>(leaf.getDepth()), map.leaves[i].level);
      const octomap::OcTreeKey key = leaf.getIndexKey();
      ASSERT_EQ((OctreeKey{key[0], key[1], key[2]}), map.leaves[i].key);
    }
    const float root = octree->getRoot()->getLogOdds();
    octree->updateInnerOccupancy();
    ASSERT_EQ(octree->getRoot()->getLogOdds(), root);
  }
}

TEST(LogOddsFile, FilesOfOctoMapAreRead) {
  octomap::OcTree tree(0.05);
  octomap::Pointcloud points;
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&] { return static_cast<float>(random() % 1000) * 0.002F; };
    points.push_back(coordinate(), coordinate(), coordinate());
  }
  tree.insertPointCloud(points, {-1.0F, 0.2F, 0.3F});
  std::ostringstream stream;
  tree.write(stream);
  const LogOddsMap map = parse_log_odds(stream.str(), "x");
  EXPECT_EQ(map.leaves.size(), tree.getNumLeafNodes());
  std::ostringstream binary;
  tree.toMaxLikelihood();
  tree.prune();
  tree.writeBinaryConst(binary);
  EXPECT_EQ(labels(map).leaves.size(), tree.getNumLeafNodes());
}
#endif

}  // namespace
}  // namespace symscene
