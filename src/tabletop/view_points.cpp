#include "symscene/tabletop/view_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "inverse_depth.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr float least_pixels = 6.0F;

/// Sums over the measured pixels of a row's segment, relative to the column and the inverse depth
/// of its middle.
struct RowSums {
  float n = 0.0F, u = 0.0F, uu = 0.0F, w = 0.0F, uw = 0.0F, ww = 0.0F;
};

/// The plane w = w0 + a du + b dv of inverse depths about a pixel.
struct PixelPlane {
  float w0 = 0.0F, a = 0.0F, b = 0.0F;
  float variance = -1.0F;  ///< of the residuals [1/m²]; negative without a plane

  bool known() const { return variance >= 0.0F; }
  float at(int du, int dv) const {
    return w0 + a * static_cast<float>(du) + b * static_cast<float>(dv);
  }
};

/// Sums of the rows of a window, for the plane of least squares.
class WindowSums {
 public:
  /// Adds a row `dv` below the pixel whose middle has `shift` more inverse depth than the pixel.
  void add(const RowSums& row, int dv, float shift) {
    const auto v = static_cast<float>(dv);
    const float w = row.w + shift * row.n;
    n_ += row.n;
    u_ += row.u;
    v_ += v * row.n;
    uu_ += row.uu;
    uv_ += v * row.u;
    vv_ += v * v * row.n;
    w_ += w;
    uw_ += row.uw + shift * row.u;
    vw_ += v * w;
    ww_ += row.ww + shift * (2.0F * row.w + shift * row.n);
  }

  /// The plane about a pixel of inverse depth `middle`.
  PixelPlane plane(float middle) const {
    if (n_ < least_pixels) return {};
    const float mu = u_ / n_, mv = v_ / n_, mw = w_ / n_;
    const float cuu = uu_ / n_ - mu * mu, cuv = uv_ / n_ - mu * mv, cvv = vv_ / n_ - mv * mv;
    const float cuw = uw_ / n_ - mu * mw, cvw = vw_ / n_ - mv * mw, cww = ww_ / n_ - mw * mw;
    const float determinant = cuu * cvv - cuv * cuv;
    // Pixels in a line do not determine a plane.
    if (!(determinant > 0.02F)) return {};
    const float a = (cvv * cuw - cuv * cvw) / determinant;
    const float b = (cuu * cvw - cuv * cuw) / determinant;
    const float rest = std::max(cww - a * cuw - b * cvw, 0.0F);
    return {middle + mw - a * mu - b * mv, a, b, rest * n_ / (n_ - 3.0F)};
  }

 private:
  float n_ = 0, u_ = 0, v_ = 0, uu_ = 0, uv_ = 0, vv_ = 0, w_ = 0, uw_ = 0, vw_ = 0, ww_ = 0;
};

class PlaneImage {
 public:
  PlaneImage(const InverseDepth& image, std::vector<Arms> arms)
      : image_(image), arms_(std::move(arms)), width_(static_cast<int>(image.camera().width)) {
    const std::vector<RowSums> rows = row_sums();
    planes_.resize(arms_.size());
    for_each_pixel([&](std::size_t i) {
      WindowSums sums;
      for (int dv = -arms_[i].up; dv <= arms_[i].down; ++dv) {
        const std::size_t row = shifted(i, 0, dv);
        sums.add(rows[row], dv, image_.at(row) - image_.at(i));
      }
      planes_[i] = sums.plane(image_.at(i));
    });
  }

  const PixelPlane& plane(std::size_t i) const { return planes_[i]; }

  /// The plane at a pixel: its own, or where that fits badly, as at a crease, the one of four
  /// windows beside it that fits best and agrees with the pixel.
  PixelPlane sharpened(std::size_t i, float noise) const {
    const PixelPlane own = planes_[i];
    const float usual = noise * noise;
    if (own.known() && own.variance < usual) return own;
    const Arms& arms = arms_[i];
    PixelPlane best = own;
    float least = own.known() ? 0.5F * own.variance : 1e9F;
    const std::array<std::array<int, 2>, 4> beside = {
        {{-arms.left, 0}, {arms.right, 0}, {0, -arms.up}, {0, arms.down}}};
    for (const auto& [du, dv] : beside) {
      const PixelPlane& other = planes_[shifted(i, du, dv)];
      if (!other.known() || !(other.variance < least)) continue;
      const float here = other.at(-du, -dv);
      if (std::abs(here - image_.at(i)) > 3.0F * noise) continue;
      least = other.variance;
      best = {here, other.a, other.b, other.variance};
    }
    return best;
  }

  template <class Body>
  void for_each_pixel(const Body& body) const {
    parallel_for_blocks(image_.camera().height, image_rows_per_block,
                        [&](std::size_t begin, std::size_t end) {
                          const auto width = static_cast<std::size_t>(width_);
                          for (std::size_t i = begin * width; i < end * width; ++i) {
                            if (image_.at(i) > 0.0F) body(i);
                          }
                        });
  }

 private:
  std::size_t shifted(std::size_t i, int du, int dv) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + dv * width_ + du);
  }

  std::vector<RowSums> row_sums() const {
    std::vector<RowSums> rows(arms_.size());
    parallel_for_blocks(image_.camera().height, image_rows_per_block,
                        [&](std::size_t begin, std::size_t end) {
                          const auto width = static_cast<std::size_t>(width_);
                          for (std::size_t i = begin * width; i < end * width; ++i) {
                            for (int du = -arms_[i].left; du <= arms_[i].right; ++du) {
                              const float here = image_.at(shifted(i, du, 0));
                              if (here == 0.0F) continue;
                              const float w = here - image_.at(i);
                              const auto u = static_cast<float>(du);
                              RowSums& row = rows[i];
                              row.n += 1.0F;
                              row.u += u;
                              row.uu += u * u;
                              row.w += w;
                              row.uw += u * w;
                              row.ww += w * w;
                            }
                          }
                        });
    return rows;
  }

  const InverseDepth& image_;
  std::vector<Arms> arms_;
  int width_;
  std::vector<PixelPlane> planes_;
};

struct OrientedPixel {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< zero without a point
};

/// The point of a plane on the ray of a pixel. With w = 1 / z, w = (n · ray) / d on a plane n · x =
/// d.
OrientedPixel on_ray(const PixelPlane& plane, const CameraIntrinsics& camera,
                     const Eigen::Vector3f& ray, float min_cosine) {
  OrientedPixel pixel;
  if (!plane.known() || !(plane.w0 > 0.0F)) return pixel;
  const float x = plane.a * static_cast<float>(camera.fx);
  const float y = plane.b * static_cast<float>(camera.fy);
  const Eigen::Vector3f normal(-x, -y, -(plane.w0 - x * ray.x() - y * ray.y()));
  const float cosine = -normal.dot(ray) / (normal.norm() * ray.norm());
  if (!(cosine > min_cosine)) return pixel;
  pixel.position = ray / plane.w0;
  pixel.normal = normal.normalized();
  return pixel;
}

}  // namespace

void ViewPointOptions::validate() const {
  check_fields(*this);
  require_option(max_depth > min_depth, "max_depth", "more than min_depth", max_depth);
}

ViewPoints unproject(const DepthFrame& frame, const CameraIntrinsics& camera,
                     const ViewPointOptions& options) {
  options.validate();
  const InverseDepth image(frame, camera, options);
  const PlaneImage planes(image, arms_of(image, options.max_hole));
  const std::vector<float> ray_x = camera.column_rays(), ray_y = camera.row_rays();
  std::vector<OrientedPixel> oriented(camera.pixels());
  const auto noise = static_cast<float>(options.noise);
  planes.for_each_pixel([&](std::size_t i) {
    const Eigen::Vector3f ray(ray_x[i % camera.width], ray_y[i / camera.width], 1.0F);
    oriented[i] = on_ray(options.sharpen ? planes.sharpened(i, noise) : planes.plane(i), camera,
                         ray, static_cast<float>(options.min_cosine));
  });
  ViewPoints points{camera, {}, {}};
  for (Index i = 0; i < oriented.size(); ++i) {
    if (oriented[i].normal.z() != 0.0F) points.pixels.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(points.pixels.size());
  points.cloud.positions.resize(count, 3);
  points.cloud.normals.resize(count, 3);
  const bool colored = frame.colors.rows() == static_cast<Eigen::Index>(camera.pixels());
  points.cloud.colors.resize(colored ? count : 0, 3);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Index i = points.pixels[static_cast<std::size_t>(k)];
    points.cloud.positions.row(k) = oriented[i].position.transpose();
    points.cloud.normals.row(k) = oriented[i].normal.transpose();
    if (colored) points.cloud.colors.row(k) = frame.colors.row(i);
  }
  return points;
}

}  // namespace symscene
