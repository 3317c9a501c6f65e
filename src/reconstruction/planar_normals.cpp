#include "planar_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/parallel.hpp"
#include "inverse_plane.hpp"

namespace symscene {
namespace {

constexpr std::size_t blocks_across = 4;  ///< of a window
constexpr std::size_t block_rows_per_task = 4;

/// The places of a block in the windows that contain it, the most central first.
std::array<std::array<std::size_t, 2>, blocks_across * blocks_across> central_first() {
  std::array<std::array<std::size_t, 2>, blocks_across * blocks_across> places;
  for (std::size_t k = 0; k < places.size(); ++k)
    places[k] = {k / blocks_across, k % blocks_across};
  const auto distance = [](const std::array<std::size_t, 2>& place) {
    const auto from_center = [](std::size_t k) {
      const int twice = 2 * static_cast<int>(k) - static_cast<int>(blocks_across - 1);
      return twice * twice;
    };
    return from_center(place[0]) + from_center(place[1]);
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return places;
}

/// The planes of the windows of an image, which start at every block.
class PlanarWindows {
 public:
  PlanarWindows(SurfaceImage& image, double noise, const PlanarNormalOptions& options)
      : image_(image),
        noise_(noise),
        options_(options),
        edge_(std::max<std::size_t>(
            1, static_cast<std::size_t>(
                   std::lround(options.window_angle / blocks_across * image.camera.fx)))),
        columns_(image.camera.width / edge_),
        rows_(image.camera.height / edge_) {
    // The deviation of a slope fitted to n × n pixels is √12 / n² of a pixel's.
    const auto side = static_cast<double>(blocks_across * edge_);
    slope_bound_ = options.slope_deviations * noise * std::sqrt(12.0) / (side * side);
  }

  void smooth() {
    if (columns_ < blocks_across || rows_ < blocks_across) return;
    std::vector<InversePlaneMoments> moments(columns_ * rows_);
    for_each_block([&](std::size_t x, std::size_t y) { moments[y * columns_ + x] = sum(x, y); });
    windows_.resize(moments.size());
    for_each_block([&](std::size_t x, std::size_t y) {
      if (x + blocks_across <= columns_ && y + blocks_across <= rows_) {
        windows_[y * columns_ + x] = fit_window(moments, x, y);
      }
    });
    planes_.resize(moments.size());
    for_each_block([&](std::size_t x, std::size_t y) {
      if (is_continued(x, y)) planes_[y * columns_ + x] = windows_[y * columns_ + x];
    });
    for_each_block([&](std::size_t x, std::size_t y) { smooth_block(x, y); });
  }

 private:
  struct Plane {
    InversePlane inverse;
    Eigen::Vector3f normal;
  };

  template <class Visit>
  void for_each_block(const Visit& visit) const {
    parallel_for_blocks(rows_, block_rows_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t y = begin; y < end; ++y) {
        for (std::size_t x = 0; x < columns_; ++x) visit(x, y);
      }
    });
  }

  /// Calls visit(u, v, pixel) for the pixels of a block that show a surface.
  template <class Visit>
  void for_each_pixel(std::size_t x, std::size_t y, const Visit& visit) const {
    for (std::size_t v = y * edge_; v < (y + 1) * edge_; ++v) {
      for (std::size_t u = x * edge_; u < (x + 1) * edge_; ++u) {
        SurfacePixel& pixel = image_.pixels[v * image_.camera.width + u];
        if (pixel.shows_surface()) visit(static_cast<double>(u), static_cast<double>(v), pixel);
      }
    }
  }

  InversePlaneMoments sum(std::size_t x, std::size_t y) const {
    InversePlaneMoments moments;
    for_each_pixel(x, y, [&](double u, double v, const SurfacePixel& pixel) {
      moments.add(u, v, 1.0 / static_cast<double>(pixel.depth));
    });
    return moments;
  }

  std::optional<Plane> fit_window(const std::vector<InversePlaneMoments>& moments, std::size_t x,
                                  std::size_t y) const {
    InversePlaneMoments window;
    for (std::size_t j = y; j < y + blocks_across; ++j) {
      for (std::size_t i = x; i < x + blocks_across; ++i) window.add(moments[j * columns_ + i]);
    }
    const auto side = static_cast<double>(blocks_across * edge_);
    if (window.count < options_.min_filled * side * side) return std::nullopt;
    const std::optional<InversePlane> inverse = fit_inverse_plane(window, noise_);
    if (!inverse) return std::nullopt;
    const Plane plane{*inverse, inverse->normal(image_.camera)};
    return plane.normal.z() < 0.0F ? std::optional(plane) : std::nullopt;
  }

  /// Whether windows beside it and above or below it have the plane of a window, which those of a
  /// curved surface do not.
  bool is_continued(std::size_t x, std::size_t y) const {
    const std::optional<Plane>& plane = windows_[y * columns_ + x];
    const auto agrees = [&](std::size_t i, std::size_t j) {
      if (i >= columns_ || j >= rows_) return false;
      const std::optional<Plane>& other = windows_[j * columns_ + i];
      return other && std::abs(plane->inverse.b - other->inverse.b) < slope_bound_ &&
             std::abs(plane->inverse.c - other->inverse.c) < slope_bound_;
    };
    constexpr std::size_t shift = blocks_across / 2;  // x - shift wraps, which is out of the image
    return plane && (agrees(x - shift, y) || agrees(x + shift, y)) &&
           (agrees(x, y - shift) || agrees(x, y + shift));
  }

  /// Gives each pixel the normal of the most central window on whose plane it lies.
  void smooth_block(std::size_t x, std::size_t y) const {
    static const auto places = central_first();
    std::array<const Plane*, places.size()> planes{};
    std::size_t found = 0;
    for (const auto& [left, above] : places) {
      if (x < left || y < above) continue;
      const std::optional<Plane>& plane = planes_[(y - above) * columns_ + x - left];
      if (plane) planes[found++] = &*plane;
    }
    if (found == 0) return;
    const double bound = options_.pixel_deviations * noise_;
    for_each_pixel(x, y, [&](double u, double v, SurfacePixel& pixel) {
      const double inverse = 1.0 / static_cast<double>(pixel.depth);
      for (std::size_t k = 0; k < found; ++k) {
        if (std::abs(planes[k]->inverse.at(u, v) - inverse) > bound) continue;
        const Eigen::Vector3f& n = planes[k]->normal;
        pixel = {pixel.depth, n.x(), n.y(), n.z()};
        return;
      }
    });
  }

  SurfaceImage& image_;
  double noise_;
  const PlanarNormalOptions& options_;
  std::size_t edge_;  ///< of a block [px]
  std::size_t columns_, rows_;
  double slope_bound_;                         ///< between windows of one plane [1/m per px]
  std::vector<std::optional<Plane>> windows_;  ///< by the first block
  std::vector<std::optional<Plane>> planes_;   ///< those that neighbours continue
};

}  // namespace

void smooth_planar_normals(SurfaceImage& image, double noise, const PlanarNormalOptions& options) {
  PlanarWindows(image, noise, options).smooth();
}

}  // namespace symscene
