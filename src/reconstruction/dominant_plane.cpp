#include "dominant_plane.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include "core/random.hpp"
#include "inverse_plane.hpp"

namespace symscene {
namespace {

constexpr Index samples_across = 64;
constexpr int triples = 200;
constexpr int refits = 3;

/// A pixel that shows a surface.
struct Sample {
  double u, v, inverse_depth;
  Eigen::Vector3f normal;
};

Sample sample_of(Index u, Index v, const SurfacePixel& pixel) {
  return {static_cast<double>(u),
          static_cast<double>(v),
          1.0 / static_cast<double>(pixel.depth),
          {pixel.nx, pixel.ny, pixel.nz}};
}

/// Pixels that show a surface, on a grid over the image.
std::vector<Sample> spread_samples(const SurfaceImage& image) {
  const CameraIntrinsics& camera = image.camera;
  const Index stride = std::max<Index>(1, camera.width / samples_across);
  std::vector<Sample> samples;
  for (Index v = stride / 2; v < camera.height; v += stride) {
    for (Index u = stride / 2; u < camera.width; u += stride) {
      const SurfacePixel& pixel = image.pixels[std::size_t{v} * camera.width + u];
      if (pixel.shows_surface()) samples.push_back(sample_of(u, v, pixel));
    }
  }
  return samples;
}

/// A plane with the bounds within which pixels lie on it.
class PlaneTest {
 public:
  PlaneTest(const InversePlane& plane, const CameraIntrinsics& camera, double noise,
            const DominantPlaneOptions& options)
      : plane_(plane),
        normal_(plane.normal(camera)),
        bound_(options.pixel_deviations * noise),
        min_cosine_(static_cast<float>(std::cos(options.max_angle))) {}

  bool contains(const Sample& pixel) const {
    return std::abs(plane_.at(pixel.u, pixel.v) - pixel.inverse_depth) <= bound_ &&
           normal_.dot(pixel.normal) >= min_cosine_;
  }
  const Eigen::Vector3f& normal() const { return normal_; }

 private:
  InversePlane plane_;
  Eigen::Vector3f normal_;
  double bound_;
  float min_cosine_;
};

std::optional<InversePlane> plane_through(const Sample& a, const Sample& b, const Sample& c) {
  Eigen::Matrix3d pixels;
  pixels << 1, a.u, a.v, 1, b.u, b.v, 1, c.u, c.v;
  if (std::abs(pixels.determinant()) < 1.0) return std::nullopt;
  const Eigen::Vector3d x =
      pixels.inverse() * Eigen::Vector3d(a.inverse_depth, b.inverse_depth, c.inverse_depth);
  return InversePlane{x[0], x[1], x[2]};
}

class PlaneSearch {
 public:
  PlaneSearch(const SurfaceImage& image, double noise, const DominantPlaneOptions& options)
      : camera_(image.camera), noise_(noise), options_(options), samples_(spread_samples(image)) {}

  /// The plane with the most samples, if it has enough.
  std::optional<PlaneTest> dominant() const {
    if (samples_.size() < 3) return std::nullopt;
    std::optional<InversePlane> plane = largest_of_triples();
    for (int k = 0; k < refits && plane; ++k) plane = refitted(*plane);
    if (!plane) return std::nullopt;
    const PlaneTest test = tested(*plane);
    const double least = options_.min_share * static_cast<double>(samples_.size());
    return static_cast<double>(count(test)) > least ? std::optional(test) : std::nullopt;
  }

 private:
  PlaneTest tested(const InversePlane& plane) const { return {plane, camera_, noise_, options_}; }

  std::size_t count(const PlaneTest& test) const {
    return static_cast<std::size_t>(std::count_if(
        samples_.begin(), samples_.end(), [&](const Sample& p) { return test.contains(p); }));
  }

  std::optional<InversePlane> largest_of_triples() const {
    Random random(1);
    const auto any = [&]() -> const Sample& {
      return samples_[random.below(static_cast<std::uint32_t>(samples_.size()))];
    };
    std::optional<InversePlane> best;
    std::size_t most = 0;
    for (int k = 0; k < triples; ++k) {
      const Sample &a = any(), &b = any(), &c = any();
      const std::optional<InversePlane> plane = plane_through(a, b, c);
      if (!plane) continue;
      const std::size_t contained = count(tested(*plane));
      if (contained <= most) continue;
      best = plane;
      most = contained;
    }
    return best;
  }

  std::optional<InversePlane> refitted(const InversePlane& plane) const {
    const PlaneTest test = tested(plane);
    InversePlaneMoments moments;
    for (const Sample& pixel : samples_) {
      if (test.contains(pixel)) moments.add(pixel.u, pixel.v, pixel.inverse_depth);
    }
    return fit_inverse_plane(moments, options_.pixel_deviations * noise_);
  }

  const CameraIntrinsics& camera_;
  double noise_;
  const DominantPlaneOptions& options_;
  std::vector<Sample> samples_;
};

}  // namespace

bool flatten_dominant_plane(SurfaceImage& image, double noise,
                            const DominantPlaneOptions& options) {
  const std::optional<PlaneTest> plane = PlaneSearch(image, noise, options).dominant();
  if (!plane) return false;
  for (Index v = 0; v < image.camera.height; ++v) {
    for (Index u = 0; u < image.camera.width; ++u) {
      SurfacePixel& pixel = image.pixels[std::size_t{v} * image.camera.width + u];
      if (!pixel.shows_surface() || !plane->contains(sample_of(u, v, pixel))) continue;
      const Eigen::Vector3f& n = plane->normal();
      pixel = {pixel.depth, n.x(), n.y(), n.z()};
    }
  }
  return true;
}

}  // namespace symscene
