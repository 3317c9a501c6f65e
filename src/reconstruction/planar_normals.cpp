#include "planar_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/parallel.hpp"

namespace symscene {
namespace {

constexpr std::size_t blocks_across = 4;  ///< of a window
constexpr std::size_t block_rows_per_task = 4;

/// Sums over pixels for a fit of inverse depth, d = a + b u + c v, which is linear on a plane.
struct Moments {
  double count = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0, d = 0, ud = 0, vd = 0, dd = 0;

  void add(double x, double y, double inverse) {
    count += 1;
    u += x;
    v += y;
    uu += x * x;
    uv += x * y;
    vv += y * y;
    d += inverse;
    ud += x * inverse;
    vd += y * inverse;
    dd += inverse * inverse;
  }

  void add(const Moments& other) {
    count += other.count;
    u += other.u;
    v += other.v;
    uu += other.uu;
    uv += other.uv;
    vv += other.vv;
    d += other.d;
    ud += other.ud;
    vd += other.vd;
    dd += other.dd;
  }
};

/// Inverse depth as a linear function of the pixel. [1/m]
struct InversePlane {
  double a = 0, b = 0, c = 0;
  double at(double u, double v) const { return a + b * u + c * v; }
};

/// The plane through the pixels; none if they deviate from it by more than `noise` or lie on a
/// line.
std::optional<InversePlane> fit_plane(const Moments& m, double noise) {
  const double n = m.count, mean_u = m.u / n, mean_v = m.v / n, mean_d = m.d / n;
  const double uu = m.uu / n - mean_u * mean_u, uv = m.uv / n - mean_u * mean_v;
  const double vv = m.vv / n - mean_v * mean_v;
  const double ud = m.ud / n - mean_u * mean_d, vd = m.vd / n - mean_v * mean_d;
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0.1 * uu * vv)) return std::nullopt;
  const double b = (vv * ud - uv * vd) / determinant, c = (uu * vd - uv * ud) / determinant;
  const double squared = m.dd / n - mean_d * mean_d - b * ud - c * vd;
  if (squared > noise * noise) return std::nullopt;
  return InversePlane{mean_d - b * mean_u - c * mean_v, b, c};
}

/// The normal of a plane, towards the camera. With d = e⁻¹ n · (x, y, 1) for the ray (x, y, 1), n
/// is parallel to the coefficients of d in x, y and 1.
Eigen::Vector3f normal_of(const InversePlane& plane, const CameraIntrinsics& camera) {
  const Eigen::Vector3d n(plane.b * camera.fx, plane.c * camera.fy, plane.at(camera.cx, camera.cy));
  return -n.normalized().cast<float>();
}

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
    std::vector<Moments> moments(columns_ * rows_);
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

  Moments sum(std::size_t x, std::size_t y) const {
    Moments moments;
    for_each_pixel(x, y, [&](double u, double v, const SurfacePixel& pixel) {
      moments.add(u, v, 1.0 / static_cast<double>(pixel.depth));
    });
    return moments;
  }

  std::optional<Plane> fit_window(const std::vector<Moments>& moments, std::size_t x,
                                  std::size_t y) const {
    Moments window;
    for (std::size_t j = y; j < y + blocks_across; ++j) {
      for (std::size_t i = x; i < x + blocks_across; ++i) window.add(moments[j * columns_ + i]);
    }
    const auto side = static_cast<double>(blocks_across * edge_);
    if (window.count < options_.min_filled * side * side) return std::nullopt;
    const std::optional<InversePlane> inverse = fit_plane(window, noise_);
    if (!inverse) return std::nullopt;
    const Plane plane{*inverse, normal_of(*inverse, image_.camera)};
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
