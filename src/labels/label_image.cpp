#include "symscene/labels/label_image.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include <fmt/format.h>

#include "core/image_checks.hpp"
#include "core/parallel.hpp"
#include "core/spacing.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A pixel that shows the table.
constexpr Index on_table = PointsInView::none - 1;

/// The spacing of a cloud. [m]
double spacing_of(const Points& points) {
  const std::optional<float> spacing = median_spacing(points);
  return spacing ? std::max(1e-4, double{*spacing}) : 0.005;
}

Eigen::Vector3d point_of(const CameraIntrinsics& camera, std::span<const float> depth,
                         std::size_t pixel) {
  return depth[pixel] * camera.ray(static_cast<double>(pixel % camera.width),
                                   static_cast<double>(pixel / camera.width));
}

}  // namespace

/// Passes the points of pixels on to pixels without one, over the surface that the image shows and
/// nearest first (Dijkstra 1959).
class PointsInView::Growth {
 public:
  Growth(const CameraIntrinsics& camera, std::span<const float> depth,
         const LabelImageOptions& options, std::vector<Index>& points)
      : camera_(camera), depth_(depth), options_(options), points_(points) {
    ways_.assign(points.size(), std::numeric_limits<double>::infinity());
  }

  void run() {
    for (std::size_t pixel = 0; pixel < points_.size(); ++pixel) {
      if (points_[pixel] != none) ways_[pixel] = 0.0;
    }
    for (std::size_t pixel = 0; pixel < points_.size(); ++pixel) {
      if (points_[pixel] != none) pass_on(pixel);
    }
    while (!reached_.empty()) {
      const auto [way, pixel] = reached_.top();
      reached_.pop();
      if (way == ways_[pixel]) pass_on(pixel);
    }
  }

 private:
  void pass_on(std::size_t pixel) {
    const std::size_t u = pixel % camera_.width, v = pixel / camera_.width;
    if (u > 0) pass_to(pixel, pixel - 1);
    if (u + 1 < camera_.width) pass_to(pixel, pixel + 1);
    if (v > 0) pass_to(pixel, pixel - camera_.width);
    if (v + 1 < camera_.height) pass_to(pixel, pixel + camera_.width);
  }

  void pass_to(std::size_t from, std::size_t to) {
    if (ways_[to] == 0.0 || depth_[to] <= 0.0F || is_edge(depth_[from], depth_[to])) return;
    const double step = (point_of(camera_, depth_, from) - point_of(camera_, depth_, to)).norm();
    const double way = ways_[from] + step;
    if (way > options_.max_growth || way >= ways_[to]) return;
    ways_[to] = way;
    points_[to] = points_[from];
    reached_.push({way, to});
  }

  bool is_edge(double z, double other) const {
    const double nearer = std::min(z, other);
    const double step = options_.max_slope * nearer / camera_.fx +
                        options_.noise_sigmas * options_.noise * nearer * nearer;
    return std::abs(z - other) > step;
  }

  using Reached = std::pair<double, std::size_t>;

  const CameraIntrinsics& camera_;
  std::span<const float> depth_;
  const LabelImageOptions& options_;
  std::vector<Index>& points_;
  std::vector<double> ways_;  ///< from a pixel with a point of its own [m]
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached_;
};

PointsInView::PointsInView(const PointCloud& cloud, const std::optional<Plane>& table,
                           const LabelImageOptions& options)
    : cloud_(cloud),
      table_(table),
      options_((options.validate(), options)),
      spacing_(spacing_of(cloud.positions)),
      cells_(cloud.positions, static_cast<float>(options.spacings * spacing_)) {}

std::vector<Index> PointsInView::points_of(const CameraIntrinsics& camera,
                                           std::span<const float> depth,
                                           const Eigen::Isometry3d& T_cloud_camera) const {
  require_pixels(depth.size(), camera, "depth image");
  std::vector<Index> points(depth.size(), none);
  if (cloud_.empty()) return points;
  assign_nearest(camera, depth, T_cloud_camera, points);
  Growth(camera, depth, options_, points).run();
  std::replace(points.begin(), points.end(), on_table, none);
  return points;
}

void PointsInView::assign_nearest(const CameraIntrinsics& camera, std::span<const float> depth,
                                  const Eigen::Isometry3d& T_cloud_camera,
                                  std::vector<Index>& points) const {
  constexpr std::size_t block = 4096;  // pixels
  const Box box = bounding_box(cloud_.positions);
  parallel_for_blocks(points.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t pixel = begin; pixel < end; ++pixel) {
      const double z = depth[pixel];
      if (!(z > 0.0)) continue;
      const Eigen::Vector3d point = T_cloud_camera * point_of(camera, depth, pixel);
      const double reach =
          options_.spacings * spacing_ + options_.noise_sigmas * options_.noise * z * z;
      const double height =
          table_ ? table_->signed_distance(point) : std::numeric_limits<double>::infinity();
      if (std::abs(height) <= reach) points[pixel] = on_table;
      const Eigen::Vector3f at = point.cast<float>();
      const auto margin = static_cast<float>(reach);
      if ((at.array() < box.min.array() - margin).any() ||
          (at.array() > box.max.array() + margin).any())
        continue;
      const auto [nearest, squared] = cells_.nearest(at, margin);
      if (nearest != CellList::none && std::sqrt(static_cast<double>(squared)) < height)
        points[pixel] = nearest;
    }
  });
}

std::vector<std::uint16_t> label_image(std::span<const Index> pixel_points,
                                       std::span<const PointIndices> masks,
                                       std::size_t point_count) {
  if (masks.size() > std::numeric_limits<std::uint16_t>::max())
    throw InputError("masks", "at most 65,535", fmt::format("{}", masks.size()));
  std::vector<std::uint16_t> label_of(point_count, 0);
  for (std::size_t k = masks.size(); k-- > 0;) {
    for (const Index i : masks[k]) {
      if (i >= point_count)
        throw InputError(fmt::format("mask {}", k), fmt::format("indices below {}", point_count),
                         fmt::format("{}", i));
      label_of[i] = static_cast<std::uint16_t>(k + 1);
    }
  }
  std::vector<std::uint16_t> labels(pixel_points.size(), 0);
  for (std::size_t pixel = 0; pixel < labels.size(); ++pixel) {
    if (pixel_points[pixel] < point_count) labels[pixel] = label_of[pixel_points[pixel]];
  }
  return labels;
}

}  // namespace symscene
