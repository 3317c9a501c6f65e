#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "symscene/reconstruction/block_index.hpp"
#include "symscene/reconstruction/measurement.hpp"

namespace symscene {

struct TsdfOptions {
  double voxel_size = 0.0031;     ///< section 2.1.1 [m]
  double truncation = 0.0125;     ///< least distance at which the field is cut off [m]
  double max_truncation = 0.04;   ///< where the noise of far depths asks for more [m]
  double truncation_sigmas = 3.;  ///< truncation over the standard deviation of a depth
  double max_weight = 200.0;      ///< that a voxel gathers, in frontal views at 1 m
  bool color = true;              ///< keep colours where frames have them

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", "edge of a voxel");
    visit("truncation", self.truncation, "m", "least distance at which the field is cut off");
    visit("max_truncation", self.max_truncation, "m", "largest one, for far and noisy depths");
    visit("truncation_sigmas", self.truncation_sigmas, "",
          "truncation over the standard deviation of a depth");
    visit("max_weight", self.max_weight, "", "weight of a voxel, in frontal views at 1 m");
    visit("color", self.color, "", "keep colours where frames have them");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// A cube of 8³ voxels, x fastest. Distances are in units of TsdfVolume::distance_unit(), weights
/// in 16ths of a frontal view at 1 m. A voxel without weight was never seen; its distance says so
/// too, that who only reads distances need not look at weights.
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
/// 2011; Nießner et al. 2013): positive before a surface, negative behind it. Blocks are made where
/// depth is measured. Voxel k covers [k, k + 1) times the voxel size along each axis.
class TsdfVolume {
 public:
  /// Behind a surface weights are full down to the first share of the truncation and fall to
  /// nothing at the second (Bylow et al. 2013), so that views of one side of a thin wall do not
  /// outweigh those of the other.
  static constexpr float sure_behind = 0.25F, reach_behind = 0.625F;

  explicit TsdfVolume(const TsdfOptions& options = {}, const MeasurementOptions& sensor = {});

  /// Fuses every pixel of a measurement: voxels are projected into the image (Newcombe et al. 2011,
  /// Eqs. 6 to 13). The same bits for any number of threads.
  /// Nothing happens for a pose from which in_reach() does not hold.
  void integrate(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera);

  /// Whether blocks can be kept about a camera: within 1024 blocks of the origin along each axis.
  bool in_reach(const Eigen::Isometry3d& T_world_camera) const;

  const TsdfOptions& options() const { return options_; }
  const BlockIndex& index() const { return index_; }
  double voxel_size() const { return options_.voxel_size; }
  /// Metres a unit of a block's distances.
  float distance_unit() const { return distance_unit_; }

  const TsdfBlock& block(std::size_t slot) const { return slabs_[slot / slab]->tsdf[slot % slab]; }
  /// Null where nothing was coloured.
  const ColorBlock* colors(std::size_t slot) const;
  /// Whether the surface may pass within two voxels of a voxel of the block.
  bool near_surface(std::size_t slot) const { return near_surface_[slot] != 0; }

  bool empty() const { return index_.size() == 0; }
  /// Memory in use. [bytes]
  std::size_t bytes() const;

 private:
  static constexpr std::size_t slab = 64;
  struct Slab {
    std::array<TsdfBlock, slab> tsdf;
    std::unique_ptr<std::array<ColorBlock, slab>> colors;
  };

  void allocate(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera);
  std::vector<std::uint32_t> visible_slots(const Measurement& measurement,
                                           const Eigen::Isometry3d& T_camera_world) const;
  void add_block(const Eigen::Vector3i& block);
  void allocate_colors(std::span<const std::uint32_t> slots);
  double truncation(double depth) const;

  TsdfOptions options_;
  MeasurementOptions sensor_;
  float distance_unit_;
  BlockIndex index_;
  std::vector<std::unique_ptr<Slab>> slabs_;
  std::vector<std::uint8_t> near_surface_;
};

}  // namespace symscene
