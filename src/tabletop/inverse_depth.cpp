#include "inverse_depth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr int least_radius = 2;      // [px]
constexpr int greatest_radius = 16;  // [px]

void require_image(const DepthFrame& frame, const CameraIntrinsics& camera) {
  const bool valid = std::isfinite(camera.fx + camera.fy + camera.cx + camera.cy) &&
                     camera.fx > 0.0 && camera.fy > 0.0;
  if (!valid) throw InputError("camera", "finite intrinsics with focal lengths above 0", "others");
  if (frame.depth.size() != camera.pixels())
    throw InputError("depth image", fmt::format("{} pixels", camera.pixels()),
                     fmt::format("{}", frame.depth.size()));
}

/// Steps from a pixel along one direction, `limit` pixels at most.
struct Walk {
  const InverseDepth& image;
  int max_hole;

  std::uint8_t reach(std::size_t from, std::ptrdiff_t step, int limit) const {
    float last = image.at(from);
    int reached = 0, hole = 0;
    for (int k = 1; k <= limit; ++k) {
      const float here =
          image.at(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + k * step));
      if (here == 0.0F) {
        if (++hole > max_hole) break;
        continue;
      }
      if (!image.connected(last, here, static_cast<float>(k - reached))) break;
      last = here;
      reached = k;
      hole = 0;
    }
    return static_cast<std::uint8_t>(reached);
  }
};

}  // namespace

InverseDepth::InverseDepth(const DepthFrame& frame, const CameraIntrinsics& camera,
                           const ViewPointOptions& options)
    : camera_(camera) {
  require_image(frame, camera);
  const double focal = std::sqrt(camera.fx * camera.fy);
  edge_ = static_cast<float>(options.edge_sigmas * options.noise);
  slant_ = static_cast<float>(std::tan(options.max_slant) / focal);
  // A plane fitted to the n = π r² pixels of a disc has a slope of deviation 2 σ / (R √n), where
  // R = r z / f is its radius in metres and σ = noise z².
  radius_factor_ = static_cast<float>(2.0 * options.noise * focal /
                                      (std::sqrt(std::numbers::pi) * options.normal_noise));
  values_.resize(frame.depth.size());
  const auto nearest = static_cast<float>(options.min_depth);
  const auto farthest = static_cast<float>(options.max_depth);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const float z = frame.depth[i];
    values_[i] = z >= nearest && z <= farthest ? 1.0F / z : 0.0F;
  }
}

bool InverseDepth::connected(float a, float b, float gap) const {
  return std::abs(a - b) <= edge_ + gap * slant_ * std::min(a, b);
}

int InverseDepth::radius(float inverse) const {
  const float radius = std::sqrt(radius_factor_ / inverse);
  return std::clamp(static_cast<int>(radius + 0.5F), least_radius, greatest_radius);
}

std::vector<Arms> arms_of(const InverseDepth& image, int max_hole) {
  const auto width = static_cast<int>(image.camera().width);
  const auto height = static_cast<int>(image.camera().height);
  std::vector<Arms> arms(image.camera().pixels());
  const Walk walk{image, max_hole};
  parallel_for_blocks(image.camera().height, image_rows_per_block,
                      [&](std::size_t begin, std::size_t end) {
                        for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v) {
                          for (int u = 0; u < width; ++u) {
                            const auto i = static_cast<std::size_t>(v * width + u);
                            if (image.at(i) == 0.0F) continue;
                            const int r = image.radius(image.at(i));
                            arms[i] = {walk.reach(i, -1, std::min(r, u)),
                                       walk.reach(i, 1, std::min(r, width - 1 - u)),
                                       walk.reach(i, -width, std::min(r, v)),
                                       walk.reach(i, width, std::min(r, height - 1 - v))};
                          }
                        }
                      });
  return arms;
}

}  // namespace symscene
