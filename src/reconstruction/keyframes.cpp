#include "keyframes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace symscene {
namespace {

constexpr std::size_t columns = 20;
constexpr std::size_t rows = 15;

std::vector<float> make_thumbnail(const Measurement& measurement) {
  const SurfaceImage& image = measurement.pyramid.back();
  const std::size_t width = image.camera.width, height = image.camera.height;
  std::vector<float> sum(columns * rows, 0.0F), count(columns * rows, 0.0F);
  for (std::size_t v = 0; v < height; ++v) {
    for (std::size_t u = 0; u < width; ++u) {
      const float depth = image.pixels[v * width + u].depth;
      if (!(depth > 0.0F)) continue;
      const std::size_t cell = v * rows / height * columns + u * columns / width;
      sum[cell] += depth;
      count[cell] += 1.0F;
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    if (count[k] > 0.0F) sum[k] /= count[k];
  }
  return sum;
}

/// Mean difference of the depths, 0 to 1; it saturates per pixel at `different`. [m]
double dissimilarity(const std::vector<float>& a, const std::vector<float>& b, float different) {
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] == 0.0F && b[k] == 0.0F) continue;
    const bool both = a[k] > 0.0F && b[k] > 0.0F;
    sum += both ? static_cast<double>(std::min(std::abs(a[k] - b[k]) / different, 1.0F)) : 1.0;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 1.0;
}

bool is_near(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double distance,
             double angle) {
  const Eigen::Isometry3d difference = a.inverse() * b;
  return difference.translation().norm() < distance &&
         Eigen::AngleAxisd(difference.linear()).angle() < angle;
}

}  // namespace

void Keyframes::add(const Measurement& measurement, const Eigen::Isometry3d& T_world_camera) {
  for (const Keyframe& keyframe : keyframes_) {
    if (is_near(keyframe.T_world_camera, T_world_camera, options_.keyframe_distance,
                options_.keyframe_angle)) {
      return;
    }
  }
  keyframes_.push_back({T_world_camera, make_thumbnail(measurement)});
}

std::vector<Eigen::Isometry3d> Keyframes::most_similar(const Measurement& measurement,
                                                       std::size_t count) const {
  const std::vector<float> thumbnail = make_thumbnail(measurement);
  const auto different = static_cast<float>(options_.keyframe_depth_difference);
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t k = 0; k < keyframes_.size(); ++k) {
    ranked.emplace_back(dissimilarity(keyframes_[k].thumbnail, thumbnail, different), k);
  }
  std::sort(ranked.begin(), ranked.end());
  ranked.resize(std::min(ranked.size(), count));
  std::vector<Eigen::Isometry3d> poses;
  for (const auto& [difference, k] : ranked) poses.push_back(keyframes_[k].T_world_camera);
  return poses;
}

}  // namespace symscene
