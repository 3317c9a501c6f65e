#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "reconstruction/block_index.hpp"
#include "reconstruction/measurement.hpp"
#include "symscene/reconstruction/surface_options.hpp"

namespace symscene {

/// A cube of 8³ voxels, x fastest. Distances are in units of TsdfVolume::distance_unit(), weights
/// in Measurement::weight_units of a frontal view at 1 m. A voxel without weight was never seen;
/// its distance is `never_seen`, so that readers of distances need not read weights.
struct TsdfBlock {
  static constexpr int edge = 8;
  static constexpr int voxels = edge * edge * edge;
  static constexpr std::int16_t never_seen = -32768;

  alignas(64) std::array<std::int16_t, voxels> distance;
  alignas(64) std::array<std::uint16_t, voxels> weight{};

  TsdfBlock() { distance.fill(never_seen); }
};

/// The colours of a block's voxels near the surface.
struct ColorBlock {
  std::array<std::array<std::uint8_t, 4>, TsdfBlock::voxels> rgbw{};  ///< weight in frames
};

/// A truncated signed distance function in sparse blocks (Curless and Levoy 1996; Newcombe et al.
/// 2011; Nießner et al. 2013): positive in front of a surface, negative behind it. Blocks are
/// allocated where depth is measured. Voxel k covers [k, k + 1) times the voxel size along each
/// axis.
class TsdfVolume {
 public:
  explicit TsdfVolume(const TsdfOptions& options = {}, const MeasurementOptions& sensor = {});

  /// Fuses a measurement by projecting voxels into the image (Newcombe et al. 2011, Eqs. 6 to 13).
  /// Does nothing for a pose out of reach. The same bits for any number of threads.
  void integrate(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera);

  /// Whether a camera is within 1024 blocks of the origin along each axis, where blocks can be
  /// stored.
  bool in_reach(const Eigen::Isometry3d& T_world_camera) const;

  const TsdfOptions& options() const { return options_; }
  const BlockIndex& index() const { return index_; }
  double voxel_size() const { return options_.voxel_size; }
  /// The unit of a block's distances. [m]
  float distance_unit() const { return distance_unit_; }

  const TsdfBlock& block(std::size_t slot) const { return slabs_[slot / slab]->tsdf[slot % slab]; }
  /// Null if the block has no colours.
  const ColorBlock* colors(std::size_t slot) const;
  /// Whether the surface may pass within two voxels of a voxel of the block.
  bool near_surface(std::size_t slot) const { return near_surface_[slot] != 0; }

  /// The frames in which a block may have been seen.
  struct Looks {
    std::uint32_t frames = 0;
    float frontal_weight =
        0.0F;  ///< that frontal views from all of them would have [Measurement::weight_units]
  };
  const Looks& looks(std::size_t slot) const { return looks_[slot]; }

  bool empty() const { return index_.size() == 0; }
  /// Whether a block was left out because the volume has reached its largest memory.
  bool is_full() const { return is_full_; }
  /// Memory in use. [bytes]
  std::size_t bytes() const;

 private:
  static constexpr std::size_t slab = 64;
  struct Slab {
    std::array<TsdfBlock, slab> tsdf;
    std::unique_ptr<std::array<ColorBlock, slab>> colors;
  };

  void add_blocks(const std::vector<Eigen::Vector3i>& blocks);
  void add_block(const Eigen::Vector3i& block);
  void allocate_colors(std::span<const std::uint32_t> slots);

  TsdfOptions options_;
  MeasurementOptions sensor_;
  float distance_unit_;
  bool is_full_ = false;
  BlockIndex index_;
  std::vector<std::unique_ptr<Slab>> slabs_;
  std::vector<std::uint8_t> near_surface_;
  std::vector<Looks> looks_;  ///< by slot
};

}  // namespace symscene
