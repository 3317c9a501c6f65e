#include "reconstruction/block_index.hpp"

namespace symscene {

BlockIndex::BlockIndex() : directory_(std::size_t{64} * 64 * 64, none) {}

std::int32_t BlockIndex::insert(const Eigen::Vector3i& block) {
  const auto bx = static_cast<std::uint32_t>(block.x() + reach);
  const auto by = static_cast<std::uint32_t>(block.y() + reach);
  const auto bz = static_cast<std::uint32_t>(block.z() + reach);
  std::int32_t& chunk = directory_[((bz >> 5) << 12) | ((by >> 5) << 6) | (bx >> 5)];
  if (chunk == none) {
    chunk = static_cast<std::int32_t>(slots_.size() / chunk_size);
    slots_.resize(slots_.size() + chunk_size, none);
  }
  std::int32_t& slot = slots_[static_cast<std::size_t>(chunk) * chunk_size + place(bx, by, bz)];
  if (slot == none) {
    slot = static_cast<std::int32_t>(blocks_.size());
    blocks_.push_back(block);
  }
  return slot;
}

std::size_t BlockIndex::bytes() const {
  return directory_.capacity() * sizeof(std::int32_t) + slots_.capacity() * sizeof(std::int32_t) +
         blocks_.capacity() * sizeof(Eigen::Vector3i);
}

}  // namespace symscene
