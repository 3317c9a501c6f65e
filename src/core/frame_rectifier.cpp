#include "symscene/core/frame_rectifier.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/image_checks.hpp"
#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::uint32_t no_pixel = ~std::uint32_t{0};
constexpr std::size_t rows_per_task = 60;

/// The pixel that shows a position [px], or no_pixel outside the image.
std::uint32_t pixel_at(const Eigen::Vector2d& position, const CameraIntrinsics& camera) {
  const double u = std::floor(position.x() + 0.5), v = std::floor(position.y() + 0.5);
  if (!(u >= 0.0 && v >= 0.0 && u < camera.width && v < camera.height)) return no_pixel;
  return static_cast<std::uint32_t>(v) * camera.width + static_cast<std::uint32_t>(u);
}

/// Where a distorting camera shows a ray with z = 1. [px]
Eigen::Vector2d position_of(const Eigen::Vector2d& ray, const CameraIntrinsics& camera,
                            const LensDistortion& lens) {
  const Eigen::Vector2d shown = lens.distorted(ray);
  return {camera.fx * shown.x() + camera.cx, camera.fy * shown.y() + camera.cy};
}

std::vector<std::uint32_t> sources_of(const CameraIntrinsics& camera, const LensDistortion& lens) {
  if (lens.is_none()) return {};
  std::vector<std::uint32_t> sources(camera.pixels(), no_pixel);
  parallel_for_each(camera.height, [&](std::size_t v) {
    for (Index u = 0; u < camera.width; ++u) {
      const Eigen::Vector2d ray = camera.ray(u, static_cast<double>(v)).head<2>();
      if (lens.is_monotonic_to(ray))
        sources[v * camera.width + u] = pixel_at(position_of(ray, camera, lens), camera);
    }
  });
  return sources;
}

void require_correction(const CameraModel& camera) {
  const auto& correction = camera.depth_correction;
  if (!correction) return;
  correction->validate();
  if (correction->width == camera.intrinsics.width &&
      correction->height == camera.intrinsics.height)
    return;
  throw InputError(
      "depth correction",
      fmt::format("one for images of {}×{}", camera.intrinsics.width, camera.intrinsics.height),
      fmt::format("{}×{}", correction->width, correction->height));
}

}  // namespace

FrameRectifier::FrameRectifier(const CameraModel& camera) : camera_(camera) {
  require_correction(camera);
  sources_ = sources_of(camera.intrinsics, camera.distortion);
  if (!camera.depth_correction) return;
  const DepthCorrection& grid = *camera.depth_correction;
  for (Index u = 0; u < grid.width; ++u) {
    const AxisPlace place = place_in_image(u, grid.width, grid.columns);
    columns_.push_back({place.node * (grid.ranges + 1), static_cast<float>(place.beyond)});
  }
  for (Index j = 0; j <= grid.rows; ++j) {
    for (Index i = 0; i <= grid.columns; ++i) {
      for (Index k = 0; k <= grid.ranges; ++k)
        factors_.push_back(
            grid.factors[grid.cell(std::min(k, grid.ranges - 1), std::min(j, grid.rows - 1),
                                   std::min(i, grid.columns - 1))]);
    }
  }
}

/// Factors are interpolated between two rows of nodes once for the row of pixels, then for each
/// pixel between two columns and two ranges.
void FrameRectifier::correct_row(Index v, std::vector<float>& factors, float* depth) const {
  const DepthCorrection& grid = *camera_.depth_correction;
  const std::size_t stride = std::size_t{grid.ranges} + 1;
  factors.resize(stride * (std::size_t{grid.columns} + 1));
  const AxisPlace place = place_in_image(v, grid.height, grid.rows);
  const auto y = static_cast<float>(place.beyond);
  const float* const upper = factors_.data() + place.node * factors.size();
  const float* const lower = upper + factors.size();
  for (std::size_t i = 0; i < factors.size(); ++i)
    factors[i] = upper[i] + y * (lower[i] - upper[i]);
  const auto first = static_cast<float>(grid.first_range);
  const auto per_step = static_cast<float>(1.0 / grid.range_step);
  const auto last = static_cast<float>(grid.ranges - 1);
  for (Index u = 0; u < grid.width; ++u) {
    const float z = std::max(0.0F, std::min((depth[u] - first) * per_step, last));
    const auto range = static_cast<int>(z);
    const float t = z - static_cast<float>(range);
    const float* left = factors.data() + columns_[u].offset + range;
    const float* right = left + stride;
    const float at_left = left[0] + t * (left[1] - left[0]);
    const float at_right = right[0] + t * (right[1] - right[0]);
    depth[u] *= at_left + columns_[u].beyond * (at_right - at_left);
  }
}

std::vector<float> FrameRectifier::rectified(const std::vector<float>& depth) const {
  const CameraIntrinsics& camera = camera_.intrinsics;
  std::vector<float> result(camera.pixels());
  parallel_for_blocks(camera.height, rows_per_task, [&](std::size_t begin, std::size_t end) {
    std::vector<float> factors;
    for (std::size_t v = begin; v < end; ++v) {
      float* const row = result.data() + v * camera.width;
      const std::size_t offset = v * camera.width;
      for (Index u = 0; u < camera.width; ++u) {
        if (sources_.empty()) {
          row[u] = depth[offset + u];
        } else if (const std::uint32_t source = sources_[offset + u]; source != no_pixel) {
          row[u] = depth[source];
        }
      }
      if (camera_.depth_correction) correct_row(static_cast<Index>(v), factors, row);
    }
  });
  return result;
}

Colors FrameRectifier::undistorted(const Colors& colors) const {
  Colors result = Colors::Zero(colors.rows(), 3);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i] != no_pixel) result.row(static_cast<Eigen::Index>(i)) = colors.row(sources_[i]);
  }
  return result;
}

Colors FrameRectifier::registered(const Colors& colors, const std::vector<float>& depth) const {
  const CameraIntrinsics& camera = camera_.intrinsics;
  const ColorCamera& color = *camera_.color;
  const Eigen::Isometry3d T_color_depth = color.T_depth_color.inverse();
  Colors result = Colors::Zero(static_cast<Eigen::Index>(depth.size()), 3);
  parallel_for_each(camera.height, [&](std::size_t v) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t pixel = v * camera.width + u;
      const double z = depth[pixel];
      if (!(z > 0.0)) continue;
      const Eigen::Vector3d point = T_color_depth * (z * camera.ray(u, static_cast<double>(v)));
      if (!(point.z() > 0.0)) continue;
      const Eigen::Vector2d ray = point.hnormalized();
      const std::uint32_t source =
          pixel_at(position_of(ray, color.intrinsics, color.distortion), color.intrinsics);
      if (source != no_pixel) result.row(static_cast<Eigen::Index>(pixel)) = colors.row(source);
    }
  });
  return result;
}

std::vector<Index> FrameRectifier::rectified_labels(const std::vector<Index>& labels,
                                                    Index outside) const {
  require_pixels(labels.size(), camera_.intrinsics, "label image");
  if (sources_.empty()) return labels;
  std::vector<Index> result(labels.size(), outside);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i] != no_pixel) result[i] = labels[sources_[i]];
  }
  return result;
}

DepthFrame FrameRectifier::rectified(DepthFrame frame) const {
  require_pixels(frame.depth.size(), camera_.intrinsics, "depth image");
  if (frame.colors.rows() != 0) {
    const CameraIntrinsics& shown = camera_.color ? camera_.color->intrinsics : camera_.intrinsics;
    require_pixels(static_cast<std::size_t>(frame.colors.rows()), shown, "colour image");
  }
  frame.depth = rectified(frame.depth);
  if (frame.colors.rows() == 0) return frame;
  if (camera_.color)
    frame.colors = registered(frame.colors, frame.depth);
  else if (!sources_.empty())
    frame.colors = undistorted(frame.colors);
  return frame;
}

}  // namespace symscene
