#include <algorithm>
#include <cmath>
#include <numeric>

#include "grainy_noise.hpp"
#include "sensor_models.hpp"

namespace symscene {
namespace {

/// The rows or the columns of an image, as steps between indices of pixels.
struct Lines {
  std::size_t count, line_step, length, step;
};

/// Per pixel the nearest of the pixels within `radius` along its line.
std::vector<std::size_t> nearest_along(const SensorFrame& frame, std::vector<std::size_t> sources,
                                       const Lines& lines, std::size_t radius) {
  const auto depth_of = [&](std::size_t pixel) {
    const float z = frame.depth[pixel];
    return z > 0.0F ? z : std::numeric_limits<float>::infinity();
  };
  const std::vector<std::size_t> before = sources;
  for (std::size_t line = 0; line < lines.count; ++line) {
    for (std::size_t i = 0; i < lines.length; ++i) {
      std::size_t& best = sources[line * lines.line_step + i * lines.step];
      const std::size_t last = std::min(i + radius, lines.length - 1);
      for (std::size_t k = i - std::min(i, radius); k <= last; ++k) {
        const std::size_t other = before[line * lines.line_step + k * lines.step];
        if (depth_of(other) < depth_of(best)) best = other;
      }
    }
  }
  return sources;
}

/// Per pixel the nearest pixel in the window of that radius around it.
std::vector<std::size_t> nearest_in_window(const SensorFrame& frame, const CameraIntrinsics& camera,
                                           std::size_t radius) {
  std::vector<std::size_t> sources(frame.depth.size());
  std::iota(sources.begin(), sources.end(), std::size_t{0});
  const Lines rows{camera.height, camera.width, camera.width, 1};
  const Lines columns{camera.width, 1, camera.height, camera.width};
  return nearest_along(frame, nearest_along(frame, std::move(sources), rows, radius), columns,
                       radius);
}

/// The pixels that the second camera, to the right of the first, cannot see.
std::vector<char> hidden_from_second(const SensorFrame& frame, const CameraIntrinsics& camera,
                                     double baseline) {
  std::vector<char> hidden(frame.depth.size(), 0);
  for (std::size_t v = 0; v < camera.height; ++v) {
    double leftmost = std::numeric_limits<double>::infinity();
    for (std::size_t u = camera.width; u-- > 0;) {
      const std::size_t pixel = v * camera.width + u;
      if (frame.depth[pixel] <= 0.0F) continue;
      const double column = static_cast<double>(u) - camera.fx * baseline / frame.depth[pixel];
      hidden[pixel] = column >= leftmost ? 1 : 0;
      leftmost = std::min(leftmost, column);
    }
  }
  return hidden;
}

/// Where the pattern does not return to the cameras.
class StereoHoles {
 public:
  StereoHoles(const CameraIntrinsics& camera, const StereoNoiseOptions& options, Random& random)
      : options_(options), noise_(camera, options.hole_size, random) {}

  bool at(const SensorFrame& frame, std::size_t pixel, Index u, Index v) {
    // The noise is normal, so that this share of it is above the threshold (logistic quantile).
    const double share = std::min(0.5, share_at(frame, pixel));
    return share > 0.0 && noise_.at(u, v) > std::log((1.0 - share) / share) / 1.702;
  }

 private:
  double share_at(const SensorFrame& frame, std::size_t pixel) {
    double share = options_.holes;
    if (reflectance(frame, pixel) < options_.dark) share += options_.dark_holes;
    if (is_shiny(frame.objects[pixel])) {
      const double facing = frame.cosines[pixel];
      share += 2.0 * options_.shiny_holes * facing * facing * facing;
    }
    return share;
  }

  bool is_shiny(Index object) {
    if (object == SensorFrame::nothing) return false;
    while (shiny_.size() <= object)
      shiny_.push_back(Random(options_.material_seed, shiny_.size()).chance(options_.shiny) ? 1
                                                                                            : 0);
    return shiny_[object] != 0;
  }

  const StereoNoiseOptions& options_;
  GrainyNoise noise_;
  std::vector<char> shiny_;
};

double with_disparity_error(double z, double unit_noise, double focal_baseline,
                            const StereoNoiseOptions& options) {
  double disparity = focal_baseline / z + options.disparity_noise * unit_noise;
  if (options.disparity_step > 0.0)
    disparity = std::round(disparity / options.disparity_step) * options.disparity_step;
  return disparity > 0.0 ? focal_baseline / disparity : 0.0;
}

}  // namespace

SensorFrame stereo_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                         const SensorNoiseOptions& options, Random random) {
  const StereoNoiseOptions& stereo = options.stereo;
  SensorFrame noisy = exact;
  const GrainyNoise noise(camera, stereo.window, random);
  // The same window does not match everywhere: the fattened border is frayed.
  const GrainyNoise fraying(camera, stereo.window, random);
  StereoHoles holes(camera, stereo, random);
  const auto nearest =
      nearest_in_window(exact, camera, static_cast<std::size_t>(stereo.window) / 2);
  const std::vector<char> hidden = hidden_from_second(exact, camera, stereo.baseline);
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      const double own = exact.depth[pixel];
      const bool is_background =
          own <= 0.0 || own - exact.depth[nearest[pixel]] > options.edge_step;
      const bool is_fattened = is_background && fraying.at(u, v) > 0.0;
      const std::size_t source = is_fattened ? nearest[pixel] : pixel;
      const double z = exact.depth[source];
      const bool measured =
          z > 0.0 && z < options.max_depth && (is_fattened || hidden[pixel] == 0) &&
          !random.chance(grazing_loss(exact, source, options)) && !holes.at(exact, source, u, v);
      const double measured_z =
          measured ? with_disparity_error(z, noise.at(u, v), camera.fx * stereo.baseline, stereo)
                   : 0.0;
      set_pixel(noisy, pixel, exact, source, measured_z);
      if (!(measured_z > 0.0)) clear_pixel(noisy, pixel);
    }
  }
  return noisy;
}

}  // namespace symscene
