#include "symscene/reconstruction/tsdf_volume.hpp"

#include <algorithm>
#include <cmath>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr int edge = TsdfBlock::edge;
constexpr int voxels = TsdfBlock::voxels;
constexpr std::size_t blocks_a_task = 64;
constexpr float packed_unit = Measurement::depth_unit;

/// How voxels fall into an image, in the units of the camera's frame: what is the same for all
/// blocks of a frame.
struct Projection {
  float x[voxels];  ///< a voxel's place less that of its block, in the camera's axes [m]
  float y[voxels];
  float z[voxels];
  float fx, fy, cx, cy;  ///< cx and cy half a pixel on, so that rounding is a cut [px]
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

/// How distances become units, and where they are cut off.
struct Truncation {
  float units;   ///< in a metre
  float least;   ///< [m]
  float most;    ///< [m]
  float growth;  ///< truncation over squared depth [1/m]
  int max_weight;
};

/// Where the voxels of a block whose corner is at (x, y, z) of the camera's frame fall: their
/// depths and their pixels; beside the image that is the one after its last, which measured
/// nothing.
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
    // Clamped first: a cut to an integer has to be in its range.
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

/// Averages what pixels measured into the voxels of a block. Returns the least distance of a seen
/// voxel to the surface. [units]
SYMSCENE_MULTIVERSION
int fuse_pixels(const Truncation& truncation, const float* depths, const int* pixels,
                std::int16_t* distance, std::uint16_t* weight) {
  const float units = truncation.units, least = truncation.least, most = truncation.most;
  const float growth = truncation.growth;
  const int max_weight = truncation.max_weight;
  constexpr int never_seen = TsdfBlock::never_seen;
  int nearest = -never_seen;
  for (int i = 0; i < voxels; ++i) {
    const int packed = pixels[i];
    const int tenths = (packed >> 16) & 0xFFFF;
    const float depth = static_cast<float>(tenths) * packed_unit;
    const float cosine = static_cast<float>((packed >> 8) & 255) * (1.0F / 255.0F);
    const float cut = std::min(std::max(growth * depth * depth, least), most);
    const float full = (depth - depths[i]) * cosine;
    const float cut_off = std::min(full, cut);
    // No farther behind along the ray either, where a surface is grazed.
    const int seen = static_cast<int>(full > -cut) & static_cast<int>(depths[i] - depth < cut) &
                     static_cast<int>(tenths > 0);
    const int before = weight[i];
    // Behind a thin wall is the space before its other side: there is less and less to say.
    const float says = (TsdfVolume::reach_behind * cut + full) /
                       ((TsdfVolume::reach_behind - TsdfVolume::sure_behind) * cut);
    const float weighed = static_cast<float>(packed & 255) * std::clamp(says, 0.0F, 1.0F);
    const auto share = static_cast<int>(weighed + 0.5F);
    const int added = seen != 0 ? share : 0;
    const int sum = before + added;
    const int old = distance[i];
    const float mean = (static_cast<float>(old) * static_cast<float>(before) +
                        cut_off * units * static_cast<float>(added)) /
                       static_cast<float>(std::max(sum, 1));
    const float half = mean < 0.0F ? -0.5F : 0.5F;
    // What it was, if nothing was added.
    const int now = sum > 0 ? static_cast<int>(mean + half) : never_seen;
    const int size = now < 0 ? -now : now;
    nearest = std::min(nearest, size);
    distance[i] = static_cast<std::int16_t>(now);
    weight[i] = static_cast<std::uint16_t>(std::min(sum, max_weight));
  }
  return nearest;
}

/// Where an image's pixels meet a block's voxels.
struct BlockPixels {
  alignas(64) float depth[voxels];  ///< of the voxels [m]
  alignas(64) int pixel[voxels];
  alignas(64) int packed[voxels];
};

/// Fuses an image into one block whose corner is at `corner` of the camera's frame.
int fuse_block(const Projection& p, const Truncation& truncation, const Eigen::Vector3f& corner,
               BlockPixels& pixels, TsdfBlock& block) {
  project_block(p, corner.x(), corner.y(), corner.z(), pixels.depth, pixels.pixel);
  gather_pixels(p.image, pixels.pixel, pixels.packed);
  return fuse_pixels(truncation, pixels.depth, pixels.packed, block.distance.data(),
                     block.weight.data());
}

/// Averages colours into the voxels that lie within `reach` of the measured surface. [m]
void color_block(const BlockPixels& pixels, const Colors& colors, float reach, ColorBlock& block) {
  constexpr int most = 60;
  for (std::size_t i = 0; i < voxels; ++i) {
    // The pixel beside the image has no colour.
    if (pixels.packed[i] == 0) continue;
    const float depth = static_cast<float>((pixels.packed[i] >> 16) & 0xFFFF) * packed_unit;
    if (std::abs(depth - pixels.depth[i]) > reach) continue;
    auto& voxel = block.rgbw[i];
    const int weight = voxel[3];
    const std::uint8_t* color = colors.data() + 3 * pixels.pixel[i];
    for (std::size_t c = 0; c < 3; ++c) {
      voxel[c] =
          static_cast<std::uint8_t>((voxel[c] * weight + color[c] + weight / 2) / (weight + 1));
    }
    voxel[3] = static_cast<std::uint8_t>(std::min(weight + 1, most));
  }
}

constexpr Index tile = 16;  // [px]

/// The largest depth in every tile of an image, 0 where none was measured. [m]
struct DepthBounds {
  Index columns, rows;
  std::vector<float> farthest;

  explicit DepthBounds(const Measurement& measurement)
      : columns((measurement.camera.width + tile - 1) / tile),
        rows((measurement.camera.height + tile - 1) / tile),
        farthest(std::size_t{columns} * rows) {
    const Index width = measurement.camera.width;
    for (Index v = 0; v < measurement.camera.height; ++v) {
      const std::uint32_t* row = measurement.packed.data() + std::size_t{v} * width;
      float* bounds = farthest.data() + std::size_t{v / tile} * columns;
      for (Index u = 0; u < width; u += tile) {
        std::uint32_t most = 0;
        for (Index k = u; k < std::min(width, u + tile); ++k) most = std::max(most, row[k]);
        bounds[u / tile] = std::max(bounds[u / tile], static_cast<float>(most >> 16) * packed_unit);
      }
    }
  }

  float anywhere() const { return *std::max_element(farthest.begin(), farthest.end()); }

  /// The largest depth of the tiles that a disc of pixels touches, 0 beside the image.
  float about(float u, float v, float radius) const {
    const auto clamped = [](float at, Index count) {
      return static_cast<Index>(
          std::clamp(at / static_cast<float>(tile), 0.0F, static_cast<float>(count - 1)));
    };
    const auto right = static_cast<float>(columns * tile), bottom = static_cast<float>(rows * tile);
    if (u + radius < 0.0F || v + radius < 0.0F || u - radius > right || v - radius > bottom)
      return 0.0F;
    float most = 0.0F;
    for (Index y = clamped(v - radius, rows); y <= clamped(v + radius, rows); ++y) {
      for (Index x = clamped(u - radius, columns); x <= clamped(u + radius, columns); ++x) {
        most = std::max(most, farthest[std::size_t{y} * columns + x]);
      }
    }
    return most;
  }
};

/// The block at a coordinate, rounded down; anything out of reach where it is out of reach. Cutting
/// to an integer is an instruction, rounding down without SSE 4.1 a call.
int block_of(float coordinate) {
  constexpr int offset = 2 * BlockIndex::reach;
  const float bounded =
      std::clamp(coordinate, -static_cast<float>(offset), static_cast<float>(offset));
  return static_cast<int>(bounded + static_cast<float>(offset)) - offset;
}

}  // namespace

void TsdfOptions::validate() const {
  require_option(voxel_size >= 0.0005 && voxel_size <= 0.1, "voxel_size", "0.5 mm to 10 cm",
                 voxel_size);
  require_option(truncation >= 2 * voxel_size, "truncation", "at least two voxels", truncation);
  require_option(max_truncation >= truncation && max_truncation <= 1.0, "max_truncation",
                 "at least truncation and at most 1 m", max_truncation);
  require_option(truncation_sigmas > 0 && truncation_sigmas <= 100, "truncation_sigmas",
                 "a positive number up to 100", truncation_sigmas);
  require_option(max_weight >= 1 && max_weight <= 2000, "max_weight", "1 to 2000", max_weight);
}

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

double TsdfVolume::truncation(double depth) const {
  return std::clamp(options_.truncation_sigmas * sensor_.deviation(depth), options_.truncation,
                    options_.max_truncation);
}

void TsdfVolume::add_block(const Eigen::Vector3i& block) {
  const auto slot = static_cast<std::size_t>(index_.insert(block));
  if (slot < near_surface_.size()) return;
  near_surface_.push_back(0);
  if (slot / slab == slabs_.size()) slabs_.push_back(std::make_unique<Slab>());
}

void TsdfVolume::allocate_colors(std::span<const std::uint32_t> slots) {
  for (const std::uint32_t slot : slots) {
    auto& colors = slabs_[slot / slab]->colors;
    if (!colors) colors = std::make_unique<std::array<ColorBlock, slab>>();
  }
}

void TsdfVolume::allocate(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera) {
  const CameraIntrinsics& camera = measurement.camera;
  const double block_size = options_.voxel_size * edge;
  // Every second pixel, unless these are too far apart to hit every block of a slanted surface.
  const double spacing = sensor_.max_depth / std::min(camera.fx, camera.fy);
  const Index stride = 2.0 * spacing < 0.5 * block_size ? 2 : 1;  // [px]
  const Eigen::Matrix3f R = (T_world_camera.linear() / block_size).cast<float>();
  const Eigen::Vector3f t = (T_world_camera.translation() / block_size).cast<float>();
  const std::size_t rows = (camera.height + stride - 1) / stride;
  constexpr std::size_t rows_a_task = 8;
  std::vector<std::vector<Eigen::Vector3i>> missing((rows + rows_a_task - 1) / rows_a_task);
  const std::vector<float> ray_x = camera.column_rays();
  const std::vector<float> ray_y = camera.row_rays();
  parallel_for_blocks(rows, rows_a_task, [&](std::size_t begin, std::size_t end) {
    std::vector<Eigen::Vector3i>& found = missing[begin / rows_a_task];
    Eigen::Vector3i last = Eigen::Vector3i::Constant(BlockIndex::reach);
    for (std::size_t row = begin; row < end; ++row) {
      const std::size_t v = row * stride;
      for (Index u = 0; u < camera.width; u += stride) {
        const std::uint32_t packed = measurement.packed[v * camera.width + u];
        if (packed == 0) continue;
        const float depth = static_cast<float>(packed >> 16) * packed_unit;
        const auto band = static_cast<float>(truncation(depth));
        const Eigen::Vector3f ray = R * Eigen::Vector3f(ray_x[u], ray_y[v], 1.0F);
        const int steps = 1 + static_cast<int>(4.0F * band / static_cast<float>(block_size));
        for (int k = 0; k <= steps; ++k) {
          const float at =
              depth + band * (2.0F * static_cast<float>(k) / static_cast<float>(steps) - 1.0F);
          const Eigen::Vector3f place = t + at * ray;
          const Eigen::Vector3i block(block_of(place.x()), block_of(place.y()),
                                      block_of(place.z()));
          if (block == last) continue;
          last = block;
          if (BlockIndex::in_reach(block) && index_.find(block) == BlockIndex::none) {
            found.push_back(block);
          }
        }
      }
    }
  });
  for (const auto& found : missing) {
    for (const Eigen::Vector3i& block : found) add_block(block);
  }
}

std::vector<std::uint32_t> TsdfVolume::visible_slots(
    const Measurement& measurement, const Eigen::Isometry3d& T_camera_world) const {
  const DepthBounds bounds(measurement);
  const double block_size = options_.voxel_size * edge;
  const auto radius = static_cast<float>(0.5 * std::sqrt(3.0) * block_size);
  const Eigen::Matrix3f R = (T_camera_world.linear() * block_size).cast<float>();
  const Eigen::Vector3f t =
      (T_camera_world * Eigen::Vector3d::Constant(0.5 * block_size)).cast<float>();
  const auto band = static_cast<float>(options_.max_truncation);
  const float everywhere = bounds.anywhere();
  const auto fx = static_cast<float>(measurement.camera.fx);
  const auto fy = static_cast<float>(measurement.camera.fy);
  const auto cx = static_cast<float>(measurement.camera.cx);
  const auto cy = static_cast<float>(measurement.camera.cy);
  constexpr std::size_t task = 4096;
  std::vector<std::vector<std::uint32_t>> lists((index_.size() + task - 1) / task);
  parallel_for_blocks(index_.size(), task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Eigen::Vector3f center = R * index_.blocks()[slot].cast<float>() + t;
      if (!(center.z() + radius > 0.0F)) continue;
      const float nearest = center.z() - radius;
      float farthest = everywhere;
      if (nearest > 0.05F) {
        // Beside the optical axis a ball's image is longer than its radius over its distance.
        const float inverse = 1.0F / center.z();
        const float slant = center.norm() * inverse;
        const float reach = std::max(fx, fy) * radius * slant / nearest + 1.0F;
        farthest =
            bounds.about(center.x() * fx * inverse + cx, center.y() * fy * inverse + cy, reach);
      }
      if (farthest > 0.0F && nearest < farthest + band) {
        lists[begin / task].push_back(static_cast<std::uint32_t>(slot));
      }
    }
  });
  std::vector<std::uint32_t> slots;
  for (const auto& list : lists) slots.insert(slots.end(), list.begin(), list.end());
  return slots;
}

bool TsdfVolume::in_reach(const Eigen::Isometry3d& T_world_camera) const {
  const double reach = BlockIndex::reach * edge * options_.voxel_size;
  return T_world_camera.matrix().allFinite() &&
         T_world_camera.translation().cwiseAbs().maxCoeff() < reach;
}

void TsdfVolume::integrate(const Measurement& measurement,
                           const Eigen::Isometry3d& T_world_camera) {
  if (!in_reach(T_world_camera)) return;
  allocate(measurement, T_world_camera);
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse();
  const std::vector<std::uint32_t> slots = visible_slots(measurement, T_camera_world);
  const bool colored = options_.color && measurement.colors != nullptr;
  if (colored) allocate_colors(slots);
  const auto projection = std::make_unique<Projection>(
      make_projection(measurement, T_camera_world.linear(), options_.voxel_size));
  const Truncation truncation{1.0F / distance_unit_, static_cast<float>(options_.truncation),
                              static_cast<float>(options_.max_truncation),
                              static_cast<float>(options_.truncation_sigmas * sensor_.noise),
                              static_cast<int>(16.0 * options_.max_weight)};
  const auto near = static_cast<int>(2.0 * options_.voxel_size / distance_unit_);
  const auto color_reach = static_cast<float>(2.0 * options_.voxel_size);
  parallel_for_blocks(slots.size(), blocks_a_task, [&](std::size_t begin, std::size_t end) {
    BlockPixels pixels;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t slot = slots[k];
      const Eigen::Vector3d corner =
          index_.blocks()[slot].cast<double>() * (edge * options_.voxel_size);
      const Eigen::Vector3f at = (T_camera_world * corner).cast<float>();
      Slab& home = *slabs_[slot / slab];
      const int nearest = fuse_block(*projection, truncation, at, pixels, home.tsdf[slot % slab]);
      near_surface_[slot] = nearest <= near ? 1 : 0;
      if (colored && nearest <= near) {
        color_block(pixels, *measurement.colors, color_reach, (*home.colors)[slot % slab]);
      }
    }
  });
}

std::size_t TsdfVolume::bytes() const {
  std::size_t total = index_.bytes() + near_surface_.capacity();
  for (const auto& home : slabs_) {
    total += sizeof(Slab) + (home->colors ? sizeof(*home->colors) : 0);
  }
  return total;
}

}  // namespace symscene
