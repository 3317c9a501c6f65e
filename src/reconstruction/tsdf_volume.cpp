#include "reconstruction/tsdf_volume.hpp"

#include "block_fusion.hpp"
#include "block_selection.hpp"
#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t blocks_per_task = 64;

}  // namespace

TsdfVolume::TsdfVolume(const TsdfOptions& options, const MeasurementOptions& sensor)
    : options_(options),
      sensor_(sensor),
      distance_unit_(static_cast<float>(options.max_truncation / 32000.0)) {
  options_.validate();
  sensor_.validate();
}

const ColorBlock* TsdfVolume::colors(std::size_t slot) const {
  const auto& colors = slabs_[slot / slab]->colors;
  return colors ? &(*colors)[slot % slab] : nullptr;
}

void TsdfVolume::add_blocks(const std::vector<Eigen::Vector3i>& blocks) {
  const double per_block = sizeof(TsdfBlock) + (options_.color ? sizeof(ColorBlock) : 0);
  const auto most = static_cast<std::size_t>(1e9 * options_.max_memory / per_block);
  for (const Eigen::Vector3i& block : blocks) {
    if (index_.size() >= most) {
      is_full_ = true;
      return;
    }
    add_block(block);
  }
}

void TsdfVolume::add_block(const Eigen::Vector3i& block) {
  const auto slot = static_cast<std::size_t>(index_.insert(block));
  if (slot < near_surface_.size()) return;
  near_surface_.push_back(0);
  looks_.emplace_back();
  if (slot / slab == slabs_.size()) slabs_.push_back(std::make_unique<Slab>());
}

void TsdfVolume::allocate_colors(std::span<const std::uint32_t> slots) {
  for (const std::uint32_t slot : slots) {
    auto& colors = slabs_[slot / slab]->colors;
    if (!colors) colors = std::make_unique<std::array<ColorBlock, slab>>();
  }
}

bool TsdfVolume::in_reach(const Eigen::Isometry3d& T_world_camera) const {
  const double reach = BlockIndex::reach * TsdfBlock::edge * options_.voxel_size;
  return T_world_camera.matrix().allFinite() &&
         T_world_camera.translation().cwiseAbs().maxCoeff() < reach;
}

void TsdfVolume::integrate(const Measurement& measurement,
                           const Eigen::Isometry3d& T_world_camera) {
  if (!in_reach(T_world_camera)) return;
  const BlockSelection selection{index_, options_, sensor_};
  add_blocks(selection.missing(measurement, T_world_camera));
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  const std::vector<std::uint32_t> slots = selection.visible(measurement, T_camera_world);
  const bool colored = options_.color && measurement.colors != nullptr;
  if (colored) allocate_colors(slots);
  const BlockFusion fusion(measurement, T_camera_world.linear(), options_, sensor_.noise,
                           distance_unit_);
  const auto near = static_cast<int>(2.0 * options_.voxel_size / distance_unit_);
  parallel_for_blocks(slots.size(), blocks_per_task, [&](std::size_t begin, std::size_t end) {
    BlockFusion::Pixels pixels;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t slot = slots[k];
      const Eigen::Vector3d corner =
          index_.blocks()[slot].cast<double>() * (TsdfBlock::edge * options_.voxel_size);
      const Eigen::Vector3f corner_camera = (T_camera_world * corner).cast<float>();
      ++looks_[slot].frames;
      looks_[slot].frontal_weight += frontal_weight(corner_camera.z());
      Slab& home = *slabs_[slot / slab];
      const int nearest = fusion.fuse(corner_camera, pixels, home.tsdf[slot % slab]);
      near_surface_[slot] = nearest <= near ? 1 : 0;
      if (colored && nearest <= near) {
        fusion.color(pixels, *measurement.colors, (*home.colors)[slot % slab]);
      }
    }
  });
}

std::size_t TsdfVolume::bytes() const {
  std::size_t total = index_.bytes() + near_surface_.capacity() + looks_.capacity() * sizeof(Looks);
  for (const auto& home : slabs_) {
    total += sizeof(Slab) + (home->colors ? sizeof(*home->colors) : 0);
  }
  return total;
}

}  // namespace symscene
