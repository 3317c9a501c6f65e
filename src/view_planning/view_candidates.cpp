#include "symscene/view_planning/view_candidates.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/looking_at.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

std::vector<Eigen::Isometry3d> views_on_sphere(const Eigen::Vector3d& target,
                                               const Eigen::Vector3d& up, double radius,
                                               std::span<const ViewRing> rings,
                                               double first_azimuth) {
  if (!(radius > 0.0)) throw InputError("views", "a positive radius", fmt::format("{}", radius));
  const Eigen::Vector3d vertical = up.normalized();
  const Eigen::Vector3d x = vertical.unitOrthogonal();
  std::vector<Eigen::Isometry3d> views;
  for (const ViewRing& ring : rings) {
    if (ring.views < 1) throw InputError("views", "rings with a view", "one without");
    for (int i = 0; i < ring.views; ++i) {
      const double azimuth = first_azimuth + 2.0 * std::numbers::pi * i / ring.views;
      const Eigen::Vector3d level = Eigen::AngleAxisd(azimuth, vertical) * x;
      const Eigen::Vector3d direction =
          std::cos(ring.from_vertical) * vertical + std::sin(ring.from_vertical) * level;
      views.push_back(looking_at(target + radius * direction, target, vertical));
    }
  }
  return views;
}

}  // namespace symscene
