#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/median.hpp"
#include "method_parts.hpp"

namespace symscene {
namespace {

constexpr double least_ratio = 0.8, bin = 0.002;
constexpr std::size_t bins = 200;
constexpr double kept = 0.01;  // ratios this close to the most frequent one are of the table

/// Per pixel that would show the table, its depth over the depth of the table there.
std::vector<double> depth_ratios(const ClutterView& view, const CameraIntrinsics& camera,
                                 const Plane& table) {
  std::vector<double> ratios;
  const double height = table.signed_distance(view.T_world_camera.translation());
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const double depth = view.frame.depth[std::size_t{v} * camera.width + u];
      const double descent = -table.normal.dot(view.T_world_camera.linear() * camera.ray(u, v));
      if (depth > 0.0 && descent > 0.0) ratios.push_back(depth * descent / height);
    }
  }
  return ratios;
}

}  // namespace

double depth_scale(const ClutterView& view, const CameraIntrinsics& camera, const Plane& table) {
  const std::vector<double> ratios = depth_ratios(view, camera, table);
  std::array<std::size_t, bins> counts{};
  for (const double ratio : ratios) {
    const double place = (ratio - least_ratio) / bin;
    if (place >= 0.0 && place < static_cast<double>(bins))
      ++counts[static_cast<std::size_t>(place)];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  if (*most == 0) return 1.0;
  const double mode = least_ratio + (static_cast<double>(most - counts.begin()) + 0.5) * bin;
  std::vector<double> near;
  for (const double ratio : ratios) {
    if (std::abs(ratio - mode) < kept) near.push_back(ratio);
  }
  return median(std::move(near)).value_or(1.0);
}

}  // namespace symscene
