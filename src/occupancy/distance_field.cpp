#include "symscene/occupancy/distance_field.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/dispatch.hpp"
#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using Byte = std::uint8_t;

constexpr int max_clamp = 11;  // 11² + 10² fits a byte

/// The states around a voxel row; a row outside the grid is missing.
struct RowNeighbourhood {
  const VoxelState* here;
  std::array<const VoxelState*, 4> beside;  ///< y − 1, y + 1, z − 1, z + 1 or null
};

/// Marks the obstacles of a row: 0 where there is one, `far` elsewhere.
SYMSCENE_MULTIVERSION
void mark_obstacles(const RowNeighbourhood& row, std::size_t length, bool grow, Byte far,
                    Byte* marks) {
  for (std::size_t x = 0; x < length; ++x) {
    marks[x] = row.here[x] == VoxelState::free ? far : Byte{0};
  }
  if (!grow) return;
  for (const VoxelState* beside : row.beside) {
    if (beside == nullptr) continue;
    for (std::size_t x = 0; x < length; ++x) {
      marks[x] = beside[x] == VoxelState::never_seen ? Byte{0} : marks[x];
    }
  }
  for (std::size_t x = 0; x + 1 < length; ++x) {
    marks[x] = row.here[x + 1] == VoxelState::never_seen ? Byte{0} : marks[x];
    marks[x + 1] = row.here[x] == VoxelState::never_seen ? Byte{0} : marks[x + 1];
  }
}

/// Height over the table along a voxel row, in voxels: at(x) is that of voxel x's centre.
struct RowHeight {
  float first;
  float step;
  float at(std::size_t x) const { return first + step * static_cast<float>(x); }
};

RowHeight height_of_row(const Plane& table, const VoxelFrame& frame, std::size_t y, std::size_t z) {
  const double resolution = frame.resolution;
  const Eigen::Vector3d centre =
      frame.origin.cast<double>() +
      resolution * Eigen::Vector3d(0.5, static_cast<double>(y) + 0.5, static_cast<double>(z) + 0.5);
  return {static_cast<float>(table.signed_distance(centre) / resolution),
          static_cast<float>(table.normal.x())};
}

void mark_below_table(const RowHeight& height, std::size_t length, Byte* marks) {
  for (std::size_t x = 0; x < length; ++x) marks[x] = height.at(x) < 0.0F ? Byte{0} : marks[x];
}

/// Below the table the value becomes the squared depth, which no obstacle there lessens.
void write_table_depth(const RowHeight& height, std::size_t length, float clamp, Byte* squared) {
  for (std::size_t x = 0; x < length; ++x) {
    const float depth = std::clamp(-height.at(x), 0.0F, clamp);
    const auto squared_depth = static_cast<Byte>(static_cast<int>(depth * depth + 0.5F));
    squared[x] = std::max(squared[x], squared_depth);
  }
}

/// target[i] = min(target[i], source[i] + squared_step)
inline void lower_by_step(const Byte* __restrict source, std::size_t length, int squared_step,
                          Byte* __restrict target) {
  const auto step = static_cast<Byte>(squared_step);
  for (std::size_t i = 0; i < length; ++i) {
    const auto candidate = static_cast<Byte>(source[i] + step);
    target[i] = std::min(target[i], candidate);
  }
}

/// Lines of bytes, each the neighbour of the one before and the one after it.
struct Lines {
  const Byte* source;
  std::size_t stride, count, length;
};

/// One dimension of the transform for one of the lines.
SYMSCENE_MULTIVERSION
void transform_across_lines(const Lines& lines, std::size_t line, int clamp, Byte* target) {
  const auto [source, stride, count, length] = lines;
  std::copy_n(source + line * stride, length, target);
  for (int step = 1; step < clamp; ++step) {
    const auto offset = static_cast<std::size_t>(step);
    if (line >= offset)
      lower_by_step(source + (line - offset) * stride, length, step * step, target);
    if (line + offset < count)
      lower_by_step(source + (line + offset) * stride, length, step * step, target);
  }
}

/// The same along a line.
SYMSCENE_MULTIVERSION
void transform_along_line(const Byte* source, std::size_t length, int clamp, Byte* target) {
  std::copy_n(source, length, target);
  for (int step = 1; step < clamp; ++step) {
    const auto offset = static_cast<std::size_t>(step);
    if (offset >= length) break;
    lower_by_step(source + offset, length - offset, step * step, target);
    lower_by_step(source, length - offset, step * step, target + offset);
  }
}

class Transform {
 public:
  Transform(const OccupancyGrid& grid, const std::optional<Plane>& table,
            const DistanceFieldOptions& options, int clamp)
      : grid_(grid), frame_(grid.frame), table_(table), options_(options), clamp_(clamp) {}

  std::vector<Byte> run() const {
    std::vector<Byte> in_slices(frame_.voxels());
    parallel_for_each(frame_.slices(),
                      [&](std::size_t z) { transform_slice(z, in_slices.data()); });
    std::vector<Byte> squared(frame_.voxels());
    const auto rows = static_cast<std::size_t>(frame_.size.y());
    parallel_for_each(rows, [&](std::size_t y) {
      for (std::size_t z = 0; z < frame_.slices(); ++z)
        finish_row(in_slices.data(), y, z, squared.data());
    });
    return squared;
  }

 private:
  const VoxelState* states_at(std::size_t y, std::size_t z) const {
    const bool inside = y < static_cast<std::size_t>(frame_.size.y()) && z < frame_.slices();
    return inside ? grid_.states.data() + z * frame_.slice_length() + y * frame_.row_length()
                  : nullptr;
  }

  /// Obstacles and the transform along x and y of one slice.
  void transform_slice(std::size_t z, Byte* in_slices) const {
    const std::size_t length = frame_.row_length();
    const auto rows = static_cast<std::size_t>(frame_.size.y());
    std::vector<Byte> marks(length);
    std::vector<Byte> along_x(frame_.slice_length());
    const auto far = static_cast<Byte>(clamp_ * clamp_);
    for (std::size_t y = 0; y < rows; ++y) {
      // y − 1 and z − 1 wrap to a huge number at the border, which lies outside too.
      const RowNeighbourhood row{
          states_at(y, z),
          {states_at(y - 1, z), states_at(y + 1, z), states_at(y, z - 1), states_at(y, z + 1)}};
      mark_obstacles(row, length, options_.grow_never_seen, far, marks.data());
      if (table_) mark_below_table(height_of_row(*table_, frame_, y, z), length, marks.data());
      transform_along_line(marks.data(), length, clamp_, along_x.data() + y * length);
    }
    Byte* slice = in_slices + z * frame_.slice_length();
    for (std::size_t y = 0; y < rows; ++y) {
      transform_across_lines({along_x.data(), length, rows, length}, y, clamp_, slice + y * length);
    }
  }

  void finish_row(const Byte* in_slices, std::size_t y, std::size_t z, Byte* squared) const {
    const std::size_t length = frame_.row_length();
    Byte* row = squared + z * frame_.slice_length() + y * length;
    transform_across_lines({in_slices + y * length, frame_.slice_length(), frame_.slices(), length},
                           z, clamp_, row);
    if (table_ && options_.table_depth_counts) {
      write_table_depth(height_of_row(*table_, frame_, y, z), length, static_cast<float>(clamp_),
                        row);
    }
  }

  const OccupancyGrid& grid_;
  const VoxelFrame& frame_;
  const std::optional<Plane>& table_;
  const DistanceFieldOptions& options_;
  int clamp_;  ///< [voxels]
};

int clamp_in_voxels(const DistanceFieldOptions& options, float resolution) {
  const double voxels = std::ceil(options.clamp / double{resolution} - 1e-6);
  if (!(resolution >= 1e-4F && resolution <= 0.1F && voxels <= max_clamp)) {
    throw InputError("occupancy",
                     fmt::format("voxels from {:.2g} to 0.1 m", options.clamp / max_clamp),
                     fmt::format("voxels of {:.4g} m", resolution));
  }
  return static_cast<int>(voxels);
}

}  // namespace

DistanceField distance_field(const OccupancyGrid& grid, const std::optional<Plane>& table,
                             const DistanceFieldOptions& options) {
  options.validate();
  const int clamp = clamp_in_voxels(options, grid.frame.resolution);
  DistanceField field;
  field.frame = grid.frame;
  field.inverse_resolution = 1.0F / grid.frame.resolution;
  field.upper = grid.frame.size.cast<float>();
  for (std::size_t i = 0; i < field.metres.size(); ++i) {
    field.metres[i] = grid.frame.resolution * std::sqrt(static_cast<float>(i));
  }
  field.outside = field.metres[static_cast<std::size_t>(clamp * clamp)];
  field.squared = Transform(grid, table, options, clamp).run();
  return field;
}

DistanceField unknown_distance_field(const Box& box, float resolution,
                                     const std::optional<Plane>& table,
                                     const DistanceFieldOptions& options) {
  OccupancyMap nothing_seen;
  nothing_seen.resolution = resolution;
  DistanceField field =
      distance_field(rasterize(nothing_seen, box, options.max_voxels), table, options);
  field.outside = 0.0F;
  return field;
}

}  // namespace symscene
