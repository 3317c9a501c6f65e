#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

namespace symscene {

/// Log-odds in steps of 0.05.
using LogOdds = std::int8_t;
constexpr double log_odds_step = 0.05;
constexpr LogOdds unseen = -128;

/// How evidence changes log-odds. [steps]
struct LogOddsModel {
  int hit = 17;
  int miss = -8;
  int min = -40;
  int max = 70;

  LogOdds looked_through(LogOdds value) const {
    const int next = (value == unseen ? 0 : value) + miss;
    return static_cast<LogOdds>(next < min ? min : next > max ? max : next);
  }
};

/// Voxels are stored in blocks of 8³ and blocks in bricks of 8³, both in depth-first (Morton)
/// order, so that a cube of the octree is a contiguous range.
constexpr int block_level = 3;
constexpr int brick_level = 6;
constexpr std::size_t block_voxels = 512;
constexpr std::size_t brick_blocks = 512;
constexpr std::size_t blocks_of(int level) { return std::size_t{1} << (3 * (level - block_level)); }

/// The log-odds of 64³ voxels. A uniform block or brick is stored as one value.
class OccupancyBrick {
 public:
  bool is_uniform() const { return cells_.empty(); }
  bool is_uniform(std::size_t block) const { return is_uniform() || cells_[block] < 0; }
  /// The value of a uniform brick or of a uniform block.
  LogOdds value() const { return uniform_; }
  LogOdds value(std::size_t block) const {
    return is_uniform() ? uniform_ : decoded(cells_[block]);
  }
  const LogOdds* voxels(std::size_t block) const {
    return blocks_[static_cast<std::size_t>(cells_[block])].data();
  }

  /// Every voxel of `count` blocks from `first` on was looked through.
  void look_through(std::size_t first, std::size_t count, const LogOddsModel& model);

  /// Adds evidence per voxel: a byte of 1 for a hit or for a look through it; hits take precedence.
  void update(std::size_t block, const std::uint8_t* hits, const std::uint8_t* looks,
              const LogOddsModel& model);

  /// Merges uniform blocks; to be called after each frame.
  void settle();

  std::size_t memory() const;

 private:
  using Block = std::array<LogOdds, block_voxels>;

  static std::int16_t encoded(LogOdds value) { return static_cast<std::int16_t>(-129 - value); }
  static LogOdds decoded(std::int16_t cell) { return static_cast<LogOdds>(-129 - cell); }

  void split();
  LogOdds* make_dense(std::size_t block);
  void join(std::size_t block);

  LogOdds uniform_ = unseen;         ///< the value if there are no cells
  std::vector<std::int16_t> cells_;  ///< index of a block in blocks_, or its encoded value
  std::deque<Block> blocks_;
  std::vector<std::int16_t> vacant_;  ///< unused indices of blocks_
};

}  // namespace symscene
