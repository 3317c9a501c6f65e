#include "block_fusion.hpp"

#include <algorithm>
#include <cmath>

#include "core/dispatch.hpp"

namespace symscene {
namespace {

constexpr int edge = TsdfBlock::edge;
constexpr int voxels = TsdfBlock::voxels;
constexpr float packed_unit = Measurement::depth_unit;

/// A frame contradicts a voxel if the distances differ by this share of the truncation distance,
/// which by default is more than two standard deviations of a depth.
constexpr float contradicting_share = 0.75F;

/// Projection of a block's voxels, up to the translation of the block.
struct Projection {
  float x[voxels];  ///< a voxel's centre relative to its block, in the camera's axes [m]
  float y[voxels];
  float z[voxels];
  float fx, fy, cx, cy;  ///< cx and cy plus half a pixel, so that truncation rounds [px]
  int width, height;
  const std::uint32_t* image;
};

Projection make_projection(const Measurement& measurement, const Eigen::Matrix3d& R_camera_world,
                           double voxel_size) {
  Projection projection{};
  for (int i = 0; i < voxels; ++i) {
    const Eigen::Vector3d center(i % edge + 0.5, i / edge % edge + 0.5, i / (edge * edge) + 0.5);
    const Eigen::Vector3f offset = (R_camera_world * (voxel_size * center)).cast<float>();
    projection.x[i] = offset.x();
    projection.y[i] = offset.y();
    projection.z[i] = offset.z();
  }
  const CameraIntrinsics& camera = measurement.camera;
  projection.fx = static_cast<float>(camera.fx);
  projection.fy = static_cast<float>(camera.fy);
  projection.cx = static_cast<float>(camera.cx + 0.5);
  projection.cy = static_cast<float>(camera.cy + 0.5);
  projection.width = static_cast<int>(camera.width);
  projection.height = static_cast<int>(camera.height);
  projection.image = measurement.packed.data();
  return projection;
}

/// Scale, truncation and weights of the fused distances.
struct Truncation {
  float units;             ///< per metre
  float least;             ///< [m]
  float most;              ///< [m]
  float growth;            ///< truncation over squared depth [1/m]
  float full_behind;       ///< see TsdfOptions::full_weight_behind
  float zero_behind;       ///< see TsdfOptions::zero_weight_behind
  float full_growth;       ///< TsdfOptions::full_weight_sigmas over squared depth [1/m]
  float zero_growth;       ///< TsdfOptions::zero_weight_sigmas over squared depth [1/m]
  float full_most;         ///< largest share of the depth of zero weight
  int max_weight;          ///< [Measurement::weight_units]
  float max_contradicted;  ///< TsdfOptions::max_contradicted_looks
};

Truncation make_truncation(const TsdfOptions& options, double noise, float distance_unit) {
  return {.units = 1.0F / distance_unit,
          .least = static_cast<float>(options.truncation),
          .most = static_cast<float>(options.max_truncation),
          .growth = static_cast<float>(options.truncation_sigmas * noise),
          .full_behind = static_cast<float>(options.full_weight_behind),
          .zero_behind = static_cast<float>(options.zero_weight_behind),
          .full_growth = static_cast<float>(options.full_weight_sigmas * noise),
          .zero_growth = static_cast<float>(options.zero_weight_sigmas * noise),
          .full_most =
              static_cast<float>(std::max(options.full_weight_behind / options.zero_weight_behind,
                                          options.full_weight_sigmas / options.zero_weight_sigmas)),
          .max_weight = static_cast<int>(Measurement::weight_units * options.max_weight),
          .max_contradicted = static_cast<float>(options.max_contradicted_looks)};
}

/// Depths and pixels of the voxels of a block whose corner is at (x, y, z) of the camera's frame.
/// Outside the image the pixel is the one after the last, where nothing is measured.
SYMSCENE_MULTIVERSION
void project_block(const Projection& p, float x, float y, float z, float* depth, int* pixel) {
  const float* const px = p.x;
  const float* const py = p.y;
  const float* const pz = p.z;
  const float fx = p.fx, fy = p.fy, cx = p.cx, cy = p.cy;
  const int width = p.width, none = p.width * p.height;
  const auto right = static_cast<float>(p.width), bottom = static_cast<float>(p.height);
  for (int i = 0; i < voxels; ++i) {
    const float zc = z + pz[i];
    const float before = zc > 0.01F ? zc : 0.01F;
    const float inverse = 1.0F / before;
    const float u = (x + px[i]) * fx * inverse + cx;
    const float v = (y + py[i]) * fy * inverse + cy;
    // Clamped first: the conversion to an integer must be in its range.
    const float column = std::min(std::max(u, 0.0F), right);
    const float row = std::min(std::max(v, 0.0F), bottom);
    const int at = static_cast<int>(row) * width + static_cast<int>(column);
    const int inside = static_cast<int>(column == u) & static_cast<int>(row == v) &
                       static_cast<int>(u < right) & static_cast<int>(v < bottom) &
                       static_cast<int>(before == zc);
    depth[i] = zc;
    pixel[i] = inside != 0 ? at : none;
  }
}

SYMSCENE_MULTIVERSION
void gather_pixels(const std::uint32_t* image, const int* pixel, int* packed) {
  for (int i = 0; i < voxels; ++i) packed[i] = static_cast<int>(image[pixel[i]]);
}

/// Averages the measured distances into the voxels of a block (Newcombe et al. 2011, Eqs. 6 to 13).
/// Returns the smallest distance of a seen voxel to the surface. [units]
/// `forgets`: with TsdfOptions::max_contradicted_looks.
template <bool forgets>
[[gnu::always_inline]] inline int fuse_pixels(const Truncation& truncation, const float* depths,
                                              const int* pixels, std::int16_t* distance,
                                              std::uint16_t* weight) {
  const float units = truncation.units, least = truncation.least, most = truncation.most;
  const float growth = truncation.growth;
  const float full_behind = truncation.full_behind, zero_behind = truncation.zero_behind;
  const float full_growth = truncation.full_growth, zero_growth = truncation.zero_growth;
  const float full_most = truncation.full_most;
  const int max_weight = truncation.max_weight;
  const float max_contradicted = truncation.max_contradicted;
  constexpr int never_seen = TsdfBlock::never_seen;
  constexpr float per_squared_root = Measurement::weight_units / (64.0F * 64.0F);
  int nearest = -never_seen;
  for (int i = 0; i < voxels; ++i) {
    const int packed = pixels[i];
    const int tenths = (packed >> 16) & 0xFFFF;
    const float depth = static_cast<float>(tenths) * packed_unit;
    const float cosine = static_cast<float>((packed >> 8) & 255) * (1.0F / 255.0F);
    const float cut = std::min(std::max(growth * depth * depth, least), most);
    const float full = (depth - depths[i]) * cosine;
    const float cut_off = std::min(full, cut);
    // The bound holds along the ray too, where a surface is seen at a flat angle.
    const int seen = static_cast<int>(full > -cut) & static_cast<int>(depths[i] - depth < cut) &
                     static_cast<int>(tenths > 0);
    // The weight falls to zero behind the surface (Bylow et al. 2013): views of one side of a thin
    // wall do not outweigh those of the other.
    const float squared = depth * depth;
    const float zero_depth = std::min(std::max(zero_growth * squared, zero_behind * cut), cut);
    const float full_depth =
        std::min(std::max(full_growth * squared, full_behind * cut), full_most * zero_depth);
    const float falloff = (zero_depth + full) / (zero_depth - full_depth);
    const int root = packed & 255;
    const float weighted =
        static_cast<float>(root * root) * per_squared_root * std::clamp(falloff, 0.0F, 1.0F);
    const auto rounded = static_cast<int>(weighted + 0.5F);
    const int added = seen != 0 ? rounded : 0;
    const int old = distance[i];
    int before = weight[i];
    if constexpr (forgets) {
      // What a frame contradicts at full weight has moved: the frames before it count less.
      const float gap = std::abs(cut_off * units - static_cast<float>(old));
      const int contradicts = static_cast<int>(gap > contradicting_share * cut * units) &
                              static_cast<int>(full >= -full_depth) & seen &
                              static_cast<int>(root > 0);
      const auto kept = static_cast<int>(max_contradicted * static_cast<float>(added));
      before -= contradicts * std::max(before - kept, 0);
    }
    const int sum = before + added;
    const float mean = (static_cast<float>(old) * static_cast<float>(before) +
                        cut_off * units * static_cast<float>(added)) /
                       static_cast<float>(std::max(sum, 1));
    const float half = mean < 0.0F ? -0.5F : 0.5F;
    const int now = sum > 0 ? static_cast<int>(mean + half) : never_seen;
    const int size = now < 0 ? -now : now;
    nearest = std::min(nearest, size);
    distance[i] = static_cast<std::int16_t>(now);
    weight[i] = static_cast<std::uint16_t>(std::min(sum, max_weight));
  }
  return nearest;
}

SYMSCENE_MULTIVERSION
int fuse_all(const Truncation& truncation, const float* depths, const int* pixels,
             std::int16_t* distance, std::uint16_t* weight) {
  return fuse_pixels<false>(truncation, depths, pixels, distance, weight);
}

SYMSCENE_MULTIVERSION
int fuse_forgetting(const Truncation& truncation, const float* depths, const int* pixels,
                    std::int16_t* distance, std::uint16_t* weight) {
  return fuse_pixels<true>(truncation, depths, pixels, distance, weight);
}

}  // namespace

struct BlockFusion::Kernel {
  Projection projection;
  Truncation truncation;
};

BlockFusion::BlockFusion(const Measurement& measurement, const Eigen::Matrix3d& R_camera_world,
                         const TsdfOptions& options, double noise, float distance_unit)
    : kernel_(std::make_unique<Kernel>(
          Kernel{make_projection(measurement, R_camera_world, options.voxel_size),
                 make_truncation(options, noise, distance_unit)})),
      color_reach_(static_cast<float>(2.0 * options.voxel_size)),
      max_color_weight_(options.max_color_weight) {}

BlockFusion::~BlockFusion() = default;

int BlockFusion::fuse(const Eigen::Vector3f& corner, Pixels& pixels, TsdfBlock& block) const {
  project_block(kernel_->projection, corner.x(), corner.y(), corner.z(), pixels.depth,
                pixels.pixel);
  gather_pixels(kernel_->projection.image, pixels.pixel, pixels.packed);
  const auto fuse_block = kernel_->truncation.max_contradicted > 0.0F ? fuse_forgetting : fuse_all;
  return fuse_block(kernel_->truncation, pixels.depth, pixels.packed, block.distance.data(),
                    block.weight.data());
}

void BlockFusion::color(const Pixels& pixels, const Colors& colors, ColorBlock& block) const {
  for (std::size_t i = 0; i < TsdfBlock::voxels; ++i) {
    // The entry after the last pixel stands for voxels outside the image and has no colour.
    if (pixels.packed[i] == 0) continue;
    const float depth = static_cast<float>((pixels.packed[i] >> 16) & 0xFFFF) * packed_unit;
    if (std::abs(depth - pixels.depth[i]) > color_reach_) continue;
    auto& voxel = block.rgbw[i];
    const int weight = voxel[3];
    const std::uint8_t* color = colors.data() + 3 * pixels.pixel[i];
    for (std::size_t c = 0; c < 3; ++c) {
      voxel[c] =
          static_cast<std::uint8_t>((voxel[c] * weight + color[c] + weight / 2) / (weight + 1));
    }
    voxel[3] = static_cast<std::uint8_t>(std::min(weight + 1, max_color_weight_));
  }
}

}  // namespace symscene
