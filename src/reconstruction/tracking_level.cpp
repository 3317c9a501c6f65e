#include "tracking_level.hpp"

namespace symscene {
namespace {

SurfaceImage every_second_pixel(const SurfaceImage& fine) {
  SurfaceImage coarse;
  // The kept pixel is the upper left of four.
  coarse.camera = {fine.camera.width / 2, fine.camera.height / 2, 0.5 * fine.camera.fx,
                   0.5 * fine.camera.fy,  0.5 * fine.camera.cx,   0.5 * fine.camera.cy};
  coarse.pixels.resize(coarse.camera.pixels());
  for (Index v = 0; v < coarse.camera.height; ++v) {
    for (Index u = 0; u < coarse.camera.width; ++u) {
      coarse.pixels[std::size_t{v} * coarse.camera.width + u] =
          fine.pixels[std::size_t{2 * v} * fine.camera.width + std::size_t{2 * u}];
    }
  }
  return coarse;
}

}  // namespace

std::vector<SurfaceImage> view_pyramid(const SurfaceImage& view, const Measurement& measurement) {
  std::vector<SurfaceImage> levels{view};
  while (levels.size() < measurement.pyramid.size()) {
    levels.push_back(every_second_pixel(levels.back()));
  }
  return levels;
}

double mean_depth(const SurfaceImage& image) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SurfacePixel& pixel : image.pixels) {
    if (!pixel.shows_surface()) continue;
    sum += static_cast<double>(pixel.depth);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

MatchOptions tracking_matches(double max_distance, const TrackingOptions& options,
                              const MeasurementOptions& sensor) {
  return {.max_distance = max_distance,
          .max_angle = options.max_angle,
          .robust_sigmas = options.robust_sigmas,
          .noise = {.floor = static_cast<float>(options.model_deviation),
                    .moved = static_cast<float>(sensor.noise),
                    .fixed = 0.0F}};
}

}  // namespace symscene
