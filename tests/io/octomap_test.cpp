#include "symscene/io/octomap.hpp"

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

bool same_leaf(const OccupancyLeaf& a, const OccupancyLeaf& b) {
  return a.key == b.key && a.level == b.level && a.state == b.state;
}

void expect_same_leaves(const OccupancyMap& a, const OccupancyMap& b) {
  EXPECT_EQ(a.resolution, b.resolution);
  ASSERT_EQ(a.leaves.size(), b.leaves.size());
  for (std::size_t i = 0; i < a.leaves.size(); ++i) {
    ASSERT_TRUE(same_leaf(a.leaves[i], b.leaves[i])) << "leaf " << i;
  }
}

/// Splits cubes at random, depth first; unsplit cubes are free, occupied or never seen.
void grow(std::mt19937& random, const OccupancyLeaf& cube, OccupancyMap& map) {
  const bool on_a_path = random() % 8 < 3;
  if (cube.level > 0 && (cube.level == 16 || (on_a_path && map.leaves.size() < 3000))) {
    for (unsigned child = 0; child < 8; ++child) {
      OccupancyLeaf part{cube.key, static_cast<std::uint8_t>(cube.level - 1), {}};
      for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned half = ((child >> axis) & 1U) << part.level;
        part.key[axis] = static_cast<std::uint16_t>(part.key[axis] + half);
      }
      grow(random, part, map);
    }
  } else if (const auto state = random() % 3; state != 0) {
    map.leaves.push_back({cube.key, cube.level, static_cast<VoxelState>(state)});
  }
}

OccupancyMap random_map(unsigned seed) {
  std::mt19937 random(seed);
  OccupancyMap map;
  map.resolution = 0.001 * (1 + seed);
  grow(random, {{}, 16, {}}, map);
  return map;
}

TEST(Octomap, LeavesAreReadInDepthFirstOrder) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const OccupancyMap map = random_map(seed);
    expect_same_leaves(parse_octomap(format_octomap(map), "x"), map);
  }
}

TEST(Octomap, TheOrderOfTheLeavesDoesNotChangeTheFile) {
  OccupancyMap map = random_map(3);
  const std::string bytes = format_octomap(map);
  std::mt19937 random(1);
  std::shuffle(map.leaves.begin(), map.leaves.end(), random);
  EXPECT_EQ(format_octomap(map), bytes);
}

TEST(Octomap, TheCornersOfTheTreeAreKept) {
  OccupancyMap map;
  map.leaves = {{{0, 0, 0}, 0, VoxelState::occupied},
                {{32768, 32768, 32768}, 0, VoxelState::free},
                {{65535, 65535, 65535}, 0, VoxelState::occupied}};
  expect_same_leaves(parse_octomap(format_octomap(map), "x"), map);
}

TEST(Octomap, ALeafThatIsTheWholeTreeIsWrittenAsItsChildren) {
  OccupancyMap map;
  map.leaves = {{{}, 16, VoxelState::free}};
  const OccupancyMap again = parse_octomap(format_octomap(map), "x");
  ASSERT_EQ(again.leaves.size(), 8U);
  for (const OccupancyLeaf& leaf : again.leaves) EXPECT_EQ(leaf.level, 15);
}

TEST(Octomap, AnEmptyMapIsReadBackEmpty) {
  OccupancyMap map;
  map.resolution = 0.02;
  map.leaves = {{{}, 16, VoxelState::never_seen}};
  const OccupancyMap again = parse_octomap(format_octomap(map), "x");
  EXPECT_TRUE(again.leaves.empty());
  EXPECT_EQ(again.resolution, 0.02);
}

TEST(Octomap, BitPairsMeanFreeOccupiedAndInner) {
  // The root's children 0 to 3: never seen, free, occupied, inner; of the inner one, 7 is occupied.
  const std::string file = std::string("# Octomap OcTree binary file\nid OcTree\nsize 5\n") +
                           "res 0.5\ndata\n" + std::string("\xE4\x00\x00\x80", 4);
  const OccupancyMap map = parse_octomap(file, "x");
  ASSERT_EQ(map.leaves.size(), 3U);
  EXPECT_TRUE(same_leaf(map.leaves[0], {{32768, 0, 0}, 15, VoxelState::free}));
  EXPECT_TRUE(same_leaf(map.leaves[1], {{0, 32768, 0}, 15, VoxelState::occupied}));
  EXPECT_TRUE(same_leaf(map.leaves[2], {{49152, 49152, 16384}, 14, VoxelState::occupied}));
}

TEST(Octomap, LeavesThatOverlapAreRefused) {
  OccupancyMap map;
  map.leaves = {{{8, 8, 8}, 3, VoxelState::free}, {{9, 10, 15}, 0, VoxelState::free}};
  EXPECT_EQ(refusal([&] { format_octomap(map); }),
            "occupancy map to write: expected leaves that do not overlap, found two that do");
  std::swap(map.leaves[0], map.leaves[1]);
  EXPECT_THROW(format_octomap(map), InputError);
  map.leaves[0] = map.leaves[1];
  EXPECT_THROW(format_octomap(map), InputError);
}

TEST(Octomap, MisalignedLeavesAreRefused) {
  OccupancyMap map;
  map.leaves = {{{4, 8, 8}, 3, VoxelState::free}};
  EXPECT_THROW(format_octomap(map), InputError);
  map.leaves = {{{0, 0, 0}, 17, VoxelState::free}};
  EXPECT_THROW(format_octomap(map), InputError);
  map.leaves.clear();
  map.resolution = 0.0;
  EXPECT_THROW(format_octomap(map), InputError);
}

TEST(Octomap, ATreeDeeperThanSixteenIsRefused) {
  std::string file = "# Octomap OcTree binary file\nid OcTree\nsize 18\nres 0.005\ndata\n";
  for (int level = 0; level < 100000; ++level) file += std::string("\x03\x00", 2);
  EXPECT_EQ(refusal([&] { parse_octomap(file, "a.bt"); }),
            "a.bt: expected a tree of depth 16, found a voxel with children");
}

TEST(Octomap, AHugeSizeInTheHeaderTakesNoMemory) {
  const std::string file =
      "# Octomap OcTree binary file\nid OcTree\nsize 18446744073709551615\nres 1\ndata\n\x01";
  EXPECT_EQ(refusal([&] { parse_octomap(file + std::string(1, '\0'), "a.bt"); }),
            "a.bt: expected 18446744073709551615 nodes, as its header declares, found 2");
}

TEST(Octomap, RefusalsNameFileExpectedAndFound) {
  EXPECT_EQ(refusal([] { parse_octomap("# Octomap OcTree file\n", "a.ot"); }),
            "a.ot: expected an OctoMap binary file (.bt), found \"# Octomap OcTree file\"");
  const std::string first = "# Octomap OcTree binary file\n";
  EXPECT_EQ(refusal([&] { parse_octomap(first + "id ColorOcTree\ndata\n", "a.bt"); }),
            "a.bt: expected id OcTree, found \"id ColorOcTree\"");
  EXPECT_EQ(refusal([&] { parse_octomap(first + "id OcTree\nsize 1\nres -1\ndata\n", "a.bt"); }),
            "a.bt: expected a positive resolution after res, found -1");
  EXPECT_EQ(refusal([&] { parse_octomap(first + "size 1\nres 1\ndata\n", "a.bt"); }),
            "a.bt: expected a line id OcTree, found none");
  OccupancyMap map;
  map.leaves = {{{32768, 32768, 32768}, 0, VoxelState::free}};
  EXPECT_EQ(refusal([&] { parse_octomap(format_octomap(map) + "abc", "a.bt"); }),
            "a.bt: expected the end of the file, found 3 bytes more");
}

TEST(Octomap, DamagedFilesAreReadOrRefused) {
  const std::string bytes = format_octomap(random_map(5));
  EXPECT_EQ(damage(
                bytes, [](std::string_view b) { parse_octomap(b, "x"); }, 500, 1000),
            0);
}

TEST(Octomap, ReadingAndWritingTheSampleSceneGivesTheSameBytes) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "skipped: no data";
  const std::string bytes = read_text(*data / "ctd_sample/occupancy.bt");
  const OccupancyMap map = parse_octomap(bytes, "x");
  EXPECT_EQ(map.leaves.size(), 1704753U);
  const auto tree = [](const std::string& file) { return file.substr(file.find("\ndata\n")); };
  EXPECT_TRUE(tree(format_octomap(map)) == tree(bytes));
}

}  // namespace
}  // namespace symscene
