#include "occupancy_brick.hpp"

#include <algorithm>

#include "core/dispatch.hpp"

namespace symscene {
namespace {

/// LogOddsModel in the type of the sums, so that the loops vectorise.
struct ShortModel {
  explicit ShortModel(const LogOddsModel& model)
      : hit(static_cast<std::int16_t>(model.hit)),
        miss(static_cast<std::int16_t>(model.miss)),
        min(static_cast<std::int16_t>(model.min)),
        max(static_cast<std::int16_t>(model.max)) {}
  std::int16_t hit, miss, min, max;
};

SYMSCENE_MULTIVERSION
void add_evidence(LogOdds* values, const std::uint8_t* hits, const std::uint8_t* looks,
                  ShortModel model) {
  for (std::size_t i = 0; i < block_voxels; ++i) {
    const std::int16_t old = values[i];
    const std::int16_t known = old == unseen ? std::int16_t{0} : old;
    const auto up = static_cast<std::int16_t>(known + model.hit);
    const auto down = static_cast<std::int16_t>(known + model.miss);
    std::int16_t next = hits[i] != 0 ? up : down;
    next = next < model.min ? model.min : next;
    next = next > model.max ? model.max : next;
    values[i] = static_cast<LogOdds>((hits[i] | looks[i]) != 0 ? next : old);
  }
}

SYMSCENE_MULTIVERSION
void add_looks(LogOdds* values, ShortModel model) {
  for (std::size_t i = 0; i < block_voxels; ++i) {
    const std::int16_t known = values[i] == unseen ? std::int16_t{0} : std::int16_t{values[i]};
    const auto next = static_cast<std::int16_t>(known + model.miss);
    values[i] = static_cast<LogOdds>(next < model.min ? model.min : next);
  }
}

SYMSCENE_MULTIVERSION
bool all_equal(const LogOdds* values) {
  int differences = 0;
  for (std::size_t i = 0; i < block_voxels; ++i) differences |= values[i] ^ values[0];
  return differences == 0;
}

}  // namespace

void OccupancyBrick::split() {
  if (is_uniform()) cells_.assign(brick_blocks, encoded(uniform_));
}

LogOdds* OccupancyBrick::make_dense(std::size_t block) {
  split();
  if (cells_[block] < 0) {
    const LogOdds value = decoded(cells_[block]);
    if (vacant_.empty()) {
      vacant_.push_back(static_cast<std::int16_t>(blocks_.size()));
      blocks_.emplace_back();
    }
    cells_[block] = vacant_.back();
    vacant_.pop_back();
    blocks_[static_cast<std::size_t>(cells_[block])].fill(value);
  }
  return blocks_[static_cast<std::size_t>(cells_[block])].data();
}

void OccupancyBrick::join(std::size_t block) {
  const LogOdds* values = voxels(block);
  if (!all_equal(values)) return;
  vacant_.push_back(cells_[block]);
  cells_[block] = encoded(values[0]);
}

void OccupancyBrick::look_through(std::size_t first, std::size_t count, const LogOddsModel& model) {
  if (is_uniform() && count == brick_blocks) {
    uniform_ = model.looked_through(uniform_);
    return;
  }
  split();
  for (std::size_t block = first; block < first + count; ++block) {
    if (cells_[block] < 0) {
      cells_[block] = encoded(model.looked_through(decoded(cells_[block])));
      continue;
    }
    add_looks(make_dense(block), ShortModel(model));
    join(block);
  }
}

void OccupancyBrick::update(std::size_t block, const std::uint8_t* hits, const std::uint8_t* looks,
                            const LogOddsModel& model) {
  add_evidence(make_dense(block), hits, looks, ShortModel(model));
  join(block);
}

void OccupancyBrick::settle() {
  if (is_uniform() || cells_[0] >= 0) return;
  const auto same = [&](std::int16_t cell) { return cell == cells_[0]; };
  if (!std::all_of(cells_.begin(), cells_.end(), same)) return;
  uniform_ = decoded(cells_[0]);
  cells_ = {};
  blocks_ = {};
  vacant_ = {};
}

std::size_t OccupancyBrick::memory() const {
  return sizeof(*this) + cells_.capacity() * sizeof(cells_[0]) + blocks_.size() * sizeof(Block) +
         vacant_.capacity() * sizeof(vacant_[0]);
}

}  // namespace symscene
