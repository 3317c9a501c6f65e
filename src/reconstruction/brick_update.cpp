#include "brick_update.hpp"

#include <array>
#include <bitset>
#include <vector>

namespace symscene {
namespace {

/// Adds the evidence of one frame to one brick.
class BrickUpdater {
 public:
  BrickUpdater(OccupancyBrick& brick, BrickKey key, const OccupancyView& view,
               const LogOddsModel& model)
      : brick_(brick), code_(morton_code(first_voxel(key))), view_(view), model_(model) {}

  void run(std::span<const BrickHits> hits) {
    mark(hits);
    descend(0, brick_level);
    brick_.settle();
  }

 private:
  using Flags = std::array<std::uint8_t, block_voxels>;

  void mark(std::span<const BrickHits> hits) {
    for (const BrickHits& run : hits) {
      for (const std::uint32_t voxel : run.voxels) {
        const std::size_t block = voxel / block_voxels;
        if (!hit_blocks_[block]) {
          hit_blocks_.set(block);
          places_[block] = static_cast<std::uint16_t>(flags_.size());
          flags_.emplace_back(Flags{});
        }
        flags_[places_[block]][voxel % block_voxels] = 1;
      }
    }
  }

  bool any_hits(std::size_t first, std::size_t count) const {
    if (flags_.empty()) return false;
    for (std::size_t block = first; block < first + count; ++block) {
      if (hit_blocks_[block]) return true;
    }
    return false;
  }

  /// Updates the blocks of a cube. A cube without hits that is looked through or unseen as a whole
  /// is updated without a test of its voxels.
  void descend(std::size_t first, int level) {
    const Eigen::Vector3f center = view_.center_camera(octree_key(code_ + first * block_voxels));
    const Sight sight = view_.look_at(center, level);
    if (sight != Sight::some && !any_hits(first, blocks_of(level))) {
      if (sight == Sight::all) brick_.look_through(first, blocks_of(level), model_);
    } else if (level == block_level) {
      update(first, center, sight);
    } else {
      for (std::size_t child = 0; child < 8; ++child) {
        descend(first + child * blocks_of(level - 1), level - 1);
      }
    }
  }

  void update(std::size_t block, const Eigen::Vector3f& center, Sight sight) {
    static constexpr Flags no_hits{};
    Flags looks;
    if (sight == Sight::none) {
      looks.fill(0);
    } else {
      view_.look_through(center, looks.data());
    }
    const bool hit = hit_blocks_[block];
    const Flags& hits = hit ? flags_[places_[block]] : no_hits;
    if (hit || looks != no_hits) brick_.update(block, hits.data(), looks.data(), model_);
  }

  OccupancyBrick& brick_;
  std::uint64_t code_;
  const OccupancyView& view_;
  const LogOddsModel& model_;
  std::bitset<brick_blocks> hit_blocks_;
  std::array<std::uint16_t, brick_blocks> places_;  ///< in flags_, of blocks that are hit
  std::vector<Flags> flags_;
};

}  // namespace

void update_brick(OccupancyBrick& brick, BrickKey key, const FrameEvidence& evidence) {
  BrickUpdater(brick, key, evidence.view, evidence.model).run(evidence.hits.in_brick(key));
}

}  // namespace symscene
